#include "runtime/frame/glow_lights.h"

#include <algorithm>
#include <glm/common.hpp>

#include "runtime/frame/glow_faces.h"
#include "runtime/voxel/brick_entries.h"
#include "runtime/voxel/brick_parts.h"

namespace rubble {
namespace {

constexpr double kSamePlace = 0.5;  ///< metres that a light moves at most when voxels beside it go, and stays the same

UsedEntries entriesThatGlow(const Palette& palette) {
    UsedEntries out;
    for (size_t i = 1; i < palette.size(); ++i)
        if (palette[i].emission > 0.0f && !palette[i].lightGroup) out.insert(i);
    return out;
}

bool isEmpty(const UsedEntries& entries) {
    return entries.bits == UsedEntries{}.bits;
}

/// The voxels of one entry of a node, as a grid of their own.
VoxelGrid onlyEntryOf(const BrickNode& node, size_t entry) {
    VoxelGrid out{glm::ivec3(kNodeSize)};
    forEachChild(node.mask, [&](int child) {
        const Brick& brick = *node.bricks[size_t(child)];
        BrickBits keep{};
        forEachEntry(brick, brick.occupancy, [&](uint8_t found, size_t layer, uint64_t bits) {
            if (found == entry) keep[layer] |= bits;
        });
        out.setBrick(childPosition(child), maskBrick(brick, keep));
    });
    return out;
}

/// In metres of the shape's frame.
WorldBox boundsOf(const Component& voxels, const VoxelGrid& only, glm::ivec3 corner, double voxelSize) {
    WorldBox box{glm::dvec3(kMaxGridSize * voxelSize), glm::dvec3(0.0)};
    forEachSubset(only, voxels, [&](glm::ivec3 brick, const Brick&, const BrickBits& bits) {
        const CellBox cells = voxelBounds(brick, bits);
        box = box.merged({glm::dvec3(corner + cells.low) * voxelSize, glm::dvec3(corner + cells.high) * voxelSize});
    });
    return box;
}

}  // namespace

bool GlowLights::update(const FrameChanges& changes, const World& world, ShownPalettes& palettes) {
    bool changed = false;
    const auto replace = [&](ShapeHandle handle) {
        changed |= m_shapes.erase(handle) > 0;
        add(handle, world, palettes);
        changed |= m_shapes.contains(handle);
    };
    if (changes.levelReplaced) {
        m_shapes.clear();
        world.shapes().forEach([&](ShapeHandle handle, const Shape&) { replace(handle); });
    } else {
        for (const ShapeHandle handle : changes.shapesDestroyed) changed |= m_shapes.erase(handle) > 0;
        changed |= fitChangedNodes(changes, world);
        std::for_each(changes.shapesCreated.begin(), changes.shapesCreated.end(), replace);
        std::for_each(changes.palettes.begin(), changes.palettes.end(), replace);
    }
    if (!m_shapes.empty() && (changed || !changes.lights.empty())) findOwnLights(world);
    return changed || changes.levelReplaced;
}

void GlowLights::add(ShapeHandle handle, const World& world, ShownPalettes& palettes) {
    const Shape* source = world.shapes().find(handle);
    if (!source || !source->palette) return;
    const PaletteRef palette = palettes.of(*source);
    const UsedEntries entries = entriesThatGlow(*palette);
    if (isEmpty(entries)) return;
    ShapeGlows& shape = m_shapes[handle];
    shape.palette = palette;
    shape.entries = entries;
    source->grid.forEachNode([&](glm::ivec3 node, const BrickNode&) { fitNode(shape, *source, node); });
}

/// Fits the nodes with changed bricks, and those beside them, where a face may have opened.
bool GlowLights::fitChangedNodes(const FrameChanges& changes, const World& world) {
    if (m_shapes.empty()) return false;
    bool changed = false;
    std::vector<glm::ivec3> nodes;
    for (size_t i = 0; i < changes.bricks.size();) {
        const ShapeHandle handle = changes.bricks[i].shape;
        const auto shape = m_shapes.find(handle);
        const Shape* source = world.shapes().find(handle);
        nodes.clear();
        for (; i < changes.bricks.size() && changes.bricks[i].shape == handle; ++i) {
            if (shape == m_shapes.end() || !source) continue;
            const glm::ivec3 brick = changes.bricks[i].brick;
            nodes.push_back(nodeOfBrick(brick));
            for (const glm::ivec3 side : kFaceOffsets)
                if (nodeOfBrick(brick + side) != nodeOfBrick(brick)) nodes.push_back(nodeOfBrick(brick + side));
        }
        std::sort(nodes.begin(), nodes.end(), [](glm::ivec3 a, glm::ivec3 b) { return cellBefore(a, b); });
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        for (const glm::ivec3 node : nodes) changed |= fitNode(shape->second, *source, node);
    }
    return changed;
}

/// Whether the node has glowing voxels, or had some.
bool GlowLights::fitNode(ShapeGlows& shape, const Shape& source, glm::ivec3 position) {
    std::vector<Glow> before, now;
    if (const auto old = shape.nodes.find(position); old != shape.nodes.end()) {
        before = std::move(old->second);
        shape.nodes.erase(old);
    }
    const BrickNode* node = source.grid.nodeAt(position);
    if (!node || !usedEntries(*node).intersects(shape.entries)) return !before.empty();
    const glm::ivec3 corner = position * kNodeSize;
    shape.entries.forEach([&](size_t entry) {
        if (!usedEntries(*node).contains(entry)) return;
        const VoxelGrid only = onlyEntryOf(*node, entry);
        for (const Component& voxels : findComponents(only)) {
            const WorldBox box = boundsOf(voxels, only, corner, source.voxelSize);
            for (Light& light :
                 glowingFaces({source.grid, *shape.palette, source.voxelSize, uint8_t(entry), only, voxels, corner},
                              kMinIntensity))
                now.push_back({std::move(light), box, uint8_t(entry), 0});
        }
    });
    for (Glow& glow : now) {
        const auto same =
            std::find_if(before.begin(), before.end(), [&](const Glow& last) { return isSame(glow, last); });
        glow.number = same == before.end() ? ++m_lastNumber : same->number;
        if (same != before.end()) before.erase(same);
    }
    if (!now.empty()) shape.nodes.emplace(position, std::move(now));
    return true;
}

bool GlowLights::isSame(const Glow& a, const Glow& b) {
    return a.entry == b.entry && a.light.local.rotation == b.light.local.rotation &&
           glm::distance(a.light.local.position, b.light.local.position) < kSamePlace;
}

void GlowLights::findOwnLights(const World& world) {
    std::vector<glm::dvec3> places;
    world.lights().forEach(
        [&](LightHandle, const Light& light) { places.push_back(lightToWorld(world, light).position); });
    for (auto& [handle, shape] : m_shapes) {
        if (shape.nodes.empty()) continue;
        const Pose pose = shapeToWorld(world, handle);
        std::vector<glm::dvec3> local;
        for (const glm::dvec3 place : places) local.push_back(pose.inversePoint(place));
        for (auto& [node, glows] : shape.nodes)
            for (Glow& glow : glows)
                glow.hasOwnLight = std::any_of(local.begin(), local.end(), [&](glm::dvec3 place) {
                    return glm::distance(place, glm::clamp(place, glow.box.low, glow.box.high)) < kOwnLight;
                });
    }
}

void GlowLights::list(const World& world, std::vector<SnapshotLight>& lights, std::vector<BodyHandle>& bodies) const {
    const size_t first = lights.size();
    for (const auto& [handle, shape] : m_shapes) {
        if (shape.nodes.empty()) continue;
        const Pose pose = shapeToWorld(world, handle);
        bodies.push_back(world.shapes().at(handle).body);
        for (const auto& [node, glows] : shape.nodes)
            for (const Glow& glow : glows)
                // Generation 0 is that of no light of a World.
                if (!glow.hasOwnLight)
                    lights.push_back(
                        describeLight(glow.light, pose * glow.light.local, LightHandle::make(0, 0, glow.number)));
    }
    if (lights.size() - first <= kMaxLights) return;
    const auto rank = [](const SnapshotLight& light) {
        return std::max({light.color.x, light.color.y, light.color.z});
    };
    std::stable_sort(lights.begin() + ptrdiff_t(first), lights.end(),
                     [&](const SnapshotLight& a, const SnapshotLight& b) { return rank(a) > rank(b); });
    lights.resize(first + kMaxLights);
}

}  // namespace rubble
