#include "runtime/plugin/c_abi/registry.h"

#include <algorithm>

#include "runtime/plugin/c_abi/checks.h"

namespace rubble::abi {
namespace {

constexpr uint32_t kMaxWorlds = 255;  // a world's number is 8 bits of each handle, and 0 is no world

template <class Map, class Id>
auto& lookUp(Map& map, Id id, const char* name) {
    auto* value = map.find(id);
    if (!value) throw ApiError{RUBBLE_ERROR_STALE, std::string(name) + (id ? " is stale" : " is 0")};
    return *value;
}

}  // namespace

void throwInUse(const char* name) {
    throw ApiError{RUBBLE_ERROR_BUSY, std::string(name) +
                                          " is in another call: expected calls one at a time, found one from another "
                                          "thread or from a log callback"};
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

WorldId Registry::createWorld(FrameLoopSettings settings, bool drawable) {
    const std::lock_guard lock(m_mutex);
    if (m_worlds.size() >= kMaxWorlds)
        throw ApiError{RUBBLE_ERROR_CAPACITY, "255 worlds exist already: destroy one first"};
    // The world's number is its slot plus 1, so the slot is taken before the world is made.
    const WorldId id = m_worlds.insert(nullptr);
    settings.worldId = uint8_t(id.slot() + 1);
    settings.firstGeneration = std::max(1u, m_firstGeneration[settings.worldId]);
    try {
        m_worlds.at(id) = std::make_shared<HostedWorld>(settings);
    } catch (...) {
        m_worlds.erase(id);
        throw;
    }
    m_worlds.at(id)->drawable = drawable;
    return id;
}

void Registry::destroyWorld(WorldId id) {
    std::shared_ptr<HostedWorld> last;  // destroyed after the lock is released, because that joins a thread
    const std::lock_guard lock(m_mutex);
    std::shared_ptr<HostedWorld>& found = lookUp(m_worlds, id, "world");
    if (found->isInCall.exchange(true)) throwInUse("world");
    last = std::move(found);
    m_worlds.erase(id);
    const World& world = last->loop.world();
    uint32_t& first = m_firstGeneration[world.id()];
    first = std::max(first, highestGeneration(world.data()) + 1);
}

std::shared_ptr<HostedWorld> Registry::findWorld(uint64_t handle) {
    const std::lock_guard lock(m_mutex);
    return lookUp(m_worlds, readHandle<HandleType::World>(handle, "world"), "world");
}

RendererId Registry::addRenderer(std::shared_ptr<HostedRenderer> renderer) {
    const std::lock_guard lock(m_mutex);
    return m_renderers.insert(std::move(renderer));
}

void Registry::destroyRenderer(RendererId id) {
    std::shared_ptr<HostedRenderer> last;
    const std::lock_guard lock(m_mutex);
    std::shared_ptr<HostedRenderer>& found = lookUp(m_renderers, id, "renderer");
    if (found->isInCall.exchange(true)) throwInUse("renderer");
    last = std::move(found);
    m_renderers.erase(id);
}

Use<HostedRenderer> Registry::renderer(uint64_t handle) {
    std::shared_ptr<HostedRenderer> found;
    {
        const std::lock_guard lock(m_mutex);
        found = lookUp(m_renderers, readHandle<HandleType::Renderer>(handle, "renderer"), "renderer");
    }
    return Use(std::move(found), "renderer");
}

}  // namespace rubble::abi
