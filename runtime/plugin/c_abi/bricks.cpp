#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/voxel/greedy_mesh.h"

namespace rubble::abi {
namespace {

const Shape* findShape(const HostedWorld& hosted, rubble_shape bits, const char* name) {
    return findLive<HandleType::Shape>(hosted.loop.world().shapes(), bits, name);
}

rubble_result getChangedBricks(rubble_world world, const rubble_brick_changes* changes, uint64_t* version,
                               rubble_brick* out, uint32_t capacity, uint32_t* count) {
    return inWorld("get_changed_bricks", world, [&](HostedWorld& hosted) {
        RowWriter<rubble_brick> rows(out, capacity, count);
        const rubble_brick_changes given = readStruct(changes, "changes");
        const bool isMesh = readEnum(given.what, RUBBLE_BRICKS_MESHES, "changes->what") == RUBBLE_BRICKS_MESHES;
        const Shape* shape = findShape(hosted, given.shape, "changes->shape");
        isGiven(version, "version");
        if (isRefused()) return;
        const auto* found = hosted.bricks.changed(hosted.loop.world().data(), ShapeHandle{given.shape}, given.since,
                                                  isMesh ? BrickVersions::What::Mesh : BrickVersions::What::Voxels);
        if (!found)
            return refuse(RUBBLE_ERROR_STALE,
                          "changes->since is {}, and the shape has changed as a whole since then: ask with 0",
                          given.since);
        *version = hosted.bricks.version();
        for (const BrickPlace& each : *found)
            rows.add([&] {
                const bool isEmpty = !shape->grid.brickAt(each.brick());
                return rubble_brick{each.x, each.y, each.z, isEmpty};
            });
        rows.finish();
    });
}

/// What the four corners of a rectangle have in common.
rubble_mesh_vertex vertexOf(const WorldData& world, const Shape& shape, const FaceQuad& quad) {
    const PaletteEntry& entry = (*shape.palette)[quad.entry];
    rubble_mesh_vertex vertex = {};
    vertex.normal[quad.side / 2] = quad.side & 1 ? 1.0f : -1.0f;
    Srgb color = {entry.red, entry.green, entry.blue};
    if (quad.paint && shape.paintColors)
        color = paintOver(color, shape.paintColors->colors[size_t(paintColor(quad.paint) - 1)], paintSteps(quad.paint));
    std::copy(color.begin(), color.end(), vertex.color);
    vertex.color[3] = entry.opacity;
    vertex.emission = entry.emission * shape.emission;
    if (entry.lightGroup && vertex.emission > 0.0f) {
        const LightGroup* group = world.groups.find(world.groups.handleAt(entry.lightGroup - 1));
        if (group && (group->out || group->off)) vertex.emission = 0.0f;
    }
    vertex.material = entry.material;
    vertex.palette_index = quad.entry;
    vertex.roughness = entry.roughness;
    vertex.metallic = entry.metallic;
    return vertex;
}

rubble_result meshOneBrick(rubble_world world, rubble_shape bits, const int32_t brick[3], rubble_mesh_vertex* out,
                           uint32_t capacity, uint32_t* count) {
    return inWorld("mesh_brick", world, [&](HostedWorld& hosted) {
        RowWriter<rubble_mesh_vertex> rows(out, capacity, count);
        const Shape* shape = findShape(hosted, bits, "shape");
        if (!isGiven(brick, "brick") || isRefused()) return;
        const glm::ivec3 place(brick[0], brick[1], brick[2]);
        std::vector<FaceQuad>& quads = hosted.quads;
        quads.clear();
        if (shape->grid.brickAt(place)) meshBrick(shape->grid, place, OpaqueEntries(*shape->palette), quads);
        for (const FaceQuad& quad : quads) {
            rubble_mesh_vertex vertex = vertexOf(hosted.loop.world().data(), *shape, quad);
            for (const glm::ivec3 corner : cornersOf(quad, place))
                rows.add([&] {
                    for (int i = 0; i < 3; ++i)
                        vertex.position[i] = float(double(corner[i]) * double(shape->voxelSize));
                    return vertex;
                });
        }
        rows.finish();
    });
}

void copyBrick(const Brick* brick, uint8_t* out) {
    BrickIndices indices;
    expandBrick(brick, indices);
    std::copy(indices.begin(), indices.end(), out);
    if (brick && brick->paint)
        std::copy(brick->paint->begin(), brick->paint->end(), out + kBrickVoxels);
    else
        std::fill_n(out + kBrickVoxels, kBrickVoxels, uint8_t(0));
}

rubble_result readBricks(rubble_world world, rubble_shape bits, const rubble_brick* bricks, uint32_t brickCount,
                         uint8_t* out, uint64_t capacity, uint64_t* count) {
    return inWorld("read_bricks", world, [&](const HostedWorld& hosted) {
        const Shape* shape = findShape(hosted, bits, "shape");
        if (brickCount) isGiven(bricks, "bricks");
        if (capacity) isGiven(out, "out");
        if (!isGiven(count, "count") || isRefused()) return;
        *count = uint64_t(brickCount) * RUBBLE_BRICK_BYTES;
        if (!capacity) return;
        if (capacity < *count)
            return refuse(RUBBLE_ERROR_CAPACITY, "there are {} bytes, the array holds {}", *count, capacity);
        for (uint32_t i = 0; i < brickCount; ++i, out += RUBBLE_BRICK_BYTES)
            copyBrick(shape->grid.brickAt({bricks[i].x, bricks[i].y, bricks[i].z}), out);
    });
}

rubble_shadow_brick shadowRow(const BrickPlace& place, const ShadowBrick* brick) {
    rubble_shadow_brick row = {place.x, place.y, place.z, !brick, 0, {}};
    if (!brick) return row;
    row.occupied = brick->occupied;
    std::copy(brick->texels.begin(), brick->texels.end(), row.texels);
    return row;
}

rubble_result getShadowBricks(rubble_world world, uint64_t since, uint64_t* version, rubble_shadow_brick* out,
                              uint32_t capacity, uint32_t* count) {
    return inWorld("get_shadow_bricks", world, [&](HostedWorld& hosted) {
        RowWriter<rubble_shadow_brick> rows(out, capacity, count);
        ShadowCopy* copy = hosted.loop.drawingData().shadow;
        if (!copy)
            refuse(RUBBLE_ERROR_ARGUMENT, "the world keeps no shadow volume: create it with RUBBLE_WORLD_SHADOW_DATA");
        isGiven(version, "version");
        if (isRefused()) return;
        const std::vector<BrickPlace>* found = copy->changed(since);
        if (!found)
            return refuse(RUBBLE_ERROR_STALE, "since is {}, and all has been replaced since: ask with 0", since);
        *version = copy->version();
        for (const BrickPlace& place : *found) rows.add([&] { return shadowRow(place, copy->find(place)); });
        rows.finish();
    });
}

}  // namespace

void setBrickFunctions(rubble_api& api) {
    api.get_changed_bricks = getChangedBricks;
    api.mesh_brick = meshOneBrick;
    api.read_bricks = readBricks;
    api.get_shadow_bricks = getShadowBricks;
}

}  // namespace rubble::abi
