#pragma once
#include <glm/mat4x4.hpp>
#include <vector>

#include "render/overlay/glyph_atlas.h"
#include "render/overlay/overlay.h"

namespace rubble {

/// A parallelogram of the overlay, as shaders/passes/overlay.vert reads it.
struct OverlayQuad {
    enum Kind { Glyph, Box, Image, Line };  ///< a line's depths are their inverse
    glm::vec4 corner, right, down;          ///< in clip space: its left upper corner, and what leads to the next ones
    glm::vec4 shape;  ///< glyph, image: x, y, width, height in the texture. Box: half its size, radius, stroke
    glm::vec4 clip;   ///< where the corner is in the clip rectangle, which is 0 to 1; zw what `right` adds
    glm::vec4 look;   ///< xy what `down` adds there, z Kind, w what a glyph grows by, texels
    glm::vec4 color;  ///< sRGB, with opacity
    glm::vec4 depth;  ///< x linear depth of the corner, negative: in front of all; y, z what right and down add;
                      ///< w blur of a glyph in texels, margin round a box
};

/// Quads that are drawn with the same image.
struct OverlayRun {
    size_t first = 0, count = 0;
    std::string image;  ///< its name; empty: none of them needs one
};

/// What the places of items become places of the image by.
struct OverlayCamera {
    glm::dmat4 clipFromWorld{1.0};
    glm::dvec3 position{0.0}, forward{0.0, 0.0, -1.0};  ///< world
    glm::dquat rotation{1, 0, 0, 0};
    glm::vec2 size{1.0f};  ///< pixels
};

/// All quads of an overlay, in the order in which they are drawn.
struct OverlayQuads {
    std::vector<OverlayQuad> quads;
    std::vector<OverlayRun> runs;
    bool areGlyphsMissing = false;  ///< the atlas has no room for some
};

/// Fills `out` with the quads of an overlay; adds their glyphs to the atlas.
void fillQuads(Overlay& overlay, const OverlayCamera& camera, GlyphAtlas& atlas, OverlayQuads& out);

}  // namespace rubble
