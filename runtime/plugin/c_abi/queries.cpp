#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/world/queries/query.h"

namespace rubble::abi {
namespace {

QueryFilter readFilter(const rubble_query_filter* given) {
    QueryFilter filter;
    if (!given) return filter;
    const rubble_query_filter read = readStruct(given, "filter");
    if (isRefused()) return filter;
    const uint32_t flags = readFlags(read.flags,
                                     RUBBLE_FILTER_REJECT_STATIC | RUBBLE_FILTER_REJECT_DYNAMIC |
                                         RUBBLE_FILTER_REJECT_TRANSPARENT | RUBBLE_FILTER_REJECT_UNPHYSICAL,
                                     "filter->flags");
    if (read.layer_mask) filter.layerMask = uint8_t(readEnum(read.layer_mask, 255, "filter->layer_mask"));
    filter.rejectStatic = flags & RUBBLE_FILTER_REJECT_STATIC;
    filter.rejectDynamic = flags & RUBBLE_FILTER_REJECT_DYNAMIC;
    filter.rejectTransparent = flags & RUBBLE_FILTER_REJECT_TRANSPARENT;
    filter.rejectUnphysical = flags & RUBBLE_FILTER_REJECT_UNPHYSICAL;
    if (read.rejected_body_count) isGiven(read.rejected_bodies, "filter->rejected_bodies");
    if (read.rejected_shape_count) isGiven(read.rejected_shapes, "filter->rejected_shapes");
    if (isRefused()) return filter;
    for (uint32_t i = 0; i < read.rejected_body_count; ++i)
        filter.rejectedBodies.push_back(
            readHandle<HandleType::Body>(read.rejected_bodies[i], "filter->rejected_bodies"));
    for (uint32_t i = 0; i < read.rejected_shape_count; ++i)
        filter.rejectedShapes.push_back(
            readHandle<HandleType::Shape>(read.rejected_shapes[i], "filter->rejected_shapes"));
    return filter;
}

QueryShape readShape(const rubble_query_shape& given) {
    QueryShape shape;
    shape.kind = QueryShapeKind(readEnum(given.kind, RUBBLE_QUERY_CAPSULE, "kind"));
    readReserved(given.reserved, "reserved");
    shape.position = readVector(given.position, "position");
    shape.end = readVector(given.end, "end");
    shape.radius = readOrDefault(given.radius, ranges::kQuerySize, 0.0, "radius");
    shape.halfSize = readVector(given.half_size, "half_size");
    for (int i = 0; i < 3; ++i)
        if (shape.halfSize[i] < 0.0)
            refuse(RUBBLE_ERROR_ARGUMENT, "half_size[{}] is {}, expected 0 or more", i, shape.halfSize[i]);
    shape.rotation = readRotation(given.rotation, "rotation");
    return shape;
}

double readDistance(double given) {
    return readInRange(given, ranges::kDistance, "max_distance");
}

rubble_hit hitRow(const World& world, const WorldHit& hit) {
    rubble_hit row = {};
    if (!hit.hit) return row;
    row.hit = 1;
    row.palette_index = hit.entry;
    row.distance = hit.distance;
    writeVector(row.position, hit.position);
    writeVector(row.normal, hit.normal);
    if (!hit.shape) return row;  // the ground around the level
    row.shape = hit.shape.bits;
    row.body = world.shapes().at(hit.shape).body.bits;
    writeCell(row.cell, hit.cell);
    return row;
}

rubble_result castOneRay(rubble_world world, const double origin[3], const double direction[3], double maxDistance,
                         rubble_hit* out) {
    return inWorld("cast_ray", world, [&](const HostedWorld& hosted) {
        const glm::dvec3 from = readVectorAt(origin, "origin");
        const glm::dvec3 along = readDirectionAt(direction, "direction");
        const double distance = readDistance(maxDistance);
        const World& inside = hosted.loop.world();
        if (isGiven(out, "out") && !isRefused()) *out = hitRow(inside, castRay(inside, {from, along, distance}));
    });
}

/// The distances between the rows of both arrays of a batch.
struct RowSizes {
    uint32_t query, hit;
};

/// The filter with zeros for what its host does not know.
rubble_query_filter sizesOf(const rubble_query_filter& filter) {
    return copyStruct<rubble_query_filter>(&filter, filter.struct_size);
}

template <class Row>
RowSizes readRowSizes(const rubble_query_filter* filter) {
    const auto read = filter ? sizesOf(*filter) : rubble_query_filter{};
    return {readRowSize<Row>(read.query_size, "filter->query_size"),
            readRowSize<rubble_hit>(read.hit_size, "filter->hit_size")};
}

/// Answers each row of the host's array by one of `out`: read(row) makes a query, cast() answers them all.
template <class Query, class Row, class Read, class Cast>
void castAll(const HostedWorld& hosted, const Row* rows, const char* name, uint32_t count,
             const rubble_query_filter* filter, rubble_hit* out, Read&& read, Cast&& cast) {
    const QueryFilter rejecting = readFilter(filter);
    const RowSizes sizes = readRowSizes<Row>(filter);
    if (count) isGiven(rows, name), isGiven(out, "out");
    if (isRefused()) return;
    std::vector<Query> queries(count);
    const auto* given = reinterpret_cast<const char*>(rows);
    for (uint32_t i = 0; i < count; ++i) {
        queries[i] = read(copyStruct<Row>(given + size_t(i) * sizes.query, sizes.query));
        if (isRefused()) return Call::current().locate(fmt::format("{}[{}].", name, i));
    }
    const auto write = [&](size_t first, std::span<const WorldHit> hits) {
        for (size_t i = 0; i < hits.size(); ++i)
            writeRow(reinterpret_cast<char*>(out) + (first + i) * sizes.hit, hitRow(hosted.loop.world(), hits[i]),
                     sizes.hit);
    };
    cast(queries, write, rejecting, hosted.loop.parallelFor());
}

rubble_result castManyRays(rubble_world world, const rubble_ray* rays, uint32_t count,
                           const rubble_query_filter* filter, rubble_hit* out) {
    return inWorld("cast_rays", world, [&](HostedWorld& hosted) {
        const auto read = [](const rubble_ray& ray) {
            return RayQuery{readVector(ray.origin, "origin"), readDirection(ray.direction, "direction"),
                            readDistance(ray.max_distance),
                            readOrDefault(ray.radius, ranges::kQuerySize, 0.0, "radius")};
        };
        castAll<RayQuery>(hosted, rays, "rays", count, filter, out, read,
                          [&](auto& queries, const HitSink& sink, const auto& with, const auto& parallelFor) {
                              castRays(hosted.loop.world(), queries, sink, with, parallelFor);
                          });
    });
}

rubble_result castManyShapes(rubble_world world, const rubble_shape_cast* casts, uint32_t count,
                             const rubble_query_filter* filter, rubble_hit* out) {
    return inWorld("cast_shapes", world, [&](HostedWorld& hosted) {
        const auto read = [](const rubble_shape_cast& cast) {
            return CastQuery{readShape(cast.shape), readDirection(cast.direction, "direction"),
                             readDistance(cast.max_distance)};
        };
        castAll<CastQuery>(hosted, casts, "casts", count, filter, out, read,
                           [&](auto& queries, const HitSink& sink, const auto& with, const auto& parallelFor) {
                               castShapes(hosted.loop.world(), queries, sink, with, parallelFor);
                           });
    });
}

template <class Find>
rubble_result overlap(const char* function, rubble_world world, const rubble_query_shape* region,
                      const rubble_query_filter* filter, uint64_t* out, uint32_t capacity, uint32_t* count,
                      Find&& find) {
    return listRows<uint64_t>(function, world, out, capacity, count, [&](const HostedWorld& hosted, auto& rows) {
        if (!isGiven(region, "region")) return;
        const QueryShape shape = readShape(*region);
        const QueryFilter rejecting = readFilter(filter);
        if (isRefused()) return;
        for (const auto handle : find(hosted.loop.world(), shape, rejecting)) rows.add([&] { return handle.bits; });
    });
}

rubble_result overlapBodies(rubble_world world, const rubble_query_shape* region, const rubble_query_filter* filter,
                            rubble_body* out, uint32_t capacity, uint32_t* count) {
    return overlap("overlap_bodies", world, region, filter, out, capacity, count, overlappingBodies);
}
rubble_result overlapShapes(rubble_world world, const rubble_query_shape* region, const rubble_query_filter* filter,
                            rubble_shape* out, uint32_t capacity, uint32_t* count) {
    return overlap("overlap_shapes", world, region, filter, out, capacity, count, overlappingShapes);
}

rubble_result findClosestPoint(rubble_world world, const double position[3], double maxDistance,
                               const rubble_query_filter* filter, rubble_hit* out) {
    return inWorld("find_closest_point", world, [&](const HostedWorld& hosted) {
        const World& inside = hosted.loop.world();
        const glm::dvec3 point = readVectorAt(position, "position");
        const double distance = readOrDefault(maxDistance, ranges::kDistance, 0.0, "max_distance");
        const QueryFilter rejecting = readFilter(filter);
        const uint32_t hitSize = readRowSize<rubble_hit>(filter ? sizesOf(*filter).hit_size : 0, "filter->hit_size");
        if (isGiven(out, "out") && !isRefused())
            writeRow(out, hitRow(inside, closestPoint(inside, point, distance, rejecting)), hitSize);
    });
}

}  // namespace

void setQueryFunctions(rubble_api& api) {
    api.cast_ray = castOneRay;
    api.cast_rays = castManyRays;
    api.cast_shapes = castManyShapes;
    api.overlap_bodies = overlapBodies;
    api.overlap_shapes = overlapShapes;
    api.find_closest_point = findClosestPoint;
}

}  // namespace rubble::abi
