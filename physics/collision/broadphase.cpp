#include "physics/collision/broadphase.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "physics/math/bullet_math.h"
#include "runtime/core/random.h"
#include "runtime/core/world_box.h"

namespace rubble {
namespace {

/// Metres by which the leaf of a moving object is larger than its bounds, so that small moves do not change the tree.
constexpr btScalar kFatMargin = 0.05f;
constexpr double kRounding = 1e-4;    ///< metres added to bounds against the rounding of their floats
constexpr double kScatter = 0x1p-17;  ///< share of a coordinate by which a leaf is shifted: 64 steps of a float
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

/// Sorts pairs and drops those that two bodies have added. Those of objects in order are mostly sorted.
void Broadphase::sortPairs(std::vector<ObjectPair>& pairs, size_t from) {
    const auto isBefore = [](const ObjectPair& a, const ObjectPair& b) {
        return a.first->number != b.first->number ? a.first->number < b.first->number
                                                  : a.second->number < b.second->number;
    };
    const auto begin = pairs.begin() + std::ptrdiff_t(from);
    if (!std::is_sorted(begin, pairs.end(), isBefore)) std::sort(begin, pairs.end(), isBefore);
    pairs.erase(std::unique(begin, pairs.end()), pairs.end());
}

/// A moving object is bounded by its parts' hulls, one at rest by their boxes, whose computation touches no voxels.
void Broadphase::setBounds(CollisionObject& object, glm::dvec3 displacement, double margin) const {
    glm::dvec3 low(1e30), high(-1e30);
    for (size_t i = 0; i < object.m_cellTransforms.size(); ++i) {
        const ColliderPart& part = *object.collider.parts[i];
        if (part.grid().empty()) continue;
        const glm::mat3 axes(object.m_cellTransforms[i].axes);
        glm::vec3 partLow, partHigh;
        if (object.m_moves)
            part.hull().bounds(axes, partLow, partHigh);
        else
            HullPoints(part.bounds()).bounds(axes, partLow, partHigh);
        const double gap = part.round() ? kMaxRoundGap * part.voxelSize() : 0.0;
        low = glm::min(low, object.m_cellTransforms[i].corner + glm::dvec3(partLow) - gap);
        high = glm::max(high, object.m_cellTransforms[i].corner + glm::dvec3(partHigh) + gap);
    }
    object.displacement = displacement;
    object.low = object.pose.position + low - margin - kRounding + glm::min(displacement, 0.0);
    object.high = object.pose.position + high + margin + kRounding + glm::max(displacement, 0.0);
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

void Broadphase::move(CollisionObject& object, glm::dvec3 displacement, double margin) {
    setBounds(object, displacement, margin);
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

size_t Broadphase::findPairs(std::span<CollisionObject* const> moving, std::vector<ObjectPair>& out) {
    m_bounds.clear();
    for (const CollisionObject* object : moving) m_bounds.push_back({object->low, object->high});
    m_packed.build(m_bounds, m_origin);
    const size_t from = out.size();
    size_t leftOut = 0;
    for (size_t i = 0; i < moving.size(); ++i) {
        CollisionObject* const object = moving[i];
        m_found.clear();
        m_indices.clear();
        m_nearest.begin(object);
        findIn(m_resting, object->low, object->high, m_found);
        m_packed.find(m_bounds[i], m_indices);
        for (const uint32_t other : m_indices)
            if (other != i && m_bounds[i].overlaps(m_bounds[other])) m_found.push_back(moving[other]);
        const size_t own = out.size();
        for (CollisionObject* other : m_found) {
            const bool isNear = areCrowded(*object, *other) || areNear(*object, *other);
            if (!isNear && other->m_moves && object->number > other->number) continue;  // the other finds the pair
            if (!object->filter.meets(other->filter) || !meet(*object, *other)) continue;
            if (isNear)
                m_nearest.add(other);
            else
                out.push_back(inOrder(object, other));
        }
        for (CollisionObject* other : m_nearest.all()) out.push_back(inOrder(object, other));
        leftOut += m_nearest.leftOut();
        sortPairs(out, own);
    }
    sortPairs(out, from);
    return leftOut;
}

}  // namespace rubble
