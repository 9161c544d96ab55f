#include "runtime/shadow/shadow_cell_transform.h"

#include <algorithm>
#include <cmath>

#include "runtime/shadow/shadow_volume.h"

namespace rubble {
namespace {

constexpr double kCell = 0.1;  ///< metres: kShadowCell, which as a float would be 0.15 m off at 10,000 km
static_assert(kShadowCell == float(kCell));
constexpr double kFixedOne = 0x1p32;
constexpr double kMaxPosition = 1e8;  ///< metres: cell coordinates stay within 32 bits
constexpr int kMaxSamples = 8;        ///< voxels under 0.0125 m have samples farther apart than they are wide

FixedPoint toFixed(glm::dvec3 v) {
    FixedPoint out;
    for (int k = 0; k < 3; ++k) out[size_t(k)] = std::llround(v[k] * kFixedOne);
    return out;
}

}  // namespace

bool ShadowCellTransform::place(const Pose& shapeToWorld, double voxelSize) {
    const glm::dquat& r = shapeToWorld.rotation;
    const double square = glm::dot(r, r);
    if (!(square > 0.5 && square < 2.0) || !(voxelSize > 0.0)) return false;
    for (int a = 0; a < 3; ++a)
        if (!(std::fabs(shapeToWorld.position[a]) <= kMaxPosition)) return false;

    const glm::dquat worldToShape = glm::conjugate(r) / std::sqrt(square);
    // Voxels of the cells' size are that of a float, too.
    const double voxelsPerCell = double(kShadowCell) / voxelSize;
    samples = int(std::clamp(std::ceil(voxelsPerCell - 1e-6), 1.0, double(kMaxSamples)));
    glm::dvec3 firstWorld(0.0);
    for (int a = 0; a < 3; ++a) {
        const double cell = std::floor(shapeToWorld.position[a] / kCell);
        base[a] = int(cell);
        firstWorld[a] = (cell + 0.5 / samples) * kCell - shapeToWorld.position[a];
        glm::dvec3 axis(0.0);
        axis[a] = voxelsPerCell / samples;
        step[size_t(a)] = toFixed(worldToShape * axis);
    }
    origin = toFixed(worldToShape * firstWorld / voxelSize);
    return true;
}

bool ShadowCellTransform::isShift() const {
    if (samples != 1) return false;
    for (size_t a = 0; a < 3; ++a)
        for (size_t k = 0; k < 3; ++k)
            if (step[a][k] != (a == k ? int64_t(1) << 32 : 0)) return false;
    return true;
}

CellBox shadowBounds(const Pose& shapeToWorld, double voxelSize, glm::dvec3 lowLocal, glm::dvec3 highLocal) {
    constexpr double kMargin = 1e-3;  // cells: more than all rounding errors together
    glm::dvec3 low(1e300), high(-1e300);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 local(corner & 1 ? highLocal.x : lowLocal.x, corner & 2 ? highLocal.y : lowLocal.y,
                               corner & 4 ? highLocal.z : lowLocal.z);
        const glm::dvec3 world = shapeToWorld.transformPoint(local * voxelSize) / kCell;
        for (int a = 0; a < 3; ++a) {
            low[a] = std::min(low[a], world[a]);
            high[a] = std::max(high[a], world[a]);
        }
    }
    CellBox out;
    for (int a = 0; a < 3; ++a) {
        out.low[a] = int(std::floor(low[a] - kMargin));
        out.high[a] = int(std::floor(high[a] + kMargin)) + 1;
    }
    return out;
}

}  // namespace rubble
