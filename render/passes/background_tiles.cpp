#include "render/passes/background_tiles.h"

#include <glm/geometric.hpp>

#include "render/frame/shader_constants.h"

namespace rubble {
namespace {

constexpr int kTileShift = 4;  ///< tiles of 16x16 pixels

/// What a direction can show. The directions of Sky, and those of Fields, are a convex cone: a tile whose four corners
/// are in it is all in it.
BackgroundTiles::Band bandOf(glm::vec3 direction, float eyeHeight) {
    if (direction.y < 0.0f && eyeHeight > 0.0f) return BackgroundTiles::Fields;
    return direction.y > shared::kMaxHillSlope * glm::length(glm::vec2(direction.x, direction.z))
               ? BackgroundTiles::Sky
               : BackgroundTiles::Both;
}

}  // namespace

void BackgroundTiles::update(const FrameBlock& block) {
    const glm::ivec2 size(block.targetSize), tiles = (size + (1 << kTileShift) - 1) >> kTileShift;
    m_tilesAcross = tiles.x;
    std::vector<Band> corners;
    for (int y = 0; y <= tiles.y; ++y)
        for (int x = 0; x <= tiles.x; ++x) {
            const glm::vec2 uv =
                glm::vec2(x << kTileShift, y << kTileShift) * glm::vec2(block.targetSize.z, block.targetSize.w);
            const glm::vec2 p = (uv + glm::vec2(block.jitter)) * 2.0f - 1.0f;  // as viewRay() in lib/frame.glsl
            corners.push_back(bandOf(block.ray(p), block.rayStart(p).y - block.skyCover.z));
        }
    for (auto& list : m_tiles) list.clear();
    for (int y = 0; y < tiles.y; ++y)
        for (int x = 0; x < tiles.x; ++x) {
            const Band* c = &corners[size_t(y * (tiles.x + 1) + x)];
            const bool same = c[0] == c[1] && c[0] == c[tiles.x + 1] && c[0] == c[tiles.x + 2];
            m_tiles[same ? c[0] : Both].push_back(uint32_t(y * tiles.x + x));
        }
    for (size_t band = 0; band < kBands; ++band) {
        if (!m_textures[band].refill(std::as_bytes(std::span(m_tiles[band])))) m_tiles[band].clear();
    }
}

void BackgroundTiles::draw(const Program& program, Band band, const FrameContext& frame) const {
    program.set("uTileIds", m_textures[band]);
    program.set("uTileGrid", glm::ivec2(m_tilesAcross, kTileShift));
    glBindVertexArray(frame.emptyVertexArray.get());
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, GLsizei(m_tiles[band].size()));
    ++frame.stats.drawCalls;
}

}  // namespace rubble
