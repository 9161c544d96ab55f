#pragma once
#include "render/frame/render_settings.h"
#include "render/shader_library/fullscreen_choice.h"
#include "render/shader_library/shader_library.h"

namespace rubble {

/// How this GL draws full-screen passes, if the settings want `wanted`.
Fullscreen supportedFullscreen(Fullscreen wanted);
/// The programs that a way to draw needs.
ShaderLibrary::Fullscreen programsFor(Fullscreen drawn);
/// The choice among them at the start.
FullscreenChoice initialChoice(Fullscreen drawn);

}  // namespace rubble
