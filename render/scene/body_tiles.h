#pragma once
#include <vector>

#include "render/gl/program.h"
#include "render/scene/bodies.h"

namespace rubble {

struct FrameBlock;

/// The bodies that a camera can see, nearest first, and which of them each small square of the screen has to look at.
/// lib/body_tiles.glsl reads it.
class BodyTiles {
public:
    void update(const Bodies& bodies, const FrameBlock& block);
    enum class Which { All, Glass };
    /// Sets the uniforms of lib/body_tiles.glsl: lists of all bodies, or of those with glass. The program must be in
    /// use.
    void bind(const Program& program, Which which) const;
    /// Draws the tiles whose list is not empty, with the program that is in use: its vertex shader is
    /// passes/tiles.vert.
    void drawTiles(const Program& program, Which which, const VertexArray& empty) const;
    /// Instances in view, nearest first.
    const std::vector<int>& order() const { return m_order; }
    bool empty(Which which) const { return list(which).entries.empty(); }

private:
    /// On the GPU: a body as this frame's camera sees it, in its cells.
    struct BodyView {
        glm::vec3 camera;
        float nearest;  ///< metres along the view axis, at most: to its box
        glm::vec3 ray;  ///< through the screen's lower left corner; with 1 along the view axis, as all rays
        int instance;
        glm::vec3 rayAcross;  ///< what a pixel to the right adds
        uint32_t node;
        glm::vec3 rayUp;  ///< what a pixel up adds
        uint32_t paletteAndFlags;
        glm::uvec3 box;  ///< low | high << 16
        uint32_t sizeInNodes;
    };
    /// Tiles of one row that a body's box covers.
    struct Span {
        uint32_t body;
        int row, first, last;
    };
    /// A list of bodies for each tile.
    struct Lists {
        std::vector<uint32_t> firsts, entries;  ///< of tile t: entries from firsts[t] to firsts[t + 1]
        std::vector<uint32_t> tiles;            ///< those that have some
        BufferTexture firstTexture{GL_R32UI}, entryTexture{GL_R32UI}, tileTexture{GL_R32UI};
    };
    const Lists& list(Which which) const { return which == Which::All ? m_all : m_glass; }
    void sort(const Bodies& bodies, const FrameBlock& block);
    void cover(const Bodies::Instance& body, const FrameBlock& block, uint32_t number, std::vector<Span>& spans) const;
    void fill(Lists& lists, const std::vector<Span>& spans) const;

    int m_tileShift = 3;
    glm::ivec2 m_tiles{0};
    std::vector<std::pair<float, int>> m_sorted;
    std::vector<int> m_order;
    std::vector<BodyView> m_views;
    std::vector<Span> m_spans, m_glassSpans;
    Lists m_all, m_glass;
    BufferTexture m_viewTexture{GL_RGBA32UI};
};

}  // namespace rubble
