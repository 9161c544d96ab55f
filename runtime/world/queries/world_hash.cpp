#include "runtime/world/queries/world_hash.h"

#include "runtime/core/hash.h"
#include "runtime/world/objects/state_hash.h"

namespace rubble {
namespace {

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
    StateHasher hasher;
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
    StateHasher hasher;
    const auto addAll = [&](const auto& map) {
        map.forEach([&](auto handle, const auto& value) {
            hasher.add(handle.slot());
            hasher.state = hashState(value, hasher.state);
        });
    };
    addAll(world.bodies);
    PaletteHash palettes;
    world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        hasher.add(handle.slot());
        hasher.state = hashState(shape, palettes.of(*shape.palette), hasher.state);
    });
    addAll(world.groups);
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
    addAll(world.joints);
    return hashScripts(world.scripts, hasher.state);
}

}  // namespace rubble
