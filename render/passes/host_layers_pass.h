#pragma once
#include "render/frame/frame_context.h"
#include "render/scene/body_tiles.h"

namespace rubble {

class FogPass;
class GlassPass;
class ParticlesPass;
class WaterPass;

/// Draws panes, waters, fog and particles over what the host has drawn before them, in its framebuffer: at its own
/// pixels, without jitter and history, as it has resolved its edges itself. They are the passes of the main image, with
/// the host's image as radiance and its depth as the depth of surfaces. What nothing covers stays as it is.
class HostLayersPass {
public:
    /// The passes of the main image; null: no frame has needed it so far.
    struct Layers {
        const GlassPass& glass;
        const BodyTiles& tiles;  ///< of the displayed pixels
        WaterPass* water;
        const FogPass* fog;
        ParticlesPass* particles;
    };

    /// Builds its programs. If one fails, shaders.errors() says why and draw() does nothing.
    explicit HostLayersPass(ShaderLibrary& shaders);
    /// Whether the view composes with the host's depth and anything may lie before what the host has drawn.
    static bool needed(const FrameContext& frame, const View& view);
    /// Fills the layers. frame: of the displayed pixels, with targets of its own. depth: linear, of the voxels. Only
    /// the host's image is copied where its framebuffer is multisampled or draws no colour.
    void draw(const FrameContext& frame, const View& view, const Texture& depth, const Layers& layers, float alpha);
    /// Draws to the view's framebuffer what draw() has put over the host's image. After the voxels are shown.
    void show(const FrameContext& frame, const View& view);

private:
    bool copyImage(const FrameContext& frame, const View& view) const;
    void takeOver(const FrameContext& frame, const View& view, const Texture& depth) const;
    void bind(const Program& program, const FrameContext& frame, const View& view) const;

    const Program& m_image;
    const Program& m_layers;
    bool m_isDrawn = false;
};

}  // namespace rubble
