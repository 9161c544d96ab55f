#include "render/scene/bodies.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "runtime/voxel/brick_node.h"

namespace rubble {
namespace {

constexpr uint32_t kNoBrickTable = ~0u;
using shared::kHasGlass;
using shared::kHasPaint;

glm::vec4 packed(glm::quat q) {
    return {q.x, q.y, q.z, q.w};
}
/// Whether an entry is smooth enough for reflection rays: lib/mirror.glsl sends none at roughness 0.6 and above.
bool hasMirrorEntry(const Palette& palette) {
    return std::any_of(palette.begin() + 1, palette.end(),
                       [](const PaletteEntry& e) { return e.material && e.opacity == 255 && e.roughness < 153; });
}

bool hasGlassEntry(const Palette& palette) {
    return std::any_of(palette.begin() + 1, palette.end(), [](const PaletteEntry& e) { return e.opacity < 255; });
}

template <class F>
void forEachBrick(const FrameSnapshot& snapshot, F&& f) {
    for (const SnapshotShape& shape : snapshot.created)
        for (const BrickChange& change : shape.bricks)
            if (change.content) f(change.content);
    for (const BrickChange& change : snapshot.bricks)
        if (change.content) f(change.content);
}

}  // namespace

WorldBox Bodies::Instance::box() const {
    const glm::dvec3 from = glm::vec3(low) * voxelSize, to = glm::vec3(high) * voxelSize;
    const glm::dquat turned(rotation);
    return boundsOfBox(glm::dvec3(position) + turned * ((from + to) * 0.5), (to - from) * 0.5, turned);
}

Bodies::Shape* Bodies::find(ShapeHandle handle) {
    if (handle.slot() >= m_shapes.size() || !m_shapes[handle.slot()] || m_shapes[handle.slot()]->handle != handle)
        return nullptr;
    return m_shapes[handle.slot()].get();
}

void Bodies::create(const SnapshotShape& given) {
    const uint32_t slot = given.shape.slot();
    if (slot < m_shapes.size() && m_shapes[slot]) destroy(m_shapes[slot]->handle);
    if (slot >= m_shapes.size()) {
        m_shapes.resize(slot + 1);
        m_instances.resize(slot + 1);
        m_transforms.resize(slot + 1);
        m_layouts.resize(slot + 1);
    }
    auto shape = std::make_unique<Shape>();
    shape->handle = given.shape;
    shape->size = given.size;
    shape->sizeInNodes = (given.size + 31) / 32;
    shape->voxelSize = given.voxelSize;
    const uint32_t nodes = uint32_t(shape->sizeInNodes.x * shape->sizeInNodes.y * shape->sizeInNodes.z);
    shape->bricks.resize(nodes);
    shape->firstNode = m_nodeRanges.allocate(nodes);
    m_nodes.resize(std::max<size_t>(m_nodes.size(), m_nodeRanges.end()));
    for (uint32_t n = 0; n < nodes; ++n) m_nodes.change(shape->firstNode + n) = Node{{0, 0}, kNoBrickTable, 0};

    m_instances[slot] = Instance{};
    m_instances[slot].voxelSize = given.voxelSize;
    m_layouts.change(slot) =
        Layout{shape->firstNode, 0, 0, 0, glm::ivec4(shape->sizeInNodes, 0), glm::ivec4(0), glm::ivec4(0)};
    m_shapes[slot] = std::move(shape);
    ++m_shapeCount;
    usePalette(*m_shapes[slot], slot, given.palette);
    usePaint(slot, given.paintColors);
    for (const BrickChange& change : given.bricks) putBrick(*m_shapes[slot], change.brick, change.content);
    m_changed.push_back(slot);
    m_moving.push_back(slot);
    m_shapes[slot]->moving = true;
}

void Bodies::destroy(ShapeHandle handle) {
    Shape* shape = find(handle);
    if (!shape) return;
    release(*shape, handle.slot());
    m_shapes[handle.slot()].reset();
    m_instances[handle.slot()] = Instance{};
    m_changed.push_back(handle.slot());
    --m_shapeCount;
}

void Bodies::release(Shape& shape, uint32_t slot) {
    for (size_t n = 0; n < shape.bricks.size(); ++n) {
        if (!shape.bricks[n]) continue;
        for (const BrickRef& brick : *shape.bricks[n])
            if (brick) m_atlas.release(brick.get());
        m_tableSlots.free(m_nodes[shape.firstNode + n].table);
    }
    m_nodeRanges.free(shape.firstNode, uint32_t(shape.bricks.size()));
    m_glassShapes -= m_instances[slot].glass;
    m_mirrorShapes -= m_instances[slot].mirror;
    if (shape.palette) releaseGpuPalette(shape.palette.get());
    shape.palette = nullptr;
}

void Bodies::clear() {
    for (const auto& shape : m_shapes)
        if (shape) destroy(ShapeHandle(shape->handle));
    m_moving.clear();
}

void Bodies::setBrick(const BrickChange& change) {
    Shape* shape = find(change.shape);
    if (!shape) return;
    putBrick(*shape, change.brick, change.content);
    m_changed.push_back(change.shape.slot());
}

void Bodies::putBrick(Shape& shape, glm::ivec3 brick, const BrickRef& content) {
    const glm::ivec3 node = nodeOfBrick(brick);
    const size_t n =
        (size_t(node.z) * size_t(shape.sizeInNodes.y) + size_t(node.y)) * size_t(shape.sizeInNodes.x) + size_t(node.x);
    if (!shape.bricks[n] && !content) return;
    Node& gpuNode = m_nodes.change(shape.firstNode + n);
    if (!shape.bricks[n]) {
        shape.bricks[n] = std::make_unique<std::array<BrickRef, 64>>();
        gpuNode.table = m_tableSlots.allocate();
        m_tables.resize(std::max<size_t>(m_tables.size(), m_tableSlots.end()));
        m_tables.change(gpuNode.table) = Table{};
    }
    const int child = childIndex(brick);
    BrickRef& held = (*shape.bricks[n])[size_t(child)];
    const uint32_t entry = content ? m_atlas.acquire(content) << 8 | BrickAtlas::occupiedWords(*content) : 0;
    for (size_t axis = 0; axis < 3; ++axis) {
        if (content && !held) shape.layers[axis].add(brick[int(axis)]);
        if (held && !content) shape.layers[axis].remove(brick[int(axis)]);
    }
    if (held) m_atlas.release(held.get());
    held = content;
    m_tables.change(gpuNode.table).entry[child] = entry;
    uint32_t& mask = gpuNode.mask[child >> 5];
    const uint32_t bit = 1u << (child & 31);
    mask = content ? mask | bit : mask & ~bit;
}

/// Leaves these shapes out from now on, and no others; also ones that come later. False: it did already.
bool Bodies::hide(std::span<const ShapeHandle> shapes) {
    if (shapes.empty() && m_hidden.empty()) return false;
    std::vector<ShapeHandle> wanted(shapes.begin(), shapes.end());
    std::sort(wanted.begin(), wanted.end());
    if (wanted == m_hidden) return false;
    std::swap(wanted, m_hidden);
    for (const std::vector<ShapeHandle>* list : {&wanted, &m_hidden})
        for (const ShapeHandle shape : *list)
            if (find(shape)) m_changed.push_back(shape.slot());
    return true;
}

bool Bodies::isHidden(ShapeHandle shape) const {
    return std::binary_search(m_hidden.begin(), m_hidden.end(), shape);
}

void Bodies::updateBounds(uint32_t slot) {
    const Shape& shape = *m_shapes[slot];
    if (isHidden(shape.handle)) return void(m_instances[slot].low = m_instances[slot].high = glm::ivec3(0));
    const auto& [x, y, z] = shape.layers;
    const glm::ivec3 low = glm::ivec3(x.low(), y.low(), z.low()) * kBrickSize,
                     high = glm::min(glm::ivec3(x.high(), y.high(), z.high()) * kBrickSize, shape.size);
    m_instances[slot].low = low;
    m_instances[slot].high = high;
    m_layouts.change(slot).low = glm::ivec4(low, 0);
    m_layouts.change(slot).high = glm::ivec4(high, 0);
}

uint32_t Bodies::acquireGpuPalette(const PaletteRef& palette) {
    PaletteUse& use = m_paletteUses[palette.get()];
    if (use.references++) return use.slot;
    use.palette = palette;
    use.slot = m_paletteSlots.allocate();
    m_palettes.resize(std::max<size_t>(m_palettes.size(), m_paletteSlots.end()));
    GpuPalette& gpuPalette = m_palettes.change(use.slot);
    for (size_t i = 0; i < 256; ++i) {
        const PaletteEntry& e = (*palette)[i];
        uint32_t* to = gpuPalette.entry[i];
        to[0] = uint32_t(e.red) | uint32_t(e.green) << 8 | uint32_t(e.blue) << 16 | uint32_t(e.opacity) << 24;
        to[1] = uint32_t(e.roughness) | uint32_t(e.metallic) << 8 | uint32_t(e.reflectivity) << 16 |
                uint32_t(e.material) << 24;
        to[2] = glm::floatBitsToUint(e.emission);
        to[3] = m_detailMaps[e.material];
        use.detail |= to[3] != 0;
    }
    m_detailPalettes += int(use.detail);
    return use.slot;
}

void Bodies::releaseGpuPalette(const Palette* palette) {
    const auto found = m_paletteUses.find(palette);
    if (--found->second.references) return;
    m_paletteSlots.free(found->second.slot);
    m_detailPalettes -= int(found->second.detail);
    m_paletteUses.erase(found);
}

void Bodies::usePalette(Shape& shape, uint32_t slot, const PaletteRef& palette) {
    const uint32_t paletteSlot = acquireGpuPalette(palette);
    if (shape.palette) releaseGpuPalette(shape.palette.get());
    shape.palette = palette;
    const bool glass = hasGlassEntry(*palette);
    m_glassShapes += int(glass) - int(m_instances[slot].glass);
    m_instances[slot].glass = glass;
    const bool mirror = hasMirrorEntry(*palette);
    m_mirrorShapes += int(mirror) - int(m_instances[slot].mirror);
    m_instances[slot].mirror = mirror;
    m_layouts.change(slot).palette = paletteSlot;
    uint32_t& flags = m_layouts.change(slot).flags;
    flags = (flags & ~kHasGlass) | (glass ? kHasGlass : 0);
}

void Bodies::usePaint(uint32_t slot, const PaintColorsRef& colors) {
    uint32_t& flags = m_layouts.change(slot).flags;
    flags = (flags & ~kHasPaint) | (colors ? kHasPaint : 0);
    if (colors) m_atlas.ensurePaint().setColors(slot, *colors);
}

PaletteRef Bodies::setPalette(const SnapshotPalette& given) {
    Shape* shape = find(given.shape);
    if (!shape) return nullptr;
    PaletteRef before = shape->palette;
    usePalette(*shape, given.shape.slot(), given.palette);
    usePaint(given.shape.slot(), given.paintColors);
    m_changed.push_back(given.shape.slot());
    return before;
}

void Bodies::setPose(const SnapshotPose& pose) {
    Shape* shape = find(pose.shape);
    if (!shape) return;
    shape->previous = pose.previous;
    shape->current = pose.current;
    if (!shape->moving) m_moving.push_back(pose.shape.slot());
    shape->moving = true;
}

uint64_t Bodies::beginFrame(float alpha, glm::dvec3 originWorld, bool isSameMoment,
                            std::span<const ShapeHandle> hidden) {
    m_touched.hidesOthers = hide(hidden);
    const bool isRebased = originWorld != m_origin;
    if (isRebased) {
        m_origin = originWorld;
        for (uint32_t slot = 0; slot < m_shapes.size(); ++slot) {
            if (!m_shapes[slot]) continue;
            m_shapes[slot]->hasTransform = false;
            if (!m_shapes[slot]->moving) m_moving.push_back(slot);
            m_shapes[slot]->moving = true;
        }
    }
    std::sort(m_changed.begin(), m_changed.end());
    m_changed.erase(std::unique(m_changed.begin(), m_changed.end()), m_changed.end());
    for (uint32_t slot : m_changed)
        if (m_shapes[slot]) updateBounds(slot);
    m_touched.slots = std::exchange(m_changed, {});
    leaveOutWithoutRoom();
    if (isRebased || !isSameMoment) updateTransforms(alpha);
    listMovingBodies();
    updateTree();
    ++m_touched.frame;
    return m_nodes.upload() + m_tables.upload() + m_transforms.upload() + m_layouts.upload() + m_palettes.upload();
}

void Bodies::updateTransforms(float alpha) {
    std::vector<uint32_t> still;
    std::sort(m_moving.begin(), m_moving.end());
    m_moving.erase(std::unique(m_moving.begin(), m_moving.end()), m_moving.end());
    m_touched.slots.insert(m_touched.slots.end(), m_moving.begin(), m_moving.end());
    for (uint32_t slot : m_moving)
        if (m_shapes[slot]) {
            updateTransform(slot, alpha, m_origin);
            if (m_shapes[slot]->moving) still.push_back(slot);
        }
    m_moving = std::move(still);
}

void Bodies::listMovingBodies() {
    m_touched.moving.clear();
    for (const uint32_t slot : m_moving) {
        const Instance& body = m_instances[slot];
        if (!m_shapes[slot] || body.empty()) continue;
        const Pose& pose = m_shapes[slot]->current;
        const glm::vec3 low = glm::vec3(body.low) * body.voxelSize, high = glm::vec3(body.high) * body.voxelSize,
                        middle = 0.5f * (low + high), halfSize = 0.5f * (high - low);
        const glm::quat rotation(pose.rotation);
        m_touched.moving.add({body.position + body.rotation * middle, halfSize, body.rotation},
                             {glm::vec3(pose.position - m_origin) + rotation * middle, halfSize, rotation});
    }
}

/// Enters what was touched into the tree of bounds.
void Bodies::updateTree() {
    for (const uint32_t slot : m_touched.slots) {
        const Instance& body = m_instances[slot];
        if (body.empty())
            m_bounds.remove(slot);
        else
            m_bounds.update(slot, body.box());
    }
}

/// Whether the GL has room for all that a shape needs but its bricks.
bool Bodies::hasRoom(uint32_t slot) const {
    const Shape& shape = *m_shapes[slot];
    for (size_t n = 0; n < shape.bricks.size(); ++n)
        if (shape.bricks[n] && m_nodes[shape.firstNode + n].table >= m_tables.held()) return false;
    return shape.firstNode + shape.bricks.size() <= m_nodes.held() && slot < m_transforms.held() &&
           slot < m_layouts.held() && m_layouts[slot].palette < m_palettes.held();
}

/// Takes the bricks that the GL has no room for out of a shape's directory.
void Bodies::leaveOutBricks(const Shape& shape) {
    for (size_t n = 0; n < shape.bricks.size(); ++n) {
        if (!shape.bricks[n]) continue;
        const uint32_t table = m_nodes[shape.firstNode + n].table;
        for (uint32_t child = 0; child < 64; ++child) {
            if (m_tables[table].entry[child] >> 8 < m_room) continue;
            m_tables.change(table).entry[child] = 0;
            m_nodes.change(shape.firstNode + n).mask[child >> 5] &= ~(1u << (child & 31));
        }
    }
}

/// Hides shapes, and leaves out bricks, that the GL has no room for, so that shaders read nothing that is not there. Of
/// shapes that have changed: what the others need is as it was.
void Bodies::leaveOutWithoutRoom() {
    bool isFull = false;
    const auto reserve = [&](auto&... buffers) {
        (buffers.reserve(), ...);
        isFull = ((buffers.held() < buffers.size()) || ...);
    };
    reserve(m_nodes, m_tables, m_transforms, m_layouts, m_palettes);
    const bool isNew = std::exchange(m_room, m_atlas.room()) != m_room;
    for (uint32_t slot = 0; slot < m_shapes.size() && isNew; ++slot) m_touched.slots.push_back(slot);
    for (const uint32_t slot : m_touched.slots) {
        if (!m_shapes[slot]) continue;
        if (m_room != ~0u) leaveOutBricks(*m_shapes[slot]);
        if (isFull && !hasRoom(slot)) m_instances[slot].low = m_instances[slot].high = glm::ivec3(0);
    }
}

uint64_t Bodies::newBytes(const FrameSnapshot& snapshot) const {
    uint64_t bytes = 0;
    forEachBrick(snapshot,
                 [&](const BrickRef& brick) { bytes += m_atlas.has(brick.get()) ? 0 : BrickAtlas::kBrickBytes; });
    return bytes;
}

uint64_t Bodies::retainBricks(const FrameSnapshot& snapshot) {
    forEachBrick(snapshot, [&](const BrickRef& brick) { m_atlas.acquire(brick); });
    return m_atlas.queued();
}

void Bodies::releaseBricks(const FrameSnapshot& snapshot) {
    forEachBrick(snapshot, [&](const BrickRef& brick) { m_atlas.release(brick.get()); });
}

void Bodies::updateTransform(uint32_t slot, float alpha, glm::dvec3 originWorld) {
    Shape& shape = *m_shapes[slot];
    const glm::dvec3 position = glm::mix(shape.previous.position, shape.current.position, double(alpha)) - originWorld;
    const glm::quat rotation =
        glm::normalize(glm::slerp(glm::quat(shape.previous.rotation), glm::quat(shape.current.rotation), alpha));
    InstanceTransform& to = m_transforms.change(slot);
    const InstanceTransform last = to;
    to.rotation = packed(rotation);
    to.position = glm::vec4(glm::vec3(position), shape.voxelSize);
    to.lastRotation = shape.hasTransform ? last.rotation : to.rotation;
    to.lastPosition =
        shape.hasTransform ? glm::vec4(glm::vec3(last.position), 0.0f) : glm::vec4(glm::vec3(position), 0.0f);
    const bool moved = to.lastRotation != to.rotation || glm::vec3(to.lastPosition) != glm::vec3(to.position);
    to.lastPosition.w = moved ? 1.0f : 0.0f;
    m_instances[slot].position = glm::vec3(position);
    m_instances[slot].rotation = rotation;
    const bool arrived = shape.previous == shape.current && !moved && shape.hasTransform;
    shape.hasTransform = true;
    if (arrived) shape.moving = false;
}

void Bodies::bind(const Program& program) const {
    program.set("uBrickWords", m_atlas.words());
    program.set("uBrickIndices", m_atlas.indices());
    program.set("uNodes", m_nodes.texture());
    program.set("uTables", m_tables.texture());
    program.set("uTransforms", m_transforms.texture());
    program.set("uLayouts", m_layouts.texture());
    program.set("uPalettes", m_palettes.texture());
    static const PaintAtlas none;
    (m_atlas.paint() ? *m_atlas.paint() : none).bind(program);
}

uint64_t Bodies::bytes() const {
    return m_atlas.bytes() + m_nodes.texture().bytes() + m_tables.texture().bytes() + m_transforms.texture().bytes() +
           m_layouts.texture().bytes() + m_palettes.texture().bytes();
}

}  // namespace rubble
