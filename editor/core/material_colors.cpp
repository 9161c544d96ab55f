#include "editor/core/material_colors.h"

#include <algorithm>
#include <vector>

#include "editor/core/palette.h"
#include "samples/support/material_colors.h"

namespace editor {

void colorByMaterial(Editor& editor, rubble_shape shape) {
    editor.document().applyNow();
    std::vector<rubble_palette_entry> entries = editor.world().get_palette(paletteRange(shape, 1, 255));
    for (const rubble::MaterialColor& each : rubble::kMaterialColors) {
        rubble_palette_entry& entry = entries[each.entry - 1];
        std::copy(each.rgb, each.rgb + 3, entry.color);
        entry.opacity = each.opacity;
    }
    editor.world().set_palette(paletteRange(shape, 1, 255), entries.data());
}

}  // namespace editor
