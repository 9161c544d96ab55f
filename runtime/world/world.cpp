#include "runtime/world/world.h"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <unordered_map>

#include "runtime/core/hash.h"
#include "runtime/core/log.h"
#include "runtime/destruction/wire.h"
#include "runtime/world/stages/edit_step.h"
#include "runtime/world/level/fit_lights.h"
#include "runtime/world/history/undo_history.h"

namespace rubble {
namespace {

/// The lowest layer of cells that holds anything, as a box over the whole grid.
CellBox bottomLayer(const VoxelGrid& grid) {
    int lowest = grid.size().y;
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        if (position.y * kBrickSize >= lowest) return;
        forEachVoxel(brick->occupancy,
                     [&](int i) { lowest = std::min(lowest, position.y * kBrickSize + voxelInBrick(i).y); });
    });
    return {{0, lowest, 0}, {grid.size().x, lowest + 1, grid.size().z}};
}

glm::dmat3 inertiaMatrix(const std::array<double, 6>& t) {
    return {t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2]};
}

/// Chains field after field into one hash.
struct Hasher {
    uint64_t state = 0;
    void add(uint64_t value) { state = hashValue(value, state); }
    void add(const glm::dvec3& v) { state = hashBytes(&v, sizeof v, state); }
    void add(const glm::dquat& q) { state = hashBytes(&q, sizeof q, state); }
    void add(const Pose& pose) {
        add(pose.position);
        add(pose.rotation);
    }
};

/// Of a shape's grid at a pose (grid corner -> world).
WorldBox boundsOf(const Shape& shape, const Pose& pose) {
    const glm::dvec3 half = glm::dvec3(shape.grid.size()) * (0.5 * shape.voxelSize);
    const glm::dmat3 axes = glm::mat3_cast(pose.rotation);
    const glm::dvec3 halfExtent = glm::abs(axes[0]) * half.x + glm::abs(axes[1]) * half.y + glm::abs(axes[2]) * half.z;
    const glm::dvec3 middle = pose.transformPoint(half);
    return {middle - halfExtent, middle + halfExtent};
}

}  // namespace

World::World(uint8_t id)
    : m_id(id),
      m_bodies(id),
      m_shapes(id),
      m_lights(id),
      m_groups(id),
      m_waters(id),
      m_triggers(id),
      m_characters(id),
      m_joints(id) {}
World::~World() = default;
World::World(const World&) = default;
World::World(World&&) noexcept = default;
World& World::operator=(const World&) = default;
World& World::operator=(World&&) noexcept = default;

void World::clear() {
    m_stress.reset();
    m_bodies.clear();
    m_shapes.clear();
    m_lights.clear();
    m_groups.clear();
    m_waters.clear();
    m_triggers.clear();
    m_characters.clear();
    m_joints.clear();
    m_jointIndex.clear();
    m_fire = {};
    m_shapeBounds.clear();
    m_triggerBounds.clear();
    m_movedBodies.clear();
    m_debris.clear();
    m_revived.clear();
    m_pendingSplits.clear();
    m_step = m_imported = m_removed = 0;
    m_flickeringGroups = 0;
    m_undo.clear();
    m_levelReplaced = true;
}

void World::load(const Level& level) {
    if (level.autoLightGroups) {
        Level fitted = level;
        fitLights(fitted);
        fitted.autoLightGroups = 0;
        return load(fitted);
    }
    clear();
    m_name = level.name;
    m_materials = level.materials;
    m_wire = m_materials.find("wire");
    m_locations = level.locations;
    setEnvironment(level.environment);
    for (const LightGroup& group : level.lightGroups) m_groups.insert(group);

    std::unordered_map<std::string, ShapeHandle> byName;
    const auto isHidden = [](const LevelShape& shape) { return shape.hidden; };  // kept in files, not part of the world
    for (const LevelBody& source : level.bodies) {
        if (!source.shapes.empty() && std::all_of(source.shapes.begin(), source.shapes.end(), isHidden)) continue;
        Body body{source.name, source.pose, source.velocity, source.angularVelocity, source.isStatic,
                  false,       {},          source.tags};
        body.asleep =
            !source.isStatic && source.velocity == glm::vec3(0.0f) && source.angularVelocity == glm::vec3(0.0f);
        const BodyHandle bodyHandle = m_bodies.insert(std::move(body));
        for (const LevelShape& from : source.shapes) {
            if (isHidden(from)) continue;
            Shape shape{from.name,        bodyHandle, from.local,   from.voxelSize, from.grid, from.palette,
                        from.paintColors, {},         from.anchors, from.tags,      false};
            shape.strength = from.strength;
            shape.loadBearing = from.loadBearing;
            shape.collisionLayer = from.collisionLayer;
            shape.collisionMask = from.collisionMask;
            if (!shape.palette) shape.palette = std::make_shared<const Palette>();
            if (source.isStatic && shape.anchors.empty()) shape.anchors = {bottomLayer(shape.grid)};
            shape.moments = gridMoments(shape.grid, *shape.palette, m_materials);
            m_imported += shape.grid.voxelCount();
            const ShapeHandle handle = m_shapes.insert(std::move(shape));
            m_bodies.at(bodyHandle).shapes.push_back(handle);
            updateShapeBounds(handle);
            byName.emplace(from.name, handle);
        }
    }
    countGroupVoxels();
    m_groups.forEach([&](LightGroupHandle, LightGroup& group) {
        const auto shape = byName.find(group.supplyShape);
        group.supply = group.supplyShape.empty() || shape == byName.end() ? ShapeHandle{} : shape->second;
    });
    connectPowerSupplies();
    for (const LevelLight& source : level.lights) {
        Light light = source.light;
        const auto shape = byName.find(source.shapeName);
        light.shape = source.shapeName.empty() || shape == byName.end() ? ShapeHandle{} : shape->second;
        m_groups.forEach([&](LightGroupHandle handle, const LightGroup& group) {
            if (!source.groupName.empty() && group.name == source.groupName) light.group = handle;
        });
        m_lights.insert(std::move(light));
    }
    for (const Water& water : level.waters) m_waters.insert(water);
    for (Trigger trigger : level.triggers) {
        trigger.inside.clear();
        m_triggers.insert(std::move(trigger));
    }
    for (Character character : level.characters) {
        character.ground = {};
        m_characters.insert(std::move(character));
    }
    for (const LevelJoint& source : level.joints) {
        Joint joint = source.joint;
        std::string error;
        for (size_t i = 0; i < 2; ++i) {
            const auto shape = byName.find(source.shapeNames[i]);
            joint.ends[i].shape = {};
            if (source.shapeNames[i].empty()) continue;
            if (shape == byName.end())
                error = "there is no shape '" + source.shapeNames[i] + "'";
            else
                joint.ends[i].shape = shape->second;
        }
        if (error.empty()) error = resolveJoint(joint);
        if (error.empty())
            addJoint(std::move(joint));
        else
            logWarning("joint '" + source.joint.name + "': " + error + ": it is left out");
    }
    EditStep::initTriggers(*this);
    restartStress();
}

/// A supply that leads nowhere from the start is none.
void World::connectPowerSupplies() {
    m_groups.forEach([&](LightGroupHandle handle, LightGroup& group) {
        if (!group.supply && group.supplyShape.empty()) return;
        if (!group.out && isPowered(handle, group)) return;
        if (!group.out)
            logWarning("light group '" + group.name + "': no wire leads from its supply to its voxels: it needs none");
        group.supply = {};
    });
}

bool World::isPowered(LightGroupHandle handle, const LightGroup& group) const {
    const Shape* shape = m_shapes.find(group.supply);
    if (!shape) return false;
    EntrySet wire{}, goal{};
    for (size_t i = 1; i < 256; ++i) {
        wire[i] = m_wire && (*shape->palette)[i].material == m_wire;
        goal[i] = (*shape->palette)[i].lightGroup == handle.slot() + 1;
    }
    return isWireConnected(shape->grid, group.supplyCell, wire, goal);
}

void World::countGroupVoxels() {
    if (m_groups.size() == 0) return;
    std::vector<uint64_t> counts(m_groups.slotCount());
    m_shapes.forEach([&](ShapeHandle, const Shape& shape) {
        const Palette& palette = *shape.palette;
        if (std::none_of(palette.begin(), palette.end(),
                         [](const PaletteEntry& entry) { return entry.lightGroup != 0; }))
            return;
        shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                const uint32_t group = palette[brick->at(i)].lightGroup;
                if (group && group <= counts.size()) ++counts[group - 1];
            });
        });
    });
    m_groups.forEach([&](LightGroupHandle handle, LightGroup& group) {
        if (group.initialVoxels == 0) group.initialVoxels = counts[handle.slot()];
    });
}

Level World::toLevel() const {
    Level level;
    level.name = m_name;
    level.materials = m_materials;
    level.environment = m_environment;
    level.locations = m_locations;
    std::vector<std::string> shapeNames(m_shapes.slotCount());
    m_bodies.forEach([&](BodyHandle, const Body& body) {
        LevelBody out{body.name, body.pose, body.isStatic, body.velocity, body.angularVelocity, {}, body.tags};
        for (const ShapeHandle handle : body.shapes) {
            const Shape& shape = m_shapes.at(handle);
            out.shapes.push_back({shape.name, shape.local, shape.voxelSize, shape.grid, shape.palette, shape.anchors,
                                  shape.tags, false, shape.paintColors, shape.strength, shape.loadBearing,
                                  shape.collisionLayer, shape.collisionMask});
            shapeNames[handle.slot()] = shape.name;
        }
        level.bodies.push_back(std::move(out));
    });
    std::vector<std::string> groupNames(m_groups.slotCount());
    m_groups.forEach([&](LightGroupHandle handle, const LightGroup& group) {
        groupNames[handle.slot()] = group.name;
        level.lightGroups.push_back(group);
    });
    m_lights.forEach([&](LightHandle, const Light& light) {
        LevelLight out{light, m_shapes.find(light.shape) ? shapeNames[light.shape.slot()] : "",
                       m_groups.find(light.group) ? groupNames[light.group.slot()] : ""};
        out.light.shape = {};
        out.light.group = {};
        level.lights.push_back(std::move(out));
    });
    m_waters.forEach([&](WaterHandle, const Water& water) { level.waters.push_back(water); });
    m_triggers.forEach([&](TriggerHandle, const Trigger& trigger) {
        level.triggers.push_back(trigger), level.triggers.back().inside.clear();
    });
    m_characters.forEach([&](CharacterHandle, const Character& each) {
        level.characters.push_back(each), level.characters.back().ground = {};
    });
    m_joints.forEach([&](JointHandle, const Joint& joint) {
        LevelJoint out{joint, {}};
        for (size_t i = 0; i < 2; ++i) {
            if (joint.ends[i].shape) out.shapeNames[i] = shapeNames[joint.ends[i].shape.slot()];
            out.joint.ends[i].shape = {};
        }
        level.joints.push_back(std::move(out));
    });
    return level;
}

void World::setEnvironment(Environment environment) {
    const float length = glm::length(environment.sunDirection);
    environment.sunDirection = length > 0.0f ? environment.sunDirection / length : glm::vec3(0.0f, 1.0f, 0.0f);
    swapEnvironment(environment);
}

Environment World::swapEnvironment(const Environment& environment) {
    if (m_stress && environment.gravity != m_environment.gravity) m_stress->restartAll();
    return std::exchange(m_environment, environment);
}

void World::setPoses(std::span<const BodyPose> poses) {
    for (const BodyPose& pose : poses)
        if (Body* body = m_bodies.find(pose.body)) {
            const bool turns = body->asleep != pose.asleep;
            body->pose = pose.pose;
            body->velocity = pose.velocity;
            body->angularVelocity = pose.angularVelocity;
            body->asleep = pose.asleep;
            for (const ShapeHandle shape : body->shapes) updateShapeBounds(shape);
            if (!turns) continue;
            body->restingSince = pose.asleep ? m_step : 0;
            if (body->settled) m_revived.push_back(pose.body);
            body->settled = false;
            updateDebris(pose.body);
        }
    if (m_triggers.size())
        for (const BodyPose& pose : poses) m_movedBodies.push_back(pose.body);
    for (UndoHistory& undo : m_undo) undo.recordMoves(*this, poses);
}

void World::setCharacters(std::span<const CharacterMove> moves) {
    for (const CharacterMove& move : moves)
        if (Character* character = m_characters.find(move.character)) {
            character->position = move.position;
            character->velocity = move.velocity;
            character->grounded = move.grounded;
            character->crouched = move.crouched;
            character->swimming = move.swimming;
            character->ground = move.ground;
            character->wantsJump = false;
        }
    for (UndoHistory& undo : m_undo) undo.recordMoves(*this, moves);
}

void World::updateDebris(BodyHandle handle) {
    const Body* body = m_bodies.find(handle);
    const Shape* shape = body && !body->isStatic && body->shapes.size() == 1 ? m_shapes.find(body->shapes[0]) : nullptr;
    if (!shape || !shape->isPiece || shape->grid.voxelCount() > m_settings.debris.largestPiece)
        return m_debris.remove(handle.slot());
    const RestState rest = body->settled ? RestState::Settled : body->asleep ? RestState::Asleep : RestState::Awake;
    m_debris.set({handle, rest, shape->grid.voxelCount(), body->createdStep, body->restingSince});
}

void World::setSettings(const WorldSettings& settings) {
    const bool stressChanged = !(settings.stress == m_settings.stress);
    m_settings = settings;
    if (stressChanged) restartStress();
    m_bodies.forEach(
        [&](BodyHandle handle, const Body&) { updateDebris(handle); });  // what counts as debris may be another now
}

/// Whether a step without edits has something to say or to do about debris.
bool World::hasDebrisWork() const {
    const DebrisSettings& limits = m_settings.debris;
    return !m_revived.empty() || m_debris.awakeCount() > limits.awakeBodies || m_debris.count() > limits.bodies ||
           m_debris.voxels() > limits.voxels ||
           (m_step >= limits.settleSteps && m_debris.asleepSince(m_step - limits.settleSteps));
}

void World::updateShapeBounds(ShapeHandle handle) {
    m_shapeBounds.update(handle.slot(), boundsOf(m_shapes.at(handle), shapeToWorld(handle)));
}

/// The tree's margins depend on how a shape came to where it is, so what it finds is looked at again: nothing that
/// happens next may depend on that.
std::vector<ShapeHandle> World::shapesNear(glm::dvec3 point, double radius) const {
    std::vector<ShapeHandle> out;
    if (!(radius >= 0.0)) return out;
    const WorldBox around{point - radius, point + radius};
    const auto visit = [&](uint32_t slot) {
        const ShapeHandle handle = m_shapes.handleAt(slot);
        if (boundsOf(m_shapes.at(handle), shapeToWorld(handle)).overlaps(around)) out.push_back(handle);
    };
    m_shapeBounds.find([&](const WorldBox& box) { return box.overlaps(around); }, visit);
    std::sort(out.begin(), out.end(), [](ShapeHandle a, ShapeHandle b) { return a.slot() < b.slot(); });
    return out;
}

Pose World::shapeToWorld(ShapeHandle handle) const {
    const Shape& shape = m_shapes.at(handle);
    return m_bodies.at(shape.body).pose * shape.local;
}

Pose World::lightToWorld(const Light& light) const {
    return m_shapes.find(light.shape) ? shapeToWorld(light.shape) * light.local : light.local;
}

MassProperties World::bodyMass(BodyHandle handle) const {
    const Body& body = m_bodies.at(handle);
    if (body.shapes.size() == 1)  // as all pieces are
        if (const Shape& only = m_shapes.at(body.shapes[0]); only.local == Pose{})
            return massProperties(only.moments, only.voxelSize);
    MassProperties sum;
    std::vector<std::pair<const Shape*, MassProperties>> parts;
    parts.reserve(body.shapes.size());
    for (const ShapeHandle shapeHandle : body.shapes) {
        const Shape& shape = m_shapes.at(shapeHandle);
        parts.emplace_back(&shape, massProperties(shape.moments, shape.voxelSize));
        sum.mass += parts.back().second.mass;
        sum.center += parts.back().second.mass * shape.local.transformPoint(parts.back().second.center);
    }
    if (sum.mass <= 0.0) return sum;
    sum.center /= sum.mass;
    glm::dmat3 inertia(0.0);
    for (const auto& [shape, part] : parts) {
        const glm::dmat3 rotation = glm::mat3_cast(shape->local.rotation);
        const glm::dvec3 r = shape->local.transformPoint(part.center) - sum.center;
        inertia += rotation * inertiaMatrix(part.inertia) * glm::transpose(rotation);
        inertia += part.mass * (glm::dmat3(glm::dot(r, r)) - glm::outerProduct(r, r));  // parallel axes
    }
    sum.inertia = {inertia[0][0], inertia[1][1], inertia[2][2], inertia[1][0], inertia[2][1], inertia[2][0]};
    principalAxes(sum.inertia, sum.principalInertia, sum.principalAxes);
    return sum;
}

VoxelAccounting World::voxelAccounting() const {
    VoxelAccounting ledger{m_imported, 0, 0, m_removed};
    m_shapes.forEach([&](ShapeHandle, const Shape& shape) {
        (shape.isPiece ? ledger.inPieces : ledger.standing) += shape.grid.voxelCount();
    });
    return ledger;
}

uint64_t World::hash() const {
    uint64_t hash = hashValue(m_step, resolvedHash());
    if (m_fire.isActive()) hash = hashValue(m_fire.hash(), hash);
    for (const JointHandle rope : m_jointIndex.ropes()) hash = hashRopePoints(m_joints.at(rope), hash);
    for (const PendingSplit& pending : m_pendingSplits) {
        hash = hashValue(pending.shape.slot(), hashValue(pending.search ? pending.search->visitedParts() : 0, hash));
        pending.cut.forEachNode([&](glm::ivec3 node, BrickMask bricks) {
            hash = hashValue(uint64_t(node.x) | uint64_t(node.y) << 20 | uint64_t(node.z) << 40, hash);
            hash = hashValue(bricks, hash);
        });
    }
    return m_stress ? hashValue(m_stress->hash(), hash) : hash;
}

uint64_t World::voxelHash() const {
    Hasher hasher;
    m_shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        hasher.add(handle.slot());
        hasher.add(shape.grid.contentHash());
        hasher.add(hashPalette(*shape.palette));
        if (shape.paintColors) hasher.add(hashBytes(shape.paintColors.get(), sizeof(PaintColors)));
    });
    m_groups.forEach(
        [&](LightGroupHandle, const LightGroup& group) { hasher.add(group.removedVoxels << 1 | uint64_t(group.out)); });
    return hasher.state;
}

uint64_t World::resolvedHash() const {
    Hasher hasher;
    m_bodies.forEach([&](BodyHandle handle, const Body& body) {
        hasher.add(handle.slot());
        hasher.add(body.pose);
        hasher.add(body.velocity);
        hasher.add(body.angularVelocity);
        hasher.add(uint64_t(body.settled) << 2 | uint64_t(body.isStatic) << 1 | uint64_t(body.asleep));
        hasher.add(body.createdStep);
        hasher.add(body.restingSince);
    });
    const Palette* lastPalette = nullptr;
    uint64_t paletteHash = 0;
    m_shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        if (shape.palette.get() != lastPalette) {
            lastPalette = shape.palette.get();
            paletteHash = hashPalette(*shape.palette);
        }
        hasher.add(handle.slot());
        hasher.add(shape.body.slot());
        hasher.add(shape.local);
        hasher.add(shape.grid.contentHash());
        hasher.add(paletteHash);
        hasher.add(uint64_t(shape.collisionLayer) << 8 | shape.collisionMask);
        if (shape.paintColors) hasher.add(hashBytes(shape.paintColors.get(), sizeof(PaintColors)));
    });
    m_groups.forEach([&](LightGroupHandle handle, const LightGroup& group) {
        hasher.add(handle.slot());
        hasher.add(group.removedVoxels << 1 | uint64_t(group.out));
        hasher.add(group.failingSince << 1 | uint64_t(group.dark));
    });
    const auto addAll = [&](const auto& map) {
        map.forEach([&](auto handle, const auto& value) {
            hasher.add(handle.slot());
            hasher.add(value.hash());
        });
    };
    addAll(m_lights);
    addAll(m_waters);
    addAll(m_triggers);
    addAll(m_characters);
    hasher.add(m_environment.hash());
    m_joints.forEach([&](JointHandle handle, const Joint& joint) {
        hasher.state = hashJoint(joint, hashValue(handle.slot(), hasher.state));
    });
    return hasher.state;
}

}  // namespace rubble
