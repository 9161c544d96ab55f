#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/voxel/read_box.h"

namespace rubble::abi {
namespace {

/// A box of cells with at least one cell, no longer than a grid can be and not far outside of one.
CellBox readBoxOf(const int32_t (&low)[3], const int32_t (&size)[3]) {
    CellBox box;
    for (int a = 0; a < 3; ++a) {
        constexpr const char* kLow[] = {"low[0]", "low[1]", "low[2]"};
        constexpr const char* kSize[] = {"size[0]", "size[1]", "size[2]"};
        box.low[a] = int(readInRange(low[a], {-kMaxGridSize, kMaxGridSize}, kLow[a]));
        box.high[a] = box.low[a] + int(readInRange(size[a], {1, kMaxGridSize}, kSize[a]));
    }
    return box;
}

template <class EditType>
rubble_result editShape(const char* function, rubble_world world, rubble_shape shape, EditType edit) {
    return inWorld(function, world, [&](HostedWorld& hosted) {
        edit.shape = readLiveHandle<HandleType::Shape>(hosted.loop.world().shapes(), shape, "shape");
        push(hosted, edit);
    });
}

rubble_result splitShape(rubble_world world, rubble_shape shape) {
    return editShape("split_shape", world, shape, SplitShapeEdit{});
}
rubble_result trimShape(rubble_world world, rubble_shape shape) {
    return editShape("trim_shape", world, shape, TrimShapeEdit{});
}

rubble_result destroyShape(rubble_world world, rubble_shape shape) {
    return editShape("destroy_shape", world, shape, DestroyShapeEdit{});
}

rubble_result mergeShape(rubble_world world, rubble_shape shape, rubble_shape into) {
    return inWorld("merge_shape", world, [&](HostedWorld& hosted) {
        const auto& shapes = hosted.loop.world().shapes();
        const MergeShapeEdit edit{readLiveHandle<HandleType::Shape>(shapes, shape, "shape"),
                                  readOptionalHandle<HandleType::Shape>(shapes, into, "into")};
        if (isRefused()) return;
        const Shape *moved = shapes.find(edit.shape), *target = shapes.find(edit.into);  // null: made by the step
        if (moved && target && moved->body != target->body)
            refuse(RUBBLE_ERROR_ARGUMENT, "into is on another body, expected a shape of the same one");
        if (edit.into == edit.shape) refuse(RUBBLE_ERROR_ARGUMENT, "into is the shape, expected another one");
        push(hosted, edit);
    });
}

ResizeShapeEdit readResize(const World& world, const rubble_resize& given) {
    return {readLiveHandle<HandleType::Shape>(world.shapes(), given.shape, "shape"), readBoxOf(given.low, given.size)};
}
rubble_result resizeShape(rubble_world world, const rubble_resize* edit) {
    return pushEdit("resize_shape", world, edit, "resize", readResize);
}

rubble_result readVoxels(rubble_world world, const rubble_voxel_box* box, uint8_t* out, uint64_t capacity,
                         uint64_t* count) {
    return inWorld("read_voxels", world, [&](const HostedWorld& hosted) {
        if (!isGiven(count, "count")) return;
        *count = 0;
        if (capacity) isGiven(out, "out");
        const rubble_voxel_box given = readStruct(box, "box");
        if (isRefused()) return;
        const auto what = CellByte(readEnum(given.what, RUBBLE_VOXEL_PAINT, "box->what"));
        const CellBox cells = readBoxOf(given.low, given.size);
        const Shape* shape = findLive<HandleType::Shape>(hosted.loop.world().shapes(), given.shape, "box->shape");
        if (isRefused()) return;
        const uint64_t needed = uint64_t(given.size[0]) * uint64_t(given.size[1]) * uint64_t(given.size[2]);
        *count = needed;
        if (capacity && capacity < needed)
            return refuse(RUBBLE_ERROR_CAPACITY, "the box has {} cells, the array holds {} bytes", needed, capacity);
        if (capacity) readBox(shape->grid, cells, what, {out, size_t(needed)});
    });
}

/// The cells of a shape's grid after the edits that wait; nothing: only the step can tell.
std::optional<glm::ivec3> waitingSize(HostedWorld& hosted, ShapeHandle handle) {
    const Shape* shape = hosted.loop.world().shapes().find(handle);  // null: it is made by the step
    hosted.waiting.follow(hosted.loop.edits());
    return hosted.waiting.gridSize(handle, shape ? std::optional(shape->grid.size()) : std::nullopt);
}

rubble_result writeVoxels(rubble_world world, const rubble_voxel_box* box, const uint8_t* voxels, uint64_t size) {
    return inWorld("write_voxels", world, [&](HostedWorld& hosted) {
        const rubble_voxel_box given = readStruct(box, "box");
        if (isRefused() || !isGiven(voxels, "voxels")) return;
        readEnum(given.what, RUBBLE_VOXEL_INDEX, "box->what");
        const CellBox cells = readBoxOf(given.low, given.size);
        const auto& shapes = hosted.loop.world().shapes();
        const auto handle = readLiveHandle<HandleType::Shape>(shapes, given.shape, "box->shape");
        if (isRefused()) return;
        const uint64_t needed = uint64_t(given.size[0]) * uint64_t(given.size[1]) * uint64_t(given.size[2]);
        if (size != needed)
            return refuse(RUBBLE_ERROR_ARGUMENT, "size is {}, expected {}, a byte each cell", size, needed);
        const glm::ivec3 grid = waitingSize(hosted, handle).value_or(glm::ivec3(kMaxGridSize));
        for (int a = 0; a < 3; ++a)
            if (cells.low[a] < 0 || cells.high[a] > grid[a])
                return refuse(RUBBLE_ERROR_ARGUMENT, "the box has cells {} to {} of axis {}, expected 0 to {} at most",
                              cells.low[a], cells.high[a] - 1, a, grid[a] - 1);
        WriteVoxelsEdit edit{handle, cells, {voxels, voxels + needed}};
        if (given.mask) edit.mask.assign(given.mask, given.mask + needed);
        push(hosted, std::move(edit));
    });
}

rubble_result detachJoint(rubble_world world, rubble_joint joint, rubble_shape shape) {
    return inWorld("detach_joint", world, [&](HostedWorld& hosted) {
        const World& inside = hosted.loop.world();
        push(hosted, DetachJointEdit{readLiveHandle<HandleType::Joint>(inside.joints(), joint, "joint"),
                                     readLiveHandle<HandleType::Shape>(inside.shapes(), shape, "shape")});
    });
}

}  // namespace

void setShapeFunctions(rubble_api& api) {
    api.split_shape = splitShape;
    api.merge_shape = mergeShape;
    api.trim_shape = trimShape;
    api.resize_shape = resizeShape;
    api.read_voxels = readVoxels;
    api.write_voxels = writeVoxels;
    api.destroy_shape = destroyShape;
    api.detach_joint = detachJoint;
}

}  // namespace rubble::abi
