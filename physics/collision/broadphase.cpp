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
constexpr size_t kMaxNear = 16;     ///< pairs of a body with those that it is deep in
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

/// Whether the bounds of two objects, which move on straight lines, overlap at some time of the step. The boxes that
/// they sweep may overlap although one has passed long before the other comes. Those boxes are taken for what moves
/// less than its size.
bool Broadphase::meet(const CollisionObject& a, const CollisionObject& b) {
    const glm::dvec3 path = a.displacement - b.displacement;
    const double size = 2.0 * std::min(a.radius, b.radius);
    if (glm::dot(path, path) <= size * size) return true;
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

/// Adds the pairs of an object with the nearest of those that it is deep in, whatever their numbers: they may add them,
/// too. Returns how many it left out.
size_t Broadphase::addNearest(CollisionObject* object, std::vector<ObjectPair>& out) {
    const size_t kept = std::min(m_near.size(), kMaxNear), leftOut = m_near.size() - kept;
    if (leftOut)
        std::nth_element(m_near.begin(), m_near.begin() + std::ptrdiff_t(kept), m_near.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
    for (size_t i = 0; i < kept; ++i) out.push_back(inOrder(object, m_near[i].second));
    return leftOut;
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

void Broadphase::find(glm::dvec3 low, glm::dvec3 high, std::vector<CollisionObject*>& out) {
    struct Collect : btDbvt::ICollide {
        Collect(const WorldBox& b, std::vector<CollisionObject*>& found) : box(b), objects(found) {}
        void Process(const btDbvtNode* leaf) override {
            auto* object = static_cast<CollisionObject*>(leaf->data);
            if (box.overlaps({object->low, object->high})) objects.push_back(object);
        }
        const WorldBox box;
        std::vector<CollisionObject*>& objects;
    } collect({low, high}, out);
    const btDbvtVolume volume = volumeOf(low, high);
    for (const Tree* tree : {&m_resting, &m_moving})
        tree->nodes.collideTVNoStackAlloc(tree->nodes.m_root, volume, m_stack, collect);
}

}  // namespace rubble
