#pragma once
#include "runtime/plugin/c_abi/registry.h"

// What the edits in the queue of a world will do in its next step.
namespace rubble::abi {

/// The settings that the edits which wait for the next step leave, before those of later calls.
WorldSettings waitingSettings(const HostedWorld& hosted);
/// Whether an undo or redo waits for the next step.
bool hasWaitingUndo(const HostedWorld& hosted);
/// Refuses the call if an undo or redo waits: a game that is loaded has no marks and could not carry it out.
void requireNoWaitingUndo(const HostedWorld& hosted);

}  // namespace rubble::abi
