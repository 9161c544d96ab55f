#pragma once
#include <imgui.h>
#include <imgui_stdlib.h>

#include <string>
#include <vector>

#include "editor/core/command.h"

namespace editor {

/// The drawings on buttons.
enum class Icon : uint8_t {
    Select,
    Move,
    Rotate,
    Scale,
    Brush,
    Break,
    Play,
    Pause,
    Step,
    Stop,
    Rewind,
    Keep,
    Undo,
    Redo,
    Open,
    Save,
    Search,
    Voxel,
    Box,
    Sphere,
    Line,
    Face,
    Flood,
    Body,
    Shape,
    Light,
    Joint,
    Water,
    Trigger,
    Group,
    Layer,
    Shown,
    Hidden
};

/// Draws an icon into a square.
void drawIcon(ImDrawList& list, Icon icon, ImVec2 low, float side, ImU32 color);
/// A button with an icon, lit while it is active. True: it was clicked.
bool iconButton(const char* id, Icon icon, bool isActive, const char* tip, bool isEnabled = true);
/// Explains what was drawn last, while the mouse rests on it.
void tooltip(const char* text);
/// The help of a command, as a tooltip.
void commandTooltip(const char* command);
/// A heading within a panel.
void heading(const char* text);
/// Begins a row of two columns: a name, and what follows in the rest of the width.
void property(const char* name, const char* tip);
/// A number that is typed or dragged. True: it has another value now, at the end of the change.
bool numberField(const char* id, double& value, double speed, const char* format = "%.3f");
/// Three numbers. True: as above.
bool pointField(const char* id, double (&value)[3], double speed, const char* format = "%.2f");
/// A colour in shares of sRGB. True: as above.
bool colorField(const char* id, float (&color)[3]);
/// A text that is typed. True: it was changed, and the change is done.
bool textField(const char* id, std::string& value, const char* hint);
/// A choice from some names. True: another one was chosen.
bool choiceField(const char* id, int& value, const std::vector<std::string>& names);

}  // namespace editor
