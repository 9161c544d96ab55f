#pragma once
#include <array>

#include "render/passes/background_tiles.h"

namespace rubble {

class GlassShadowPass;

/// Shades the surfaces (light times albedo, highlights, reflections, emission, haze) and draws sky and fields behind
/// them.
class CompositePass {
public:
    /// Builds its programs. If one fails, shaders.errors() says why and it is not drawn.
    explicit CompositePass(ShaderLibrary& shaders);
    /// Fills Radiance and DiffuseFraction. glassShadow: null where no sunlight comes through glass.
    void draw(const FrameContext& frame, const GlassShadowPass* glassShadow);

private:
    void drawBackground(const FrameContext& frame);

    FullscreenProgram& m_surfaces;
    std::array<const Program*, BackgroundTiles::kBands> m_backgrounds;
    BackgroundTiles m_tiles;
};

}  // namespace rubble
