#pragma once
#include <map>
#include <string>

#include "render/frame/frame_context.h"
#include "render/overlay/overlay_quads.h"

namespace rubble {

/// Draws an overlay onto the view's framebuffer, after the image: one call for all that needs the same image. Only a
/// frame that has an overlay makes it: it is not among what is compiled ahead.
class OverlayPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing. maxTextureSide: pixels.
    OverlayPass(ShaderLibrary& shaders, int maxTextureSide);
    /// depth: linear, of the voxels, in any size. Leaves the framebuffer's own depth as it is.
    void draw(const FrameContext& frame, Overlay& overlay, const View& view, const Texture& depth);
    /// GPU memory.
    uint64_t bytes() const;

private:
    void fill(const FrameContext& frame, Overlay& overlay, const View& view);
    void uploadGlyphs();
    void uploadImages(Overlay& overlay);
    void drawRun(const OverlayRun& run) const;

    const Program& m_program;
    GlyphAtlas m_atlas;
    Texture m_glyphs;
    uint64_t m_glyphVersion = 0;
    bool m_hasWarned = false;  ///< of glyphs without room
    std::map<std::string, Texture> m_images;
    OverlayQuads m_quads;
    GlName<BufferKind> m_buffer = GlName<BufferKind>::make();
    VertexArray m_vertexArray = VertexArray::make();
};

}  // namespace rubble
