#include "runtime/frame/snapshots.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "runtime/core/assertion.h"
#include "runtime/core/constants.h"
#include "runtime/shadow/shadow_worker.h"

namespace rubble {
namespace {

// What an edit moves farther than its velocity does in a step has jumped; a host that moves a platform step by step
// stays below that.
constexpr double kJumpMetres = 0.5, kJumpRadians = 0.5;
constexpr size_t kMaxPosted = 16;  ///< snapshots in the queue before the main thread merges them: nobody draws

SnapshotShape describeShape(ShapeHandle handle, const Shape& shape, PaletteRef palette) {
    SnapshotShape out{handle, shape.grid.size(), shape.voxelSize, std::move(palette), {}, shape.paintColors};
    out.bricks.reserve(shape.grid.brickCount());
    shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
        out.bricks.push_back({handle, brick, content});
    });
    return out;
}

bool showsNothing(const FrameSnapshot& s) {
    return !s.replacesAll && s.destroyed.empty() && s.created.empty() && s.bricks.empty() && s.palettes.empty() &&
           s.poses.empty() && !s.lightsChanged && !s.particlesChanged && !s.ropesChanged && !s.watersChanged &&
           !s.ripplesChanged && !s.environmentChanged && s.materials.empty();
}

}  // namespace

void Snapshots::publish(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world,
                        std::vector<ShadowPatches> patches, std::span<const Impact> impacts) {
    enqueue(changes, moved, world, impacts);
    release(std::move(patches));
}

void Snapshots::release(std::vector<ShadowPatches> patches) {
    SnapshotMerger out;
    for (ShadowPatches& publication : patches) {
        const auto isShown = [&] {
            return !m_waiting.empty() && m_waiting.front().snapshot.version <= publication.version;
        };
        FrameSnapshot newest;  // with its shadow it is one snapshot: there is nothing to merge
        while (isShown()) {
            newest = takeOldest();
            if (isShown()) out.add(std::move(newest));
        }
        newest.version = publication.version;
        newest.shadowReplacesAll = newest.shadowReplacesAll || publication.replacesAll;
        newest.shadow = std::move(publication.patches);
        out.add(std::move(newest));
    }
    while (!m_waiting.empty() && !m_waiting.front().needsShadow) out.add(takeOldest());
    post(out.take());
}

void Snapshots::publishWithoutShadow(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world,
                                     std::span<const Impact> impacts) {
    enqueue(changes, moved, world, impacts);
    SnapshotMerger out;
    while (!m_waiting.empty()) out.add(takeOldest());
    post(out.take());
}

std::optional<FrameSnapshot> Snapshots::take() {
    SnapshotMerger all;
    m_taken.clear();
    {
        const std::lock_guard lock(m_mutex);
        all = std::exchange(m_backlog, {});
        m_posted.swap(m_taken);
    }
    for (FrameSnapshot& snapshot : m_taken) all.add(std::move(snapshot));
    return all.take();
}

FrameSnapshot Snapshots::takeOldest() {
    FrameSnapshot oldest = std::move(m_waiting.front().snapshot);
    m_waiting.pop_front();
    return oldest;
}

void Snapshots::post(std::optional<FrameSnapshot> snapshot) {
    if (!snapshot) return;
    snapshot->newestStep = m_newestStep;
    const std::lock_guard lock(m_mutex);
    m_posted.push_back(std::move(*snapshot));
    if (m_posted.size() < kMaxPosted) return;
    for (FrameSnapshot& posted : m_posted) m_backlog.add(std::move(posted));
    m_posted.clear();
}

void Snapshots::enqueue(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world,
                        std::span<const Impact> impacts) {
    if (changes.levelReplaced) {
        m_waiting.clear();
        m_lastPoses.clear();
        m_moving.clear();
    }
    ++m_count;
    m_newestStep = changes.step;
    FrameSnapshot out;
    out.version = out.newestStep = changes.step;
    out.replacesAll = out.shadowReplacesAll = changes.levelReplaced;
    if (changes.levelReplaced || changes.materialsChanged)
        for (const Material& material : world.materials().materials) out.materials.push_back(material.name);
    m_palettes.update(changes, world);
    addCreated(changes, world, out);
    addChanged(changes, world, out);
    m_placed = changes.teleported;
    std::sort(m_placed.begin(), m_placed.end());
    addPoses(moved, world, out);
    const bool lightsChanged = updateLights(changes, moved, world);
    addParticles(changes, impacts, world, out);
    listLights(out, lightsChanged);
    if (changes.levelReplaced) m_ripples.clear();
    if (!changes.isStill) addRipples(moved, world, out);
    if (changes.levelReplaced) m_ropes.clear();
    if (!m_ropes.empty() || !world.data().jointIndex.ropes().empty()) addRopes(world, out);
    if (changes.levelReplaced || !changes.waters.empty()) {
        out.watersChanged = true;
        world.waters().forEach([&](WaterHandle, const Water& water) { out.waters.push_back(water); });
    }
    if (changes.levelReplaced || !m_environment || *m_environment != world.environment()) {
        out.environmentChanged = true;
        out.environment = world.environment();
        m_environment = world.environment();
    }
    const bool needsShadow = changesShadow(changes, moved);
    if (needsShadow || !showsNothing(out)) m_waiting.push_back({std::move(out), needsShadow});
}

void Snapshots::addCreated(const FrameChanges& changes, const World& world, FrameSnapshot& out) {
    const auto add = [&](ShapeHandle handle, const Shape& shape) {
        if (m_lastPoses.size() <= handle.slot()) m_lastPoses.resize(world.shapes().slotCount());
        m_lastPoses[handle.slot()] = {handle, shapeToWorld(world, handle), 0};
        out.created.push_back(describeShape(handle, shape, m_palettes.of(shape)));
    };
    if (changes.levelReplaced) return world.shapes().forEach(add);
    for (const ShapeHandle handle : changes.shapesCreated)
        if (const Shape* shape = world.shapes().find(handle)) add(handle, *shape);
    // The previous pose of a piece is that of its parent, so that it does not jump in its first step.
    for (const ShapeSplit& split : changes.splits)
        for (size_t i = 0; i < split.children.size(); ++i) {
            const Shape* child = world.shapes().find(split.children[i]);
            if (!child || m_lastPoses.size() <= split.parent.slot() ||
                m_lastPoses[split.parent.slot()].shape != split.parent)
                continue;
            const Pose offset{glm::dvec3(split.parentOffset[i]) * double(child->voxelSize)};
            m_lastPoses[split.children[i].slot()].pose = m_lastPoses[split.parent.slot()].pose * offset;
        }
}

void Snapshots::addChanged(const FrameChanges& changes, const World& world, FrameSnapshot& out) {
    if (changes.levelReplaced) return;
    out.destroyed = changes.shapesDestroyed;
    for (const BrickChange& brick : changes.bricks)
        if (world.shapes().find(brick.shape)) out.bricks.push_back(brick);
    for (const ShapeHandle handle : changes.palettes)
        if (const Shape* shape = world.shapes().find(handle))
            out.palettes.push_back({handle, m_palettes.of(*shape), shape->paintColors});
}

/// Whether an edit or undo has put a shape so far from where it was that nothing was in between.
bool Snapshots::hasJumped(ShapeHandle shape, const World& world, const Pose& from, const Pose& to) const {
    const BodyHandle handle = world.shapes().at(shape).body;
    if (!std::binary_search(m_placed.begin(), m_placed.end(), handle)) return false;
    const Body& body = world.bodies().at(handle);
    const double seconds = 1.0 / kStepsPerSecond;
    const glm::dvec3 at = body.pose.position, arm = to.position - at;
    const glm::dvec3 expected = (body.velocity + glm::cross(body.angularVelocity, arm)) * seconds;
    const double turn = 2.0 * std::acos(std::min(std::abs(glm::dot(from.rotation, to.rotation)), 1.0));
    return glm::distance(to.position - from.position, expected) > kJumpMetres ||
           turn > glm::length(body.angularVelocity) * seconds + kJumpRadians;
}

void Snapshots::addPose(ShapeHandle shape, const World& world, FrameSnapshot& out) {
    RUBBLE_ASSERT(shape.slot() < m_lastPoses.size() && m_lastPoses[shape.slot()].shape == shape &&
                  "a shape moved that was never created");
    LastPose& placed = m_lastPoses[shape.slot()];
    if (placed.listedIn == m_count) return;
    placed.listedIn = m_count;
    const Pose current = shapeToWorld(world, shape);
    if (!m_placed.empty() && hasJumped(shape, world, placed.pose, current)) placed.pose = current;
    out.poses.push_back({shape, placed.pose, current});
    if (placed.pose != current) m_moved.push_back(shape);
    placed.pose = current;
}

void Snapshots::addPoses(std::span<const BodyPose> moved, const World& world, FrameSnapshot& out) {
    m_moved.clear();
    out.poses.reserve(out.created.size() + moved.size() + m_moving.size());
    for (const SnapshotShape& created : out.created) addPose(created.shape, world, out);
    for (const BodyPose& pose : moved)
        if (const Body* body = world.bodies().find(pose.body))
            for (const ShapeHandle shape : body->shapes) addPose(shape, world, out);
    // Shapes that moved in the step before and not in this one have come to rest: their pose is listed once more.
    for (const ShapeHandle shape : m_moving)
        if (world.shapes().find(shape)) addPose(shape, world, out);
    std::swap(m_moving, m_moved);
}

void Snapshots::addParticles(const FrameChanges& changes, std::span<const Impact> impacts, const World& world,
                             FrameSnapshot& out) {
    const bool before = !m_particles.empty();
    m_particles.step(changes, impacts, m_fires, world);
    if (!before && m_particles.empty()) return;
    out.particlesChanged = true;
    out.particles = m_particles.snapshot();
}

void Snapshots::stepParticles(const FrameChanges& changes, std::span<const Impact> impacts, const World& world) {
    if (changes.firesChanged || changes.levelReplaced) m_fires = findFires(world);
    m_particles.step(changes, impacts, m_fires, world);
}

void Snapshots::addRipples(std::span<const BodyPose> moved, const World& world, FrameSnapshot& out) {
    const bool before = !m_ripples.empty();
    m_ripples.step(moved, world);
    if (!before && m_ripples.empty()) return;
    out.ripplesChanged = true;
    out.ripples = m_ripples.snapshot();
}

bool Snapshots::updateLights(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world) {
    const bool glowChanged = m_glow.update(changes, world, m_palettes);
    const bool listChanged =
        glowChanged || !changes.lights.empty() || !changes.groupsOut.empty() || changes.firesChanged;
    const auto carries = [&](const BodyPose& pose) {
        return std::binary_search(m_lightBodies.begin(), m_lightBodies.end(), pose.body);
    };
    if (!listChanged && (m_lightBodies.empty() || std::none_of(moved.begin(), moved.end(), carries))) return false;
    m_lights.clear();
    m_lightBodies.clear();
    world.lights().forEach([&](LightHandle handle, const Light& light) {
        if (const Shape* shape = world.shapes().find(light.shape)) m_lightBodies.push_back(shape->body);
        const LightGroup* group = world.lightGroups().find(light.group);
        if (!light.enabled || (group && (group->out || group->off || group->dark))) return;
        m_lights.push_back(describeLight(light, lightToWorld(world, light), handle));
    });
    m_glow.list(world, m_lights, m_lightBodies);
    std::sort(m_lightBodies.begin(), m_lightBodies.end());
    addFires(changes, world);
    return true;
}

void Snapshots::listLights(FrameSnapshot& out, bool worldChanged) {
    std::vector<SnapshotLight> glow;
    if (!m_particles.empty()) glow = m_particles.lights();
    if (!worldChanged && glow.empty() && !m_hadGlow) return;
    m_hadGlow = !glow.empty();
    out.lightsChanged = true;
    out.lights = m_lights;
    out.lights.insert(out.lights.end(), glow.begin(), glow.end());
}

/// Adds all ropes, if any of them moved in this step or the one before, or was created or removed.
void Snapshots::addRopes(const World& world, FrameSnapshot& out) {
    std::vector<SnapshotRope> ropes;
    bool changed = world.data().jointIndex.ropes().size() != m_ropes.size();
    for (const JointHandle handle : world.data().jointIndex.ropes()) {
        const Joint& joint = world.joints().at(handle);
        SnapshotRope& rope = ropes.emplace_back();
        rope.rope = handle;
        rope.radius = float(joint.rope.radius);
        rope.color = glm::vec3(joint.rope.color[0], joint.rope.color[1], joint.rope.color[2]) / 255.0f;
        for (const RopePoint& point : joint.points) rope.current.push_back(point.position);
        const auto last =
            std::find_if(m_ropes.begin(), m_ropes.end(), [&](const SnapshotRope& each) { return each.rope == handle; });
        const bool isKnown = last != m_ropes.end() && last->current.size() == rope.current.size();
        rope.previous = isKnown ? last->current : rope.current;
        changed = changed || !isKnown || rope.previous != rope.current || last->previous != last->current;
    }
    if (!changed) return;
    out.ropesChanged = true;
    out.ropes = ropes;
    m_ropes = std::move(ropes);
}

/// Finds what burns, for the particles, and adds flickering lights over the biggest fires.
void Snapshots::addFires(const FrameChanges& changes, const World& world) {
    const std::vector<Fire> fires = findFires(world);
    if (changes.firesChanged || changes.levelReplaced) m_fires = fires;
    for (const FireLight& light : fireLights(fires, changes.step, world.settings().fire.maxLights)) {
        const float strength = 6.0f * std::sqrt(light.intensity);
        const glm::dvec3 above = light.position + glm::dvec3(0.0, 0.5 * light.radius, 0.0);
        m_lights.push_back({LightKind::Sphere, above, {0, -1, 0}, kFireColor * strength, 1.2f, 4.0f + strength, 0, 0});
        m_lights.back().fleeting = true;
    }
}

}  // namespace rubble
