#include "samples/stress/scene_cuts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"

namespace stress {
namespace {

using namespace rubble::script;

/// Brushes count in 1/256 of a cell, see docs/decisions/destruction.md.
constexpr double kBrushUnit = 256.0;
double onBrushGrid(double cells) {
    return std::round(cells * kBrushUnit) / kBrushUnit;
}

/// How many voxels of a shape have their centre within a sphere, whose centre and radius in cells are on the grid of
/// brushes: so the squares are exact.
uint64_t countInSphere(lua_State* L, rubble_shape shape, const int32_t* size, const Vector& center, double radius) {
    auto cells = sized<rubble_voxel_box>();
    cells.shape = shape;
    for (size_t axis = 0; axis < 3; ++axis) {
        cells.low[axis] = std::clamp(int32_t(std::floor(center[axis] - radius)), 0, size[axis] - 1);
        cells.size[axis] = std::clamp(int32_t(2.0 * radius) + 3, 1, size[axis] - cells.low[axis]);
    }
    std::vector<uint8_t> voxels(size_t(cells.size[0]) * size_t(cells.size[1]) * size_t(cells.size[2]));
    uint64_t bytes = 0, count = 0;
    if (!isDone(L, apiOf(L).read_voxels(worldOf(L), &cells, voxels.data(), voxels.size(), &bytes))) return 0;
    size_t at = 0;
    for (int z = 0; z < cells.size[2]; ++z)
        for (int y = 0; y < cells.size[1]; ++y)
            for (int x = 0; x < cells.size[0]; ++x) {
                const Vector middle{cells.low[0] + x + 0.5, cells.low[1] + y + 0.5, cells.low[2] + z + 0.5};
                const Vector away = middle - center;
                count += voxels[at++] && dot(away, away) <= radius * radius;
            }
    return count;
}

}  // namespace

int exactHole(lua_State* L) {
    const rubble_shape shape = handleAt(L, 1, "shape");
    Vector cell = vectorAt(L, 2, "cell");
    for (double& each : cell) each = onBrushGrid(each);
    const double radius = onBrushGrid(std::clamp(numberAt(L, 3, "radius"), 0.3, 60.0));
    auto state = rubble_shape_state{};
    if (!isDone(L, apiOf(L).get_shape_state(worldOf(L), shape, &state))) return 0;
    SceneRequests& requests = requestsOf(L);
    requests.holes.push_back({shape, countInSphere(L, shape, state.size, cell, radius),
                              ScriptContext::of(L).shared.step + requests.extraSteps + 1});
    const Placement frame = placementOf(state.position, state.rotation);
    auto carve = sized<rubble_carve>();
    copy(carve.position, toParent(frame, cell * state.voxel_size));
    std::fill_n(carve.radii, 3, radius * state.voxel_size);
    carve.shape = shape;
    isDone(L, apiOf(L).carve(worldOf(L), &carve));
    return 0;
}

int cut(lua_State* L) {
    auto carve = sized<rubble_carve>();
    carve.shape = handleAt(L, 1, "shape");
    carve.brush = RUBBLE_BRUSH_BOX;
    copy(carve.position, vectorAt(L, 2, "pos"));
    copy(carve.half_size, vectorAt(L, 3, "half"));
    const Rotation rotation = rotationAt(L, 4, "rot");
    std::copy(rotation.begin(), rotation.end(), carve.rotation);
    isDone(L, apiOf(L).carve(worldOf(L), &carve));
    return 0;
}

}  // namespace stress
