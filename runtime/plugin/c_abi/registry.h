#pragma once
#include <memory>
#include <mutex>

#include "runtime/core/slot_map.h"
#include "runtime/plugin/c_abi/reads.h"
#include "runtime/plugin/frame_loop.h"

namespace rubble::abi {

using WorldId = Handle<HandleType::World>;
using RendererId = Handle<HandleType::Renderer>;

/// A world of the host.
struct HostedWorld {
    explicit HostedWorld(const FrameLoopSettings& settings) : loop(settings) {}
    FrameLoop loop;
    EventRows events;
    bool drawable = true;
    bool hadRenderer = false;  ///< snapshots are handed over once: a second renderer would miss what the first one took
};

/// A renderer of the host and the world that it draws.
struct HostedRenderer {
    std::weak_ptr<HostedWorld> world;
    std::unique_ptr<Renderer> renderer;
    double applyMs = 0.0, drawMs = 0.0;
};

/// All that the host has made, by handle. [any-thread] What is looked up lives on until the caller drops it.
class Registry {
public:
    static Registry& instance();
    ~Registry();

    WorldId createWorld(FrameLoopSettings settings, bool drawable);
    void destroyWorld(WorldId id);
    /// Throws ApiError for a stale handle.
    std::shared_ptr<HostedWorld> world(uint64_t handle);

    RendererId addRenderer(std::shared_ptr<HostedRenderer> renderer);
    void destroyRenderer(RendererId id);
    std::shared_ptr<HostedRenderer> renderer(uint64_t handle);

private:
    std::mutex m_mutex;
    SlotMap<WorldId, std::shared_ptr<HostedWorld>> m_worlds;
    SlotMap<RendererId, std::shared_ptr<HostedRenderer>> m_renderers;
};

}  // namespace rubble::abi
