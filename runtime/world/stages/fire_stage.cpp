#include <algorithm>
#include <cmath>

#include "runtime/core/log.h"
#include "runtime/core/number_range.h"
#include "runtime/core/random.h"
#include "runtime/destruction/spray.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {
namespace {

constexpr Srgb kChar = {22, 19, 17};
constexpr uint8_t kCharStrength = 44;     // of 255 in a round
constexpr int kRadiationInterval = 5;     // updates between two looks for other shapes near a fire
constexpr double kRadiationRadius = 1.1;  // metres to other shapes
constexpr double kRadiatedShare = 0.12;   // share of what a fire emits that reaches them

constexpr double kMaxCoordinate = 1e30;  // metres: of what is a number at all

/// f(brick) for the bricks of a grid that are there and may be within radiusCells of a point, in cells.
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

void EditStep::apply(const HeatEdit& edit) {
    if (!isWithin(edit.position, kMaxCoordinate) || !(edit.radius > 0.0 && edit.radius < 1e6) ||
        !(edit.joules >= 0.0 && edit.joules < 1e15))
        return logWarning(
            "HeatEdit: expected finite numbers, a radius above zero and joules of zero or more; nothing was heated");
    if (!m_world.m_settings.fire.enabled) return;
    if (edit.shape && !m_world.m_shapes.find(edit.shape))
        return logWarning("HeatEdit: the handle of its shape is stale; nothing was heated");
    const std::vector<ShapeHandle> shapes =
        edit.shape ? std::vector{edit.shape} : m_world.shapesNear(edit.position, edit.radius);
    struct Target {
        ShapeHandle shape;
        glm::ivec3 brick;
        int64_t cells;
    };
    std::vector<Target> targets;
    int64_t sum = 0;
    for (const ShapeHandle handle : shapes) {
        const Shape& shape = m_world.m_shapes.at(handle);
        const glm::dvec3 center = m_world.shapeToWorld(handle).inversePoint(edit.position) / double(shape.voxelSize);
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

/// Nothing that is wet gets hot. Null if there is no room for one more.
HotBrick* EditStep::depositHeat(const Deposit& deposit) {
    const FireSettings& settings = m_world.m_settings.fire;
    HotBrick* hot = m_world.m_fire.findOrAdd(deposit.shape, deposit.brick, settings.maxHot);
    if (!hot) {
        ++m_changes.heatLost;
        if (!std::exchange(m_world.m_fire.hasLoggedFull, true))
            logWarning("fire: " + std::to_string(settings.maxHot) +
                       " bricks are hot, more do not get hot; raise FireSettings::maxHot");
        return nullptr;
    }
    if (hot->wet == 0) hot->heat = std::min(hot->heat + deposit.heat, int64_t(1) << 56);
    return hot;
}

void EditStep::igniteBrick(ShapeHandle handle, HotBrick& hot) {
    FireState& fire = m_world.m_fire;
    const uint32_t limit = m_world.m_settings.fire.maxFires;
    const Shape& shape = m_world.m_shapes.at(handle);
    if (hot.burningFor || hot.wet || !heatSkin(shape.grid, hot.brick, heatTable(handle)).ignition) return;
    if (fire.burning >= limit) {
        ++m_changes.firesRefused;
        if (!std::exchange(fire.hasLoggedFull, true))
            logWarning("fire: " + std::to_string(limit) +
                       " bricks updateFires, more do not; raise FireSettings::maxFires");
        return;
    }
    ignite(hot);
    ++fire.burning;
    m_changes.firesLit.push_back({handle, hot.brick, brickInWorld(handle, hot.brick)});
}

void EditStep::apply(const ExtinguishEdit& edit) {
    if (!isWithin(edit.position, kMaxCoordinate) || !(edit.radius > 0.0 && edit.radius < 1e6) ||
        !(edit.wetSeconds >= 0.0 && edit.wetSeconds <= 6000.0))
        return logWarning(
            "ExtinguishEdit: expected finite numbers, a radius above zero and 0 to 6000 seconds; nothing was put out");
    const uint32_t wet = uint32_t(edit.wetSeconds * kHeatUpdatesPerSecond);
    FireState& fire = m_world.m_fire;
    if (wet == 0 && !fire.isActive()) return;
    for (const ShapeHandle handle : m_world.shapesNear(edit.position, edit.radius)) {
        const Shape& shape = m_world.m_shapes.at(handle);
        const glm::dvec3 center = m_world.shapeToWorld(handle).inversePoint(edit.position) / double(shape.voxelSize);
        forEachBrickNear(shape.grid, center, edit.radius / shape.voxelSize, [&](glm::ivec3 brick) {
            HotBrick* hot =
                wet ? fire.findOrAdd(handle, brick, m_world.m_settings.fire.maxHot) : fire.find(handle, brick);
            if (hot) extinguishBrick(handle, *hot, wet);
        });
    }
}

void EditStep::apply(const RemoveFiresEdit& edit) {
    if (!isWithin(edit.low, kMaxCoordinate) || !isWithin(edit.high, kMaxCoordinate))
        return logWarning("RemoveFiresEdit: expected finite numbers; nothing was put out");
    for (HeatField& field : m_world.m_fire.fields)
        for (HotBrick& hot : field.bricks) {
            if (!hot.burningFor || !m_world.m_shapes.find(field.shape)) continue;
            const glm::dvec3 at = brickInWorld(field.shape, hot.brick);
            if (glm::all(glm::lessThanEqual(edit.low, at)) && glm::all(glm::lessThanEqual(at, edit.high)))
                extinguishBrick(field.shape, hot, 0);
        }
}

void EditStep::extinguishBrick(ShapeHandle shape, HotBrick& hot, uint32_t wet) {
    if (hot.burningFor) m_changes.firesOut.push_back({shape, hot.brick, brickInWorld(shape, hot.brick)});
    extinguish(hot, wet);
}

glm::dvec3 EditStep::brickInWorld(ShapeHandle handle, glm::ivec3 brick) const {
    return m_world.shapeToWorld(handle).transformPoint(brickMiddle(brick) *
                                                       double(m_world.m_shapes.at(handle).voxelSize));
}

/// Of the shape's present palette; kept for the step, or until it is asked for another shape.
const HeatTable& EditStep::heatTable(ShapeHandle handle) {
    const Shape& shape = m_world.m_shapes.at(handle);
    if (m_heatTableOf != shape.palette || m_heatTableSize != shape.voxelSize) {
        m_heatTable = makeHeatTable(*shape.palette, m_world.m_materials, double(shape.voxelSize),
                                    double(m_world.m_settings.fire.burnTime));
        m_heatTableOf = shape.palette;
        m_heatTableSize = shape.voxelSize;
    }
    return m_heatTable;
}

/// One step of all that is hot: a sixth of the bricks is updated, each brick every kHeatInterval steps.
void EditStep::updateFires() {
    FireState& fire = m_world.m_fire;
    if (!fire.isActive()) return;
    m_changes.firesChanged = fire.burning > 0 || !m_changes.firesOut.empty();
    if (!m_world.m_settings.fire.enabled)
        for (HeatField& field : fire.fields)
            for (HotBrick& hot : field.bricks) extinguishBrick(field.shape, hot, 0);
    if (m_world.m_waters.size()) extinguishUnderWater();
    fire.compact();
    for (HeatField& field : fire.fields) updateHeatField(field);
    for (const Deposit& deposit : m_deposits) depositHeat(deposit);
    m_deposits.clear();
    fire.compact();
}

void EditStep::updateHeatField(HeatField& field) {
    const ShapeHandle handle = field.shape;
    std::vector<BrickSubset> charred, consumed;
    std::erase_if(field.bricks, [&](HotBrick& hot) {
        const uint32_t turn = hashCell(hot.brick.x, hot.brick.y, hot.brick.z);
        if ((m_changes.step + turn) % kHeatInterval != 0) return false;
        const Shape& shape = m_world.m_shapes.at(handle);
        const HeatSkin skin = heatSkin(shape.grid, hot.brick, heatTable(handle));
        const HeatOutcome outcome = updateHeat(hot, skin);
        if (outcome.wantsToBurn) igniteBrick(handle, hot);
        if (outcome.wentOut) m_changes.firesOut.push_back({handle, hot.brick, brickInWorld(handle, hot.brick)});
        if (outcome.chars) charred.push_back({hot.brick, charredCells(skin, hot.brick, hot.charred)});
        if (outcome.consumed)
            consumed.push_back({hot.brick, consumedCells(shape.grid, hot.brick, skin, outcome.consumed)});
        if (m_world.m_stress) weaken(handle, hot.brick, remainingStrength(hot, skin));
        if (outcome.emitted) emitHeat(handle, hot, outcome.emitted);
        return outcome.isOver || !shape.grid.brickAt(hot.brick);
    });
    m_changes.firesChanged |= !m_changes.firesLit.empty() || !m_changes.firesOut.empty();
    if (!charred.empty())
        paintCells(handle, charred, {.color = kChar, .strength = kCharStrength, .seed = uint32_t(m_changes.step)});
    if (!consumed.empty()) removeBurnedCells(handle, consumed);
}

/// To the bricks around in the same shape, and now and then to those of other shapes.
void EditStep::emitHeat(ShapeHandle handle, const HotBrick& hot, int64_t emitted) {
    emitted = int64_t(double(emitted) * std::clamp(double(m_world.m_settings.fire.spread), 0.0, 100.0));
    m_near.clear();
    spreadHeat(m_world.m_shapes.at(handle).grid, hot.brick, emitted, m_near);
    for (const HeatDeposit& each : m_near) m_deposits.push_back({handle, each.brick, each.heat});
    if (hot.burningFor % kRadiationInterval) return;
    const glm::dvec3 from = brickInWorld(handle, hot.brick);
    for (const ShapeHandle other : m_world.shapesNear(from + glm::dvec3(0.0, 0.3, 0.0), kRadiationRadius)) {
        if (other == handle) continue;
        const Shape& shape = m_world.m_shapes.at(other);
        const Pose pose = m_world.shapeToWorld(other);
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

void EditStep::removeBurnedCells(ShapeHandle handle, const std::vector<BrickSubset>& cells) {
    Shape& shape = m_world.m_shapes.at(handle);
    recordMotion(shape.body);
    const Densities densities(*shape.palette, m_world.m_materials);
    const glm::vec3 velocity(m_world.m_bodies.at(shape.body).velocity);
    for (const BrickSubset& subset : cells) {
        const BrickRef brick = shape.grid.shareBrick(subset.brick);
        std::array<uint64_t, 256> removed{};
        BrickBits keep;
        for (size_t i = 0; i < 8; ++i) keep[i] = brick->occupancy[i] & ~subset.voxels[i];
        forEachVoxel(subset.voxels, [&](int i) { ++removed[brick->at(i)]; });
        shape.moments -= brickMoments(*brick, subset.voxels, subset.brick, densities);
        shape.grid.setBrick(subset.brick, maskBrick(*brick, keep));
        recordRemoved(handle, removed, {brickInWorld(handle, subset.brick), 4.0 * shape.voxelSize, velocity});
        ShapeEditState& each = editState(handle);
        each.carved.insert(subset.brick);
        each.lost = joined(each.lost, voxelBounds(subset.brick, subset.voxels));
    }
}

void EditStep::redistributeHeat() {
    FireState& fire = m_world.m_fire;
    if (!fire.isActive()) return;
    for (const ShapeSplit& split : m_changes.splits) splitHeat(split);
    std::erase_if(fire.fields, [&](const HeatField& field) { return !m_world.m_shapes.find(field.shape); });
    fire.compact();
}

/// What was hot of a shape that came apart goes with its voxels.
void EditStep::splitHeat(const ShapeSplit& split) {
    FireState& fire = m_world.m_fire;
    const auto field = std::find_if(fire.fields.begin(), fire.fields.end(),
                                    [&](const HeatField& each) { return each.shape == split.parent; });
    if (field == fire.fields.end()) return;
    std::vector<HotBrick> before = std::exchange(field->bricks, {});
    const auto countIn = [&](ShapeHandle handle, glm::ivec3 brick) {
        const Shape* shape = m_world.m_shapes.find(handle);
        const Brick* content = shape ? shape->grid.brickAt(brick) : nullptr;
        return int64_t(content ? content->count() : 0);
    };
    for (const HotBrick& hot : before) {
        struct Holder {
            ShapeHandle shape;
            glm::ivec3 brick;
            int64_t voxels;
        };
        std::vector<Holder> holders{{split.parent, hot.brick, countIn(split.parent, hot.brick)}};
        for (size_t i = 0; i < split.children.size(); ++i) {
            const glm::ivec3 brick = hot.brick - split.parentOffset[i] / kBrickSize;
            holders.push_back({split.children[i], brick, countIn(split.children[i], brick)});
        }
        int64_t sum = 0;
        for (const Holder& holder : holders) sum += holder.voxels;
        for (const Holder& holder : holders) {
            HotBrick* part = holder.voxels ? fire.findOrAdd(holder.shape, holder.brick, ~0u) : nullptr;
            if (!part) continue;
            *part = hot;
            part->brick = holder.brick;
            part->heat = hot.heat / sum * holder.voxels;
        }
    }
}

}  // namespace rubble
