#include "render/scene/light_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "render/frame/frame_block.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

using shared::kAlwaysWeighed;
using shared::kTexelsPerLight;
using shared::kTilePixels;
constexpr int kSlices = 12;        ///< of depth: two per doubling from 1 m on; the last one has no end
constexpr double kSameFire = 1.0;  ///< metres between a fire and what it is in the next frame, at most
constexpr float kAnyDepth = 8.0f;  ///< metres: depth at which lights of a tile at any depth are compared

int sliceAt(float depth) {
    return std::clamp(int(std::floor(2.0f * std::log2(std::max(depth, 1.0f)))), 0, kSlices - 1);
}

/// Radius around a light's position within which all of it lies.
float extentOf(const SnapshotLight& light) {
    if (light.kind == LightKind::Capsule) return 0.5f * light.width + light.radius;
    if (light.isRectangle()) return 0.5f * glm::length(glm::vec2(light.width, light.height));
    return light.radius;
}

/// Luminance of its radiant intensity. What is sent less counts as much as what is sent more.
float brightness(const SnapshotLight& light) {
    return glm::dot(glm::abs(light.color), glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

/// Approximate angular falloff: clamp(dot(direction from the light, xyz) + w, 0, 1).
glm::vec4 angularFalloff(const SnapshotLight& light) {
    if (light.kind == LightKind::Cone) {
        const float outer = std::cos(light.coneOuter);
        const float scale = 1.0f / std::max(std::cos(light.coneInner) - outer, 1e-3f);
        return {light.direction * scale, -outer * scale};
    }
    return light.isRectangle() && !light.twoSided ? glm::vec4(light.direction, 0.0f) : glm::vec4(0, 0, 0, 1);
}

/// Mean linear colour of a screen's image, by at most kSamples of its texels.
glm::vec3 meanColor(const LightImage& image) {
    constexpr size_t kSamples = 64;
    if (image.texels.empty()) return glm::vec3(1.0f);
    glm::vec3 sum(0.0f);
    const size_t stride = (image.texels.size() + kSamples - 1) / kSamples;
    for (size_t i = 0; i < image.texels.size(); i += stride)
        for (int channel = 0; channel < 3; ++channel)
            sum[channel] += srgbToLinear(uint8_t(image.texels[i] >> (16 - 8 * channel)));
    return sum / float((image.texels.size() + stride - 1) / stride);
}

LightGrid::Sent sentBy(const SnapshotLight& light) {
    LightGrid::Sent sent{light, extentOf(light), angularFalloff(light)};
    sent.light.color *= meanColor(light.image);
    sent.light.image = {};
    return sent;
}

bool isFire(const LightGrid::Sent& sent) {
    return sent.light.light == LightHandle();
}

/// Whether two lights differ in nothing but their colour.
bool isSameShape(const SnapshotLight& a, const SnapshotLight& b) {
    const auto shape = [](const SnapshotLight& light) {
        return std::tie(light.kind, light.position, light.direction, light.radius, light.reach, light.coneInner,
                        light.coneOuter, light.right, light.width, light.height, light.twoSided);
    };
    return shape(a) == shape(b);
}

/// Whether what a light sends is different enough for histories to be dropped. Flames flicker all the time, and their
/// histories are left to the statistics of passes/light_change.frag.
bool differs(const LightGrid::Sent& a, const LightGrid::Sent& b) {
    constexpr float kColorChange = 0.1f, kTurn = 0.1f, kScale = 0.1f;  // relative
    constexpr double kMetres = 0.25;
    const glm::vec3 brightest = glm::max(a.light.color, b.light.color),
                    change = glm::abs(a.light.color - b.light.color);
    const auto isScaled = [](float x, float y) { return std::abs(x - y) > kScale * std::max(x, y); };
    return std::max({change.x, change.y, change.z}) >
               kColorChange * std::max({brightest.x, brightest.y, brightest.z}) ||
           glm::distance(a.light.position, b.light.position) > kMetres || isScaled(a.light.reach, b.light.reach) ||
           isScaled(a.extent, b.extent) ||
           glm::distance(a.falloff, b.falloff) > kTurn * std::max(glm::length(a.falloff), glm::length(b.falloff));
}

/// The same light while it is out.
LightGrid::Sent outAt(LightGrid::Sent sent) {
    sent.light.color = glm::vec3(0.0f);
    return sent;
}

/// A bounding sphere of what a light reaches. For a cone narrower than a right angle it is smaller than the light's
/// whole reach.
glm::vec4 boundingSphere(const SnapshotLight& light, glm::dvec3 origin) {
    const glm::vec3 place(light.position - origin);
    const float all = light.reach + extentOf(light);
    if (light.kind != LightKind::Cone || light.coneOuter > 0.78f) return {place, all};
    const float half = all / (2.0f * std::cos(light.coneOuter));
    return {place + light.direction * half, half + light.radius};
}

/// One axis of the image, in view space.
struct ImageAxis {
    ImageAxis(const FrameBlock& block, int axis)
        : middle(glm::dot(glm::vec3(block.viewMiddle), glm::vec3(axis == 0 ? block.cameraRight : block.cameraUp))),
          half((axis == 0 ? block.cameraRight : block.cameraUp).w),
          pixels(block.targetSize[axis]),
          isOrthographic(block.isOrthographic()) {}
    /// Where the edge of a tile lies at depth 1. Beyond the image: at its end.
    float edgeOf(int tile) const {
        return middle + (std::min(float(tile * kTilePixels), pixels) / pixels * 2.0f - 1.0f) * half;
    }
    /// Signed distance of a point from the plane through the edge of a tile, positive on the right.
    float beyond(int tile, float along, float depth) const {
        const float edge = edgeOf(tile);
        return isOrthographic ? along - edge : (along - edge * depth) / std::sqrt(1.0f + edge * edge);
    }

    float middle, half;  ///< of what is seen at depth 1; half: of its size
    float pixels;
    bool isOrthographic;
};

/// The first and the last tile along one axis of the screen that a sphere can touch. along, depth: the sphere's centre
/// in view space. Each tile lies between two planes, so the test is exact except near the sphere's silhouette.
std::optional<glm::ivec2> tilesAlong(float along, float depth, float radius, const ImageAxis& axis) {
    const int count = int(std::ceil(axis.pixels / kTilePixels));
    int low = count, high = -1;
    for (int tile = 0; tile < count; ++tile) {
        const auto beyond = [&](int edge) { return axis.beyond(edge, along, depth); };
        if (beyond(tile) < -radius || beyond(tile + 1) > radius) continue;
        low = std::min(low, tile);
        high = std::max(high, tile);
    }
    if (high < low) return {};
    return glm::ivec2(low, high);
}

/// The fires that are in one list and have none near them in the other. They have no handles, and flicker all the time:
/// one that is still there counts as the same.
std::vector<LightGrid::Sent> firesWithout(std::span<const LightGrid::Sent> fires,
                                          std::span<const LightGrid::Sent> others) {
    std::vector<LightGrid::Sent> without;
    std::vector<bool> isTaken(others.size());
    for (const LightGrid::Sent& fire : fires) {
        if (!isFire(fire)) continue;
        size_t nearest = others.size();
        double least = kSameFire;
        for (size_t i = 0; i < others.size(); ++i) {
            if (isTaken[i] || !isFire(others[i])) continue;
            const double away = glm::distance(fire.light.position, others[i].light.position);
            if (away < least) least = away, nearest = i;
        }
        if (nearest < others.size())
            isTaken[nearest] = true;
        else
            without.push_back(fire);
    }
    return without;
}

}  // namespace

void LightGrid::listVisibleLights(std::span<const SnapshotLight> lights, const FrameBlock& block, glm::dvec3 origin) {
    m_visible.clear();
    for (size_t i = 0; i < lights.size(); ++i) {
        const glm::vec4 sphere = boundingSphere(lights[i], origin);
        const glm::vec3 toCentre = glm::vec3(sphere) - glm::vec3(block.cameraPosition);
        const float depth = glm::dot(toCentre, glm::vec3(block.cameraForward));
        if (!(depth + sphere.w > 0.0f) || !(lights[i].reach > 0.0f) || !(brightness(lights[i]) > 0.0f)) continue;
        const glm::vec3 seen(glm::dot(toCentre, glm::vec3(block.cameraRight)),
                             glm::dot(toCentre, glm::vec3(block.cameraUp)), depth);
        const auto across = tilesAlong(seen.x, depth, sphere.w, {block, 0});
        const auto up = tilesAlong(seen.y, depth, sphere.w, {block, 1});
        if (!across || !up) continue;
        m_visible.push_back({int(i),
                             {seen, sphere.w},
                             {across->x, up->x, sliceAt(depth - sphere.w)},
                             {across->y, up->y, sliceAt(depth + sphere.w)}});
    }
    std::stable_sort(m_visible.begin(), m_visible.end(), [&](const VisibleLight& a, const VisibleLight& b) {
        return brightness(lights[size_t(a.light)]) > brightness(lights[size_t(b.light)]);
    });
}

/// Whether the light's sphere meets the bounding box of a cell.
bool LightGrid::reaches(const VisibleLight& light, glm::ivec3 cell, const FrameBlock& block) const {
    const float nearest = cell.z == 0 ? 0.0f : std::exp2(0.5f * float(cell.z));
    const float beyondLight = std::max(light.sphere.z + light.sphere.w, nearest);  // an end for the last slice
    const float farthest = cell.z + 1 == kSlices ? beyondLight : std::exp2(0.5f * float(cell.z + 1));
    const auto aside = [&](int axis) {
        const ImageAxis image(block, axis);
        float first = image.edgeOf(cell[axis]), last = image.edgeOf(cell[axis] + 1);
        if (!image.isOrthographic) {
            first *= first > 0.0f ? nearest : farthest;
            last *= last > 0.0f ? farthest : nearest;
        }
        return light.sphere[axis] - std::clamp(light.sphere[axis], first, last);
    };
    const glm::vec3 away(aside(0), aside(1), light.sphere.z - std::clamp(light.sphere.z, nearest, farthest));
    return glm::dot(away, away) <= light.sphere.w * light.sphere.w;
}

void LightGrid::fillCells(const FrameBlock& block) {
    m_pairs.clear();
    const auto cellAt = [&](int x, int y, int slice) { return uint32_t(x + m_size.x * (y + m_size.y * slice)); };
    for (size_t i = 0; i < m_visible.size(); ++i) {
        const VisibleLight& light = m_visible[i];
        for (int y = light.low.y; y <= light.high.y; ++y)
            for (int x = light.low.x; x <= light.high.x; ++x) {
                const size_t before = m_pairs.size();
                for (int slice = light.low.z; slice <= light.high.z; ++slice)
                    if (reaches(light, {x, y, slice}, block)) m_pairs.emplace_back(cellAt(x, y, slice), uint32_t(i));
                if (m_pairs.size() > before) m_pairs.emplace_back(cellAt(x, y, kSlices), uint32_t(i));
            }
    }
    m_cells.assign(size_t(tiles()) * (kSlices + 1), glm::uvec2(0));
    for (const auto& [cell, light] : m_pairs) ++m_cells[cell].y;
    uint32_t sum = 0;
    for (glm::uvec2& cell : m_cells) {
        cell.x = sum;
        sum += std::exchange(cell.y, 0u);
    }
    m_list.resize(sum);
    for (const auto& [cell, light] : m_pairs) m_list[m_cells[cell].x + m_cells[cell].y++] = light;
}

/// In cells of more lights than a pixel weighs, puts those first that are strongest at the cell's centre.
void LightGrid::moveStrongestFirst(const FrameBlock& block) {
    std::vector<std::pair<float, uint32_t>> byStrength;
    for (size_t i = 0; i < m_cells.size(); ++i) {
        const glm::uvec2 cell = m_cells[i];
        if (cell.y <= 2 * kAlwaysWeighed) continue;
        const int slice = int(i) / tiles(), x = int(i) % m_size.x, y = int(i) / m_size.x % m_size.y;
        const float depth = slice == kSlices ? kAnyDepth : std::exp2(0.5f * (float(slice) + 0.5f));
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) * float(kTilePixels) / glm::vec2(block.targetSize) * 2.0f - 1.0f;
        const glm::vec3 middle = block.rayStart(uv) + block.ray(uv) * depth;
        byStrength.clear();
        for (uint32_t k = 0; k < cell.y; ++k) {
            const uint32_t light = m_list[cell.x + k];
            const glm::vec4 place = m_texels[light * kTexelsPerLight], rough = m_texels[light * kTexelsPerLight + 2];
            const glm::vec3 away = glm::vec3(place) - middle;
            byStrength.emplace_back(-rough.x / (0.5f + glm::dot(away, away)), light);
        }
        std::nth_element(byStrength.begin(), byStrength.begin() + kAlwaysWeighed, byStrength.end());
        for (uint32_t k = 0; k < cell.y; ++k) m_list[cell.x + k] = byStrength[k].second;
    }
}

void LightGrid::addTexels(const SnapshotLight& light, glm::dvec3 origin) {
    const bool cone = light.kind == LightKind::Cone;
    // A light without a cone has an edge that lies beyond all directions.
    const float outer = cone ? std::cos(light.coneOuter) : -3.0f, inner = cone ? std::cos(light.coneInner) : -2.0f;
    const int shape = light.kind == LightKind::Screen    ? shared::kScreen
                      : light.kind == LightKind::Area    ? shared::kArea
                      : light.kind == LightKind::Capsule ? shared::kCapsule
                                                         : shared::kSphere;
    const bool hasImage = shape == shared::kScreen && light.image.height() > 0;
    const float scale = 1.0f / std::max(inner - outer, 1e-3f);
    m_texels.emplace_back(glm::vec3(light.position - origin), extentOf(light));
    m_texels.push_back(angularFalloff(light));
    m_texels.emplace_back(brightness(light), light.reach, std::max(light.radius, 0.005f), 0.5f * light.height);
    m_texels.emplace_back(light.color, float(shape));
    m_texels.emplace_back(light.direction, outer);
    m_texels.emplace_back(light.right, 0.5f * light.width);
    m_texels.emplace_back(scale, float(m_imageTexels.size()),
                          hasImage ? float(light.image.width + (light.image.height() << 8)) : 0.0f,
                          float(light.twoSided));
    if (!hasImage) return;
    for (const uint32_t texel : light.image.texels)
        m_imageTexels.emplace_back(srgbToLinear(uint8_t(texel >> 16)), srgbToLinear(uint8_t(texel >> 8)),
                                   srgbToLinear(uint8_t(texel)), 1.0f);
}

uint64_t LightGrid::upload() {
    uint64_t sent = 0;
    const auto send = [&](BufferTexture& texture, const auto& data) {
        const auto bytes = std::as_bytes(std::span(data));
        sent += bytes.size();
        return texture.refill(bytes);
    };
    const bool fits = send(m_lightsTexture, m_texels) && send(m_cellsTexture, m_cells) && send(m_listTexture, m_list) &&
                      send(m_imageTexture, m_imageTexels);
    if (fits) return sent;
    if (!std::exchange(m_fullLogged, true))
        logError("local lights are not drawn: the GL has no room for " + std::to_string(m_visible.size()) + " in view");
    m_list.clear();
    return 0;
}

float LightGrid::Change::range() const {
    return std::max(after.light.reach,
                    before.light.reach + float(glm::distance(before.light.position, after.light.position)));
}

/// A light's new change takes the place of its last one, and where there is no room that of the oldest one that no
/// longer counts for accumulation.
void LightGrid::addChange(const Sent& before, const Sent& after) {
    if (!isFire(after))
        std::erase_if(m_changes, [&](const Change& old) { return old.after.light.light == after.light.light; });
    const auto oldest = std::max_element(m_changes.begin(), m_changes.end(),
                                         [](const Change& a, const Change& b) { return a.frames < b.frames; });
    if (m_changes.size() == kMaxChanges && oldest->frames > kOldestForAccumulation) m_changes.erase(oldest);
    if (m_changes.size() < kMaxChanges) {
        m_changes.push_back({before, after, 0, !isFire(after) && !m_differences.empty()});
        return;
    }
    constexpr float kBright = 1e9f;  // brighter than any light's share of what a place has
    Sent everywhere{after.light, 0.0f, {0, 0, 0, 1}};
    everywhere.light.reach = std::numeric_limits<float>::infinity();
    everywhere.light.color = glm::vec3(kBright);
    m_changes.back() = {outAt(before), everywhere, 0, false};
}

void LightGrid::addDifference(SnapshotLight light) {
    if (brightness(light) > 0.0f) m_differences.push_back(std::move(light));
}

/// Compares all lights but fires, which flicker all the time and have no handles, with those of the last update().
void LightGrid::findDifferences(std::vector<Sent> now) {
    const auto bits = [](const Sent& sent) { return sent.light.light.bits; };
    const auto negative = [](SnapshotLight light) { return light.color = -light.color, light; };
    std::erase_if(now, isFire);
    std::sort(now.begin(), now.end(), [&](const Sent& a, const Sent& b) { return bits(a) < bits(b); });
    m_differences.clear();
    auto before = m_drawn.begin();
    for (const Sent& after : now) {
        for (; before != m_drawn.end() && bits(*before) < bits(after); ++before) addDifference(negative(before->light));
        const bool isKnown = before != m_drawn.end() && bits(*before) == bits(after);
        SnapshotLight more = after.light;
        if (isKnown && isSameShape(before->light, more))
            more.color -= before->light.color;
        else if (isKnown)
            addDifference(negative(before->light));
        addDifference(std::move(more));
        before += isKnown;
    }
    for (; before != m_drawn.end(); ++before) addDifference(negative(before->light));
    if (m_differences.size() > kMaxDifferences) m_differences.clear();  // more than pixels can afford: see Change
    m_drawn = std::move(now);
}

/// Lights are compared with what they were when their last change counted, so that slow changes count in the end.
void LightGrid::recordChanges(std::span<const SnapshotLight> lights) {
    for (Change& change : m_changes) ++change.frames;
    std::erase_if(m_changes, [](const Change& change) { return change.frames >= kMaxChangeFrames; });
    m_framesSinceChange = std::min(m_framesSinceChange + 1, 1000);
    std::vector<Sent> now;
    now.reserve(lights.size());
    std::transform(lights.begin(), lights.end(), std::back_inserter(now), sentBy);
    findDifferences(now);
    std::vector<std::pair<uint64_t, const Sent*>> gone;
    for (const Sent& each : m_lastLights)
        if (!isFire(each)) gone.emplace_back(each.light.light.bits, &each);
    std::sort(gone.begin(), gone.end());
    std::vector<std::pair<Sent, Sent>> changed;
    for (const Sent& lit : firesWithout(now, m_lastLights)) changed.emplace_back(outAt(lit), lit);
    for (const Sent& out : firesWithout(m_lastLights, now)) changed.emplace_back(out, outAt(out));
    for (Sent& each : now) {
        if (isFire(each)) continue;
        const auto last =
            std::lower_bound(gone.begin(), gone.end(), std::pair(each.light.light.bits, (const Sent*)nullptr));
        if (last == gone.end() || last->first != each.light.light.bits) {
            changed.emplace_back(outAt(each), each);
            continue;
        }
        if (differs(*last->second, each))
            changed.emplace_back(*last->second, each);
        else
            each = *last->second;
        last->second = nullptr;
    }
    for (const auto& [bits, last] : gone)
        if (last) changed.emplace_back(*last, outAt(*last));
    if (!changed.empty()) m_framesSinceChange = 0;
    for (const auto& [before, after] : changed) addChange(before, after);
    m_lastLights = std::move(now);
}

uint64_t LightGrid::update(std::span<const SnapshotLight> lights, const FrameBlock& block, glm::dvec3 origin,
                           bool isSameMoment) {
    m_size = glm::ivec3(glm::ivec2(glm::ceil(glm::vec2(block.targetSize) / float(kTilePixels))), kSlices);
    m_isCut = block.counters.y == 0;
    if (!isSameMoment) recordChanges(lights);
    if (m_isCut && !isSameMoment) m_changes.clear(), m_differences.clear();
    listVisibleLights(lights, block, origin);
    m_list.clear();
    if (m_visible.empty() && differences().empty()) return 0;
    m_texels.clear();
    m_imageTexels.clear();
    for (const VisibleLight& each : m_visible) addTexels(lights[size_t(each.light)], origin);
    for (const SnapshotLight& each : differences()) addTexels(each, origin);
    fillCells(block);
    moveStrongestFirst(block);
    return upload();
}

std::vector<int> LightGrid::lightsAt(glm::ivec2 pixel, float depth) const {
    std::vector<int> found;
    if (empty()) return found;
    const glm::ivec2 tile = pixel / kTilePixels;
    const glm::uvec2 cell = m_cells[size_t(tile.x + m_size.x * (tile.y + m_size.y * sliceAt(depth)))];
    for (uint32_t i = 0; i < cell.y; ++i) found.push_back(m_visible[m_list[cell.x + i]].light);
    return found;
}

void LightGrid::bind(const Program& program, const LightGrid* grid) {
    static const LightGrid none;
    const LightGrid& bound = grid ? *grid : none;
    program.set("uLights", bound.m_lightsTexture);
    program.set("uLightCells", bound.m_cellsTexture);
    program.set("uLightList", bound.m_listTexture);
    program.set("uLightImages", bound.m_imageTexture);
    program.set("uLightGrid", bound.m_size);
}

}  // namespace rubble
