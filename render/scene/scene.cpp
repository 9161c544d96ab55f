#include "render/scene/scene.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/frame/frame_block.h"
#include "runtime/core/constants.h"

namespace rubble {
namespace {

constexpr double kSector = 6.4;             ///< metres: side of a sector, 64 shadow cells
constexpr double kRebaseDistance = 1024.0;  ///< metres of the camera from the origin: a float is exact to 0.06 mm there

}  // namespace

void Scene::apply(FrameSnapshot&& snapshot) {
    if (snapshot.replacesAll) {
        for (Deferred& held : m_deferred) {
            applyNow(held.snapshot);
            m_bodies.releaseBricks(held.snapshot);
        }
        m_deferred.clear();
        m_sendAll = true;
        return applyNow(snapshot);
    }
    if (m_deferred.empty() && (m_sendAll || m_bodies.waitingBytes() + m_bodies.newBytes(snapshot) <= m_uploadBudget))
        return applyNow(snapshot);
    const uint64_t bricks = m_bodies.retainBricks(snapshot);
    m_deferred.push_back({std::move(snapshot), bricks});
}

void Scene::applyDeferred() {
    while (!m_deferred.empty() && m_deferred.front().bricksSent <= m_bodies.bricksSent()) {
        applyNow(m_deferred.front().snapshot);
        m_bodies.releaseBricks(m_deferred.front().snapshot);
        m_deferred.pop_front();
    }
}

void Scene::applyNow(FrameSnapshot& snapshot) {
    bool glassChanged = snapshot.environmentChanged || touchesGlass(snapshot);  // the glass that it removes
    if (snapshot.replacesAll) {
        m_lookChanges.replaceAll();
        m_bodies.clear();
        m_bodies.setMaterials(snapshot.materials);
    } else if (!snapshot.materials.empty()) {
        m_bodies.setMaterials(snapshot.materials);  // palettes of what was renamed are listed
    }
    for (ShapeHandle shape : snapshot.destroyed) m_bodies.destroy(shape);
    for (const SnapshotShape& shape : snapshot.created) m_bodies.create(shape);
    for (const BrickChange& change : snapshot.bricks) m_bodies.setBrick(change);
    for (const SnapshotPalette& given : snapshot.palettes)
        if (const PaletteRef before = m_bodies.setPalette(given))
            m_lookChanges.addPalette(given.shape.slot(), *before, *given.palette);
    for (const SnapshotPose& pose : snapshot.poses) m_bodies.setPose(pose);
    glassChanged |= touchesGlass(snapshot);  // the glass that it adds
    m_glassChanges += uint64_t(glassChanged);
    m_shadow.apply(snapshot.shadow, snapshot.shadowReplacesAll);
    if (!snapshot.shadowReplacesAll) m_dirtyRegions.add(snapshot.shadow);
    if (snapshot.watersChanged) m_waters = std::move(snapshot.waters);
    m_watersChanged |= snapshot.watersChanged;
    if (snapshot.replacesAll) m_ripples.clear();
    if (snapshot.ripplesChanged) m_ripples = std::move(snapshot.ripples);
    m_seconds = double(snapshot.version) / kStepsPerSecond;
    if (snapshot.lightsChanged) m_lights = std::move(snapshot.lights);
    if (snapshot.replacesAll) m_ropes.clear();
    if (snapshot.ropesChanged) m_ropes = std::move(snapshot.ropes);
    if (snapshot.replacesAll) m_particles.clear();
    if (snapshot.particlesChanged) m_particles = std::move(snapshot.particles);
    m_smokeChanged = m_smokeChanged || snapshot.replacesAll || snapshot.particlesChanged || snapshot.environmentChanged;
    if (!snapshot.environmentChanged) return;
    if (!snapshot.replacesAll) m_lookChanges.addEnvironment(m_environment, snapshot.environment);
    m_environment = snapshot.environment;
}

bool Scene::isGlass(ShapeHandle shape) const {
    return shape.slot() < m_bodies.instances().size() && m_bodies.instances()[shape.slot()].glass;
}

bool Scene::touchesGlass(const FrameSnapshot& snapshot) const {
    const auto isOne = [&](const auto& changed) { return isGlass(changed.shape); };
    return std::any_of(snapshot.destroyed.begin(), snapshot.destroyed.end(),
                       [&](ShapeHandle shape) { return isGlass(shape); }) ||
           std::any_of(snapshot.created.begin(), snapshot.created.end(), isOne) ||
           std::any_of(snapshot.bricks.begin(), snapshot.bricks.end(), isOne) ||
           std::any_of(snapshot.palettes.begin(), snapshot.palettes.end(), isOne) ||
           std::any_of(snapshot.poses.begin(), snapshot.poses.end(), isOne);
}

uint64_t Scene::beginFrame(float alpha, glm::dvec3 cameraWorld, bool isSameMoment,
                           std::span<const ShapeHandle> hidden) {
    const uint64_t bricks = m_bodies.sendBricks(std::exchange(m_sendAll, false) ? ~uint64_t(0) : m_uploadBudget);
    applyDeferred();
    const bool rebased = glm::distance(cameraWorld, m_origin) > kRebaseDistance;
    if (rebased) m_origin = glm::round(cameraWorld / kSector) * kSector;
    if (m_smokeChanged || rebased) m_smoke.update(m_particles, m_environment.sunDirection, m_origin);
    const uint64_t outlines = m_watersChanged || rebased ? m_outlines.update(m_waters, m_origin) : 0;
    m_smokeChanged = m_watersChanged = false;
    if (!isSameMoment) {
        m_shownDirtyRegions = m_dirtyRegions.begin(m_shownDirtyRegions);
        m_dirtyRegions.clear();
        m_lookChanges.beginMoment();
    }
    const uint64_t bodies = m_bodies.beginFrame(alpha, m_origin, isSameMoment, hidden);
    m_glassChanges += uint64_t(m_bodies.touched().hidesOthers);
    m_lookChanges.findBoxes(m_bodies);
    return bricks + outlines + bodies + updateGrid() + m_shadow.upload();
}

uint64_t Scene::updateGrid() {
    if (!m_bounceColors && !hasMirrors() && !hasGlass() && m_environment.wetness <= 0.0f && m_waters.empty()) {
        m_grid.reset();
        return 0;
    }
    const auto& instances = m_bodies.instances();
    if (m_grid) {
        for (const uint32_t slot : m_bodies.touched().slots) m_grid->put(slot, instances[slot]);
    } else {
        m_grid.emplace();
        for (uint32_t slot = 0; slot < instances.size(); ++slot) m_grid->put(slot, instances[slot]);
    }
    return m_grid->upload();
}

void Scene::bindVoxelsAt(const Program& program) const {
    m_bodies.bind(program);
    static const BodyGrid none;
    (m_grid ? *m_grid : none).bind(program);
}

void Scene::describe(FrameBlock& block) const {
    describeShadow(block);
    const Environment& e = m_environment;
    block.sunDirection = glm::vec4(glm::normalize(e.sunDirection), e.sunAngle);
    block.sunColor = glm::vec4(e.sunColor, 0.0f);
    block.skyColor = glm::vec4(e.skyColor, 0.0f);
    block.horizonColor = glm::vec4(e.horizonColor, 0.0f);
    block.groundColor = glm::vec4(e.groundColor, e.wetness > 0.0f ? std::min(e.wetness, 1.0f) : 0.0f);
    block.fogColor = glm::vec4(e.fogColor, e.fogDistance);
    block.fog = glm::vec4(e.fogDensity, float(double(e.fogBase) - m_origin.y), std::max(e.fogHeight, 0.1f),
                          std::clamp(e.fogForward, -0.9f, 0.9f));
    block.fogTint = glm::vec4(e.fogTint, 0.0f);
    block.skyCover = glm::vec4(e.clouds, e.stars, float(kFieldsHeight - m_origin.y), 0.0f);
    block.exposure = glm::vec4(e.exposure);
}

void Scene::describeShadow(FrameBlock& block) const {
    const glm::ivec3 origin(glm::round(m_origin / kSector));
    const auto describe = [&](const ShadowDirectory::Part& part, glm::ivec4& first, glm::ivec4& size, glm::vec4& low,
                              glm::vec4& high) {
        first = glm::ivec4(part.low - origin, 0);
        size = glm::ivec4(part.size, part.bricks > 0);
        low = glm::vec4(part.occupiedLow(), 0.0f);
        high = glm::vec4(part.occupiedHigh(), 0.0f);
    };
    describe(m_shadow.directory().dense(), block.shadowDenseFirst, block.shadowDenseSize, block.shadowDenseLow,
             block.shadowDenseHigh);
    describe(m_shadow.directory().paged(), block.shadowPagedFirst, block.shadowPagedSize, block.shadowPagedLow,
             block.shadowPagedHigh);
}

}  // namespace rubble
