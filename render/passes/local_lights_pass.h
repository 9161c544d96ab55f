#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Light of spheres, capsules, cones, areas and screens, by resampled importance sampling: one ray per pixel to one
/// light, for any number of lights. One draw over the tiles of the view that a light reaches. Derivation:
/// shaders/passes/local_lights.frag.
class LocalLightsPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() only clears Specular.
    explicit LocalLightsPass(ShaderLibrary& shaders);
    /// Adds to the colour of NoisyLight and fills Specular.
    void draw(const FrameContext& frame) const;
    /// Whether the settings want local lights and the scene has some.
    static bool needed(const FrameContext& frame);

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
