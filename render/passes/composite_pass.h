#pragma once
#include <array>

#include "render/passes/background_tiles.h"

namespace rubble {

class GlassShadowPass;

/// Light x albedo, highlights, reflections, emission, air; sky and fields behind: into the history "radiance".
class CompositePass {
public:
    explicit CompositePass(ShaderLibrary& shaders);
    /// glassShadow: null where no sun comes through glass.
    void draw(const FrameContext& frame, const GlassShadowPass* glassShadow);

private:
    void drawBackground(const FrameContext& frame);

    FullscreenProgram& m_surfaces;
    std::array<const Program*, BackgroundTiles::kBands> m_backgrounds;
    BackgroundTiles m_tiles;
};

}  // namespace rubble
