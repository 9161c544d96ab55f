#include "samples/hosts/godot/world_child.h"

namespace rubble_godot {
namespace {

const Method kGetTransform{"Spatial", "get_global_transform"}, kSetTransform{"Spatial", "set_global_transform"};

}  // namespace

Transform WorldChild::place() const {
    return kGetTransform(m_node).as<Transform>();
}

void WorldChild::setPlace(const Transform& place) const {
    kSetTransform(m_node, place);
}

Variant WorldChild::enterTree(Arguments) {
    m_start = place();
    m_world = VoxelWorld::above(m_node);
    if (m_world) m_world->add(*this);
    return {};
}

Variant WorldChild::exitTree(Arguments) {
    if (!m_world) return {};
    m_world->remove(*this);
    despawn();
    m_world = nullptr;
    return {};
}

}  // namespace rubble_godot
