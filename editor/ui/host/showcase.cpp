#include "editor/ui/host/scripted_ui.h"

namespace editor {

const char* const kShowcase = R"(
ui screenshot 00_start.png
)";

}  // namespace editor
