#pragma once
#include <optional>

#include "render/frame/frame_context.h"
#include "render/scene/scene.h"

namespace rubble {

/// Fog with light shafts: in-scattered light at half the size, denoised, then blended over the radiance. Derivation:
/// shaders/passes/fog_light.frag.
class FogPass {
public:
    /// Builds its programs. If one fails, shaders.errors() says why and it is not drawn.
    explicit FogPass(ShaderLibrary& shaders);
    /// Fills FogLight and Fog, and blends the fog over Radiance.
    void draw(const FrameContext& frame);
    /// Blends the fog before Depth over Radiance. fog: the target of that name.
    void drawOver(const FrameContext& frame, const Texture& fog) const;
    /// Whether the environment has fog and the settings want it.
    static bool needed(const FrameContext& frame);

private:
    /// Frames that the light of fog is averaged over: few while anything changes.
    int maxHistory(const FrameContext& frame);
    void drawLight(const FrameContext& frame);
    void drawFilter(const FrameContext& frame) const;

    FullscreenProgram& m_light;
    FullscreenProgram& m_filter;
    FullscreenProgram& m_over;
    std::optional<Environment> m_environment;  ///< of the last frame
};

}  // namespace rubble
