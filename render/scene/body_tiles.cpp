#include "render/scene/body_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <string>
#include <utility>

#include "render/frame/frame_block.h"
#include "render/frame/shader_constants.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr int kMinTileShift = 3;  ///< tiles of 8x8 pixels; larger ones for views of more than kMaxTiles
constexpr int kMaxTiles = 4096;
constexpr size_t kMaxStaleViews = 1024;  ///< more than twice as many views as bodies: then all are projected again

/// A plane: what lies inside is at heights of 0 and more over it, as seen from the camera.
struct SidePlane {
    glm::vec3 normal;
    float camera = 0.0f;  ///< height of the camera

    float heightOf(glm::vec3 fromCamera) const { return glm::dot(fromCamera, normal) + camera; }
};

/// Whether a body's box holds a point, or nearly so.
bool holds(const Bodies::Instance& body, glm::vec3 point) {
    const glm::vec3 local = glm::conjugate(body.rotation) * (point - body.position);
    const glm::vec3 low = glm::vec3(body.low) * body.voxelSize, high = glm::vec3(body.high) * body.voxelSize;
    return glm::all(glm::greaterThan(local, low - shared::kNearestSurface)) &&
           glm::all(glm::lessThan(local, high + shared::kNearestSurface));
}

/// The planes of the view frustum beside the camera: left, right, bottom, top.
std::array<SidePlane, 4> sidePlanes(const FrameBlock& b) {
    const glm::vec3 forward(b.cameraForward), right(b.cameraRight), up(b.cameraUp), middle(b.viewMiddle);
    const float width = b.cameraRight.w, height = b.cameraUp.w;
    if (b.isOrthographic()) return {{{right, width}, {-right, width}, {up, height}, {-up, height}}};
    const float x = glm::dot(middle, right), y = glm::dot(middle, up);
    return {{{glm::normalize(right + forward * (width - x))},
             {glm::normalize(-right + forward * (width + x))},
             {glm::normalize(up + forward * (height - y))},
             {glm::normalize(-up + forward * (height + y))}}};
}

/// The edges of a projected box, in pixels.
struct ScreenBox {
    std::array<std::pair<glm::vec2, glm::vec2>, 12> edges;
    int count = 0;
    bool cut = false;  ///< at the camera: its outline has parts that are not among the edges

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

/// What a camera sees.
struct BodyTiles::Frustum {
    explicit Frustum(const FrameBlock& b) : camera(b.cameraPosition), forward(b.cameraForward), planes(sidePlanes(b)) {}
    /// Whether the sphere around a body is in view; then also the least depth of its box.
    bool sees(const Bodies::Instance& body, float& minDepth) const {
        if (body.empty()) return false;
        const glm::vec3 low = glm::vec3(body.low) * body.voxelSize, high = glm::vec3(body.high) * body.voxelSize;
        const glm::vec3 half = (high - low) * 0.5f;
        const glm::vec3 center = body.position + body.rotation * ((low + high) * 0.5f) - camera;
        const float radius = glm::length(half), depth = glm::dot(center, forward);
        if (!(depth > -radius)) return false;
        for (const SidePlane& plane : planes)
            if (!(plane.heightOf(center) > -radius)) return false;
        minDepth = std::max(depth - glm::dot(glm::abs(glm::conjugate(body.rotation) * forward), half), 0.0f);
        return true;
    }
    /// Whether a part of a box may be in view.
    bool sees(const WorldBox& box) const {
        const glm::vec3 half((box.high - box.low) * 0.5), center(glm::vec3((box.low + box.high) * 0.5) - camera);
        const auto isBefore = [&](const SidePlane& plane) {
            return plane.heightOf(center) + glm::dot(half, glm::abs(plane.normal)) >= 0.0f;
        };
        return isBefore({forward}) && std::all_of(planes.begin(), planes.end(), isBefore);
    }
    glm::vec3 camera, forward;
    std::array<SidePlane, 4> planes;
};

void BodyTiles::update(const Bodies& bodies, const FrameBlock& block) {
    const Camera camera{block.cameraPosition, block.cameraRight, block.cameraUp,
                        block.cameraForward,  block.viewMiddle,  block.targetSize};
    const bool isSameView = camera == m_camera && bodies.touched().frame - m_frame <= 1;
    const bool isSameFrame = isSameView && bodies.touched().frame == m_frame;
    m_camera = camera;
    m_frame = bodies.touched().frame;
    if (isSameView && (isSameFrame || bodies.touched().slots.empty())) return;

    resize();
    const Frustum frustum(block);
    const bool keeps = isSameView && m_views.size() <= 2 * m_seen.size() + kMaxStaleViews;
    const bool fits = (keeps && addBodies(dropTouched(bodies, frustum), bodies, block)) ||
                      addBodies(startOver(bodies, frustum), bodies, block);
    if (!fits) m_camera = {};  // the next frame starts over too
    for (const Which which : {Which::All, Which::Glass}) {
        Lists& lists = which == Which::All ? m_all : m_glass;
        fill(lists, which);
        if (lists.entries.empty() || (fits && send(lists))) continue;
        lists.entries.clear();
        if (!std::exchange(m_fullLogged, true))
            logError("bodies are not drawn: the GL has no room for the lists of " + std::to_string(m_seen.size()) +
                     " bodies in view");
    }
}

/// Adds bodies in view. False if the GL has no room for their views.
bool BodyTiles::addBodies(const Found& found, const Bodies& bodies, const FrameBlock& block) {
    const size_t firstNew = m_views.size(), kept = m_seen.size();
    for (const auto& [minDepth, instance] : found) project(bodies, block, minDepth, instance);
    std::inplace_merge(m_seen.begin(), m_seen.begin() + std::ptrdiff_t(kept), m_seen.end());
    return sendViews(firstNew);
}

void BodyTiles::resize() {
    const glm::ivec2 size(m_camera.targetSize);
    m_tileShift = kMinTileShift;
    const auto tiles = [&] { return (size + (1 << m_tileShift) - 1) >> m_tileShift; };
    while (tiles().x * tiles().y > kMaxTiles) ++m_tileShift;
    m_tiles = tiles();
}

/// Forgets all bodies and returns those in view, nearest first.
BodyTiles::Found BodyTiles::startOver(const Bodies& bodies, const Frustum& frustum) {
    m_seen.clear();
    m_views.clear();
    m_spans.clear();
    Found found;
    float minDepth = 0.0f;
    const auto sees = [&](const WorldBox& box) { return ++m_compared, frustum.sees(box); };
    bodies.bounds().find(sees, [&](uint32_t slot) {
        if (frustum.sees(bodies.instances()[slot], minDepth)) found.emplace_back(minDepth, slot);
    });
    std::sort(found.begin(), found.end());
    return found;
}

/// Forgets the bodies that were touched and returns those of them that are in view, nearest first.
BodyTiles::Found BodyTiles::dropTouched(const Bodies& bodies, const Frustum& frustum) {
    std::vector<uint32_t> touched = bodies.touched().slots;
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    std::erase_if(m_seen,
                  [&](const Seen& seen) { return std::binary_search(touched.begin(), touched.end(), seen.instance); });
    m_compared += touched.size();
    Found found;
    float minDepth = 0.0f;
    for (const uint32_t slot : touched)
        if (frustum.sees(bodies.instances()[slot], minDepth)) found.emplace_back(minDepth, slot);
    std::sort(found.begin(), found.end());
    return found;
}

/// Appends a body with its view and the tiles that it covers.
void BodyTiles::project(const Bodies& bodies, const FrameBlock& block, float minDepth, uint32_t instance) {
    const Bodies::Instance& body = bodies.instances()[instance];
    const Bodies::Layout& layout = bodies.layout(instance);
    const glm::mat3 toCells = glm::mat3_cast(glm::conjugate(body.rotation)) * (1.0f / body.voxelSize);
    Seen seen{minDepth, instance, uint32_t(m_views.size()), uint32_t(m_spans.size()), 0, body.glass};
    const glm::vec2 corner(-1.0f), pixel(2.0f * block.targetSize.z, 2.0f * block.targetSize.w);
    m_views.push_back({toCells * (block.rayStart(corner) - body.position), minDepth, toCells * block.ray(corner),
                       int(instance), toCells * block.across({pixel.x, 0.0f}), layout.node,
                       toCells * block.across({0.0f, pixel.y}), layout.palette << 8 | layout.flags,
                       glm::uvec3(body.low) | glm::uvec3(body.high) << 16u, packed(layout.sizeInNodes)});
    cover(body, block);
    seen.endSpan = uint32_t(m_spans.size());
    m_seen.push_back(seen);
    ++m_projected;
}

/// Sends the views from an index on.
bool BodyTiles::sendViews(size_t firstNew) {
    if (firstNew == 0) return rubble::send(m_viewTexture, m_views);
    const auto bytes = std::as_bytes(std::span(m_views));
    if (!m_viewTexture.reserve(bytes.size())) return false;
    if (firstNew < m_views.size())
        m_viewTexture.upload(firstNew * sizeof(BodyView), bytes.subspan(firstNew * sizeof(BodyView)));
    return true;
}

bool BodyTiles::send(Lists& lists) {
    return rubble::send(lists.offsetTexture, lists.offsets) && rubble::send(lists.entryTexture, lists.entries) &&
           rubble::send(lists.tileTexture, lists.tiles);
}

/// Appends the tiles that a body's box covers, by any jitter.
void BodyTiles::cover(const Bodies::Instance& body, const FrameBlock& block) {
    const glm::vec2 halfSize = glm::vec2(block.targetSize) * 0.5f;
    std::array<glm::vec4, 8> corners;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 cell(i & 1 ? body.high.x : body.low.x, i & 2 ? body.high.y : body.low.y,
                             i & 4 ? body.high.z : body.low.z);
        corners[size_t(i)] =
            block.viewProjectionPlain * glm::vec4(body.position + body.rotation * (cell * body.voxelSize), 1.0f);
    }
    ScreenBox box;
    for (int i = 0; i < 8; ++i)
        for (int axis = 1; axis <= 4; axis *= 2)
            if (!(i & axis)) box.add(corners[size_t(i)], corners[size_t(i | axis)], shared::kNearestSurface, halfSize);
    glm::vec2 low(1e30f), high(-1e30f);
    for (int i = 0; i < box.count; ++i) {
        const auto& [a, b] = box.edges[size_t(i)];
        low = glm::min(low, glm::min(a, b));
        high = glm::max(high, glm::max(a, b));
    }
    if (!block.isOrthographic() && holds(body, block.cameraPosition)) {
        box.cut = true;
        low = glm::vec2(0.0f), high = halfSize * 2.0f;
    }
    const auto tileOf = [&](float pixel, int size) {
        return int(std::clamp(pixel, 0.0f, float(size) - 1.0f)) >> m_tileShift;
    };
    const int width = int(block.targetSize.x), height = int(block.targetSize.y);
    if (high.x < 0.0f || high.y < 0.0f || low.x > float(width) || low.y > float(height)) return;
    for (int row = tileOf(low.y - 1.0f, height); row <= tileOf(high.y + 1.0f, height); ++row) {
        glm::vec2 range(low.x, high.x);
        if (!box.cut) range = box.rangeX(float(row << m_tileShift) - 1.0f, float((row + 1) << m_tileShift) + 1.0f);
        if (range.x > float(width) || range.y < 0.0f || range.x > range.y) continue;
        m_spans.push_back({row, tileOf(range.x - 1.0f, width), tileOf(range.y + 1.0f, width)});
    }
}

/// Builds the lists by a counting sort: bodies come in order of depth, so each tile's list is sorted.
void BodyTiles::fill(Lists& lists, Which which) const {
    lists.tiles.clear();
    lists.entries.clear();
    auto& offsets = lists.offsets;
    offsets.assign(size_t(m_tiles.x * m_tiles.y) + 1, 0);
    const auto forEachTile = [&](auto&& f) {
        for (const Seen& seen : m_seen)
            for (uint32_t i = seen.firstSpan; i < seen.endSpan && (which == Which::All || seen.isGlass); ++i)
                for (int x = m_spans[i].first; x <= m_spans[i].last; ++x)
                    f(offsets[size_t(m_spans[i].row * m_tiles.x + x)], seen.view);
    };
    forEachTile([](uint32_t& count, uint32_t) { ++count; });
    uint32_t sum = 0;
    for (size_t tile = 0; tile < offsets.size(); ++tile) {
        if (offsets[tile]) lists.tiles.push_back(uint32_t(tile));
        sum += std::exchange(offsets[tile], sum);
    }
    lists.entries.resize(sum);
    forEachTile([&](uint32_t& next, uint32_t view) { lists.entries[next++] = view; });
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

std::vector<int> BodyTiles::bodiesAt(glm::ivec2 pixel, Which which) const {
    const Lists& lists = list(which);
    const size_t tile = size_t((pixel.y >> m_tileShift) * m_tiles.x + (pixel.x >> m_tileShift));
    std::vector<int> bodies;
    for (uint32_t i = lists.offsets[tile]; i < lists.offsets[tile + 1] && !lists.entries.empty(); ++i)
        bodies.push_back(m_views[lists.entries[i]].instance);
    return bodies;
}

std::vector<int> BodyTiles::order() const {
    std::vector<int> order;
    for (const Seen& seen : m_seen) order.push_back(int(seen.instance));
    return order;
}

}  // namespace rubble
