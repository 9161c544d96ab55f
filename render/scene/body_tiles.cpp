#include "render/scene/body_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <string>
#include <utility>

#include "render/frame/frame_block.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr int kMinTileShift = 3;  ///< tiles of 8x8 pixels; larger ones for views of more than kMaxTiles
constexpr int kMaxTiles = 4096;

/// Normals of the planes of the view frustum through the camera, pointing inwards: left, right, bottom, top.
std::array<glm::vec3, 4> sidePlanes(const FrameBlock& b) {
    const glm::vec3 forward(b.cameraForward), right(b.cameraRight), up(b.cameraUp);
    return {glm::normalize(right + forward * b.cameraRight.w), glm::normalize(-right + forward * b.cameraRight.w),
            glm::normalize(up + forward * b.cameraUp.w), glm::normalize(-up + forward * b.cameraUp.w)};
}

/// The edges of a projected box, in pixels.
struct ScreenBox {
    std::array<std::pair<glm::vec2, glm::vec2>, 12> edges;
    int count = 0;
    bool cut = false;  ///< by the near plane: its outline has parts that are not among the edges

    void add(glm::vec4 a, glm::vec4 b, float near, glm::vec2 halfSize) {
        if (a.w < near && b.w < near) return void(cut = true);
        if (a.w < near || b.w < near) {
            cut = true;
            const glm::vec4 crossing = glm::mix(a, b, (near - a.w) / (b.w - a.w));
            (a.w < near ? a : b) = crossing;
        }
        edges[size_t(count++)] = {(glm::vec2(a) / a.w + 1.0f) * halfSize, (glm::vec2(b) / b.w + 1.0f) * halfSize};
    }
    /// The smallest and the largest x between two heights; none if they come in the wrong order.
    glm::vec2 rangeX(float y0, float y1) const {
        glm::vec2 range(1e30f, -1e30f);
        for (int i = 0; i < count; ++i) {
            auto [a, b] = edges[size_t(i)];
            if (a.y > b.y) std::swap(a, b);
            if (b.y < y0 || a.y > y1) continue;
            const float slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0.0f;
            const float x0 = a.y < y0 ? a.x + slope * (y0 - a.y) : a.x, x1 = b.y > y1 ? a.x + slope * (y1 - a.y) : b.x;
            range = {std::min({range.x, x0, x1}), std::max({range.y, x0, x1})};
        }
        return range;
    }
};

template <class T>
bool send(BufferTexture& to, const std::vector<T>& data) {
    return to.refill(std::as_bytes(std::span(data)));
}

uint32_t packed(glm::ivec3 size) {
    return uint32_t(size.x) | uint32_t(size.y) << 10 | uint32_t(size.z) << 20;
}

}  // namespace

void BodyTiles::update(const Bodies& bodies, const FrameBlock& block) {
    const glm::ivec2 size(block.targetSize);
    m_tileShift = kMinTileShift;
    const auto tiles = [&] { return (size + (1 << m_tileShift) - 1) >> m_tileShift; };
    while (tiles().x * tiles().y > kMaxTiles) ++m_tileShift;
    m_tiles = tiles();
    sort(bodies, block);
    m_views.clear();
    m_spans.clear();
    m_glassSpans.clear();
    const glm::vec3 across = glm::vec3(block.cameraRight) * block.cameraRight.w,
                    up = glm::vec3(block.cameraUp) * block.cameraUp.w;
    const glm::vec2 corner = glm::vec2(block.jitter) * 2.0f - 1.0f;  // as viewRay() in lib/frame.glsl
    for (const auto& [minDepth, slot] : m_sorted) {
        const Bodies::Instance& body = bodies.instances()[size_t(slot)];
        const Bodies::Layout& layout = bodies.layout(size_t(slot));
        const glm::mat3 toCells = glm::mat3_cast(glm::conjugate(body.rotation)) * (1.0f / body.voxelSize);
        m_views.push_back({toCells * (glm::vec3(block.cameraPosition) - body.position), minDepth,
                           toCells * (glm::vec3(block.cameraForward) + across * corner.x + up * corner.y), slot,
                           toCells * across * (2.0f * block.targetSize.z), layout.node,
                           toCells * up * (2.0f * block.targetSize.w), layout.palette << 8 | layout.flags,
                           glm::uvec3(body.low) | glm::uvec3(body.high) << 16u, packed(layout.sizeInNodes)});
        const size_t before = m_spans.size();
        cover(body, block, uint32_t(m_views.size() - 1), m_spans);
        if (body.glass)
            m_glassSpans.insert(m_glassSpans.end(), m_spans.begin() + std::ptrdiff_t(before), m_spans.end());
    }
    const bool fits = rubble::send(m_viewTexture, m_views);
    for (auto [lists, spans] : {std::pair(&m_all, &m_spans), std::pair(&m_glass, &m_glassSpans)}) {
        fill(*lists, *spans);
        if (lists->entries.empty() || (fits && send(*lists))) continue;
        lists->entries.clear();
        if (!std::exchange(m_fullLogged, true))
            logError("bodies are not drawn: the GL has no room for the lists of " + std::to_string(m_views.size()) +
                     " bodies in view");
    }
}

bool BodyTiles::send(Lists& lists) {
    return rubble::send(lists.offsetTexture, lists.offsets) && rubble::send(lists.entryTexture, lists.entries) &&
           rubble::send(lists.tileTexture, lists.tiles);
}

void BodyTiles::sort(const Bodies& bodies, const FrameBlock& block) {
    const auto& instances = bodies.instances();
    const glm::vec3 camera(block.cameraPosition), forward(block.cameraForward);
    const auto planes = sidePlanes(block);
    m_sorted.clear();
    for (size_t i = 0; i < instances.size(); ++i) {
        const Bodies::Instance& body = instances[i];
        if (body.empty()) continue;
        const glm::vec3 low = glm::vec3(body.low) * body.voxelSize, high = glm::vec3(body.high) * body.voxelSize;
        const glm::vec3 center = body.position + body.rotation * ((low + high) * 0.5f) - camera;
        const float radius = glm::length(high - low) * 0.5f;
        bool visible = glm::dot(center, forward) > -radius;
        for (const glm::vec3& plane : planes) visible &= glm::dot(center, plane) > -radius;
        if (!visible) continue;
        const glm::vec3 half = (high - low) * 0.5f, axis = glm::abs(glm::conjugate(body.rotation) * forward);
        m_sorted.emplace_back(std::max(glm::dot(center, forward) - glm::dot(axis, half), 0.0f), int(i));
    }
    std::sort(m_sorted.begin(), m_sorted.end());
    m_order.clear();
    for (const auto& [distance, body] : m_sorted) m_order.push_back(body);
}

void BodyTiles::cover(const Bodies::Instance& body, const FrameBlock& block, uint32_t view,
                      std::vector<Span>& spans) const {
    const glm::vec2 halfSize = glm::vec2(block.targetSize) * 0.5f;
    std::array<glm::vec4, 8> corners;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 cell(i & 1 ? body.high.x : body.low.x, i & 2 ? body.high.y : body.low.y,
                             i & 4 ? body.high.z : body.low.z);
        corners[size_t(i)] =
            block.viewProjection * glm::vec4(body.position + body.rotation * (cell * body.voxelSize), 1.0f);
    }
    ScreenBox box;
    for (int i = 0; i < 8; ++i)
        for (int axis = 1; axis <= 4; axis *= 2)
            if (!(i & axis))
                box.add(corners[size_t(i)], corners[size_t(i | axis)], block.cameraPosition.w * 0.5f, halfSize);
    glm::vec2 low(1e30f), high(-1e30f);
    for (int i = 0; i < box.count; ++i) {
        const auto& [a, b] = box.edges[size_t(i)];
        low = glm::min(low, glm::min(a, b));
        high = glm::max(high, glm::max(a, b));
    }
    if (box.count == 0)
        low = glm::vec2(0.0f), high = halfSize * 2.0f;  // the box holds the camera and the whole near plane
    const auto tileOf = [&](float pixel, int size) {
        return int(std::clamp(pixel, 0.0f, float(size) - 1.0f)) >> m_tileShift;
    };
    const int width = int(block.targetSize.x), height = int(block.targetSize.y);
    if (high.x < 0.0f || high.y < 0.0f || low.x > float(width) || low.y > float(height)) return;
    for (int row = tileOf(low.y - 1.0f, height); row <= tileOf(high.y + 1.0f, height); ++row) {
        glm::vec2 range(low.x, high.x);
        if (!box.cut) range = box.rangeX(float(row << m_tileShift) - 1.0f, float((row + 1) << m_tileShift) + 1.0f);
        if (range.x > float(width) || range.y < 0.0f || range.x > range.y) continue;
        spans.push_back({view, row, tileOf(range.x - 1.0f, width), tileOf(range.y + 1.0f, width)});
    }
}

/// Builds the lists by a counting sort: spans come in order of depth, so each tile's list is sorted.
void BodyTiles::fill(Lists& lists, const std::vector<Span>& spans) const {
    lists.tiles.clear();
    lists.entries.clear();
    if (spans.empty()) return;
    auto& offsets = lists.offsets;
    offsets.assign(size_t(m_tiles.x * m_tiles.y) + 1, 0);
    const auto forEachTile = [&](auto&& f) {
        for (const Span& span : spans)
            for (int x = span.first; x <= span.last; ++x) f(offsets[size_t(span.row * m_tiles.x + x)], span.body);
    };
    forEachTile([](uint32_t& count, uint32_t) { ++count; });
    uint32_t sum = 0;
    for (size_t tile = 0; tile < offsets.size(); ++tile) {
        if (offsets[tile]) lists.tiles.push_back(uint32_t(tile));
        sum += std::exchange(offsets[tile], sum);
    }
    lists.entries.resize(sum);
    forEachTile([&](uint32_t& next, uint32_t body) { lists.entries[next++] = body; });
    // Filling moved each offset to the end of its tile's entries, where the next tile's begin.
    std::rotate(offsets.begin(), offsets.end() - 1, offsets.end());
    offsets[0] = 0;
}

void BodyTiles::bind(const Program& program, Which which) const {
    program.set("uBodyViews", m_viewTexture);
    program.set("uTileOffsets", list(which).offsetTexture);
    program.set("uTileBodies", list(which).entryTexture);
    program.set("uTileGrid", glm::ivec2(m_tiles.x, m_tileShift));
}

void BodyTiles::drawTiles(const Program& program, Which which, const VertexArray& empty) const {
    program.set("uTileIds", list(which).tileTexture);
    glBindVertexArray(empty.get());
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, GLsizei(list(which).tiles.size()));
}

}  // namespace rubble
