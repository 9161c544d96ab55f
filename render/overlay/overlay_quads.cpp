#include "render/overlay/overlay_quads.h"

#include <algorithm>
#include <glm/gtc/matrix_access.hpp>

#include "render/overlay/text_layout.h"

namespace rubble {
namespace {

constexpr double kNearest = 0.02;  ///< metres: where lines of the world are cut off before the camera
constexpr float kTexelsOfBlur = float(kGlyphSpread);

/// A surface with its axes in clip space and their linear depths.
struct Surface {
    glm::vec4 origin, x, y;
    glm::vec3 depth{-1.0f, 0.0f, 0.0f};  ///< of the origin, and what x and y add
};

Surface viewSurface(const OverlayCamera& camera) {
    return {{-1, 1, 0, 1}, {2.0f / camera.size.x, 0, 0, 0}, {0, -2.0f / camera.size.y, 0, 0}};
}

Surface planeSurface(const OverlayCamera& camera, const OverlayItem::Plane& plane) {
    const glm::dquat turn = plane.facesCamera ? camera.rotation : plane.rotation;
    const glm::dvec3 x = turn * glm::dvec3(plane.scale, 0, 0), y = turn * glm::dvec3(0, -plane.scale, 0);
    Surface surface{glm::vec4(camera.clipFromWorld * glm::dvec4(plane.position, 1.0)),
                    glm::vec4(camera.clipFromWorld * glm::dvec4(x, 0.0)),
                    glm::vec4(camera.clipFromWorld * glm::dvec4(y, 0.0))};
    for (glm::vec4* axis : {&surface.origin, &surface.x, &surface.y}) axis->z = 0.0f;  // nothing is too far
    if (plane.isOccluded)
        surface.depth = {glm::dot(plane.position - camera.position, camera.forward), glm::dot(x, camera.forward),
                         glm::dot(y, camera.forward)};
    return surface;
}

/// Adds the quads of items.
class QuadWriter {
public:
    QuadWriter(Overlay& overlay, const OverlayCamera& camera, GlyphAtlas& atlas, OverlayQuads& out)
        : m_overlay(overlay), m_camera(camera), m_atlas(atlas), m_out(out) {}

    void add(const OverlayItem& item) {
        m_item = &item;
        m_surface = item.plane ? planeSurface(m_camera, *item.plane) : viewSurface(m_camera);
        switch (item.kind) {
            case OverlayItem::Kind::Text:
                return addText();
            case OverlayItem::Kind::Box:
                return addBox(-item.align * item.size, item.size, item.transform, item.radius, item.stroke);
            case OverlayItem::Kind::Image:
                return addImage();
            case OverlayItem::Kind::Line:
                return addLine();
            case OverlayItem::Kind::WorldLine:
                return addWorldLine();
        }
    }

private:
    /// A rectangle of the item, before its transform.
    void push(glm::vec2 low, glm::vec2 size, const glm::mat3x2& transform, OverlayQuad quad, const std::string& image) {
        const glm::vec2 corner = transform * glm::vec3(low, 1.0f), right = transform[0] * size.x,
                        down = transform[1] * size.y;
        const Surface& s = m_surface;
        quad.corner = s.origin + s.x * corner.x + s.y * corner.y;
        quad.right = s.x * right.x + s.y * right.y;
        quad.down = s.x * down.x + s.y * down.y;
        const glm::vec2 axes(s.depth.y, s.depth.z);
        quad.depth =
            glm::vec4(s.depth.x + glm::dot(axes, corner), glm::dot(axes, right), glm::dot(axes, down), quad.depth.w);
        const glm::vec4 clip = m_item->clip.value_or(glm::vec4(0.0f));
        const glm::vec2 clipLow(clip), extent = glm::max(glm::vec2(clip.z, clip.w) - clipLow, glm::vec2(1e-6f));
        quad.clip = glm::vec4(0.5f, 0.5f, 0.0f, 0.0f);
        quad.look.x = quad.look.y = 0.0f;
        if (m_item->clip) {
            quad.clip = glm::vec4((corner - clipLow) / extent, right / extent);
            quad.look.x = down.x / extent.x, quad.look.y = down.y / extent.y;
        }
        pushQuad(quad, image);
    }

    void pushQuad(const OverlayQuad& quad, const std::string& image) {
        std::vector<OverlayRun>& runs = m_out.runs;
        if (runs.empty() || (!image.empty() && !runs.back().image.empty() && runs.back().image != image))
            runs.push_back({m_out.quads.size(), 0, image});
        if (!image.empty()) runs.back().image = image;
        ++runs.back().count;
        m_out.quads.push_back(quad);
    }

    /// With a margin of a pixel or so for its smooth sides.
    void addBox(glm::vec2 low, glm::vec2 size, const glm::mat3x2& transform, float radius, float stroke) {
        const float scale = std::max(std::max(glm::length(transform[0]), glm::length(transform[1])), 1e-6f);
        const float margin = m_item->plane ? 0.02f * std::max(size.x, size.y) + 0.5f : 1.0f / scale;
        OverlayQuad quad{};
        quad.shape = glm::vec4(size * 0.5f, std::min(radius, std::min(size.x, size.y) * 0.5f), stroke);
        quad.look.z = OverlayQuad::Box;
        quad.color = m_item->color;
        quad.depth.w = margin;
        push(low - margin, size + 2.0f * margin, transform, quad, "");
    }

    void addLine() {
        const float length = glm::length(m_item->size), width = m_item->stroke > 0.0f ? m_item->stroke : 1.0f;
        if (length <= 0.0f) return;
        const glm::vec2 along = m_item->size / length;
        const glm::mat3x2 turn(along, {-along.y, along.x}, {0.0f, 0.0f});
        const glm::mat3x2 whole(m_item->transform * glm::vec3(turn[0], 0.0f),
                                m_item->transform * glm::vec3(turn[1], 0.0f), m_item->transform[2]);
        addBox({0.0f, -0.5f * width}, {length, width}, whole, 0.0f, 0.0f);
    }

    void addImage() {
        const glm::vec4 source = m_item->source;
        OverlayQuad quad{};
        quad.shape = {source.x, source.y, source.z - source.x, source.w - source.y};
        quad.look.z = OverlayQuad::Image;
        quad.color = m_item->color;
        push(-m_item->align * m_item->size, m_item->size, m_item->transform, quad, m_item->text);
    }

    /// Shadow, outline and letters, each of the whole text, so that no letter's outline lies over its neighbour.
    void addText() {
        const auto font = m_overlay.fonts().find(m_item->font);
        if (!font || m_item->fontSize <= 0.0f) return;
        const TextLayout layout = layOut(**font, m_item->text, {m_item->fontSize, m_item->size.x, m_item->align.x});
        glm::vec2 low = -m_item->align * layout.size;
        if (m_item->isOnBaseline) low.y = -(*font)->ascent() * m_item->fontSize;
        const float texels = kGlyphEm / m_item->fontSize;
        const float outline = std::min(m_item->outline * texels, float(kGlyphSpread) - 1.0f);
        if (m_item->shadowColor.a > 0.0f) {
            // The field ends so far from a letter: what is blurred more is grown less, or else its end would be seen.
            const float blur = std::min(m_item->shadowBlur * texels, kTexelsOfBlur);
            addGlyphs(**font, layout, low + m_item->shadowOffset, m_item->shadowColor,
                      std::min(outline, float(kGlyphSpread) - blur), blur);
        }
        if (outline > 0.0f) addGlyphs(**font, layout, low, m_item->outlineColor, outline, 0.0f);
        addGlyphs(**font, layout, low, m_item->color, 0.0f, 0.0f);
    }

    void addGlyphs(const Font& font, const TextLayout& layout, glm::vec2 low, glm::vec4 color, float grown,
                   float blur) {
        OverlayQuad quad{};
        quad.look.z = OverlayQuad::Glyph, quad.look.w = grown;
        quad.color = color;
        quad.depth.w = blur;
        for (const TextLayout::Glyph& glyph : layout.glyphs) {
            const GlyphAtlas::Place* place = m_atlas.find(font, glyph.glyph);
            m_out.areGlyphsMissing = m_out.areGlyphsMissing || !place;
            if (!place || !place->size.x) continue;
            quad.shape = glm::vec4(place->low, place->size);  // in texels: the image may still grow
            push(low + glyph.pen + place->offset * m_item->fontSize,
                 glm::vec2(place->size) * (m_item->fontSize / kGlyphEm), m_item->transform, quad, "");
        }
    }

    /// A line of a width in pixels between two places, after the division by w: its depths are inverse.
    void addWorldLine() {
        if (!m_item->plane) return;
        glm::dvec3 from = m_item->plane->position, to = m_item->end;
        glm::dvec4 a = m_camera.clipFromWorld * glm::dvec4(from, 1.0), b = m_camera.clipFromWorld * glm::dvec4(to, 1.0);
        if (a.w < b.w) std::swap(a, b), std::swap(from, to);
        if (a.w <= kNearest) return;
        if (b.w < kNearest) {
            const double t = (a.w - kNearest) / (a.w - b.w);
            b = a + (b - a) * t, to = from + (to - from) * t;
        }
        const glm::dvec2 half = 0.5 * glm::dvec2(m_camera.size);
        const glm::dvec2 start = glm::dvec2(a) / a.w * half, end = glm::dvec2(b) / b.w * half;
        const double length = glm::length(end - start);
        if (!(length > 1e-3 && length < 1e7)) return;
        const double width = (m_item->stroke > 0.0f ? m_item->stroke : 1.0) + 2.0;
        const glm::dvec2 side = glm::dvec2(start.y - end.y, end.x - start.x) * (width / length);
        OverlayQuad quad{};
        quad.corner = glm::vec4((start - 0.5 * side) / half, 0.0, 1.0);
        quad.right = glm::vec4((end - start) / half, 0.0, 0.0);
        quad.down = glm::vec4(side / half, 0.0, 0.0);
        quad.shape = glm::vec4(0.5 * length, 0.5 * width - 1.0, 0.0f, 0.0f);
        quad.clip = glm::vec4(0.5f, 0.5f, 0.0f, 0.0f);
        quad.look.z = OverlayQuad::Line;
        quad.color = m_item->color;
        const auto inverse = [&](glm::dvec3 place) {
            return 1.0 / std::max(glm::dot(place - m_camera.position, m_camera.forward), kNearest);
        };
        quad.depth = {-1.0f, 0.0f, 0.0f, 1.0f};
        if (m_item->plane->isOccluded)
            quad.depth.x = float(inverse(from)), quad.depth.y = float(inverse(to) - inverse(from));
        pushQuad(quad, "");
    }

    Overlay& m_overlay;
    const OverlayCamera& m_camera;
    GlyphAtlas& m_atlas;
    OverlayQuads& m_out;
    const OverlayItem* m_item = nullptr;
    Surface m_surface{};
};

}  // namespace

void fillQuads(Overlay& overlay, const OverlayCamera& camera, GlyphAtlas& atlas, OverlayQuads& out) {
    out.quads.clear();
    out.runs.clear();
    out.areGlyphsMissing = false;
    QuadWriter writer(overlay, camera, atlas, out);
    for (const OverlayItem& item : overlay.items()) writer.add(item);
}

}  // namespace rubble
