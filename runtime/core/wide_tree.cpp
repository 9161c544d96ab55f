#include "runtime/core/wide_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/core/assertion.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace rubble {
namespace {

/// Metres from the middle up to which the errors of floats are below kSlack: 24 bits make 2 mm there, and a ray has
/// some of them.
constexpr double kRange = 2e4;
constexpr double kSlack = 0.02;  ///< metres by which boxes are wider

}  // namespace

/// A node of the BoundsTree.
struct WideTree::Binary {
    WorldBox box;
    uint32_t item = kNone;  ///< kNone: it has children
    uint32_t left = kNone, right = kNone;
};

/// BoundsTree::find() visits a node before its children, and all of one child before the other: that order is the tree.
WideTree::WideTree(const BoundsTree& tree) {
    std::vector<Binary> binary;
    tree.find(
        [&](const WorldBox& box) {
            binary.push_back({box});
            return true;
        },
        [&](uint32_t item) {
            binary.back().item = item;
            m_items.push_back(item);
        });
    if (binary.empty()) return;
    std::vector<uint32_t> lacking;  // children
    for (uint32_t i = 0; i < binary.size(); ++i) {
        if (!lacking.empty()) {
            Binary& parent = binary[lacking.back()];
            (parent.left == kNone ? parent.left : parent.right) = i;
            if (parent.right != kNone) lacking.pop_back();
        }
        if (binary[i].item == kNone) lacking.push_back(i);
    }
    RUBBLE_ASSERT(lacking.empty());
    const WorldBox& all = binary[0].box;
    m_middle = (all.low + all.high) * 0.5;
    const glm::dvec3 half = (all.high - all.low) * 0.5;
    m_radius = std::max({half.x, half.y, half.z});
    m_nodes.reserve(binary.size() / 2 + 1);
    addNode(binary, 0);
}

bool WideTree::isExactFor(const glm::dvec3& origin) const {
    const glm::dvec3 place = origin - m_middle;
    return m_radius <= kRange && std::abs(place.x) <= kRange && std::abs(place.y) <= kRange &&
           std::abs(place.z) <= kRange;
}

/// A node of the children of one of the binary tree, of which the largest is opened until there are four.
uint32_t WideTree::addNode(std::span<const Binary> binary, uint32_t from) {
    std::array<uint32_t, 4> children = {from, kNone, kNone, kNone};
    for (size_t count = 1; count < 4; ++count) {
        size_t largest = 4;
        for (size_t i = 0; i < count; ++i) {
            if (binary[children[i]].item != kNone) continue;
            if (largest == 4 || binary[children[i]].box.area() > binary[children[largest]].box.area()) largest = i;
        }
        if (largest == 4) break;
        const Binary& opened = binary[children[largest]];
        children[largest] = opened.left;
        children[count] = opened.right;
    }
    const auto at = uint32_t(m_nodes.size());
    m_nodes.emplace_back();
    for (size_t i = 0; i < 4; ++i) {
        const bool isThere = children[i] != kNone;
        for (int a = 0; a < 3; ++a) {
            // of none: a box that no ray meets
            const double low = isThere ? binary[children[i]].box.low[a] - m_middle[a] - kSlack : 1e30;
            const double high = isThere ? binary[children[i]].box.high[a] - m_middle[a] + kSlack : -1e30;
            m_nodes[at].low[size_t(a)][i] = float(low);
            m_nodes[at].high[size_t(a)][i] = float(high);
        }
        uint32_t child = kNone;
        if (isThere && binary[children[i]].item != kNone) child = binary[children[i]].item | kLeaf;
        if (isThere && binary[children[i]].item == kNone) child = addNode(binary, children[i]);
        m_nodes[at].children[i] = child;
    }
    return at;
}

WideTree::Ray WideTree::rayOf(const glm::dvec3& origin, const glm::dvec3& direction) const {
    Ray ray{};
    for (int a = 0; a < 3; ++a) {
        ray.origin[size_t(a)] = float(origin[a] - m_middle[a]);
        // A ray along a plane: its slab is met all along or not at all.
        const double along = std::abs(direction[a]) > 1e-20 ? direction[a] : std::copysign(1e-20, direction[a]);
        ray.inverse[size_t(a)] = float(1.0 / along);
    }
    return ray;
}

float WideTree::roundedUp(double distance) {
    return float(std::min(distance * (1.0 + 1e-6) + kSlack, 1e30));
}

/// Where a ray enters and leaves the four boxes of a node: the slab method (Kay & Kajiya 1986) on four at a time.
void WideTree::clip(const Node& node, const Ray& ray, std::array<float, 4>& near, std::array<float, 4>& far) {
#if defined(__SSE2__)
    __m128 enter = _mm_setzero_ps(), leave = _mm_loadu_ps(far.data());
    for (size_t a = 0; a < 3; ++a) {
        const bool isDown = ray.inverse[a] < 0.0f;
        const __m128 origin = _mm_set1_ps(ray.origin[a]), inverse = _mm_set1_ps(ray.inverse[a]);
        const __m128 first = _mm_load_ps((isDown ? node.high : node.low)[a].data());
        const __m128 last = _mm_load_ps((isDown ? node.low : node.high)[a].data());
        enter = _mm_max_ps(enter, _mm_mul_ps(_mm_sub_ps(first, origin), inverse));
        leave = _mm_min_ps(leave, _mm_mul_ps(_mm_sub_ps(last, origin), inverse));
    }
    _mm_storeu_ps(near.data(), enter);
    _mm_storeu_ps(far.data(), leave);
#else
    for (size_t a = 0; a < 3; ++a) {
        const bool isDown = ray.inverse[a] < 0.0f;
        for (size_t i = 0; i < 4; ++i) {
            const float in = ((isDown ? node.high : node.low)[a][i] - ray.origin[a]) * ray.inverse[a];
            const float out = ((isDown ? node.low : node.high)[a][i] - ray.origin[a]) * ray.inverse[a];
            near[i] = std::max(near[i], in);
            far[i] = std::min(far[i], out);
        }
    }
#endif
}

size_t WideTree::push(const Node& node, const Ray& ray, float farthest, Entry* open) {
    std::array<float, 4> near{}, far{farthest, farthest, farthest, farthest};
    clip(node, ray, near, far);
    size_t count = 0;
    for (size_t i = 0; i < 4; ++i) {
        if (!(near[i] <= far[i])) continue;
        size_t place = count++;
        for (; place > 0 && open[place - 1].near < near[i]; --place) open[place] = open[place - 1];
        open[place] = {node.children[i], near[i]};
    }
    return count;
}

}  // namespace rubble
