#include <algorithm>
#include <cmath>

#include "runtime/world/edit_step.h"

namespace rubble {
namespace {

MassMoments componentMoments(const VoxelGrid& grid, const Component& component, const Densities& densities) {
    MassMoments sum;
    for (const NodeShare& share : component.nodes) {
        const BrickNode& node = *grid.nodeAt(share.node);
        if (share.bricks == node.mask) {
            sum += nodeMoments(node, share.node, densities);
            continue;
        }
        forEachChild(share.bricks, [&](int child) {
            const Brick& brick = *node.bricks[size_t(child)];
            sum += brickMoments(brick, brick.occupancy, share.node * kNodeBricks + childPosition(child), densities);
        });
    }
    for (const BrickShare& share : component.shares) sum += brickMoments(*grid.brickAt(share.brick), share.voxels, share.brick, densities);
    return sum;
}

void insertBricks(const Component& component, BrickSet& out) {
    for (const NodeShare& share : component.nodes) out.insert(share.node, share.bricks);
    for (const BrickShare& share : component.shares) out.insert(share.brick);
}

}  // namespace

void EditStep::splitShape(Touched& touched) {
    const ShapeHandle parent = touched.shape;
    const uint64_t smallest = m_world.m_settings.minPieceVoxels;
    Shape* shape = &m_world.m_shapes.at(parent);
    const bool isAnchored = m_world.m_bodies.at(shape->body).isStatic;
    const Loose loose = shape->nothingLoose ? findLooseNear(shape->grid, shape->anchors, isAnchored, touched.carved)
                                            : findLoose(shape->grid, shape->anchors, isAnchored);
    shape->nothingLoose = true;
    const Densities densities(*shape->palette, m_world.m_materials);
    ShapeSplit split{.parent = parent};
    for (Fragment& fragment : touched.fragments) {
        split.parentOffset.push_back(fragment.piece.offset);
        split.children.push_back(createChild(parent, std::move(fragment.piece), fragment.moments, split.motions.emplace_back()));
    }
    if (!touched.fragments.empty()) shape = &m_world.m_shapes.at(parent);
    for (const Component& component : loose.pieces) {
        const MassMoments moments = componentMoments(shape->grid, component, densities);
        if (moments.weight == 0) continue;  // unphysical voxels are not touched: they stay where they are
        insertBricks(component, touched.carved);
        shape->moments -= moments;
        if (component.voxels < smallest) {
            dropPiece(parent, component);
            continue;
        }
        Piece piece = takePiece(shape->grid, component);
        split.parentOffset.push_back(piece.offset);
        split.children.push_back(createChild(parent, std::move(piece), moments, split.motions.emplace_back()));
        shape = &m_world.m_shapes.at(parent);  // the new shape may have moved the others
    }
    const bool isFree = loose.isAdrift || !isAnchored;
    if (isFree && shape->grid.voxelCount() < smallest)
        for (const Component& rest : findComponents(shape->grid)) {
            shape->moments -= componentMoments(shape->grid, rest, densities);
            dropPiece(parent, rest);
        }
    if (!split.children.empty()) {
        m_cutWires.insert(parent.slot());
        moveLights(split);
    }
    if (shape->grid.empty())
        destroyShape(parent);
    else if (loose.isAdrift && shape->moments.weight > 0)
        rehome(parent);
    if (!split.children.empty()) m_changes.splits.push_back(std::move(split));
}

void EditStep::dropPiece(ShapeHandle parent, const Component& component) {
    Shape& shape = m_world.m_shapes.at(parent);
    std::array<uint64_t, 256> removed{};
    forEachShare(shape.grid, component,
                 [&](glm::ivec3, const Brick& brick, const BrickBits& voxels) { forEachVoxel(voxels, [&](int i) { ++removed[brick.at(i)]; }); });
    const Densities densities(*shape.palette, m_world.m_materials);
    const MassProperties mass = massProperties(componentMoments(shape.grid, component, densities), shape.voxelSize);
    takePiece(shape.grid, component);
    const double radius = 0.5 * shape.voxelSize * std::cbrt(double(component.voxels));
    countRemoved(parent, removed, {m_world.shapeToWorld(parent).transformPoint(mass.center), radius, m_world.m_bodies.at(shape.body).velocity});
}

ShapeHandle EditStep::createChild(ShapeHandle parentHandle, Piece piece, const MassMoments& moments, PieceMotion& started) {
    const Shape& parent = m_world.m_shapes.at(parentHandle);
    const Body& from = m_world.m_bodies.at(parent.body);
    Body body{.name = parent.name};
    body.isStatic = false;
    body.pose = m_world.shapeToWorld(parentHandle) * Pose{glm::dvec3(piece.offset) * double(parent.voxelSize)};
    body.born = m_changes.step;
    const MassProperties mass = massProperties(moments.shifted(-piece.offset), parent.voxelSize);
    started = {.center = body.pose.transformPoint(mass.center), .mass = mass.mass};
    if (!from.isStatic) {
        const Motion& motion = m_motions.at(parent.body.slot());
        started.velocity = body.velocity = motion.velocityAt(started.center);
        started.angularVelocity = body.angularVelocity = motion.angularVelocity;
    }
    Shape shape{.name = parent.name, .voxelSize = parent.voxelSize};
    shape.grid = std::move(piece.grid);
    shape.palette = parent.palette;
    shape.paintColors = parent.paintColors;
    shape.moments = moments.shifted(-piece.offset);
    shape.tags = parent.tags;
    shape.isPiece = true;
    shape.nothingLoose = true;
    const BodyHandle bodyHandle = m_world.m_bodies.insert(std::move(body));
    shape.body = bodyHandle;
    const ShapeHandle handle = m_world.m_shapes.insert(std::move(shape));
    m_world.m_bodies.at(bodyHandle).shapes.push_back(handle);
    m_world.placeShape(handle);
    m_world.listDebris(bodyHandle);
    m_changes.bodiesCreated.push_back(bodyHandle);
    m_changes.shapesCreated.push_back(handle);
    return handle;
}

void EditStep::rehome(ShapeHandle handle) {
    Body body{.name = m_world.m_shapes.at(handle).name};
    body.isStatic = false;
    body.pose = m_world.shapeToWorld(handle);
    body.shapes = {handle};
    body.born = m_changes.step;
    const BodyHandle newBody = m_world.m_bodies.insert(std::move(body));
    Shape& shape = m_world.m_shapes.at(handle);
    const BodyHandle oldBody = shape.body;
    std::vector<ShapeHandle>& left = m_world.m_bodies.at(oldBody).shapes;
    std::erase(left, handle);
    if (left.empty()) {
        m_world.m_bodies.erase(oldBody);
        m_changes.bodiesDestroyed.push_back(oldBody);
    }
    shape.body = newBody;
    shape.local = {};
    shape.anchors.clear();
    shape.isPiece = true;
    m_changes.bodiesCreated.push_back(newBody);
    m_changes.rehomed.push_back(handle);
    m_world.m_lights.forEach([&](LightHandle light, const Light& rider) {
        if (rider.shape == handle) m_changes.lights.push_back(light);
    });
}

void EditStep::destroyShape(ShapeHandle handle) {
    putOutLightsOf(handle);
    const BodyHandle body = m_world.m_shapes.at(handle).body;
    m_world.forgetShape(handle);
    m_world.m_shapes.erase(handle);
    m_changes.shapesDestroyed.push_back(handle);
    std::vector<ShapeHandle>& left = m_world.m_bodies.at(body).shapes;
    std::erase(left, handle);
    if (!left.empty()) return;
    m_world.m_bodies.erase(body);
    m_world.listDebris(body);
    m_changes.bodiesDestroyed.push_back(body);
}

void EditStep::rememberMotion(BodyHandle handle) {
    const Body& body = m_world.m_bodies.at(handle);
    if (body.isStatic || m_motions.contains(handle.slot())) return;
    const glm::dvec3 center = body.pose.transformPoint(m_world.bodyMass(handle).center);
    m_motions[handle.slot()] = {handle, center, body.velocity, body.angularVelocity};
}

/// What is left of a body keeps moving as it did: its centre of mass is another one now, and has that point's velocity.
void EditStep::settleMotions() {
    for (const auto& [slot, motion] : m_motions) {
        Body* body = m_world.m_bodies.find(motion.body);
        if (!body) continue;
        const glm::dvec3 center = body->pose.transformPoint(m_world.bodyMass(motion.body).center);
        if (center == motion.center) continue;
        body->velocity = motion.velocityAt(center);
    }
}

}  // namespace rubble
