#include "render/scene/smoke_shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/scene/sun_basis.h"

namespace rubble {
namespace {

constexpr GLenum kFormat = GL_RGBA32F;
constexpr int kSide = 64;            ///< texels
constexpr float kMinCell = 0.0625f;  ///< metres per texel
constexpr float kThickness = 1.8f;   ///< optical depth of an opaque puff through its centre

}  // namespace

void SmokeShadow::update(std::span<const SnapshotParticle> particles, glm::vec3 sunDirection, glm::dvec3 origin) {
    m_puffs.clear();
    if (particles.empty() || sunDirection.y <= 0.0f) return;
    m_sun = glm::normalize(sunDirection);
    const SunBasis basis = sunBasis(m_sun);
    m_right = basis.right;
    m_up = basis.up;
    listPuffs(particles, origin);
    if (m_puffs.empty()) return;
    fitMap();
    m_texels.assign(size_t(kSide) * kSide, glm::vec4(0.0f));
    for (const Puff& puff : m_puffs) splat(puff);
    if (!m_map) m_map = Texture(kFormat, glm::ivec2(kSide), Filter::Linear);
    m_map.upload(m_texels.data());
}

void SmokeShadow::listPuffs(std::span<const SnapshotParticle> particles, glm::dvec3 origin) {
    for (const SnapshotParticle& p : particles) {
        if (p.kind != ParticleKind::Dust && p.kind != ParticleKind::Smoke) continue;
        const glm::vec3 place(p.position - origin);
        m_puffs.push_back({{glm::dot(place, m_right), glm::dot(place, m_up), glm::dot(place, m_sun)},
                           p.radius,
                           p.opacity * kThickness});
    }
}

/// Fits the map around the gas, at multiples of its texel size, so that texels keep their positions between frames.
void SmokeShadow::fitMap() {
    glm::vec2 low(1e30f), high(-1e30f);
    for (const Puff& puff : m_puffs) {
        low = glm::min(low, glm::vec2(puff.position) - puff.radius);
        high = glm::max(high, glm::vec2(puff.position) + puff.radius);
    }
    const float extent = std::max(high.x - low.x, high.y - low.y);
    m_cell = kMinCell;
    while (m_cell * (kSide - 4) < extent) m_cell *= 2.0f;
    m_corner = glm::floor(((low + high) * 0.5f) / m_cell) * m_cell - float(kSide / 2) * m_cell;
}

void SmokeShadow::splat(const Puff& puff) {
    const glm::vec2 middle = (glm::vec2(puff.position) - m_corner) / m_cell - 0.5f;
    const float radius = std::max(puff.radius / m_cell, 0.75f), inverse = 1.0f / (radius * radius);
    // A puff smaller than a texel is spread over it.
    const float thickness =
        puff.thickness * std::min(1.0f, puff.radius * puff.radius / (m_cell * m_cell * radius * radius));
    const glm::ivec2 low = glm::max(glm::ivec2(glm::ceil(middle - radius)), 0),
                     high = glm::min(glm::ivec2(glm::floor(middle + radius)), kSide - 1);
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
            const float dx = float(x) - middle.x, dy = float(y) - middle.y,
                        inside = 1.0f - (dx * dx + dy * dy) * inverse;
            if (inside <= 0.0f) continue;
            const float depth = thickness * inside * inside, along = puff.position.z;
            m_texels[size_t(y) * kSide + size_t(x)] += glm::vec4(depth, depth * along, depth * along * along, 0.0f);
        }
}

void SmokeShadow::bind(const Program& program) const {
    program.set("uHasSmoke", int(!m_puffs.empty()));
    static const Texture none = Texture::none(kFormat, glm::ivec2(kSide), Filter::Linear);
    program.set("uSmokeMap", m_map ? m_map : none);
    if (m_puffs.empty()) return;
    const float scale = 1.0f / (m_cell * float(kSide));
    program.set("uSmokeRight", glm::vec4(m_right * scale, -m_corner.x * scale));
    program.set("uSmokeUp", glm::vec4(m_up * scale, -m_corner.y * scale));
}

}  // namespace rubble
