#include "samples/scenes/fracture.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "runtime/core/random.h"

namespace rubble::scenes {
namespace {

constexpr double kHalfCut = 0.055;  ///< metres: a cut takes one cell, two where it runs askew
constexpr int kRings = 3;

/// cos of the twelfths of a turn; sin is three twelfths behind. Written out: libm differs between machines.
constexpr std::array<double, 12> kCosine = {1.0,  0.86602540378443865,  0.5,  0.0, -0.5, -0.86602540378443865,
                                            -1.0, -0.86602540378443865, -0.5, 0.0, 0.5,  0.86602540378443865};

/// Directions between two twelfths are mixed and made unit length.
glm::dvec2 direction(double twelfths) {
    const int low = int(twelfths);
    const double share = twelfths - low;
    const auto at = [](int i) { return glm::dvec2(kCosine[size_t(i % 12)], kCosine[size_t((i + 9) % 12)]); };
    return glm::normalize(at(low) * (1.0 - share) + at(low + 1) * share);
}

CarveEdit cut(glm::dvec3 from, glm::dvec3 to, glm::dvec3 normal, const Fracture& crack) {
    const glm::dvec3 along = glm::normalize(to - from), across = glm::cross(normal, along);
    CarveEdit edit;
    edit.kind = BrushKind::Box;
    edit.position = (from + to) * 0.5;
    edit.halfSize = {glm::length(to - from) * 0.5, kHalfCut, crack.halfThickness};
    edit.rotation = glm::normalize(glm::quat_cast(glm::dmat3(along, across, normal)));
    edit.hardnessLimit = crack.hardest;
    return edit;
}

}  // namespace

Edits fracture(const Fracture& crack) {
    Random random(crack.seed);
    glm::dvec3 normal(0.0), u(0.0), v(0.0);
    normal[crack.normalAxis] = 1.0;
    u[(crack.normalAxis + 1) % 3] = 1.0;
    v[(crack.normalAxis + 2) % 3] = 1.0;
    const int spokes = std::clamp(crack.spokes, 3, 12);
    std::vector<std::array<glm::dvec3, kRings>> web(static_cast<size_t>(spokes));
    for (int i = 0; i < spokes; ++i) {
        const double jitter = (random.unit() - 0.5) * 0.7;
        const glm::dvec2 way = direction(12.0 + (i + jitter) * 12.0 / spokes);
        for (int ring = 0; ring < kRings; ++ring) {
            const double share = double(ring + 1) / kRings, stray = 0.82 + 0.3 * random.unit();
            web[size_t(i)][size_t(ring)] = crack.center + (u * way.x + v * way.y) * (crack.radius * share * stray);
        }
    }
    Edits out;
    for (int i = 0; i < spokes; ++i) {
        const auto &spoke = web[size_t(i)], &next = web[size_t((i + 1) % spokes)];
        out.push_back(cut(crack.center, spoke[0], normal, crack));
        for (int ring = 0; ring < kRings; ++ring) {
            if (ring > 0) out.push_back(cut(spoke[size_t(ring - 1)], spoke[size_t(ring)], normal, crack));
            out.push_back(cut(spoke[size_t(ring)], next[size_t(ring)], normal, crack));
        }
    }
    return out;
}

}  // namespace rubble::scenes
