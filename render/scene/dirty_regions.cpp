#include "render/scene/dirty_regions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace rubble {
namespace {

DirtyRegions::Box unionOf(const DirtyRegions::Box& a, const DirtyRegions::Box& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high), a.area + b.area};
}

/// Words in a box, as a double: a box may be as large as the world.
double volumeOf(const DirtyRegions::Box& box) {
    const glm::dvec3 size(box.high - box.low);
    return size.x * size.y * size.z;
}

/// The box of some words of a brick, a bit each: x + 4 y + 16 z.
DirtyRegions::Box boxOf(uint64_t words) {
    DirtyRegions::Box box{glm::ivec3(kShadowBrickWords), glm::ivec3(0)};
    for (; words; words &= words - 1) {
        const int word = std::countr_zero(words);
        const glm::ivec3 at(word & 3, word >> 2 & 3, word >> 4);
        box.low = glm::min(box.low, at);
        box.high = glm::max(box.high, at + 1);
    }
    return box;
}

}  // namespace

void DirtyRegions::add(const Box& box) {
    Box* best = nullptr;
    double smallest = std::numeric_limits<double>::max();
    for (Box& each : m_boxes)
        if (const double growth = volumeOf(unionOf(each, box)) - volumeOf(each); growth < smallest)
            smallest = growth, best = &each;
    const bool joins = best && (smallest <= volumeOf(box) || m_boxes.size() == kMaxRegions);
    if (joins)
        *best = unionOf(*best, box);
    else
        m_boxes.push_back(box);
}

void DirtyRegions::add(const std::vector<ShadowPatch>& patches) {
    constexpr float kFace = kShadowCell * kShadowCell, kSides = 2.0f;  // where a piece was, and where it is
    for (const ShadowPatch& patch : patches) {
        if (!patch.change.words) continue;
        Box box = boxOf(patch.change.words);
        box.low += patch.brick * kShadowBrickWords;
        box.high += patch.brick * kShadowBrickWords;
        box.area = kSides * kFace * std::pow(float(patch.change.cells), 2.0f / 3.0f);
        add(box);
    }
}

DirtyRegions DirtyRegions::begin(const DirtyRegions& last) const {
    DirtyRegions begun = *this;
    begun.m_followOthers = !last.m_boxes.empty();
    return begun;
}

}  // namespace rubble
