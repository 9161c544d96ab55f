#include "render/scene/body_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>

namespace rubble {
namespace {

constexpr uint32_t kMinBuckets = 256;
constexpr int kMaxCellsPerAxis = 4;  ///< of a body's box, not counting the one more that it may touch

float cellSize(int level) {
    return BodyGrid::kFinestCell * float(1 << (2 * level));
}

}  // namespace

BodyGrid::Cells BodyGrid::cellsOf(const Bodies::Instance& body) {
    if (body.empty()) return {};
    const glm::vec3 low = glm::vec3(body.low) * body.voxelSize, high = glm::vec3(body.high) * body.voxelSize;
    const glm::vec3 middle = body.position + body.rotation * (0.5f * (low + high));
    const glm::mat3 axes = glm::mat3_cast(body.rotation);
    const glm::vec3 half = 0.5f * (high - low);
    const glm::vec3 extent =
        glm::abs(axes[0]) * half.x + glm::abs(axes[1]) * half.y + glm::abs(axes[2]) * half.z + 0.01f;
    Cells cells;
    const float side = 2.0f * std::max({extent.x, extent.y, extent.z});
    while (cells.level + 1 < kLevels && side > float(kMaxCellsPerAxis) * cellSize(cells.level)) ++cells.level;
    const float scale = 1.0f / cellSize(cells.level);
    cells.low = glm::ivec3(glm::floor((middle - extent) * scale));
    cells.high = glm::ivec3(glm::floor((middle + extent) * scale)) + 1;
    return cells;
}

/// The hash of firstBodyAt() in lib/voxel_at.glsl.
uint32_t BodyGrid::bucketOf(glm::ivec3 cell, int level) const {
    const glm::uvec3 c(cell);
    uint32_t hash = c.x * 0x8da6b343u ^ c.y * 0xd8163841u ^ c.z * 0xcb1ab31fu ^ uint32_t(level) * 0x9e3779b9u;
    hash ^= hash >> 15;
    return hash & uint32_t(m_bucketHeads.size() - 1);
}

template <class F>
void BodyGrid::forEachBucket(const Cells& cells, F&& f) const {
    for (int z = cells.low.z; z < cells.high.z; ++z)
        for (int y = cells.low.y; y < cells.high.y; ++y)
            for (int x = cells.low.x; x < cells.high.x; ++x) f(bucketOf({x, y, z}, cells.level));
}

void BodyGrid::link(uint32_t slot) {
    forEachBucket(m_cellsOfBody[slot], [&](uint32_t bucket) {
        const uint32_t number = m_slots.allocate();
        m_entries.resize(std::max<size_t>(m_entries.size(), m_slots.end()));
        m_entries.change(number) = {slot, m_bucketHeads[bucket]};
        m_bucketHeads.change(bucket) = number + 1;
    });
}

void BodyGrid::unlink(uint32_t slot) {
    forEachBucket(m_cellsOfBody[slot], [&](uint32_t bucket) {
        uint32_t before = 0, at = m_bucketHeads[bucket];
        while (m_entries[at - 1].body != slot) {
            before = at;
            at = m_entries[at - 1].next;
        }
        (before ? m_entries.change(before - 1).next : m_bucketHeads.change(bucket)) = m_entries[at - 1].next;
        m_slots.free(at - 1);
    });
}

/// Doubles the number of buckets and enters all bodies again.
void BodyGrid::grow() {
    const size_t buckets = std::max<size_t>(kMinBuckets, 2 * m_bucketHeads.size());
    m_bucketHeads.resize(0);
    m_bucketHeads.resize(buckets);
    for (size_t i = 0; i < buckets; ++i) m_bucketHeads.change(i) = 0;
    m_slots = {};
    for (uint32_t slot = 0; slot < m_cellsOfBody.size(); ++slot) link(slot);
}

void BodyGrid::put(uint32_t slot, const Bodies::Instance& body) {
    if (slot >= m_cellsOfBody.size()) m_cellsOfBody.resize(slot + 1);
    const Cells cells = cellsOf(body);
    if (cells == m_cellsOfBody[slot]) return;
    unlink(slot);
    m_cellsOfBody[slot] = cells;
    m_levels = std::max(m_levels, cells.level + 1);
    const glm::ivec3 size = cells.high - cells.low;
    if (m_slots.used() + uint32_t(size.x * size.y * size.z) > m_bucketHeads.size()) return grow();
    link(slot);
}

void BodyGrid::bind(const Program& program) const {
    program.set("uBodyBucketHeads", m_bucketHeads.texture());
    program.set("uBodyEntries", m_entries.texture());
    program.set("uBodyBuckets", int(m_bucketHeads.size()));
    const bool isWhole = m_bucketHeads.held() == m_bucketHeads.size() && m_entries.held() == m_entries.size();
    program.set("uBodyLevels", isWhole ? m_levels : 0);
}

std::vector<uint32_t> BodyGrid::bodiesAt(glm::vec3 point) const {
    std::vector<uint32_t> bodies;
    if (m_bucketHeads.size() == 0) return bodies;
    for (int level = 0; level < m_levels; ++level)
        for (uint32_t at = m_bucketHeads[bucketOf(glm::ivec3(glm::floor(point / cellSize(level))), level)]; at;
             at = m_entries[at - 1].next)
            bodies.push_back(m_entries[at - 1].body);
    return bodies;
}

}  // namespace rubble
