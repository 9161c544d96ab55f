#pragma once
#include <array>
#include <memory>
#include <mutex>

#include "runtime/core/slot_map.h"
#include "runtime/plugin/c_abi/event_rows.h"
#include "runtime/plugin/frame_loop.h"

namespace rubble::abi {

using WorldId = Handle<HandleType::World>;
using RendererId = Handle<HandleType::Renderer>;

/// A world of the host and the events of its last step.
struct HostedWorld {
    /// Makes an empty world.
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
    double applyMs = 0.0, drawMs = 0.0;  ///< of the last draw()
};

/// All worlds and renderers of the process, by handle. [any-thread] What a call returns stays alive until the caller
/// drops it, even if another thread destroys it meanwhile.
class Registry {
public:
    /// The one registry of the process.
    static Registry& instance();
    ~Registry();

    /// Makes a world whose handles carry its number; those of destroyed worlds that had it are stale. Throws ApiError
    /// if there are 255.
    WorldId createWorld(FrameLoopSettings settings, bool drawable);
    /// Throws ApiError for a stale handle.
    void destroyWorld(WorldId id);
    /// The world of a handle of any kind. Throws ApiError if it is not that of a world, or stale.
    std::shared_ptr<HostedWorld> world(uint64_t handle);

    /// Takes a renderer over and gives it a handle.
    RendererId addRenderer(std::shared_ptr<HostedRenderer> renderer);
    /// Throws ApiError for a stale handle. The GL context of the renderer must be current.
    void destroyRenderer(RendererId id);
    /// The renderer of a handle. Throws ApiError if it is not that of a renderer, or stale.
    std::shared_ptr<HostedRenderer> renderer(uint64_t handle);

private:
    std::mutex m_mutex;
    SlotMap<WorldId, std::shared_ptr<HostedWorld>> m_worlds;
    std::array<uint32_t, 256> m_firstGeneration{};  ///< by number of a world: above those of destroyed ones
    SlotMap<RendererId, std::shared_ptr<HostedRenderer>> m_renderers;
};

}  // namespace rubble::abi
