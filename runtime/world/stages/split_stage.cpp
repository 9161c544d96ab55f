#include <algorithm>
#include <cmath>

#include "runtime/destruction/local_connectivity.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {

/// What broke out of shapes becomes pieces at once: it is in no grid any more.
void EditStep::releaseFragments() {
    for (auto& [slot, broken] : m_editStates) {
        if (broken.fragments.empty()) continue;
        ShapeSplit split{.parent = broken.shape};
        for (auto& [fragment, palette, paintColors] : broken.fragments) {
            split.parentOffset.push_back(fragment.piece.offset);
            split.children.push_back(
                createPiece(broken.shape, std::move(fragment.piece), fragment.moments, split.motions.emplace_back()));
            Shape& child = m_world.m_shapes.at(split.children.back());
            child.palette = std::move(palette);
            child.paintColors = std::move(paintColors);
        }
        broken.fragments.clear();
        m_cutWires.insert(broken.shape.slot());
        moveLights(split);
        moveJoints(split);
        m_changes.splits.push_back(std::move(split));
    }
}

/// Splits what was cut in this step, or waits since an earlier one, as far as the budget goes.
void EditStep::splitShapes() {
    releaseFragments();
    std::vector<PendingSplit>& line = m_world.m_pendingSplits;
    for (auto& [slot, each] : m_editStates) {
        if (each.carved.empty() && !each.lostVoxels) continue;
        auto known = std::find_if(line.begin(), line.end(),
                                  [shape = each.shape](const PendingSplit& pending) { return pending.shape == shape; });
        if (known == line.end() && isStillConnected(each)) continue;
        if (known == line.end()) known = line.insert(line.end(), {each.shape, {}, {}});
        known->cut.insert(each.carved);
        known->search.reset();
    }
    size_t budget = m_world.m_settings.split.partsPerStep;
    if (budget == 0) budget = SIZE_MAX;
    size_t done = 0;
    while (done < line.size() && continueSearch(line[done], budget)) ++done;
    line.erase(line.begin(), line.begin() + ptrdiff_t(done));
}

/// Whether a cut shape is known at a glance to be in one piece still.
bool EditStep::isStillConnected(const ShapeEditState& each) const {
    const Shape* shape = m_world.m_shapes.find(each.shape);
    if (!shape || !shape->knownConnected || each.lostVoxels || shape->grid.empty()) return false;
    const bool isAnchored = m_world.m_bodies.at(shape->body).isStatic;
    if (!isAnchored && shape->grid.voxelCount() < m_world.m_settings.minPieceVoxels) return false;
    return isLocallyConnected(shape->grid, each.lost,
                              isAnchored ? std::span<const CellBox>(shape->anchors) : std::span<const CellBox>());
}

/// True if there is nothing left to do for the shape: it has been split, or is gone.
bool EditStep::continueSearch(PendingSplit& pending, size_t& budget) {
    Shape* shape = m_world.m_shapes.find(pending.shape);
    if (!shape) return true;
    if (budget == 0) return false;
    const bool isAnchored = m_world.m_bodies.at(shape->body).isStatic;
    if (!shape->knownConnected) {  // a shape's first cut looks at all of it, at once
        recordMotion(shape->body);
        shape->knownConnected = true;
        budget -= std::min(budget, shape->grid.brickCount() / 64 + 1);
        splitShape(pending.shape, findDetached(shape->grid, shape->anchors, isAnchored));
        return true;
    }
    if (!pending.search) pending.search.emplace(shape->grid, shape->anchors, isAnchored, pending.cut);
    if (!pending.search->run(shape->grid, shape->anchors, budget)) {
        budget = 0;
        return false;
    }
    recordMotion(shape->body);
    splitShape(pending.shape, detachedFrom(*pending.search, shape->grid, isAnchored));
    return true;
}

void EditStep::splitShape(ShapeHandle parent, const Detached& loose) {
    const uint64_t smallest = m_world.m_settings.minPieceVoxels;
    Shape* shape = &m_world.m_shapes.at(parent);
    const bool isAnchored = m_world.m_bodies.at(shape->body).isStatic;
    const Densities densities(*shape->palette, m_world.m_materials);
    ShapeSplit split{.parent = parent};
    for (const Component& component : loose.pieces) {
        const MassMoments moments = componentMoments(shape->grid, component, densities);
        if (moments.weight == 0) continue;  // unphysical voxels are not editState: they stay where they are
        editState(parent).carved.insert(component);
        shape->moments -= moments;
        if (component.voxels < smallest) {
            discardPiece(parent, component);
            continue;
        }
        Piece piece = takePiece(shape->grid, component);
        split.parentOffset.push_back(piece.offset);
        split.children.push_back(createPiece(parent, std::move(piece), moments, split.motions.emplace_back()));
        shape = &m_world.m_shapes.at(parent);  // the new shape may have moved the others
    }
    const bool isFree = loose.isUnanchored || !isAnchored;
    if (isFree && shape->grid.voxelCount() < smallest)
        for (const Component& rest : findComponents(shape->grid)) {
            editState(parent).carved.insert(rest);
            shape->moments -= componentMoments(shape->grid, rest, densities);
            discardPiece(parent, rest);
        }
    if (!split.children.empty()) {
        m_cutWires.insert(parent.slot());
        moveLights(split);
        moveJoints(split);
    }
    if (shape->grid.empty())
        destroyShape(parent);
    else if (loose.isUnanchored && shape->moments.weight > 0)
        detachToNewBody(parent);
    if (!split.children.empty()) m_changes.splits.push_back(std::move(split));
}

void EditStep::discardPiece(ShapeHandle parent, const Component& component) {
    Shape& shape = m_world.m_shapes.at(parent);
    std::array<uint64_t, 256> removed{};
    forEachSubset(shape.grid, component, [&](glm::ivec3, const Brick& brick, const BrickBits& voxels) {
        forEachVoxel(voxels, [&](int i) { ++removed[brick.at(i)]; });
    });
    const Densities densities(*shape.palette, m_world.m_materials);
    const MassProperties mass = massProperties(componentMoments(shape.grid, component, densities), shape.voxelSize);
    takePiece(shape.grid, component);
    const double radius = 0.5 * shape.voxelSize * std::cbrt(double(component.voxels));
    recordRemoved(
        parent, removed,
        {m_world.shapeToWorld(parent).transformPoint(mass.center), radius, m_world.m_bodies.at(shape.body).velocity});
}

ShapeHandle EditStep::createPiece(ShapeHandle parentHandle, Piece piece, const MassMoments& moments,
                                  PieceMotion& started) {
    const Shape& parent = m_world.m_shapes.at(parentHandle);
    const Body& from = m_world.m_bodies.at(parent.body);
    Body body{.name = parent.name};
    body.isStatic = false;
    body.pose = m_world.shapeToWorld(parentHandle) * Pose{glm::dvec3(piece.offset) * double(parent.voxelSize)};
    body.createdStep = m_changes.step;
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
    shape.loadBearing = parent.loadBearing;
    shape.strength = parent.strength;
    shape.collisionLayer = parent.collisionLayer;
    shape.collisionMask = parent.collisionMask;
    shape.isPiece = true;
    shape.knownConnected = true;
    const BodyHandle bodyHandle = m_world.m_bodies.insert(std::move(body));
    shape.body = bodyHandle;
    const ShapeHandle handle = m_world.m_shapes.insert(std::move(shape));
    m_world.m_bodies.at(bodyHandle).shapes.push_back(handle);
    m_world.updateShapeBounds(handle);
    m_world.updateDebris(bodyHandle);
    m_changes.bodiesCreated.push_back(bodyHandle);
    m_changes.shapesCreated.push_back(handle);
    return handle;
}

void EditStep::detachToNewBody(ShapeHandle handle) {
    Body body{.name = m_world.m_shapes.at(handle).name};
    body.isStatic = false;
    body.pose = m_world.shapeToWorld(handle);
    body.shapes = {handle};
    body.createdStep = m_changes.step;
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
    m_changes.unanchored.push_back(handle);
    for (const JointHandle joint : m_world.jointsOf(handle)) m_changes.jointsChanged.push_back(joint);
    m_world.m_lights.forEach([&](LightHandle light, const Light& rider) {
        if (rider.shape == handle) m_changes.lights.push_back(light);
    });
}

void EditStep::destroyShape(ShapeHandle handle) {
    turnOffLightsOf(handle);
    releaseJointsOf(handle);
    const BodyHandle body = m_world.m_shapes.at(handle).body;
    m_world.removeShapeBounds(handle);
    m_world.m_shapes.erase(handle);
    m_changes.shapesDestroyed.push_back(handle);
    std::vector<ShapeHandle>& left = m_world.m_bodies.at(body).shapes;
    std::erase(left, handle);
    if (!left.empty()) return;
    m_world.m_bodies.erase(body);
    m_world.updateDebris(body);
    m_changes.bodiesDestroyed.push_back(body);
}

void EditStep::recordMotion(BodyHandle handle) {
    const Body& body = m_world.m_bodies.at(handle);
    if (body.isStatic || m_motions.contains(handle.slot())) return;
    const glm::dvec3 center = body.pose.transformPoint(m_world.bodyMass(handle).center);
    m_motions[handle.slot()] = {handle, center, body.velocity, body.angularVelocity};
}

/// What is left of a body keeps moving as it did: its centre of mass is another one now, and has that point's velocity.
void EditStep::updateVelocities() {
    for (const auto& [slot, motion] : m_motions) {
        Body* body = m_world.m_bodies.find(motion.body);
        if (!body) continue;
        const glm::dvec3 center = body->pose.transformPoint(m_world.bodyMass(motion.body).center);
        if (center == motion.center) continue;
        body->velocity = motion.velocityAt(center);
    }
}

}  // namespace rubble
