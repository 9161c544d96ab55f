#pragma once
#include <utility>
#include <vector>

#include "render/gl/program.h"
#include "render/scene/bodies.h"

namespace rubble {

struct FrameBlock;

/// Tiled visibility: the bodies in view, nearest first, and for each tile of the screen the list of those whose box it
/// shows. Read by lib/body_tiles.glsl. Bodies out of view cost nothing; while the camera stands still, those in view
/// that did not change are only copied, and where none changed nothing is done. [render-thread]
class BodyTiles {
public:
    enum class Which { All, Glass };
    /// Brings the lists up to date with a camera and with the last Bodies::beginFrame().
    void update(const Bodies& bodies, const FrameBlock& block);
    /// Forgets all lists: needed before the first update() with other Bodies.
    void clear() { *this = {}; }
    /// Sets the uniforms of lib/body_tiles.glsl: the lists of all bodies, or of those with glass. The program must be
    /// in use.
    void bind(const Program& program, Which which) const;
    /// Draws the tiles whose list is not empty with the program in use, whose vertex shader must be passes/tiles.vert.
    void drawTiles(const Program& program, Which which, const VertexArray& empty) const;
    /// Instances in view, nearest first.
    std::vector<int> order() const;
    /// Instances listed for a pixel, in the shader's order.
    std::vector<int> bodiesAt(glm::ivec2 pixel, Which which) const;
    /// How many bodies update() has projected so far.
    uint64_t projected() const { return m_projected; }
    /// How many boxes and bodies it has compared with the view.
    uint64_t compared() const { return m_compared; }
    /// Whether no body is listed.
    bool empty(Which which) const { return list(which).entries.empty(); }

private:
    /// A body as this frame's camera sees it, as the GPU reads it. Lengths are in the body's cells.
    struct BodyView {
        glm::vec3 rayStart;  ///< of the ray through the screen's lower left corner
        float minDepth;      ///< metres along the view axis: no point of its box is nearer
        glm::vec3 ray;       ///< 1 long along the view axis, as all rays
        int instance;
        glm::vec3
            stepX;  ///< change from one pixel to the next on the right: of the ray, or of an orthographic one's start
        uint32_t node;
        glm::vec3 stepY;  ///< the same upwards
        uint32_t paletteAndFlags;
        glm::uvec3 box;  ///< low | high << 16
        uint32_t sizeInNodes;
    };
    /// Tiles first to last of a row that a body's box covers.
    struct Span {
        int row, first, last;
    };
    /// A body in view.
    struct Seen {
        float minDepth;
        uint32_t instance, view;      ///< view: index into m_views
        uint32_t firstSpan, endSpan;  ///< in m_spans
        bool isGlass;
        /// Whether it is to be tested before another one.
        bool operator<(const Seen& o) const {
            return std::pair(minDepth, instance) < std::pair(o.minDepth, o.instance);
        }
    };
    /// All of a camera that the lists depend on; jitter is no part of it.
    struct Camera {
        glm::vec4 position, right, up, forward, middle, targetSize;
        bool operator==(const Camera&) const = default;
    };
    /// A list of bodies for each tile.
    struct Lists {
        std::vector<uint32_t> offsets, entries;  ///< entries of tile t: from offsets[t] to offsets[t + 1]
        std::vector<uint32_t> tiles;             ///< those with entries
        BufferTexture offsetTexture{GL_R32UI}, entryTexture{GL_R32UI}, tileTexture{GL_R32UI};
    };
    struct Frustum;
    using Found = std::vector<std::pair<float, uint32_t>>;  ///< least depths and instances
    const Lists& list(Which which) const { return which == Which::All ? m_all : m_glass; }
    void resize();
    Found startOver(const Bodies& bodies, const Frustum& frustum);
    Found dropTouched(const Bodies& bodies, const Frustum& frustum);
    bool addBodies(const Found& found, const Bodies& bodies, const FrameBlock& block);
    void project(const Bodies& bodies, const FrameBlock& block, float minDepth, uint32_t instance);
    void cover(const Bodies::Instance& body, const FrameBlock& block);
    bool sendViews(size_t firstNew);
    void fill(Lists& lists, Which which) const;
    static bool send(Lists& lists);

    int m_tileShift = 3;
    glm::ivec2 m_tiles{0};
    Camera m_camera{};
    uint64_t m_frame = 0;           ///< Bodies::touched().frame of the last update()
    std::vector<Seen> m_seen;       ///< nearest first
    std::vector<BodyView> m_views;  ///< of m_seen, and of bodies that were in it since the lists were started over
    std::vector<Span> m_spans;      ///< the same
    uint64_t m_projected = 0, m_compared = 0;
    Lists m_all, m_glass;
    BufferTexture m_viewTexture{GL_RGBA32UI};
    bool m_fullLogged = false;
};

}  // namespace rubble
