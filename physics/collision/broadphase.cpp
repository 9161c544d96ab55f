#include "physics/collision/broadphase.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "physics/math/bullet_math.h"
#include "runtime/core/random.h"
#include "runtime/core/rotated_box.h"
#include "runtime/core/world_box.h"

namespace rubble {
namespace {

/// Metres by which the leaf of a moving object is larger than its bounds, so that small moves do not change the tree.
constexpr btScalar kFatMargin = 0.05f;
constexpr double kBoundsRounding = 1e-4;  ///< metres added to bounds against the rounding of their floats
constexpr double kScatter = 0x1p-17;      ///< share of a coordinate by which a leaf is shifted: 64 steps of a float
constexpr int kSlack = 16;          ///< nodes by which a shallow tree is deeper than twice the logarithm of its leaves
constexpr int kRebuildVisits = 16;  ///< visits of nodes that cost as much as a leaf of a tree built from top down

int depthOf(const btDbvtNode* node) {
    int depth = 0;
    for (; node; node = node->parent) ++depth;
    return depth;
}

int depthBelow(const btDbvtNode* node) {
    return !node ? 0 : node->isleaf() ? 1 : 1 + std::max(depthBelow(node->childs[0]), depthBelow(node->childs[1]));
}

}  // namespace

/// Whether the bounds of two objects, which move on straight lines, overlap at some time of the step.
bool Broadphase::boundsMeet(const CollisionObject& a, const CollisionObject& b) {
    const glm::dvec3 path = a.displacement - b.displacement;
    // Of b's corners from a's, at the beginning.
    const glm::dvec3 low = b.low - glm::min(b.displacement, 0.0) - (a.high - glm::max(a.displacement, 0.0)),
                     high = b.high - glm::max(b.displacement, 0.0) - (a.low - glm::min(a.displacement, 0.0));
    double from = 0.0, to = 1.0;  // of the step
    for (int axis = 0; axis < 3; ++axis) {
        if (path[axis] == 0.0) {
            if (low[axis] > 0.0 || high[axis] < 0.0) return false;
            continue;
        }
        const double enter = low[axis] / path[axis], leave = high[axis] / path[axis];
        from = std::max(from, std::min(enter, leave));
        to = std::min(to, std::max(enter, leave));
    }
    return from <= to;
}

/// Appends the unsorted pairs, sorted, without those that two bodies have added. Those of each moving body as the first
/// are brought together before they are compared; few begin with one at rest.
void Broadphase::sortPairs(size_t moving, std::vector<ObjectPair>& out) {
    const auto isBefore = [](const ObjectPair& a, const ObjectPair& b) {
        return a.first->number != b.first->number ? a.first->number < b.first->number
                                                  : a.second->number < b.second->number;
    };
    const auto appended = std::ptrdiff_t(out.size());
    m_ends.assign(moving + 1, 0);
    for (const auto& [first, second] : m_unsorted)
        if (first->m_moves) ++m_ends[first->m_place + 1];
    for (size_t i = 0; i < moving; ++i) m_ends[i + 1] += m_ends[i];
    out.resize(out.size() + m_ends.back());
    for (const ObjectPair& pair : m_unsorted)
        if (pair.first->m_moves) out[size_t(appended) + m_ends[pair.first->m_place]++] = pair;
    for (size_t i = 0, from = 0; i < moving; from = m_ends[i++])
        std::sort(out.begin() + appended + std::ptrdiff_t(from), out.begin() + appended + std::ptrdiff_t(m_ends[i]),
                  isBefore);
    if (!std::is_sorted(out.begin() + appended, out.end(), isBefore))  // the objects were not in order
        std::sort(out.begin() + appended, out.end(), isBefore);
    const auto ofMoving = std::ptrdiff_t(out.size());
    for (const ObjectPair& pair : m_unsorted)
        if (!pair.first->m_moves) out.push_back(pair);
    std::sort(out.begin() + ofMoving, out.end(), isBefore);
    std::inplace_merge(out.begin() + appended, out.begin() + ofMoving, out.end(), isBefore);
    out.erase(std::unique(out.begin() + appended, out.end()), out.end());
}

/// A moving object is bounded by its parts' hulls, one at rest by their boxes, whose computation touches no voxels.
void Broadphase::setBounds(CollisionObject& object, glm::dvec3 displacement, double margin) const {
    glm::dvec3 low(1e30), high(-1e30);
    for (size_t i = 0; i < object.m_cellTransforms.size(); ++i) {
        const ColliderPart& part = *object.collider.parts[i];
        if (part.grid().empty()) continue;
        const glm::mat3 axes(object.m_cellTransforms[i].axes);
        glm::vec3 partLow, partHigh;
        const BoxSurface* const box = object.m_moves ? part.box() : nullptr;
        if (box) {
            const glm::vec3 middle = axes * box->center, half = rotatedHalfExtent(axes, box->half);
            partLow = middle - half, partHigh = middle + half;
        } else if (object.m_moves)
            part.hull().bounds(axes, partLow, partHigh);
        else
            HullPoints(part.bounds()).bounds(axes, partLow, partHigh);
        const double gap = part.round() ? kMaxRoundGap * part.voxelSize() : 0.0;
        low = glm::min(low, object.m_cellTransforms[i].corner + glm::dvec3(partLow) - gap);
        high = glm::max(high, object.m_cellTransforms[i].corner + glm::dvec3(partHigh) + gap);
    }
    object.displacement = displacement;
    object.low = object.pose.position + low - margin - kBoundsRounding + glm::min(displacement, 0.0);
    object.high = object.pose.position + high + margin + kBoundsRounding + glm::max(displacement, 0.0);
}

btDbvtVolume Broadphase::volumeOf(glm::dvec3 low, glm::dvec3 high) const {
    return btDbvtVolume::FromMM(toBullet(low - m_origin), toBullet(high - m_origin));
}

/// The bounds, a little larger and shifted at random by the object's number. An insertion descends to the child whose
/// centre is nearer, so objects whose boxes have the same centre would make a list.
btDbvtVolume Broadphase::scatteredVolumeOf(const CollisionObject& object) const {
    Random random(object.number);
    const float x = random.unit(), y = random.unit(), z = random.unit();
    const glm::dvec3 below(x, y, z), low = object.low - m_origin, high = object.high - m_origin;
    const glm::dvec3 margin = kScatter * glm::max(glm::abs(low), glm::abs(high));
    return btDbvtVolume::FromMM(toBullet(low - below * margin), toBullet(high + (1.0 - below) * margin));
}

/// An insertion never balances one of Bullet's trees: objects that are added in the order of a row make a list, too. So
/// the visits that insertions have cost beyond a shallow tree's are counted, and as soon as they reach what a rebuild
/// costs, the tree is rebuilt. All insertions together then take at most a multiple of n^1.5 visits.
void Broadphase::Tree::keepShallow(const btDbvtNode* inserted) {
    const int shallow = 2 * int(std::bit_width(unsigned(nodes.m_leaves))) + kSlack;
    excess += std::max(0, depthOf(inserted) - shallow);
    if (excess < int64_t(kRebuildVisits) * nodes.m_leaves) return;
    nodes.optimizeTopDown(4);
    excess = 0;
}

int Broadphase::depth() const {
    return std::max(depthBelow(m_moving.nodes.m_root), depthBelow(m_resting.nodes.m_root));
}

void Broadphase::add(CollisionObject& object, bool moves) {
    touch(object);
    insert(object, moves);
}

void Broadphase::setMoving(CollisionObject& object, bool moves) {
    remove(object);
    insert(object, moves);
}

void Broadphase::insert(CollisionObject& object, bool moves) {
    object.m_moves = moves;
    object.turn = 0.0;
    setBounds(object, glm::dvec3(0.0), 0.0);
    Tree& tree = treeOf(object);
    object.m_leaf = tree.nodes.insert(scatteredVolumeOf(object), &object);
    tree.keepShallow(object.m_leaf);
}

void Broadphase::remove(CollisionObject& object) {
    if (!object.m_leaf) return;
    treeOf(object).nodes.remove(object.m_leaf);
    object.m_leaf = nullptr;
}

void Broadphase::move(CollisionObject& object) {
    const btDbvtVolume& leaf = object.m_leaf->volume;
    const auto toWorld = [&](const btVector3& v) { return glm::dvec3(v.x(), v.y(), v.z()) + m_origin; };
    const WorldBox now{toWorld(leaf.Mins()), toWorld(leaf.Maxs())};
    if (glm::all(glm::lessThanEqual(now.low, object.low)) && glm::all(glm::greaterThanEqual(now.high, object.high)))
        return;
    btDbvtVolume volume = scatteredVolumeOf(object);
    if (m_moving.nodes.update(object.m_leaf, volume, btVector3(0, 0, 0), kFatMargin))
        m_moving.keepShallow(object.m_leaf);
}

void Broadphase::findIn(const Tree& tree, glm::dvec3 low, glm::dvec3 high, std::vector<CollisionObject*>& out) {
    const WorldBox box{low, high};
    const btDbvtVolume volume = volumeOf(low, high);
    m_stack.assign(1, tree.nodes.m_root);
    while (!m_stack.empty()) {
        const btDbvtNode* node = m_stack.back();
        m_stack.pop_back();
        while (node && Intersect(node->volume, volume)) {
            if (node->isleaf()) {
                auto* object = static_cast<CollisionObject*>(node->data);
                if (box.overlaps({object->low, object->high})) out.push_back(object);
                break;
            }
            m_stack.push_back(node->childs[1]);
            node = node->childs[0];
        }
    }
}

void Broadphase::find(glm::dvec3 low, glm::dvec3 high, std::vector<CollisionObject*>& out) {
    findIn(m_resting, low, high, out);
    findIn(m_moving, low, high, out);
}

/// The bodies that are the nearest to a moving object, of those deep in it or in its crowd.
NearestBodies& Broadphase::nearestTo(CollisionObject* object) {
    uint32_t& number = m_nearestOf[object->m_place];
    if (number == 0) {
        number = ++m_usedNearest;
        if (m_nearest.size() < number) m_nearest.emplace_back();
        m_nearest[number - 1].begin(object);
    }
    return m_nearest[number - 1];
}

/// Takes a pair whose bounds overlap. a: it moves.
void Broadphase::addPair(CollisionObject* a, CollisionObject* b) {
    if (!a->filter.meets(b->filter) || !meet(*a, *b)) return;
    if (!areCrowded(*a, *b) && !areNear(*a, *b)) return m_unsorted.push_back(inOrder(a, b));
    nearestTo(a).add(b);
    if (b->m_moves) nearestTo(b).add(a);
}

size_t Broadphase::findPairs(std::span<CollisionObject* const> moving, std::vector<ObjectPair>& out) {
    m_bounds.clear();
    for (size_t i = 0; i < moving.size(); ++i) {
        m_bounds.push_back({moving[i]->low, moving[i]->high});
        moving[i]->m_place = uint32_t(i);
    }
    m_packed.build(m_bounds, m_origin);
    m_indices.clear();
    m_packed.findPairs(m_indices);
    m_unsorted.clear();
    m_nearestOf.assign(moving.size(), 0);
    m_usedNearest = 0;
    for (const auto& [i, k] : m_indices)
        if (m_bounds[i].overlaps(m_bounds[k])) addPair(moving[i], moving[k]);
    for (CollisionObject* object : moving) {
        m_found.clear();
        findIn(m_resting, object->low, object->high, m_found);
        for (CollisionObject* other : m_found) addPair(object, other);
    }
    size_t leftOut = 0;
    for (const NearestBodies& nearest : std::span(m_nearest).first(m_usedNearest)) {
        for (CollisionObject* other : nearest.all()) m_unsorted.push_back(inOrder(nearest.object(), other));
        leftOut += nearest.leftOut();
    }
    sortPairs(moving.size(), out);
    return leftOut;
}

}  // namespace rubble
