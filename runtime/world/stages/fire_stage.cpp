#include "runtime/world/stages/fire_stage.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/core/random.h"
#include "runtime/destruction/spray.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/queries/query.h"
#include "runtime/world/stages/entry_counts.h"
#include "runtime/world/stages/paint_edits.h"
#include "runtime/world/stages/stress_stage.h"

namespace rubble {
namespace {

constexpr Srgb kCharColor = {22, 19, 17};
constexpr uint8_t kCharStrength = 44;     ///< of 255, for each update that chars
constexpr int kRadiationInterval = 5;     ///< updates of a brick between two radiations to other shapes
constexpr double kRadiationRadius = 1.1;  ///< metres
constexpr double kRadiatedShare = 0.12;   ///< of the heat that a fire emits
constexpr uint32_t kWetSeconds = 20;      ///< that bricks stay wet after they were under water
constexpr double kFlameHeight = 0.3;      ///< metres above a fire, around which it radiates

/// Calls f(brick) for the non-empty bricks of a grid that may have a cell within `radiusCells` of a point in cells.
template <class F>
void forEachBrickNear(const VoxelGrid& grid, glm::dvec3 point, double radiusCells, F&& f) {
    const CellBox range = brushBricks(sphereBrush(point, {radiusCells, radiusCells, radiusCells}), grid.sizeInBricks());
    for (int z = range.low.z; z < range.high.z; ++z)
        for (int y = range.low.y; y < range.high.y; ++y)
            for (int x = range.low.x; x < range.high.x; ++x)
                if (grid.brickAt({x, y, z})) f(glm::ivec3(x, y, z));
}

glm::dvec3 brickMiddle(glm::ivec3 brick) {
    return glm::dvec3(brick * kBrickSize) + 0.5 * kBrickSize;
}

}  // namespace

void FireStage::apply(const HeatEdit& edit) {
    if (!m_context.world.settings.fire.enabled) return;
    if (edit.shape && !m_context.world.shapes.find(edit.shape))
        return m_context.warnStale("heat: the handle of its shape is stale; nothing was heated");
    const std::vector<ShapeHandle> shapes =
        edit.shape ? std::vector{edit.shape} : shapesNear(m_context.world, edit.position, edit.radius);
    struct Target {
        ShapeHandle shape;
        glm::ivec3 brick;
        int64_t cells;
    };
    std::vector<Target> targets;
    int64_t sum = 0;
    for (const ShapeHandle handle : shapes) {
        const Shape& shape = m_context.world.shapes.at(handle);
        const glm::dvec3 center =
            shapeToWorld(m_context.world, handle).inversePoint(edit.position) / double(shape.voxelSize);
        const double radiusCells = edit.radius / shape.voxelSize;
        const Brush brush = sphereBrush(center, {radiusCells, radiusCells, radiusCells});
        forEachBrickNear(shape.grid, center, radiusCells, [&](glm::ivec3 brick) {
            BrickBits cells = brushBits(brush, brick, brush.radii[0]);
            const BrickBits exposed = exposedBits(shape.grid, brick, *shape.grid.brickAt(brick)).all();
            int64_t count = 0;
            for (size_t i = 0; i < 8; ++i) count += std::popcount(cells[i] & exposed[i]);
            if (count > 0) targets.push_back({handle, brick, count});
            sum += count;
        });
    }
    for (const Target& target : targets) {
        HotBrick* hot = depositHeat({target.shape, target.brick, int64_t(edit.joules * 1000.0) / sum * target.cells});
        if (hot && edit.ignite) igniteBrick(target.shape, *hot);
    }
}

/// Adds heat to a brick; a wet one takes none. Null if FireSettings::maxHot bricks are hot already.
HotBrick* FireStage::depositHeat(const Deposit& deposit) {
    const FireSettings& settings = m_context.world.settings.fire;
    HotBrick* hot = m_context.world.fire.findOrAdd(deposit.shape, deposit.brick, settings.maxHot);
    if (!hot) {
        ++m_context.changes.heatLost;
        if (!std::exchange(m_context.world.fire.hasLoggedFull, true))
            logWarning("fire: " + std::to_string(settings.maxHot) +
                       " bricks are hot, the heat of others is lost; to keep more, raise max_hot of the settings");
        return nullptr;
    }
    if (hot->wet == 0) hot->heat = std::min(hot->heat + deposit.heat, kMaxHeat);
    return hot;
}

void FireStage::igniteBrick(ShapeHandle handle, HotBrick& hot) {
    FireState& fire = m_context.world.fire;
    const uint32_t limit = m_context.world.settings.fire.maxFires;
    const Shape& shape = m_context.world.shapes.at(handle);
    if (hot.burningFor || hot.wet || !heatSkin(shape.grid, hot.brick, heatTable(handle)).ignition) return;
    if (fire.burning >= limit) {
        ++m_context.changes.firesRefused;
        if (!std::exchange(fire.hasLoggedFull, true))
            logWarning("fire: " + std::to_string(limit) +
                       " bricks burn and no more will; to allow more, raise max_fires of the settings");
        return;
    }
    ignite(hot);
    ++fire.burning;
    m_context.changes.firesLit.push_back({handle, hot.brick, brickInWorld(handle, hot.brick)});
}

void FireStage::apply(const ExtinguishEdit& edit) {
    // The first update may come at once.
    const uint32_t wet = edit.wetSeconds > 0.0 ? uint32_t(std::ceil(edit.wetSeconds * kHeatUpdatesPerSecond)) + 1 : 0;
    FireState& fire = m_context.world.fire;
    if (wet == 0 && !fire.isActive()) return;
    for (const ShapeHandle handle : shapesNear(m_context.world, edit.position, edit.radius)) {
        const Shape& shape = m_context.world.shapes.at(handle);
        const glm::dvec3 center =
            shapeToWorld(m_context.world, handle).inversePoint(edit.position) / double(shape.voxelSize);
        forEachBrickNear(shape.grid, center, edit.radius / shape.voxelSize, [&](glm::ivec3 brick) {
            HotBrick* hot =
                wet ? fire.findOrAdd(handle, brick, m_context.world.settings.fire.maxHot) : fire.find(handle, brick);
            if (hot) extinguishBrick(handle, *hot, wet);
        });
    }
}

void FireStage::apply(const RemoveFiresEdit& edit) {
    for (HeatField& field : m_context.world.fire.fields)
        for (HotBrick& hot : field.bricks) {
            if (!hot.burningFor || !m_context.world.shapes.find(field.shape)) continue;
            const glm::dvec3 at = brickInWorld(field.shape, hot.brick);
            if (glm::all(glm::lessThanEqual(edit.low, at)) && glm::all(glm::lessThanEqual(at, edit.high)))
                extinguishBrick(field.shape, hot, 0);
        }
}

void FireStage::extinguishBrick(ShapeHandle shape, HotBrick& hot, uint32_t wet) {
    if (hot.burningFor) m_context.changes.firesOut.push_back({shape, hot.brick, brickInWorld(shape, hot.brick)});
    extinguish(hot, wet);
}

glm::dvec3 FireStage::brickInWorld(ShapeHandle handle, glm::ivec3 brick) const {
    return shapeToWorld(m_context.world, handle)
        .transformPoint(brickMiddle(brick) * double(m_context.world.shapes.at(handle).voxelSize));
}

/// The heat table of the shape's palette as it is now. Kept until another palette or voxel size is asked for.
const HeatTable& FireStage::heatTable(ShapeHandle handle) {
    const Shape& shape = m_context.world.shapes.at(handle);
    if (m_heatTablePalette != shape.palette || m_heatTableVoxelSize != shape.voxelSize) {
        m_heatTable = makeHeatTable(*shape.palette, m_context.world.materials, double(shape.voxelSize),
                                    double(m_context.world.settings.fire.burnTime));
        m_heatTablePalette = shape.palette;
        m_heatTableVoxelSize = shape.voxelSize;
    }
    return m_heatTable;
}

void FireStage::update() {
    FireState& fire = m_context.world.fire;
    if (!fire.isActive()) return;
    m_context.changes.firesChanged = fire.burning > 0 || !m_context.changes.firesOut.empty();
    if (!m_context.world.settings.fire.enabled)
        for (HeatField& field : fire.fields)
            for (HotBrick& hot : field.bricks) extinguishBrick(field.shape, hot, 0);
    if (m_context.world.waters.size()) extinguishUnderWater();
    fire.compact();
    for (HeatField& field : fire.fields) updateHeatField(field);
    for (const Deposit& deposit : m_deposits) depositHeat(deposit);
    m_deposits.clear();
    fire.compact();
}

void FireStage::updateHeatField(HeatField& field) {
    const ShapeHandle handle = field.shape;
    std::vector<BrickSubset> charred, consumed;
    std::erase_if(field.bricks, [&](HotBrick& hot) {
        const uint32_t turn = hashCell(hot.brick.x, hot.brick.y, hot.brick.z);
        if ((m_context.changes.step + turn) % kHeatInterval != 0) return false;
        const Shape& shape = m_context.world.shapes.at(handle);
        const HeatSkin skin = heatSkin(shape.grid, hot.brick, heatTable(handle));
        const HeatOutcome outcome = updateHeat(hot, skin);
        if (outcome.wantsToBurn) igniteBrick(handle, hot);
        if (outcome.wentOut) m_context.changes.firesOut.push_back({handle, hot.brick, brickInWorld(handle, hot.brick)});
        if (outcome.chars) charred.push_back({hot.brick, charredCells(skin, hot.brick, hot.charred)});
        if (outcome.consumed)
            consumed.push_back({hot.brick, consumedCells(shape.grid, hot.brick, skin, outcome.consumed)});
        if (m_context.world.stress) weakenBrick(m_context, handle, hot.brick, remainingStrength(hot, skin));
        if (outcome.emitted) emitHeat(handle, hot, outcome.emitted);
        return outcome.isOver || !shape.grid.brickAt(hot.brick);
    });
    m_context.changes.firesChanged |= !m_context.changes.firesLit.empty() || !m_context.changes.firesOut.empty();
    if (!charred.empty())
        paintCells(m_context, handle, charred,
                   {.color = kCharColor, .strength = kCharStrength, .seed = uint32_t(m_context.changes.step)});
    if (!consumed.empty()) removeBurnedCells(handle, consumed);
}

/// Conducts heat to the neighbouring bricks of the shape and, at intervals, radiates to the bricks of other shapes
/// nearby.
void FireStage::emitHeat(ShapeHandle handle, const HotBrick& hot, int64_t emitted) {
    emitted = int64_t(double(emitted) * std::clamp(double(m_context.world.settings.fire.spread), 0.0, 100.0));
    m_neighbors.clear();
    spreadHeat(m_context.world.shapes.at(handle).grid, hot.brick, emitted, m_neighbors);
    for (const HeatDeposit& each : m_neighbors) m_deposits.push_back({handle, each.brick, each.heat});
    if (hot.burningFor % kRadiationInterval) return;
    const glm::dvec3 from = brickInWorld(handle, hot.brick);
    for (const ShapeHandle other :
         shapesNear(m_context.world, from + glm::dvec3(0.0, kFlameHeight, 0.0), kRadiationRadius)) {
        if (other == handle) continue;
        const Shape& shape = m_context.world.shapes.at(other);
        const Pose pose = shapeToWorld(m_context.world, other);
        const glm::dvec3 center = pose.inversePoint(from) / double(shape.voxelSize);
        forEachBrickNear(shape.grid, center, kRadiationRadius / shape.voxelSize, [&](glm::ivec3 brick) {
            const glm::dvec3 away = pose.transformPoint(brickMiddle(brick) * double(shape.voxelSize)) - from;
            const double distance2 = glm::dot(away, away) / (kRadiationRadius * kRadiationRadius);
            const double upwards = std::clamp(0.5 + away.y / (2.0 * kRadiationRadius), 0.1, 1.0);
            m_deposits.push_back(
                {other, brick,
                 int64_t(double(emitted) * kRadiationInterval * kRadiatedShare * upwards / (1.0 + 4.0 * distance2))});
        });
    }
}

void FireStage::removeBurnedCells(ShapeHandle handle, const std::vector<BrickSubset>& cells) {
    Shape& shape = m_context.world.shapes.at(handle);
    m_context.recordMotion(shape.body);
    const Densities densities(*shape.palette, m_context.world.materials);
    const glm::vec3 velocity(m_context.world.bodies.at(shape.body).velocity);
    for (const BrickSubset& subset : cells) {
        const BrickRef brick = shape.grid.shareBrick(subset.brick);
        EntryCounts removed{};
        BrickBits keep;
        for (size_t i = 0; i < 8; ++i) keep[i] = brick->occupancy[i] & ~subset.voxels[i];
        forEachVoxel(subset.voxels, [&](int i) { ++removed[brick->at(i)]; });
        shape.moments -= brickMoments(*brick, subset.voxels, subset.brick, densities);
        shape.grid.setBrick(subset.brick, maskBrick(*brick, keep));
        m_context.recordRemoved(handle, removed, {brickInWorld(handle, subset.brick), 4.0 * shape.voxelSize, velocity});
        ShapeEditState& each = m_context.editState(handle);
        each.carved.insert(subset.brick);
        each.lost = joined(each.lost, voxelBounds(subset.brick, subset.voxels));
    }
}

/// Bricks under water go out and get wet.
void FireStage::extinguishUnderWater() {
    for (HeatField& field : m_context.world.fire.fields)
        for (HotBrick& hot : field.bricks) {
            if (!m_context.world.shapes.find(field.shape)) continue;
            const glm::dvec3 at = brickInWorld(field.shape, hot.brick);
            m_context.world.waters.forEach([&](WaterHandle, const Water& water) {
                if (water.contains(at)) extinguishBrick(field.shape, hot, kWetSeconds * kHeatUpdatesPerSecond);
            });
        }
}

}  // namespace rubble
