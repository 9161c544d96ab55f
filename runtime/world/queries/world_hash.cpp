#include "runtime/world/queries/world_hash.h"

#include "runtime/core/hash.h"
#include "runtime/core/planted_fault.h"

namespace rubble {
namespace {

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

/// Hashes of palettes, of which most follow an equal one.
class PaletteHash {
public:
    uint64_t of(const Palette& palette) {
        if (&palette != m_last) m_hash = hashPalette(palette);
        m_last = &palette;
        return m_hash;
    }

private:
    const Palette* m_last = nullptr;
    uint64_t m_hash = 0;
};

}  // namespace

uint64_t stateHash(const WorldData& world) {
    uint64_t hash = hashValue(world.step, resolvedHash(world));
    if (world.fire.isActive()) hash = hashValue(world.fire.hash(), hash);
    for (const JointHandle rope : world.jointIndex.ropes()) hash = hashRopePoints(world.joints.at(rope), hash);
    for (const PendingSplit& pending : world.pendingSplits) {
        hash = hashValue(pending.shape.slot(), hashValue(pending.search ? pending.search->visitedParts() : 0, hash));
        pending.cut.forEachNode([&](glm::ivec3 node, BrickMask bricks) {
            hash = hashValue(uint64_t(node.x) | uint64_t(node.y) << 20 | uint64_t(node.z) << 40, hash);
            hash = hashValue(bricks, hash);
        });
    }
    return world.stress ? hashValue(world.stress->hash(), hash) : hash;
}

uint64_t voxelHash(const WorldState& world) {
    Hasher hasher;
    PaletteHash palettes;
    world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        hasher.add(handle.slot());
        hasher.add(shape.grid.contentHash());
        hasher.add(palettes.of(*shape.palette));
        if (shape.paintColors) hasher.add(hashBytes(shape.paintColors.get(), sizeof(PaintColors)));
    });
    world.groups.forEach(
        [&](LightGroupHandle, const LightGroup& group) { hasher.add(group.removedVoxels << 1 | uint64_t(group.out)); });
    return hasher.state;
}

uint64_t resolvedHash(const WorldState& world) {
    Hasher hasher;
    world.bodies.forEach([&](BodyHandle handle, const Body& body) {
        hasher.add(handle.slot());
        hasher.add(body.pose);
        hasher.add(body.velocity);
        hasher.add(body.angularVelocity);
        hasher.add(uint64_t(body.waitsToWake) << 4 | uint64_t(body.broken) << 3 | uint64_t(body.settled) << 2 |
                   uint64_t(body.isStatic) << 1 | uint64_t(body.asleep));
        hasher.add(body.createdStep);
        hasher.add(body.restingSince);
        hasher.add(glm::dvec3(body.gravityScale, body.linearDamping, body.angularDamping));
    });
    PaletteHash palettes;
    world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        hasher.add(handle.slot());
        hasher.add(shape.body.slot());
        hasher.add(shape.local);
        hasher.add(glm::dvec3(shape.grid.size()));
        hasher.add(shape.grid.contentHash());
        hasher.add(palettes.of(*shape.palette));
        hasher.add(glm::dvec3(isPlanted("unhashed-field") ? 0.0f : shape.strength, shape.density, shape.emission));
        hasher.add(double(shape.voxelSize));
        hasher.state = hashBytes(shape.anchors.data(), shape.anchors.size() * sizeof(CellBox), hasher.state);
        hasher.add(uint64_t(shape.isPiece) << 25 | uint64_t(shape.loadBearing) << 24 |
                   uint64_t(shape.collisionShape) << 16 | uint64_t(shape.collisionLayer) << 8 | shape.collisionMask);
        if (shape.paintColors) hasher.add(hashBytes(shape.paintColors.get(), sizeof(PaintColors)));
    });
    world.groups.forEach([&](LightGroupHandle handle, const LightGroup& group) {
        hasher.add(handle.slot());
        hasher.add(group.removedVoxels << 1 | uint64_t(group.out));
        hasher.add(group.initialVoxels);
        hasher.add(group.failingSince << 2 | uint64_t(group.off) << 1 | uint64_t(group.dark));
        hasher.add(uint64_t(group.supply.slot()) << 32 | uint64_t(bool(group.supply)));
        hasher.state = hashBytes(&group.supplyCell, sizeof group.supplyCell, hasher.state);
        hasher.add(glm::dvec3(group.threshold));
        hasher.add(uint64_t(group.flickerSteps));
    });
    const auto addAll = [&](const auto& map) {
        map.forEach([&](auto handle, const auto& value) {
            hasher.add(handle.slot());
            hasher.add(value.hash());
        });
    };
    addAll(world.lights);
    addAll(world.waters);
    addAll(world.triggers);
    addAll(world.characters);
    addAll(world.notes);
    hasher.add(world.environment.hash());
    hasher.add(world.materials.hash());
    hasher.add(world.settings.hash());
    for (const WorldBox* box : {&world.bounds, &world.footprint, &world.made}) {
        hasher.add(box->low);
        hasher.add(box->high);
    }
    world.joints.forEach([&](JointHandle handle, const Joint& joint) {
        hasher.state = hashJoint(joint, hashValue(handle.slot(), hasher.state));
    });
    return hasher.state;
}

}  // namespace rubble
