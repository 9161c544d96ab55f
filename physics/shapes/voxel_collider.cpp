#include "physics/shapes/voxel_collider.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/core/rotated_box.h"

namespace rubble {
namespace {

constexpr size_t kMaxTightBricks = 512;  ///< grids of more bricks get bounds of whole directory nodes

/// The brick without voxels of unphysical materials; null if nothing is left.
BrickRef withoutUnphysical(const BrickRef& brick, const ContactMaterials& contactMaterials) {
    if (!brick || (!brick->indices && contactMaterials.solid[brick->uniform])) return brick;
    BrickBits keep = brick->occupancy;
    forEachVoxel(brick->occupancy, [&](int i) {
        if (!contactMaterials.solid[brick->at(i)]) clearVoxel(keep, i);
    });
    return keep == brick->occupancy ? brick : maskBrick(*brick, keep);
}

/// Grows the box to hold the brick's solid cells.
void includeBrick(glm::ivec3 position, const Brick& brick, CellBox& box) {
    uint64_t flat = 0;
    int low = 8, high = -1;
    for (int z = 0; z < 8; ++z) {
        if (!brick.occupancy[size_t(z)]) continue;
        flat |= brick.occupancy[size_t(z)];
        low = std::min(low, z);
        high = z;
    }
    uint32_t row = 0;
    for (int y = 0; y < 8; ++y) row |= uint32_t(flat >> (8 * y)) & 0xff;
    const glm::ivec3 base = position * kBrickSize;
    box.low = glm::min(box.low, base + glm::ivec3(std::countr_zero(row), std::countr_zero(flat) / 8, low));
    box.high =
        glm::max(box.high, base + glm::ivec3(32 - std::countl_zero(row), 8 - std::countl_zero(flat) / 8, high + 1));
}

}  // namespace

ContactMaterials::ContactMaterials(const Palette& palette, const MaterialTable& materials) {
    for (size_t i = 0; i < friction.size(); ++i) {
        const Material& material = materials[palette[i].material];
        friction[i] = material.friction;
        restitution[i] = material.restitution;
        solid[i] = material.hardness != Hardness::Unphysical;
    }
}

uint8_t commonEntry(const VoxelGrid& grid) {
    uint8_t entry = 0;
    bool isCommon = true;
    const auto take = [&](uint8_t next) { isCommon = isCommon && (entry == 0 || entry == next), entry = next; };
    grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        if (!brick->indices) return take(brick->uniform);
        forEachVoxel(brick->occupancy, [&](int i) { take(brick->at(i)); });
    });
    return isCommon ? entry : uint8_t(0);
}

ColliderPart::ColliderPart(const Shape& shape, const Pose& frame, const MaterialTable& materials)
    : m_frame(frame),
      m_voxelSize(shape.voxelSize),
      m_filter{shape.collisionLayer, shape.collisionMask},
      m_kind(shape.collisionShape),
      m_contactMaterials(std::make_shared<ContactMaterials>(*shape.palette, materials)) {
    takeGrid(shape.grid, nullptr);
    const glm::ivec3 nodes = m_grid.sizeInNodes();
    m_nodes = std::make_unique<Lazy<NodeSurface>[]>(size_t(nodes.x) * size_t(nodes.y) * size_t(nodes.z));
}

void ColliderPart::takeGrid(const VoxelGrid& grid, const std::vector<glm::ivec3>* bricks) {
    const bool shared = !bricks || !m_hasUnphysical;
    if (shared) m_grid = grid;
    const auto take = [&](glm::ivec3 position, const BrickRef& brick) {
        BrickRef kept = withoutUnphysical(brick, *m_contactMaterials);
        const bool differs = kept != brick;
        m_hasUnphysical = m_hasUnphysical || differs;
        if (differs || !shared) m_grid.setBrick(position, std::move(kept));
    };
    if (!bricks) m_hasUnphysical = false;
    if (!bricks) grid.forEachBrick(take);
    if (bricks)
        for (const glm::ivec3& brick : *bricks) take(brick, grid.shareBrick(brick));
    findBounds();
}

void ColliderPart::findBounds() {
    m_hull.forget();
    m_whole.forget();
    m_bounds = {m_grid.size(), glm::ivec3(0)};
    if (m_grid.brickCount() <= kMaxTightBricks)
        m_grid.forEachBrick(
            [&](glm::ivec3 position, const BrickRef& brick) { includeBrick(position, *brick, m_bounds); });
    else
        m_grid.forEachNode([&](glm::ivec3 node, const BrickNode&) {
            m_bounds.low = glm::min(m_bounds.low, node * kNodeSize);
            m_bounds.high = glm::max(m_bounds.high, glm::min((node + 1) * kNodeSize, m_grid.size()));
        });
    setCollisionShape(m_kind);
}

void ColliderPart::update(const Shape& shape, const std::vector<glm::ivec3>& bricks, const MaterialTable& materials) {
    const auto before =
        std::exchange(m_contactMaterials, std::make_shared<ContactMaterials>(*shape.palette, materials));
    takeGrid(shape.grid, before->solid == m_contactMaterials->solid ? &bricks : nullptr);
    for (const glm::ivec3& brick : bricks)
        for (int i = 0; i < 27; ++i) {
            const glm::ivec3 near = brick + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
            if (near.x < 0 || near.y < 0 || near.z < 0 ||
                glm::any(glm::greaterThanEqual(nodeOfBrick(near), m_grid.sizeInNodes())))
                continue;
            if (const NodeSurface* known = m_nodes[nodeNumber(nodeOfBrick(near))].find()) {
                known->features[size_t(childIndex(near))].forget();
                known->rows[size_t(childIndex(near))].forget();
            }
        }
}

const ColliderPart::NodeSurface& ColliderPart::node(glm::ivec3 brick) const {
    Lazy<NodeSurface>& lazy = m_nodes[nodeNumber(nodeOfBrick(brick))];
    const NodeSurface* known = lazy.find();
    return known ? *known : lazy.keep(std::make_unique<NodeSurface>());
}

const FeatureList& ColliderPart::features(glm::ivec3 brick) const {
    Lazy<FeatureList>& lazy = node(brick).features[size_t(childIndex(brick))];
    const FeatureList* known = lazy.find();
    return known ? *known : lazy.keep(std::make_unique<FeatureList>(findFeatures(rows(brick))));
}

const SolidRows& ColliderPart::rows(glm::ivec3 brick) const {
    Lazy<SolidRows>& lazy = node(brick).rows[size_t(childIndex(brick))];
    const SolidRows* known = lazy.find();
    return known
               ? *known
               : lazy.keep(std::make_unique<SolidRows>(m_grid, CellBox{brick * kBrickSize, (brick + 1) * kBrickSize}));
}

const PartSurface* ColliderPart::whole() const {
    const glm::ivec3 size = m_bounds.high - m_bounds.low;
    if (m_bounds.empty() || std::max({size.x, size.y, size.z}) > kMaxWholeSize) return nullptr;
    const PartSurface* known = m_whole.find();
    return known ? known : &m_whole.keep(std::make_unique<PartSurface>(m_grid, m_bounds));
}

const HullPoints& ColliderPart::hull() const {
    if (const PartSurface* surface = whole()) return surface->hull;
    const HullPoints* known = m_hull.find();
    return known ? *known : m_hull.keep(std::make_unique<HullPoints>(m_bounds));
}

void changedBricks(const FrameChanges& changes, ShapeHandle shape, std::vector<glm::ivec3>& out) {
    out.clear();
    const auto slotOf = [](const BrickChange& change) { return change.shape.slot(); };
    auto change = std::lower_bound(changes.bricks.begin(), changes.bricks.end(), shape.slot(),
                                   [&](const BrickChange& each, uint32_t slot) { return slotOf(each) < slot; });
    for (; change != changes.bricks.end() && slotOf(*change) == shape.slot(); ++change)
        if (change->shape == shape) out.push_back(change->brick);
}

bool VoxelCollider::empty() const {
    return std::all_of(parts.begin(), parts.end(), [](const auto& part) { return part->grid().empty(); });
}

void VoxelCollider::bounds(glm::dvec3& low, glm::dvec3& high) const {
    low = glm::dvec3(1e30), high = glm::dvec3(-1e30);
    for (const auto& part : parts) {
        if (part->grid().empty()) continue;
        const glm::dvec3 halfSize = glm::dvec3(part->bounds().high - part->bounds().low) * (0.5 * part->voxelSize());
        const glm::dvec3 center = part->frame().transformPoint(glm::dvec3(part->bounds().low + part->bounds().high) *
                                                               (0.5 * part->voxelSize()));
        const glm::dmat3 axes = glm::mat3_cast(part->frame().rotation);
        const glm::dvec3 extent = rotatedHalfExtent(axes, halfSize);
        low = glm::min(low, center - extent);
        high = glm::max(high, center + extent);
    }
}

double VoxelCollider::radius() const {
    double farthest = 0.0;
    for (const auto& part : parts) {
        if (part->grid().empty()) continue;
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 cell(i & 1 ? part->bounds().high.x : part->bounds().low.x,
                                  i & 2 ? part->bounds().high.y : part->bounds().low.y,
                                  i & 4 ? part->bounds().high.z : part->bounds().low.z);
            farthest =
                std::max(farthest, glm::length(part->frame().transformPoint(glm::dvec3(cell) * part->voxelSize())));
        }
    }
    return farthest;
}

double VoxelCollider::smallestVoxel() const {
    double size = 1e30;
    for (const auto& part : parts) size = std::min(size, part->voxelSize());
    return size;
}

}  // namespace rubble
