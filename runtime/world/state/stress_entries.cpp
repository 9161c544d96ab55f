#include "runtime/core/log.h"
#include "runtime/world/world.h"

namespace rubble {

void World::restartStress() {
    m_stress.reset();
    if (!m_settings.stress.on) return;
    m_stress.emplace();
    m_shapes.forEach([&](ShapeHandle handle, const Shape&) { addStress(handle); });
}

void World::addStress(ShapeHandle handle) {
    const Shape& shape = m_shapes.at(handle);
    if (!shape.loadBearing || !m_bodies.at(shape.body).isStatic) return;
    if (shape.grid.brickCount() > m_settings.stress.largestShape) {
        logWarning("stress: shape \"" + shape.name + "\" has " + std::to_string(shape.grid.brickCount()) +
                   " bricks and bears whatever comes; StressSettings::largestShape is " +
                   std::to_string(m_settings.stress.largestShape));
        return;
    }
    std::vector<glm::ivec3> bricks;
    shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) { bricks.push_back(brick); });
    WorldStress::Entry& entry = m_stress->add(handle);
    entry.analysis.markChanged(bricks);
    for (const HeatField& field : m_fire.fields) {
        if (field.shape != handle) continue;
        for (const HotBrick& hot : field.bricks)  // cf. EditStep::weaken()
            entry.weak.push_back({hot.brick, (int(256.0 * remainingStrength(handle, hot.brick)) + 15) / 16 * 16});
    }
}

}  // namespace rubble
