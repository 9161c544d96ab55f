#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/voxel/read_box.h"

namespace rubble::abi {
namespace {

/// A box of cells with at least one cell, no longer than a grid can be and not far outside of one.
CellBox readBoxOf(const int32_t (&low)[3], const int32_t (&size)[3]) {
    CellBox box;
    for (int a = 0; a < 3; ++a) {
        const std::string axis = "[" + std::to_string(a) + "]";
        box.low[a] = int(readInRange(low[a], {-kMaxGridSize, kMaxGridSize}, ("low" + axis).c_str()));
        box.high[a] = box.low[a] + int(readInRange(size[a], {1, kMaxGridSize}, ("size" + axis).c_str()));
    }
    return box;
}

template <class EditType>
rubble_result editShape(const char* function, rubble_world world, rubble_shape shape, EditType edit) {
    return guarded(function, [&] {
        const auto hosted = Registry::instance().world(world);
        edit.shape = readLiveHandle<HandleType::Shape>(hosted->loop.world().shapes(), shape, "shape");
        hosted->loop.edits().push(edit);
    });
}

rubble_result splitShape(rubble_world world, rubble_shape shape) {
    return editShape("split_shape", world, shape, SplitShapeEdit{});
}
rubble_result trimShape(rubble_world world, rubble_shape shape) {
    return editShape("trim_shape", world, shape, TrimShapeEdit{});
}

rubble_result mergeShape(rubble_world world, rubble_shape shape, rubble_shape into) {
    return guarded("merge_shape", [&] {
        const auto hosted = Registry::instance().world(world);
        const auto& shapes = hosted->loop.world().shapes();
        const MergeShapeEdit edit{readLiveHandle<HandleType::Shape>(shapes, shape, "shape"),
                                  readOptionalHandle<HandleType::Shape>(shapes, into, "into")};
        if (edit.into && shapes.at(edit.into).body != shapes.at(edit.shape).body)
            throw ApiError{RUBBLE_ERROR_ARGUMENT, "into is on another body, expected a shape of the same one"};
        if (edit.into == edit.shape) throw ApiError{RUBBLE_ERROR_ARGUMENT, "into is the shape, expected another one"};
        hosted->loop.edits().push(edit);
    });
}

ResizeShapeEdit readResize(const World& world, const rubble_resize& given) {
    return {readLiveHandle<HandleType::Shape>(world.shapes(), given.shape, "shape"), readBoxOf(given.low, given.size)};
}
rubble_result resizeShape(rubble_world world, const rubble_resize* edit) {
    return pushEdit("resize_shape", world, edit, readResize);
}

rubble_result readVoxels(rubble_world world, const rubble_voxel_box* box, uint8_t* out, uint64_t capacity,
                         uint64_t* count) {
    return guarded("read_voxels", [&] {
        requireNotNull(count, "count") = 0;
        if (capacity) requireNotNull(out, "out");
        const auto hosted = Registry::instance().world(world);
        const auto& shapes = hosted->loop.world().shapes();
        const rubble_voxel_box given = readStruct(box, "box");
        const auto what = CellByte(readEnum(given.what, RUBBLE_VOXEL_PAINT, "box->what"));
        const CellBox cells = readBoxOf(given.low, given.size);
        const Shape& shape = shapes.at(readLiveHandle<HandleType::Shape>(shapes, given.shape, "box->shape"));
        const uint64_t needed = uint64_t(given.size[0]) * uint64_t(given.size[1]) * uint64_t(given.size[2]);
        *count = needed;
        if (!capacity) return;
        if (capacity < needed)
            throw ApiError{RUBBLE_ERROR_CAPACITY,
                           fmt::format("the box has {} cells, the array holds {} bytes", needed, capacity)};
        readBox(shape.grid, cells, what, {out, size_t(needed)});
    });
}

rubble_result detachJoint(rubble_world world, rubble_joint joint, rubble_shape shape) {
    return guarded("detach_joint", [&] {
        const auto hosted = Registry::instance().world(world);
        const World& inside = hosted->loop.world();
        hosted->loop.edits().push(DetachJointEdit{readLiveHandle<HandleType::Joint>(inside.joints(), joint, "joint"),
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
    api.detach_joint = detachJoint;
}

}  // namespace rubble::abi
