#include "runtime/world/stages/settings_edits.h"

namespace rubble {

void apply(EditContext& context, const SettingsEdit& edit) {
    WorldSettings before = context.world.settings;
    if (before == edit.settings) return;
    before.undoMarks = edit.settings.undoMarks;
    context.changes.settingsChanged |= before != edit.settings;
    context.world.setSettings(edit.settings);
}

void apply(EditContext& context, const SetBoundsEdit& edit) {
    if (context.world.settings.bounds == edit.bounds) return;
    context.changes.settingsChanged = true;
    context.world.setBounds(edit.bounds);
}

}  // namespace rubble
