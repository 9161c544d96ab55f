#pragma once
#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "runtime/core/assertion.h"
#include "runtime/world/queries/query.h"
#include "runtime/world/state/level_ground.h"

// What rays and the other queries share.
namespace rubble {

inline constexpr size_t kBatch = 64;  ///< queries that one call of a ParallelFor's body answers

/// Calls answer(queries, hits) for parts of the queries, which `parallelFor` may run at the same time, and hands on the
/// hits of each.
template <class Query, class Answer>
void inBatches(std::span<const Query> queries, const HitSink& sink, const ParallelFor& parallelFor, Answer&& answer) {
    const size_t count = queries.size();
    parallelFor((count + kBatch - 1) / kBatch, [&](size_t batch) {
        std::array<WorldHit, kBatch> hits;
        const size_t first = batch * kBatch, size = std::min(kBatch, count - first);
        answer(queries.subspan(first, size), std::span(hits).first(size));
        sink(first, std::span(hits).first(size));
    });
}

/// The same with the queries in another order: order[i] is the place of the one that comes at i.
template <class Query, class Answer>
void inOrderedBatches(std::span<const Query> queries, std::span<const uint32_t> order, const HitSink& sink,
                      const ParallelFor& parallelFor, Answer&& answer) {
    parallelFor((order.size() + kBatch - 1) / kBatch, [&](size_t batch) {
        std::array<Query, kBatch> ordered;
        std::array<WorldHit, kBatch> hits;
        const std::span<const uint32_t> places =
            order.subspan(batch * kBatch, std::min(kBatch, order.size() - batch * kBatch));
        for (size_t i = 0; i < places.size(); ++i) ordered[i] = queries[places[i]];
        answer(std::span<const Query>(ordered).first(places.size()), std::span(hits).first(places.size()));
        for (size_t i = 0; i < places.size(); ++i) sink(places[i], std::span(hits).subspan(i, 1));
    });
}

/// Whether a ray of unit direction meets a box, grown by `halfExtent`, within a distance. The slab method: the ray's
/// interval inside a box is the intersection of its intervals between the three pairs of planes (Kay & Kajiya 1986).
inline bool intersects(const WorldBox& box, glm::dvec3 halfExtent, glm::dvec3 origin, glm::dvec3 direction,
                       double distance) {
    double enter = 0.0, leave = distance;
    for (int a = 0; a < 3; ++a) {
        const double lowest = box.low[a] - halfExtent[a], highest = box.high[a] + halfExtent[a];
        if (direction[a] == 0.0) {
            if (origin[a] < lowest || origin[a] > highest) return false;
            continue;
        }
        const double low = (lowest - origin[a]) / direction[a], high = (highest - origin[a]) / direction[a];
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    return enter <= leave;
}

/// A filter applied to shapes, with the accepted palette entries of the last one.
class ShapeFilter {
public:
    /// Both must outlive it.
    ShapeFilter(const WorldData& world, const QueryFilter& filter)
        : m_world(world), m_filter(filter), m_filtersEntries(filter.rejectTransparent || filter.rejectUnphysical) {
        if (!filter.rejectStatic && filter.layerMask & Shape{}.collisionLayer) m_ground = groundSlabs(world);
    }

    /// The solid ground, as far as the query sees it.
    const GroundSlabs& ground() const { return m_ground; }

    /// Whether the query sees a shape.
    bool accepts(ShapeHandle handle, const Shape& shape) const {
        if (!(shape.collisionLayer & m_filter.layerMask)) return false;
        if (m_filter.rejectStatic || m_filter.rejectDynamic) {
            const bool isStatic = m_world.bodies.at(shape.body).isStatic;
            if (isStatic ? m_filter.rejectStatic : m_filter.rejectDynamic) return false;
        }
        return !has(m_filter.rejectedShapes, handle) && !has(m_filter.rejectedBodies, shape.body);
    }
    /// Entries of the shape's palette that the query sees; null: all.
    EntryFilter entries(const Shape& shape) {
        if (!m_filtersEntries) return nullptr;
        if (m_palette == shape.palette.get()) return m_all ? nullptr : &m_entries;
        m_palette = shape.palette.get();
        for (size_t i = 0; i < 256; ++i) {
            const PaletteEntry& entry = (*m_palette)[i];
            const bool isUnphysical = m_world.materials[entry.material].hardness == Hardness::Unphysical;
            m_entries[i] =
                !(m_filter.rejectTransparent && entry.opacity < 255) && !(m_filter.rejectUnphysical && isUnphysical);
        }
        m_all = std::all_of(m_entries.begin(), m_entries.end(), [](bool accepted) { return accepted; });
        return m_all ? nullptr : &m_entries;
    }

private:
    template <class Handle>
    static bool has(const std::vector<Handle>& list, Handle handle) {
        return std::find(list.begin(), list.end(), handle) != list.end();
    }
    const WorldData& m_world;
    const QueryFilter& m_filter;
    GroundSlabs m_ground;
    bool m_filtersEntries, m_all = true;
    const Palette* m_palette = nullptr;
    std::array<bool, 256> m_entries{};
};

/// Calls f(handle, shape) for the accepted shapes whose bounds, with a margin, satisfy isNear(box); in no order.
template <class IsNear, class F>
void forEachShape(const WorldData& world, const ShapeFilter& filter, IsNear&& isNear, F&& f) {
    world.shapeBounds.find(isNear, [&](uint32_t slot) {
        const ShapeHandle handle = world.shapes.handleAt(slot);
        const Shape& shape = world.shapes.at(handle);
        if (filter.accepts(handle, shape)) f(handle, shape);
    });
}

/// The world box of a slab.
inline WorldBox boxOf(const GroundSlab& slab) {
    return {slab.low, slab.low + slab.side * glm::dvec3(slab.cubes.x, 1, slab.cubes.y)};
}

/// Whether a hit at a distance is better than the best so far: nearer, or as near in a lower slot.
inline bool isBetter(double distance, uint32_t slot, const WorldHit& best) {
    if (!best.hit) return distance <= best.distance;
    return distance < best.distance || (distance == best.distance && slot < best.shape.slot());
}

/// The unit vector along a direction of any length; zero for zero. Squares of what is below 1e-154 are zero.
inline glm::dvec3 unitVector(glm::dvec3 direction) {
    const glm::dvec3 size = glm::abs(direction);
    const double largest = std::max({size.x, size.y, size.z});
    if (largest < 1e-100 || largest > 1e100) direction /= largest;
    const double length = glm::length(direction);
    return length > 0.0 ? direction / length : glm::dvec3(0.0);
}

}  // namespace rubble
