#include "runtime/world/state/world_state.h"

#include <utility>

#include "runtime/world/stages/edit_step.h"
#include "runtime/world/history/undo_history.h"

namespace rubble {

WorldState World::state() const {
    return {m_name,      m_step,   m_imported, m_removed,   m_bodies,      m_shapes,
            m_lights,    m_groups, m_revived,  m_materials, m_environment, m_settings,
            m_locations, m_fire,   m_waters,   m_triggers,  m_characters,  m_joints};
}

void World::setState(WorldState state) {
    clear();
    m_name = std::move(state.name);
    m_step = state.step;
    m_imported = state.imported;
    m_removed = state.removed;
    m_bodies = std::move(state.bodies);
    m_shapes = std::move(state.shapes);
    m_lights = std::move(state.lights);
    m_groups = std::move(state.groups);
    m_revived = std::move(state.unsettled);
    m_materials = std::move(state.materials);
    m_wire = m_materials.find("wire");
    m_groups.forEach([&](LightGroupHandle, const LightGroup& group) { m_flickeringGroups += group.failingSince != 0; });
    m_environment = state.environment;
    m_locations = std::move(state.locations);
    m_fire = std::move(state.fire);
    m_waters = std::move(state.waters);
    m_triggers = std::move(state.triggers);
    m_characters = std::move(state.characters);
    m_joints = std::move(state.joints);
    rebuildJointIndex();
    setSettings(state.settings);
    m_shapes.forEach([&](ShapeHandle handle, const Shape&) { updateShapeBounds(handle); });
    EditStep::initTriggers(*this);
    restartStress();
}

}  // namespace rubble
