#pragma once
#include "runtime/plugin/c_abi/calls.h"

// The lists of the interface, each written by the file of its topic: for the function that is named after it, and for
// read_rows().
namespace rubble::abi {

/// All bodies.
void writeRows(const HostedWorld& hosted, RowWriter<rubble_body_state>& rows);
/// Those that the last step moved, by their slots.
void writeMovedRows(HostedWorld& hosted, RowWriter<rubble_body_state>& rows);
/// The shapes of a body; body 0: of all. A stale one is refused.
void writeRows(const HostedWorld& hosted, RowWriter<rubble_shape_state>& rows, rubble_body body);
/// All joints.
void writeRows(const HostedWorld& hosted, RowWriter<rubble_joint_state>& rows);
/// All characters.
void writeRows(const HostedWorld& hosted, RowWriter<rubble_character_state>& rows);
/// All fires.
void writeRows(const HostedWorld& hosted, RowWriter<rubble_fire>& rows);
/// Which bodies entered and left triggers in the last step.
void writeRows(const HostedWorld& hosted, RowWriter<rubble_trigger_event>& rows);

/// A function that lists all rows of a kind.
template <class Row>
rubble_result listRows(const char* function, rubble_world world, Row* out, uint32_t capacity, uint32_t* count) {
    return listRows<Row>(function, world, out, capacity, count,
                         [](const HostedWorld& hosted, RowWriter<Row>& rows) { writeRows(hosted, rows); });
}

}  // namespace rubble::abi
