#include "physics/character/character_queries.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

glm::dvec3 normalToWorld(const CellTransform& cells, double voxelSize, glm::dvec3 normal) {
    return cells.axes * normal / voxelSize;
}

}  // namespace

CharacterQueries::CharacterQueries(const Character& character, const CharacterSurroundings& around)
    : m_c(character), m_around(around), m_minNormalY(1.0 / std::sqrt(1.0 + character.maxSlope * character.maxSlope)) {}

/// Calls f(object, index, part) for the parts that the character collides with.
template <class F>
void CharacterQueries::forEachPart(F&& f) const {
    const CollisionFilter mine{m_c.collisionLayer, m_c.collisionMask};
    for (CollisionObject* object : m_around.objects)
        for (size_t i = 0; !(m_ignoresBodies && object->dynamic) && i < object->collider.parts.size(); ++i)
            if (object->collider.parts[i]->filter().meets(mine)) f(*object, i, *object->collider.parts[i]);
}

/// The capsule in the cells of a part.
CellShape CharacterQueries::capsule(const CollisionObject& object, size_t part, glm::dvec3 feet, double height,
                                    double radius) const {
    const CellTransform& cells = object.cellTransforms()[part];
    const double size = object.collider.parts[part]->voxelSize();
    const glm::dvec3 corner = object.pose.position + cells.corner;
    const glm::dmat3 toCells = metresToCells(cells, size);
    CellShape shape;
    shape.a = toCells * (feet + kUp * m_c.radius - corner);
    shape.b = toCells * (feet + kUp * (height - m_c.radius) - corner);
    shape.radius = radius / size;
    return shape;
}

CharacterHit CharacterQueries::sweep(glm::dvec3 from, glm::dvec3 displacement) const {
    CharacterHit best;
    forEachPart([&](CollisionObject& object, size_t i, const ColliderPart& part) {
        const CellTransform& cells = object.cellTransforms()[i];
        const double size = part.voxelSize();
        const CellContact contact = castShape(part.grid(), capsule(object, i, from, m_c.currentHeight(), m_c.radius),
                                              glm::transpose(cells.axes) * displacement / (size * size), best.t);
        if (!contact.hit || (best.hit && contact.t >= best.t)) return;
        best = {true, contact.t, normalToWorld(cells, size, contact.normal),
                object.pose.position + cells.corner + cells.axes * contact.point, &object};
        classifyFace(part, cells, contact, best);
    });
    return best;
}

/// Whether the contact is on an exposed face that it can stand on. Seams and edges of voxels are no slopes.
void CharacterQueries::classifyFace(const ColliderPart& part, const CellTransform& cells, const CellContact& contact,
                                    CharacterHit& out) const {
    for (int face = 0; face < 6; ++face) {
        const int axis = face >> 1, sign = face & 1 ? 1 : -1;
        glm::ivec3 outward(0);
        outward[axis] = sign;
        const double plane = contact.cell[axis] + (sign > 0 ? 1.0 : 0.0);
        if (std::abs(contact.point[axis] - plane) > 1e-6 || part.grid().at(contact.cell + outward)) continue;
        const glm::dvec3 normal = normalToWorld(cells, part.voxelSize(), glm::dvec3(outward));
        if (normal.y < m_minNormalY) continue;
        out.isFlat = true;
        out.isSlope = out.isSlope || glm::dot(normal, out.normal) > 0.999;
    }
}

bool CharacterQueries::isFree(glm::dvec3 feet, double height) const {
    bool free = true;
    forEachPart([&](CollisionObject& object, size_t i, const ColliderPart& part) {
        free = free && !findOverlap(part.grid(), capsule(object, i, feet, height, m_c.radius));
    });
    return free;
}

bool CharacterQueries::isFreeOfStatic(glm::dvec3 feet) const {
    bool free = true;
    forEachPart([&](CollisionObject& object, size_t i, const ColliderPart& part) {
        free = free &&
               (object.dynamic || !findOverlap(part.grid(), capsule(object, i, feet, m_c.currentHeight(), m_c.radius)));
    });
    return free;
}

double CharacterQueries::castPoint(glm::dvec3 from, glm::dvec3 displacement) const {
    double way = 1.0;
    forEachPart([&](CollisionObject& object, size_t i, const ColliderPart& part) {
        const glm::dmat3 toCells = metresToCells(object.cellTransforms()[i], part.voxelSize());
        CellShape point;
        point.a = point.b = toCells * (from - object.pose.position - object.cellTransforms()[i].corner);
        const CellContact contact = castShape(part.grid(), point, toCells * displacement, way);
        if (contact.hit) way = std::min(way, contact.t);
    });
    return way;
}

CharacterHit CharacterQueries::findDeepest(glm::dvec3 feet, double extra, double& depth) const {
    CharacterHit worst;
    depth = 0.0;
    forEachPart([&](CollisionObject& object, size_t i, const ColliderPart& part) {
        const CellTransform& cells = object.cellTransforms()[i];
        const double size = part.voxelSize(), radius = m_c.radius + extra;
        const CellContact contact =
            rubble::findDeepest(part.grid(), capsule(object, i, feet, m_c.currentHeight(), radius));
        const double here = contact.hit ? radius - contact.t * size : 0.0;
        const bool outranks = object.dynamic == nullptr && worst.object && worst.object->dynamic;
        if (here <= 1e-6 || (worst.hit && here <= depth && !outranks) ||
            (worst.object && !worst.object->dynamic && object.dynamic))
            return;
        depth = here;
        worst = {true, 0.0, normalToWorld(cells, size, contact.normal),
                 object.pose.position + cells.corner + cells.axes * contact.point, &object};
    });
    return worst;
}

}  // namespace rubble
