#pragma once
#include "render/gl/texture.h"

namespace rubble {

/// The blue noise of lib/noise.glsl, 64x64, RG8, repeating: red has the tile, green has it moved aside, so that a
/// shader gets two numbers from one fetch. [render-thread]
Texture makeNoiseTexture();

}  // namespace rubble
