#pragma once
#include <imgui.h>

namespace editor {

/// The colours of the window: greys and one accent, which marks what is active, selected or under way.
namespace theme {
inline constexpr ImU32 kAccent = IM_COL32(242, 163, 58, 255);
inline constexpr ImU32 kAccentFaint = IM_COL32(242, 163, 58, 70);
inline constexpr ImU32 kText = IM_COL32(222, 224, 228, 255);
inline constexpr ImU32 kDim = IM_COL32(138, 143, 152, 255);
inline constexpr ImU32 kLine = IM_COL32(12, 13, 15, 255);
inline constexpr ImU32 kPanel = IM_COL32(33, 35, 40, 255);
inline constexpr ImU32 kError = IM_COL32(238, 120, 108, 255);
/// Of the axes x, y, z.
inline constexpr ImU32 kAxes[3] = {IM_COL32(226, 86, 80, 255), IM_COL32(118, 190, 84, 255),
                                   IM_COL32(84, 142, 232, 255)};
}  // namespace theme

/// Sets colours, sizes and fonts of the current ImGui context. scale: pixels of the display by those of a plain one.
void applyTheme(float scale);
/// Letters of equal width, for numbers and commands.
ImFont* monoFont();
/// Bold letters, for headings.
ImFont* boldFont();
/// What applyTheme() was given.
float uiScale();

}  // namespace editor
