#include "runtime/plugin/c_abi/edits.h"

#include <algorithm>

#include "runtime/plugin/c_abi/checks.h"

namespace rubble::abi {
namespace {

constexpr double kMaxBrushSize = 100.0;  // metres

BrushKind readBrush(uint32_t brush) {
    if (brush > RUBBLE_BRUSH_CAPSULE)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "brush is " + std::to_string(brush) + ", expected 0 to 2"};
    constexpr BrushKind kinds[] = {BrushKind::Sphere, BrushKind::Box, BrushKind::Capsule};
    return kinds[brush];
}

Hardness readHardness(uint32_t hardness) {
    if (hardness > RUBBLE_HARDNESS_HARD)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "hardness is " + std::to_string(hardness) + ", expected 0 to 3"};
    constexpr Hardness classes[] = {Hardness::Hard, Hardness::Soft, Hardness::Medium, Hardness::Hard};
    return classes[hardness];
}

Tool readTool(uint32_t tool) {
    if (tool > RUBBLE_TOOL_EXPLOSIVE)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "tool is " + std::to_string(tool) + ", expected 0 to 4"};
    return Tool(tool);
}

std::array<double, 3> readRadii(const double (&given)[3]) {
    std::array<double, 3> radii;
    for (size_t i = 0; i < 3; ++i) radii[i] = readOrDefault(given[i], 1e-3, kMaxBrushSize, 0.0, "radii");
    if (radii[0] == 0.0) throw ApiError{RUBBLE_ERROR_ARGUMENT, "radii[0] is 0: nothing would be removed"};
    if (!std::is_sorted(radii.rbegin(), radii.rend()))
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "radii grow: expected that soft >= medium >= hard"};
    return radii;
}

ShapeHandle readShape(const World& world, rubble_shape given) {
    const ShapeHandle shape = readHandle<HandleType::Shape>(given, "shape");
    if (shape && !world.shapes().find(shape)) throw ApiError{RUBBLE_ERROR_STALE, "shape is stale"};
    return shape;
}

void readHalfSize(const rubble_carve& carve, CarveEdit& edit) {
    edit.halfSize = readVector(carve.half_size, "half_size");
    for (int i = 0; i < 3; ++i)
        if (!(edit.halfSize[i] > 0.0 && edit.halfSize[i] <= kMaxBrushSize))
            throw ApiError{RUBBLE_ERROR_ARGUMENT,
                           "half_size is " + std::to_string(edit.halfSize[i]) + ", expected more than 0, at most 100"};
}

uint8_t readByteFraction(uint32_t share, uint8_t ifZero, const char* name) {
    return uint8_t(readOrDefault(share, 1, 255, ifZero, name));
}

}  // namespace

CarveEdit toEdit(const World& world, const rubble_carve& carve) {
    CarveEdit edit;
    edit.kind = readBrush(carve.brush);
    edit.position = readVector(carve.position, "position");
    edit.hardnessLimit = readHardness(carve.hardness);
    if (edit.kind == BrushKind::Box) {
        readHalfSize(carve, edit);
        edit.rotation = readRotation(carve.rotation, "rotation");
    } else {
        edit.radii = readRadii(carve.radii);
    }
    if (edit.kind == BrushKind::Capsule) edit.end = readVector(carve.end, "end");
    edit.shape = readShape(world, carve.shape);
    edit.tool = readTool(carve.tool);
    return edit;
}

BreakEdit toEdit(const World& world, const rubble_break& given) {
    BreakEdit edit;
    edit.position = readVector(given.position, "position");
    edit.radii = readRadii(given.radii);
    edit.tool = readTool(given.tool);
    edit.seed = given.seed;
    edit.shape = readShape(world, given.shape);
    return edit;
}

ExplodeEdit toEdit(const World&, const rubble_explosion& explosion) {
    ExplodeEdit edit;
    edit.position = readVector(explosion.position, "position");
    edit.size = readOrDefault(explosion.size, 0.5, 4.0, 1.0, "size");
    edit.impulse = readOrDefault(explosion.impulse, 0.0, 1e9, 0.0, "impulse");
    return edit;
}

PaintEdit toEdit(const World&, const rubble_paint& paint) {
    PaintEdit edit;
    edit.position = readVector(paint.position, "position");
    edit.radius = readOrDefault(paint.radius, 1e-3, 10.0, 0.5, "radius");
    std::copy_n(paint.color, 3, edit.color.begin());
    edit.strength = readByteFraction(paint.strength, 64, "strength");
    edit.probability = readByteFraction(paint.probability, 255, "probability");
    edit.seed = paint.seed;
    return edit;
}

ImpulseEdit toEdit(const World& world, const rubble_impulse& impulse) {
    ImpulseEdit edit;
    edit.body = readHandle<HandleType::Body>(impulse.body, "body");
    if (!world.bodies().find(edit.body)) throw ApiError{RUBBLE_ERROR_STALE, "body is stale"};
    edit.position = readVector(impulse.position, "position");
    edit.impulse = readVector(impulse.impulse, "impulse");
    return edit;
}

}  // namespace rubble::abi
