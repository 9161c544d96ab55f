
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "runtime/core/log.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {
namespace {

std::array<uint64_t, 256> countEntries(const VoxelGrid& grid) {
    std::array<uint64_t, 256> out{};
    grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int i) { ++out[brick->at(i)]; });
    });
    return out;
}

/// Boxes of cells in a frame that begins at cell `low` of theirs and has this size.
std::vector<CellBox> translatedBoxes(const std::vector<CellBox>& boxes, glm::ivec3 low, glm::ivec3 size) {
    std::vector<CellBox> out;
    for (const CellBox& box : boxes) {
        const CellBox moved{glm::max(box.low - low, 0), glm::min(box.high - low, size)};
        if (!moved.empty()) out.push_back(moved);
    }
    return out;
}

/// The cell of `into` where cell 0 of `shape` lies; nothing if their lattices do not match.
std::optional<glm::ivec3> cellOffsetIn(const Shape& into, const Shape& shape) {
    if (into.body != shape.body || into.voxelSize != shape.voxelSize) return std::nullopt;
    if (std::fabs(glm::dot(into.local.rotation, shape.local.rotation)) < 1.0 - 1e-9) return std::nullopt;
    const glm::dvec3 cells = into.local.inversePoint(shape.local.position) / double(into.voxelSize);
    const glm::dvec3 whole = glm::round(cells);
    if (!(glm::length(cells - whole) < 1e-3) || glm::any(glm::greaterThan(glm::abs(whole), glm::dvec3(kMaxGridSize))))
        return std::nullopt;
    return glm::ivec3(whole);
}

/// Whether a voxel of `shape` has a face in common with one of `into`.
bool touch(const VoxelGrid& into, const VoxelGrid& shape, glm::ivec3 offset) {
    bool found = false;
    shape.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        const glm::ivec3 low = position * kBrickSize + offset;
        if (found || glm::any(glm::greaterThan(low, into.size())) ||
            glm::any(glm::lessThan(low + kBrickSize, glm::ivec3(0))))
            return;
        forEachVoxel(brick->occupancy, [&](int i) {
            for (const glm::ivec3 step : kFaceOffsets) found = found || into.at(low + voxelInBrick(i) + step) != 0;
        });
    });
    return found;
}

/// Adds the entries that `used` counts to a palette: which becomes which. Nothing if there are not enough free ones.
std::optional<std::array<uint8_t, 256>> mapEntries(Palette& into, const Palette& from,
                                                   const std::array<uint64_t, 256>& used) {
    std::array<uint8_t, 256> map{};
    for (size_t i = 1; i < 256; ++i) {
        if (!used[i]) continue;
        auto place =
            into[i] == from[i] ? into.begin() + ptrdiff_t(i) : std::find(into.begin() + 1, into.end(), from[i]);
        if (place == into.end())
            place = std::find_if(into.begin() + 1, into.end(),
                                 [](const PaletteEntry& entry) { return entry.material == 0; });
        if (place == into.end()) return std::nullopt;
        *place = from[i];
        map[i] = uint8_t(place - into.begin());
    }
    return map;
}

/// The same for paint; a colour for which no slot is left becomes the nearest.
std::array<uint8_t, 16> mapPaint(PaintColors& into, const PaintColors& from) {
    std::array<uint8_t, 16> map{};
    const auto away = [](const Srgb& a, const Srgb& b) {
        int sum = 0;
        for (size_t c = 0; c < 3; ++c) sum += (int(a[c]) - b[c]) * (int(a[c]) - b[c]);
        return sum;
    };
    for (size_t i = 0; i < from.count; ++i) {
        const auto known = into.colors.begin() + into.count;
        auto place = std::min_element(into.colors.begin(), known, [&](const Srgb& a, const Srgb& b) {
            return away(a, from.colors[i]) < away(b, from.colors[i]);
        });
        if ((place == known || away(*place, from.colors[i]) > 0) && into.count < kPaintColors) {
            place = known;
            *place = from.colors[i];
            ++into.count;
        }
        map[i + 1] = uint8_t(place - into.colors.begin() + 1);
    }
    return map;
}

}  // namespace

Shape* EditStep::shapeToEdit(ShapeHandle handle, const char* edit) {
    releaseFragments();  // they are in the cells that the shape has now
    Shape* shape = m_world.m_shapes.find(handle);
    if (!shape) logWarning(std::string(edit) + ": the handle of its shape is stale; nothing was done");
    return shape;
}

void EditStep::apply(const SplitShapeEdit& edit) {
    Shape* shape = shapeToEdit(edit.shape, "SplitShapeEdit");
    if (!shape) return;
    recordMotion(shape->body);
    std::vector<Component> components = findComponents(shape->grid);
    const auto keeps = [&](const Component& a, const Component& b) {
        const bool holdsA = touchesAnchor(shape->grid, a, shape->anchors),
                   holdsB = touchesAnchor(shape->grid, b, shape->anchors);
        return holdsA != holdsB ? holdsA : outranks(a, b);
    };
    if (components.size() > 1)
        components.erase(std::min_element(components.begin(), components.end(), keeps));
    else
        return;
    const Densities densities(*shape->palette, m_world.m_materials);
    ShapeSplit split{.parent = edit.shape};
    const Body& body = m_world.m_bodies.at(shape->body);
    for (const Component& component : components) {
        const MassMoments moments = componentMoments(shape->grid, component, densities);
        ShapeEditState& each = editState(edit.shape);
        each.carved.insert(component);
        each.lost = {glm::ivec3(0), shape->grid.size()};
        shape->moments -= moments;
        if (edit.removeResidual && component.voxels < edit.residualVoxels) {
            discardPiece(edit.shape, component);
            continue;
        }
        Piece piece = takePiece(shape->grid, component);
        const MassProperties mass = massProperties(moments, shape->voxelSize);
        split.motions.push_back({m_world.shapeToWorld(edit.shape).transformPoint(mass.center), body.velocity,
                                 body.angularVelocity, mass.mass});
        split.parentOffset.push_back(piece.offset);
        split.children.push_back(createSplitShape(edit.shape, std::move(piece), moments));
        shape = &m_world.m_shapes.at(edit.shape);  // the new shape may have moved the others
    }
    shape->knownConnected = true;
    if (split.children.empty()) return;
    moveLights(split);
    moveJoints(split);
    m_changes.splits.push_back(std::move(split));
}

ShapeHandle EditStep::createSplitShape(ShapeHandle handle, Piece piece, const MassMoments& moments) {
    const Shape& from = m_world.m_shapes.at(handle);
    Shape shape = from;
    shape.local = from.local * Pose{glm::dvec3(piece.offset) * double(from.voxelSize)};
    shape.anchors = translatedBoxes(from.anchors, piece.offset, piece.grid.size());
    shape.grid = std::move(piece.grid);
    shape.moments = moments.shifted(-piece.offset);
    shape.knownConnected = true;
    const BodyHandle body = shape.body;
    const ShapeHandle sibling = m_world.m_shapes.insert(std::move(shape));
    m_world.m_bodies.at(body).shapes.push_back(sibling);
    m_world.updateShapeBounds(sibling);
    m_world.updateDebris(body);
    m_changes.shapesCreated.push_back(sibling);
    return sibling;
}

ShapeHandle EditStep::findMergeTarget(ShapeHandle handle) const {
    const Shape& shape = m_world.m_shapes.at(handle);
    for (const ShapeHandle other : m_world.m_bodies.at(shape.body).shapes) {
        if (other == handle) continue;
        const Shape& into = m_world.m_shapes.at(other);
        if (const auto offset = cellOffsetIn(into, shape); offset && touch(into.grid, shape.grid, *offset))
            return other;
    }
    return {};
}

void EditStep::apply(const MergeShapeEdit& edit) {
    Shape* from = shapeToEdit(edit.shape, "MergeShapeEdit");
    if (!from) return;
    const ShapeHandle target = edit.into ? edit.into : findMergeTarget(edit.shape);
    Shape* into = target == edit.shape ? nullptr : m_world.m_shapes.find(target);
    const std::optional<glm::ivec3> offset = into ? cellOffsetIn(*into, *from) : std::nullopt;
    if (!offset || !touch(into->grid, from->grid, *offset))
        return logWarning("MergeShapeEdit: no shape that matches and touches; nothing was done");
    const CellBox box{glm::min(*offset, glm::ivec3(0)), glm::max(*offset + from->grid.size(), into->grid.size())};
    auto palette = std::make_shared<Palette>(*into->palette);
    const auto entries = mapEntries(*palette, *from->palette, countEntries(from->grid));
    if (!entries)
        return logWarning("MergeShapeEdit: the two palettes do not fit into one of 255 entries; nothing was done");
    if (!reframe(target, box)) return;
    const glm::ivec3 at = *offset - box.low;
    if (*palette != *into->palette) into->palette = palette;
    std::array<uint8_t, 16> paints{};
    if (from->paintColors) {
        auto colors = std::make_shared<PaintColors>(into->paintColors ? *into->paintColors : PaintColors{});
        paints = mapPaint(*colors, *from->paintColors);
        into->paintColors = colors;
    }
    std::array<uint64_t, 256> lost{};
    {
        GridWriter writer(into->grid);
        from->grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                const glm::ivec3 cell = position * kBrickSize + voxelInBrick(i) + at;
                if (writer.at(cell)) return void(++lost[brick->at(i)]);
                const uint8_t paint = brick->paintAt(i);
                writer.set(cell, (*entries)[brick->at(i)], uint8_t(paint ? paints[paint >> 4] << 4 | (paint & 15) : 0));
            });
        });
    }
    for (const CellBox& anchor : from->anchors) into->anchors.push_back({anchor.low + at, anchor.high + at});
    into->moments = gridMoments(into->grid, *into->palette, m_world.m_materials);
    m_world.m_lights.forEach([&](LightHandle light, Light& rider) {
        if (rider.shape != edit.shape) return;
        rider.shape = target;
        rider.local.position += glm::dvec3(at) * double(into->voxelSize);
        m_changes.lights.push_back(light);
    });
    const std::span<const JointHandle> held = m_world.jointsOf(edit.shape);
    for (const JointHandle joint : std::vector<JointHandle>(held.begin(), held.end()))
        for (size_t end = 0; end < 2; ++end)
            if (m_world.m_joints.at(joint).ends[end].shape == edit.shape) moveJointEnd(joint, end, target, -at);
    recordRemoved(edit.shape, lost, {m_world.shapeToWorld(edit.shape).transformPoint({}), 0.0, {}});
    m_editStates.erase(edit.shape.slot());
    destroyShape(edit.shape);
}

void EditStep::apply(const TrimShapeEdit& edit) {
    if (const Shape* shape = shapeToEdit(edit.shape, "TrimShapeEdit")) reframe(edit.shape, filledBounds(shape->grid));
}

void EditStep::apply(const ResizeShapeEdit& edit) {
    if (shapeToEdit(edit.shape, "ResizeShapeEdit")) reframe(edit.shape, edit.box);
}

/// Gives a shape another box of cells. False if that is refused, or nothing is left of the shape.
bool EditStep::reframe(ShapeHandle handle, const CellBox& box) {
    Shape& shape = m_world.m_shapes.at(handle);
    const auto fits = [](int low, int high) {
        return low >= -kMaxGridSize && high <= 2 * kMaxGridSize && low < high && high - low <= kMaxGridSize;
    };
    if (!fits(box.low.x, box.high.x) || !fits(box.low.y, box.high.y) || !fits(box.low.z, box.high.z)) {
        logWarning("a shape's grid must have 1 to " + std::to_string(kMaxGridSize) +
                   " cells on each side, not far from where it is; nothing was done");
        return false;
    }
    if (box == CellBox{glm::ivec3(0), shape.grid.size()}) return true;
    recordMotion(shape.body);
    std::array<uint64_t, 256> removed = countEntries(shape.grid);
    shape.grid = cropped(shape.grid, box);
    const std::array<uint64_t, 256> kept = countEntries(shape.grid);
    bool isLess = false;
    for (size_t i = 0; i < 256; ++i) removed[i] -= kept[i], isLess = isLess || removed[i];
    shape.local = shape.local * Pose{glm::dvec3(box.low) * double(shape.voxelSize)};
    shape.anchors = translatedBoxes(shape.anchors, box.low, shape.grid.size());
    shape.moments = gridMoments(shape.grid, *shape.palette, m_world.m_materials);
    shape.knownConnected = shape.knownConnected && !isLess;
    m_world.m_lights.forEach([&](LightHandle light, Light& rider) {
        if (rider.shape != handle) return;
        rider.local.position -= glm::dvec3(box.low) * double(shape.voxelSize);
        m_changes.lights.push_back(light);
    });
    reframeJoints(handle, box.low);
    if (isLess) recordRemoved(handle, removed, {m_world.shapeToWorld(handle).transformPoint({}), 0.0, {}});
    for (PendingSplit& pending : m_world.m_pendingSplits)  // its cut was in the old cells
        if (pending.shape == handle) pending.cut.clear(), pending.search.reset(), shape.knownConnected = false;
    std::erase_if(m_world.m_fire.fields, [&](const HeatField& field) { return field.shape == handle; });
    m_world.m_fire.compact();
    if (shape.grid.empty()) {
        m_editStates.erase(handle.slot());
        destroyShape(handle);
        return false;
    }
    ShapeEditState& each = editState(handle);
    const bool lostVoxels = isLess || each.lostVoxels || !each.carved.empty();
    if (lostVoxels) shape.knownConnected = false;
    each = {.shape = handle, .lostVoxels = lostVoxels};
    m_world.updateShapeBounds(handle);
    m_changes.shapesDestroyed.push_back(handle);
    m_changes.shapesCreated.push_back(handle);
    return true;
}

}  // namespace rubble
