#pragma once
#include <array>
#include <vector>

#include "render/frame/frame_context.h"

namespace rubble {

/// Sorts the tiles of the view by what background they can show, so that each is drawn by a shader that does only that.
class BackgroundTiles {
public:
    /// What a tile can show: above all hills, below the horizon, or anything.
    enum Band { Sky, Fields, Both, kBands };
    /// Sorts the tiles for a camera.
    void update(const FrameBlock& block);
    /// Whether a band has no tiles.
    bool empty(Band band) const { return m_tiles[band].empty(); }
    /// Draws a band's tiles with the program in use, whose vertex shader must be passes/tiles.vert.
    void draw(const Program& program, Band band, const FrameContext& frame) const;

private:
    int m_tilesAcross = 0;
    std::array<std::vector<uint32_t>, kBands> m_tiles;
    std::array<BufferTexture, kBands> m_textures{BufferTexture(GL_R32UI), BufferTexture(GL_R32UI),
                                                 BufferTexture(GL_R32UI)};
};

}  // namespace rubble
