#include "runtime/plugin/c_abi/rows.h"

#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

struct RowsCall {
    HostedWorld& hosted;
    rubble_row_list list;
    void* out;
    uint32_t capacity;
    uint32_t* count;
};

/// add(RowWriter<Row>&) adds them all.
template <class Row, class F>
void readAll(const RowsCall& call, F&& add) {
    RowWriter<Row> rows(call.out, call.capacity, call.count, readRowSize<Row>(call.list.row_size, "list->row_size"));
    if (isRefused()) return;
    add(rows);
    rows.finish();
}
template <class Row>
void readAll(const RowsCall& call) {
    readAll<Row>(call, [&](RowWriter<Row>& rows) { writeRows(call.hosted, rows); });
}

/// Rows that get_events() points at.
template <class Row>
void readEvents(const RowsCall& call, const Row* events, uint32_t count) {
    readAll<Row>(call, [&](RowWriter<Row>& rows) {
        for (uint32_t i = 0; i < count; ++i) rows.add([&] { return events[i]; });
    });
}

void readKind(const RowsCall& call) {
    const rubble_events events = call.hosted.events.view();
    switch (readEnum(call.list.kind, RUBBLE_ROWS_MOVED_BODIES, "list->kind")) {
        case RUBBLE_ROWS_BODIES:
            return readAll<rubble_body_state>(call);
        case RUBBLE_ROWS_MOVED_BODIES:
            return readAll<rubble_body_state>(call, [&](auto& rows) { writeMovedRows(call.hosted, rows); });
        case RUBBLE_ROWS_SHAPES:
            return readAll<rubble_shape_state>(call, [&](auto& rows) { writeRows(call.hosted, rows, call.list.body); });
        case RUBBLE_ROWS_JOINTS:
            return readAll<rubble_joint_state>(call);
        case RUBBLE_ROWS_CHARACTERS:
            return readAll<rubble_character_state>(call);
        case RUBBLE_ROWS_TRIGGER_EVENTS:
            return readAll<rubble_trigger_event>(call);
        case RUBBLE_ROWS_REMOVED_VOXELS:
            return readEvents(call, events.removed, events.removed_count);
        case RUBBLE_ROWS_SPLITS:
            return readEvents(call, events.splits, events.split_count);
        case RUBBLE_ROWS_FIRES:
            return readAll<rubble_fire>(call);
        default:
            return readEvents(call, events.dust_clouds, events.dust_cloud_count);
    }
}

rubble_result readRows(rubble_world world, const rubble_row_list* list, void* out, uint32_t capacity, uint32_t* count) {
    return inWorld("read_rows", world, [&](HostedWorld& hosted) {
        const RowsCall call{hosted, readStruct(list, "list"), out, capacity, count};
        if (!isRefused()) readKind(call);
    });
}

}  // namespace

void setRowFunctions(rubble_api& api) {
    api.read_rows = readRows;
}

}  // namespace rubble::abi
