#include <algorithm>
#include <vector>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/voxel/make_grid.h"

namespace rubble::abi {
namespace {

CreateBodyEdit readBodySettings(const rubble_body_settings& given) {
    Body body;
    const uint32_t flags = readFlags(given.flags, RUBBLE_BODY_STATIC | RUBBLE_BODY_ASLEEP, "flags");
    body.isStatic = flags & RUBBLE_BODY_STATIC;
    body.asleep = flags & RUBBLE_BODY_ASLEEP;
    body.pose = {readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    body.velocity = readVector(given.velocity, "velocity", ranges::kVelocity);
    body.angularVelocity = readVector(given.angular_velocity, "angular_velocity", ranges::kVelocity);
    const glm::dvec3 none(0.0);
    if ((body.isStatic || body.asleep) && (body.velocity != none || body.angularVelocity != none))
        refuse(RUBBLE_ERROR_ARGUMENT, "velocity is not 0, expected 0 of a body that is static or asleep");
    if (body.isStatic && body.asleep) refuse(RUBBLE_ERROR_ARGUMENT, "flags has ASLEEP, expected none: it is static");
    return {std::move(body)};
}

glm::ivec3 readGridSize(const rubble_shape_settings& given) {
    glm::ivec3 size(1);
    constexpr const char* kNames[] = {"size[0]", "size[1]", "size[2]"};
    for (int a = 0; a < 3; ++a) size[a] = int(readInRange(given.size[a], {1, kMaxGridSize}, kNames[a]));
    return size;
}

uint64_t cellsOf(glm::ivec3 size) {
    return uint64_t(size.x) * uint64_t(size.y) * uint64_t(size.z);
}

void requireFewCells(glm::ivec3 size) {
    readInRange(double(cellsOf(size)), ranges::kSolidCells, "size[0] * size[1] * size[2]");
}

/// A byte each cell.
VoxelGrid readIndices(const rubble_shape_settings& given, glm::ivec3 size) {
    if (!isGiven(given.indices, "indices")) return {};
    if (given.count != cellsOf(size))
        refuse(RUBBLE_ERROR_ARGUMENT, "count is {}, expected {}, a byte each cell", given.count, cellsOf(size));
    return isRefused() ? VoxelGrid() : gridOf(size, {given.indices, size_t(given.count)});
}

VoxelGrid readRuns(const rubble_shape_settings& given, glm::ivec3 size) {
    if (!isGiven(given.runs, "runs")) return {};
    requireFewCells(size);
    uint64_t cells = 0;
    for (uint64_t i = 0; i < given.count && !isRefused(); ++i) {
        if (given.runs[i].index > 255)
            refuse(RUBBLE_ERROR_ARGUMENT, "runs[{}].index is {}, expected 0 to 255", i, given.runs[i].index);
        cells += given.runs[i].cells;
        if (cells > cellsOf(size))
            refuse(RUBBLE_ERROR_ARGUMENT, "runs[{}] ends after {} cells, the grid has {}", i, cells, cellsOf(size));
    }
    if (isRefused()) return {};
    std::vector<uint8_t> entries(cellsOf(size));
    auto next = entries.begin();
    for (uint64_t i = 0; i < given.count; ++i)
        next = std::fill_n(next, given.runs[i].cells, uint8_t(given.runs[i].index));
    return gridOf(size, entries);
}

void readVoxels(const rubble_shape_settings& given, CreateShapeEdit& edit) {
    const glm::ivec3 size = readGridSize(given);
    if (isRefused()) return;
    switch (given.source) {
        case RUBBLE_SHAPE_BOX:
        case RUBBLE_SHAPE_SPHERE:
            requireFewCells(size);
            edit.source = given.source == RUBBLE_SHAPE_BOX ? ShapeSource::Box : ShapeSource::Sphere;
            edit.size = size;
            edit.entry = uint8_t(readOrDefault(given.index, {1, 255}, 1, "index"));
            return;
        case RUBBLE_SHAPE_INDICES:
            edit.shape.grid = readIndices(given, size);
            return;
        case RUBBLE_SHAPE_RUNS:
            edit.shape.grid = readRuns(given, size);
            return;
        default:
            edit.shape.grid = VoxelGrid(size);
    }
}

CreateShapeEdit readShapeSettings(const World& world, const rubble_shape_settings& given) {
    CreateShapeEdit edit;
    edit.body = readLiveHandle<HandleType::Body>(world.bodies(), given.body, "body");
    edit.paletteOf = readOptionalHandle<HandleType::Shape>(world.shapes(), given.palette_of, "palette_of");
    edit.shape.local = {readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    const bool isCopy = readEnum(given.source, RUBBLE_SHAPE_COPY, "source") == RUBBLE_SHAPE_COPY;
    edit.shape.voxelSize = float(readOrDefault(given.voxel_size, ranges::kVoxelSize, isCopy ? 0.0 : 0.1, "voxel_size"));
    if (isCopy) {
        edit.source = ShapeSource::Copy;
        edit.copied = readLiveHandle<HandleType::Shape>(world.shapes(), given.copied, "copied");
    } else if (!isRefused()) {
        readVoxels(given, edit);
    }
    return edit;
}

rubble_result createBody(rubble_world world, const rubble_body_settings* settings, rubble_body* out) {
    return pushMaker("create_body", world, settings, out, &WorldObjects::bodies,
                     [](const World&, const rubble_body_settings& given) { return readBodySettings(given); });
}

rubble_result createShape(rubble_world world, const rubble_shape_settings* settings, rubble_shape* out) {
    return pushMaker("create_shape", world, settings, out, &WorldObjects::shapes, readShapeSettings);
}

rubble_result getRefusals(rubble_world world, rubble_refusal* out, uint32_t capacity, uint32_t* count) {
    return listRows<rubble_refusal>(
        "get_refusals", world, out, capacity, count, [](const HostedWorld& hosted, auto& rows) {
            for (const RefusedHandle& each : hosted.loop.changes().refused)
                rows.add([&] { return rubble_refusal{each.handle.bits, each.reason.c_str()}; });
        });
}

}  // namespace

void setCreateFunctions(rubble_api& api) {
    api.create_body = createBody;
    api.create_shape = createShape;
    api.get_refusals = getRefusals;
}

}  // namespace rubble::abi
