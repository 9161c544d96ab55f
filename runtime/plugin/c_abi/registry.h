#pragma once
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "runtime/core/slot_map.h"
#include "runtime/plugin/c_abi/event_rows.h"
#include "runtime/plugin/c_abi/host.h"
#include "runtime/plugin/c_abi/prefab_cache.h"
#include "runtime/plugin/c_abi/report_rows.h"
#include "runtime/plugin/c_abi/waiting_objects.h"
#include "runtime/plugin/frame_loop.h"
#include "runtime/plugin/level_loading.h"
#include "runtime/voxel/greedy_mesh.h"
#include "runtime/world/history/brick_versions.h"

namespace rubble::abi {

using WorldId = Handle<HandleType::World>;
using RendererId = Handle<HandleType::Renderer>;

struct HostedRenderer;

/// How a host uses a world.
struct WorldOptions {
    bool drawable = true;
    WorldServices services;
    std::thread::id thread;  ///< that alone may call [main-thread] functions; none: any one at a time
};

/// A world of the host with the events and reports of its last step.
struct HostedWorld {
    /// Makes an empty world.
    HostedWorld(const FrameLoopSettings& settings, const WorldOptions& given) : options(given), loop(settings) {}
    /// Takes over what the last step did.
    void listStep() {
        reports.fill(loop);
        listChanges();
    }
    /// The same of edits alone, which give no reports.
    void listEdits() {
        reports.restart(loop);
        listChanges();
    }
    /// Nothing is known of the steps of a world that was replaced.
    void forgetSteps() {
        events.clear();
        reports.restart(loop);
        bricks.forget();
        waiting = {};
    }
    WorldOptions options;
    FrameLoop loop;
    EventRows events;
    ReportRows reports;
    BrickVersions bricks;
    WaitingObjects waiting;
    PrefabCache prefabs;
    std::vector<FaceQuad> quads;             ///< scratch of mesh_brick()
    std::unique_ptr<LevelLoading> loading;   ///< of a level that is not in the world yet
    std::atomic<bool> isInCall = false;      ///< of a [main-thread] function
    std::string damage;                      ///< what has left it in no defined state; empty: nothing
    std::weak_ptr<HostedRenderer> renderer;  ///< [render-thread] the one that draws it
    bool hadRenderer = false;                ///< [render-thread] another one has taken what was published until now

private:
    void listChanges() {
        events.fill(loop.changes());
        bricks.follow(loop.changes(), loop.world().data());
        waiting = {};
    }
};

/// A renderer with what deletes it, so that a library without renderers links.
using RendererOwner = std::unique_ptr<Renderer, void (*)(Renderer*)>;

/// A renderer of the host and the world that it draws.
struct HostedRenderer {
    std::weak_ptr<HostedWorld> world;
    RendererOwner renderer{nullptr, nullptr};
    double applyMs = 0.0, drawMs = 0.0;  ///< of the last draw()
    std::string damage;                  ///< what has left it in no defined state; empty: nothing
    std::atomic<bool> isInCall = false;
};

/// Marks a world or renderer as in use; false, and the call is refused, if it is. `name`: of the argument.
bool beginUse(std::atomic<bool>& isInCall, const char* name);

/// A call's use of a world or renderer, which stays alive until the call ends, even if another thread destroys it
/// meanwhile. Only one call at a time can use one: another thread, or a log callback inside the call, is told so.
template <class Hosted>
class Use {
public:
    /// Of nothing, if there is nothing to use or it is in use; the call is refused then. `name`: of the argument.
    Use(std::shared_ptr<Hosted> hosted, const char* name) : m_hosted(std::move(hosted)) {
        if (m_hosted && !beginUse(m_hosted->isInCall, name)) m_hosted.reset();
    }
    ~Use() {
        if (m_hosted) m_hosted->isInCall.store(false, std::memory_order_release);
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    explicit operator bool() const { return m_hosted != nullptr; }
    Hosted* operator->() const { return m_hosted.get(); }
    Hosted& operator*() const { return *m_hosted; }

private:
    std::shared_ptr<Hosted> m_hosted;
};

/// All worlds and renderers of the process, by handle. Its functions are for calls of the host: see call.h.
/// [any-thread]
class Registry {
public:
    /// The one registry of the process.
    static Registry& instance();
    ~Registry();

    /// Makes a world whose handles carry its number; those of destroyed worlds that had it are stale. Refused
    /// if there are 255.
    WorldId createWorld(FrameLoopSettings settings, const WorldOptions& options);
    /// Refused for a stale handle, and if the world is in use or of another thread.
    void destroyWorld(WorldId id);
    /// The world of a handle of any kind, for a [main-thread] call. None, and the call is refused, if it is not that of
    /// a world, or stale, or in use, or of another thread.
    Use<HostedWorld> world(uint64_t handle);
    /// The same for a [render-thread] call, which may run beside one of the main thread.
    std::shared_ptr<HostedWorld> findWorld(uint64_t handle);

    /// Takes a renderer over and gives it a handle.
    RendererId addRenderer(std::shared_ptr<HostedRenderer> renderer);
    /// Refused for a stale handle, and if the renderer is in use. Its GL context must be current.
    void destroyRenderer(RendererId id);
    /// The renderer of a handle. None, and the call is refused, if it is not that of a renderer, or stale, or in use.
    Use<HostedRenderer> renderer(uint64_t handle);

private:
    std::mutex m_mutex;
    SlotMap<WorldId, std::shared_ptr<HostedWorld>> m_worlds;
    std::array<uint32_t, 256> m_firstGeneration{};  ///< by number of a world: above those of destroyed ones
    SlotMap<RendererId, std::shared_ptr<HostedRenderer>> m_renderers;
};

}  // namespace rubble::abi
