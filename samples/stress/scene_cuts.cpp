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

using Ball = SceneRequests::Hole::Ball;

/// Centres and radii are on the grid of brushes: so the squares are exact.
bool isIn(const Ball& ball, const Vector& point) {
    const Vector away = point - ball.center;
    return dot(away, away) <= ball.radius * ball.radius;
}

/// How many voxels of a shape have their centre within a ball and outside of others.
uint64_t countInBall(lua_State* L, const rubble_shape_state& shape, const Ball& ball, const std::vector<Ball>& others) {
    auto cells = sized<rubble_voxel_box>();
    cells.shape = shape.shape;
    for (size_t axis = 0; axis < 3; ++axis) {
        const double low = std::floor(ball.center[axis] - ball.radius);
        cells.low[axis] = int32_t(std::clamp(low, 0.0, shape.size[axis] - 1.0));
        cells.size[axis] = std::clamp(int32_t(2.0 * ball.radius) + 3, 1, shape.size[axis] - cells.low[axis]);
    }
    std::vector<uint8_t> voxels(size_t(cells.size[0]) * size_t(cells.size[1]) * size_t(cells.size[2]));
    uint64_t bytes = 0, count = 0;
    if (!isDone(L, apiOf(L).read_voxels(worldOf(L), &cells, voxels.data(), voxels.size(), &bytes))) return 0;
    size_t at = 0;
    for (int z = 0; z < cells.size[2]; ++z)
        for (int y = 0; y < cells.size[1]; ++y)
            for (int x = 0; x < cells.size[0]; ++x) {
                const Vector middle{cells.low[0] + x + 0.5, cells.low[1] + y + 0.5, cells.low[2] + z + 0.5};
                count +=
                    voxels[at++] && isIn(ball, middle) &&
                    std::none_of(others.begin(), others.end(), [&](const Ball& each) { return isIn(each, middle); });
            }
    return count;
}

/// Adds what the next step shall remove.
void expectHole(lua_State* L, const rubble_shape_state& shape, const Ball& ball) {
    SceneRequests& requests = requestsOf(L);
    const uint64_t step = ScriptContext::of(L).shared.step + requests.extraSteps + 1;
    const auto isThis = [&](const SceneRequests::Hole& each) { return each.shape == shape.shape && each.step == step; };
    auto hole = std::find_if(requests.holes.begin(), requests.holes.end(), isThis);
    if (hole == requests.holes.end()) hole = requests.holes.insert(hole, SceneRequests::Hole{shape.shape, step, 0, {}});
    hole->voxels += countInBall(L, shape, ball, hole->balls);
    hole->balls.push_back(ball);
}

}  // namespace

int exactHole(lua_State* L) {
    const rubble_shape shape = handleAt(L, 1, "shape");
    Vector cell = vectorAt(L, 2, "cell");
    for (double& each : cell) each = onBrushGrid(each);
    const double radius = onBrushGrid(std::clamp(numberAt(L, 3, "radius"), 0.3, 60.0));
    auto state = rubble_shape_state{};
    if (!isDone(L, apiOf(L).get_shape_state(worldOf(L), shape, &state))) return 0;
    const Placement frame = placementOf(state.position, state.rotation);
    auto carve = sized<rubble_carve>();
    copy(carve.position, toParent(frame, cell * state.voxel_size));
    std::fill_n(carve.radii, 3, radius * state.voxel_size);
    carve.shape = shape;
    if (isDone(L, apiOf(L).carve(worldOf(L), &carve))) expectHole(L, state, {cell, radius});
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
