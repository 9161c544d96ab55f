#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "runtime/core/bounds_tree.h"

namespace rubble {

/// A BoundsTree as many rays read it: four boxes a node, in floats about the middle, tested together and visited from
/// near to far (H. Dammertz et al., Shallow Bounding Volume Hierarchies for Fast SIMD Ray Tracing, 2008). Its boxes are
/// a little wider than the tree's. It costs a pass over the tree and does not follow it. [any-thread] to read.
class WideTree {
public:
    /// Copies a tree as it is.
    explicit WideTree(const BoundsTree& tree);
    /// All items of the tree.
    std::span<const uint32_t> items() const { return m_items; }
    /// Whether floats find all that a ray from here meets: neither the tree nor the point is too far from the middle.
    bool isExactFor(const glm::dvec3& origin) const;

    /// Calls f(item) for all items whose boxes a ray of unit direction may meet within a distance, those of nearer
    /// boxes first where boxes are apart. f returns the distance that counts from then on.
    template <class F>
    void findAlong(const glm::dvec3& origin, const glm::dvec3& direction, double distance, F&& f) const {
        if (m_nodes.empty()) return;
        const Ray ray = rayOf(origin, direction);
        float farthest = roundedUp(distance);
        std::array<Entry, kStack> open;
        size_t count = 1;
        open[0] = {0, 0.0f};
        while (count > 0) {
            const Entry entry = open[--count];
            if (entry.near > farthest) continue;
            if (entry.child & kLeaf)
                farthest = roundedUp(f(entry.child & ~kLeaf));
            else
                count += push(m_nodes[entry.child], ray, farthest, &open[count]);
        }
    }

private:
    static constexpr uint32_t kLeaf = 0x80000000u, kNone = ~0u;
    static constexpr size_t kStack = 512;  ///< three entries a level: more than any balanced tree needs
    struct Node {
        alignas(16) std::array<std::array<float, 4>, 3> low, high;  ///< by axis, then child
        std::array<uint32_t, 4> children;                           ///< a node, or an item with kLeaf; or kNone
    };
    struct Ray {
        std::array<float, 3> origin, inverse;
    };
    struct Entry {
        uint32_t child;
        float near;
    };
    struct Binary;

    Ray rayOf(const glm::dvec3& origin, const glm::dvec3& direction) const;
    static float roundedUp(double distance);
    /// Appends the children that the ray meets, the farthest first; returns how many.
    static size_t push(const Node& node, const Ray& ray, float farthest, Entry* open);
    static void clip(const Node& node, const Ray& ray, std::array<float, 4>& near, std::array<float, 4>& far);
    uint32_t addNode(std::span<const Binary> binary, uint32_t from);

    glm::dvec3 m_middle{0.0};
    double m_radius = 0.0;  ///< metres: half the longest side of the tree's box
    std::vector<Node> m_nodes;
    std::vector<uint32_t> m_items;
};

}  // namespace rubble
