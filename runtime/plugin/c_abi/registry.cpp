#include "runtime/plugin/c_abi/registry.h"

#include <algorithm>
#include <optional>

#include "runtime/plugin/c_abi/checks.h"

namespace rubble::abi {
namespace {

constexpr uint32_t kMaxWorlds = 255;  // a world's number is 8 bits of each handle, and 0 is no world

/// What is under a handle; null, and the call is refused, if it names nothing.
template <class Map, class Id>
auto* lookUp(Map& map, Id id, const char* name) {
    auto* value = map.find(id);
    if (!value) refuse(RUBBLE_ERROR_STALE, "{}{}", name, id ? " is stale" : " is 0");
    return value;
}

/// Whether this thread may call the world's functions; refuses the call if not.
bool isOfThisThread(const HostedWorld& hosted) {
    const std::thread::id thread = hosted.options.thread;
    if (thread == std::thread::id() || thread == std::this_thread::get_id()) return true;
    refuse(RUBBLE_ERROR_THREAD,
           "world was made with RUBBLE_WORLD_ONE_THREAD: expected the thread of create_world(), found another");
    return false;
}

}  // namespace

bool beginUse(std::atomic<bool>& isInCall, const char* name) {
    if (!isInCall.exchange(true, std::memory_order_acquire)) return true;
    refuse(RUBBLE_ERROR_BUSY,
           "{} is in another call: expected calls one at a time, found one from another thread or from a log callback",
           name);
    return false;
}

Registry& Registry::instance() {
    static Registry registry;
    return registry;
}

Registry::~Registry() {
    // A host that ends without destroying its renderers has most likely no GL context any more, and their GL objects
    // went with the context: deleting them would call into nothing.
    m_renderers.forEach(
        [](RendererId, std::shared_ptr<HostedRenderer>& hosted) { static_cast<void>(hosted->renderer.release()); });
}

WorldId Registry::createWorld(FrameLoopSettings settings, const WorldOptions& options) {
    const std::lock_guard lock(m_mutex);
    if (m_worlds.size() >= kMaxWorlds) {
        refuse(RUBBLE_ERROR_CAPACITY, "255 worlds exist already: destroy one first");
        return {};
    }
    // The world's number is its slot plus 1, so the slot is taken before the world is made.
    const WorldId id = m_worlds.insert(nullptr);
    settings.worldId = uint8_t(id.slot() + 1);
    settings.firstGeneration = std::max(1u, m_firstGeneration[settings.worldId]);
    try {
        m_worlds.at(id) = std::make_shared<HostedWorld>(settings, options);
    } catch (...) {
        m_worlds.erase(id);
        throw;
    }
    return id;
}

void Registry::destroyWorld(WorldId id) {
    WorldServices services;
    std::optional<ServiceScope> scope;  // for what is logged while it is destroyed
    std::shared_ptr<HostedWorld> last;  // destroyed after the lock is released, because that joins a thread
    const std::lock_guard lock(m_mutex);
    std::shared_ptr<HostedWorld>* found = lookUp(m_worlds, id, "world");
    if (!found || !isOfThisThread(**found) || !beginUse((*found)->isInCall, "world")) return;
    last = std::move(*found);
    services = last->options.services;
    scope.emplace(services);
    m_worlds.erase(id);
    const World& world = last->loop.world();
    uint32_t& first = m_firstGeneration[world.id()];
    first = std::max(first, highestGeneration(world.data()) + 1);
}

Use<HostedWorld> Registry::world(uint64_t handle) {
    std::shared_ptr<HostedWorld> found = findWorld(handle);
    if (found && !isOfThisThread(*found)) found.reset();
    return Use(std::move(found), "world");
}

std::shared_ptr<HostedWorld> Registry::findWorld(uint64_t handle) {
    const std::lock_guard lock(m_mutex);
    const auto* found = lookUp(m_worlds, readHandle<HandleType::World>(handle, "world"), "world");
    return found ? *found : nullptr;
}

RendererId Registry::addRenderer(std::shared_ptr<HostedRenderer> renderer) {
    const std::lock_guard lock(m_mutex);
    return m_renderers.insert(std::move(renderer));
}

void Registry::destroyRenderer(RendererId id) {
    std::shared_ptr<HostedRenderer> last;
    const std::lock_guard lock(m_mutex);
    std::shared_ptr<HostedRenderer>* found = lookUp(m_renderers, id, "renderer");
    if (!found || !beginUse((*found)->isInCall, "renderer")) return;
    last = std::move(*found);
    m_renderers.erase(id);
}

Use<HostedRenderer> Registry::renderer(uint64_t handle) {
    std::shared_ptr<HostedRenderer> found;
    {
        const std::lock_guard lock(m_mutex);
        if (const auto* under = lookUp(m_renderers, readHandle<HandleType::Renderer>(handle, "renderer"), "renderer"))
            found = *under;
    }
    return Use(std::move(found), "renderer");
}

}  // namespace rubble::abi
