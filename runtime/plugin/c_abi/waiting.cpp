#include "runtime/plugin/c_abi/waiting.h"

#include <algorithm>

#include "runtime/plugin/c_abi/calls.h"

namespace rubble::abi {

WorldSettings waitingSettings(const HostedWorld& hosted) {
    WorldSettings settings = hosted.loop.world().settings();
    for (const Edit& edit : hosted.loop.edits().waiting()) {
        if (const auto* all = std::get_if<SettingsEdit>(&edit)) settings = all->settings;
        if (const auto* bounds = std::get_if<SetBoundsEdit>(&edit)) settings.bounds = bounds->bounds;
    }
    return settings;
}

bool hasWaitingUndo(const HostedWorld& hosted) {
    const Edits& waiting = hosted.loop.edits().waiting();
    return std::any_of(waiting.begin(), waiting.end(), [](const Edit& edit) {
        const auto* history = std::get_if<HistoryEdit>(&edit);
        return history && history->action != HistoryAction::Mark;
    });
}

void requireNoWaitingUndo(const HostedWorld& hosted) {
    if (hasWaitingUndo(hosted))
        refuse(RUBBLE_ERROR_ARGUMENT,
               "an undo or redo waits for the next step, and a saved game has no marks to go to: expected a step() "
               "before");
}

}  // namespace rubble::abi
