#pragma once
#include <vector>

#include "render/gl/program.h"
#include "render/scene/bodies.h"

namespace rubble {

struct FrameBlock;

/// Tiled visibility: the bodies in view, nearest first, and for each tile of the screen the list of those whose box it
/// shows. Read by lib/body_tiles.glsl. [render-thread]
class BodyTiles {
public:
    enum class Which { All, Glass };
    /// Rebuilds the lists for a camera.
    void update(const Bodies& bodies, const FrameBlock& block);
    /// Sets the uniforms of lib/body_tiles.glsl: the lists of all bodies, or of those with glass. The program must be
    /// in use.
    void bind(const Program& program, Which which) const;
    /// Draws the tiles whose list is not empty with the program in use, whose vertex shader must be passes/tiles.vert.
    void drawTiles(const Program& program, Which which, const VertexArray& empty) const;
    /// Instances in view, nearest first.
    const std::vector<int>& order() const { return m_order; }
    /// Whether no body is listed.
    bool empty(Which which) const { return list(which).entries.empty(); }

private:
    /// A body as this frame's camera sees it, as the GPU reads it. Lengths are in the body's cells.
    struct BodyView {
        glm::vec3 camera;
        float minDepth;  ///< metres along the view axis: no point of its box is nearer
        glm::vec3 ray;   ///< through the screen's lower left corner; 1 long along the view axis, as all rays
        int instance;
        glm::vec3 rayStepX;  ///< change of the ray from one pixel to the next on the right
        uint32_t node;
        glm::vec3 rayStepY;  ///< the same upwards
        uint32_t paletteAndFlags;
        glm::uvec3 box;  ///< low | high << 16
        uint32_t sizeInNodes;
    };
    /// Tiles first to last of a row that a body's box covers.
    struct Span {
        uint32_t body;  ///< index into m_views
        int row, first, last;
    };
    /// A list of bodies for each tile.
    struct Lists {
        std::vector<uint32_t> offsets, entries;  ///< entries of tile t: from offsets[t] to offsets[t + 1]
        std::vector<uint32_t> tiles;             ///< those with entries
        BufferTexture offsetTexture{GL_R32UI}, entryTexture{GL_R32UI}, tileTexture{GL_R32UI};
    };
    const Lists& list(Which which) const { return which == Which::All ? m_all : m_glass; }
    void sort(const Bodies& bodies, const FrameBlock& block);
    void cover(const Bodies::Instance& body, const FrameBlock& block, uint32_t view, std::vector<Span>& spans) const;
    void fill(Lists& lists, const std::vector<Span>& spans) const;
    static bool send(Lists& lists);

    int m_tileShift = 3;
    glm::ivec2 m_tiles{0};
    std::vector<std::pair<float, int>> m_sorted;  ///< least depth and instance of the bodies in view
    std::vector<int> m_order;
    std::vector<BodyView> m_views;
    std::vector<Span> m_spans, m_glassSpans;
    Lists m_all, m_glass;
    BufferTexture m_viewTexture{GL_RGBA32UI};
    bool m_fullLogged = false;
};

}  // namespace rubble
