#include "runtime/plugin/c_abi/queries.h"

#include "runtime/plugin/c_abi/guard.h"
#include "runtime/world/queries/query.h"

namespace rubble::abi {
namespace {

QueryFilter readFilter(const rubble_query_filter* given) {
    QueryFilter filter;
    if (!given) return filter;
    const rubble_query_filter& read = readStruct(given, "filter");
    constexpr uint32_t known = RUBBLE_FILTER_REJECT_STATIC | RUBBLE_FILTER_REJECT_DYNAMIC |
                               RUBBLE_FILTER_REJECT_TRANSPARENT | RUBBLE_FILTER_REJECT_UNPHYSICAL;
    if (read.flags & ~known) throw ApiError{RUBBLE_ERROR_ARGUMENT, "filter->flags has unknown bits"};
    if (read.layers > 255)
        throw ApiError{RUBBLE_ERROR_ARGUMENT,
                       "filter->layers is " + std::to_string(read.layers) + ", expected 0 to 255"};
    if (read.layers) filter.layers = uint8_t(read.layers);
    filter.includeStatic = !(read.flags & RUBBLE_FILTER_REJECT_STATIC);
    filter.includeDynamic = !(read.flags & RUBBLE_FILTER_REJECT_DYNAMIC);
    filter.rejectTransparent = read.flags & RUBBLE_FILTER_REJECT_TRANSPARENT;
    filter.rejectUnphysical = read.flags & RUBBLE_FILTER_REJECT_UNPHYSICAL;
    if (read.rejected_body_count) requireNotNull(read.rejected_bodies, "filter->rejected_bodies");
    if (read.rejected_shape_count) requireNotNull(read.rejected_shapes, "filter->rejected_shapes");
    for (uint32_t i = 0; i < read.rejected_body_count; ++i)
        filter.rejectedBodies.push_back(
            readHandle<HandleType::Body>(read.rejected_bodies[i], "filter->rejected_bodies"));
    for (uint32_t i = 0; i < read.rejected_shape_count; ++i)
        filter.rejectedShapes.push_back(
            readHandle<HandleType::Shape>(read.rejected_shapes[i], "filter->rejected_shapes"));
    return filter;
}

QueryShape readRegion(const rubble_query_shape& given) {
    if (given.kind > RUBBLE_QUERY_BOX)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "kind is " + std::to_string(given.kind) + ", expected 0 to 2"};
    QueryShape shape;
    shape.kind = QueryShapeKind(given.kind);
    shape.position = readVector(given.position, "position");
    shape.end = readVector(given.end, "end");
    shape.radius = readOrDefault(given.radius, 0.0, 1e4, 0.0, "radius");
    shape.halfSize = readVector(given.half_size, "half_size");
    if (shape.halfSize.x < 0.0 || shape.halfSize.y < 0.0 || shape.halfSize.z < 0.0)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "half_size is negative"};
    shape.rotation = readRotation(given.rotation, "rotation");
    return shape;
}

glm::dvec3 readDirection(const double (&given)[3]) {
    const glm::dvec3 direction = readVector(given, "direction");
    if (direction == glm::dvec3(0.0)) throw ApiError{RUBBLE_ERROR_ARGUMENT, "direction is zero"};
    return direction;
}

rubble_touch hitRow(const World& world, const WorldHit& hit) {
    rubble_touch row = {};
    if (!hit.hit) return row;
    row.hit = 1;
    row.entry = hit.entry;
    row.distance = hit.distance;
    writeVector(row.position, hit.position);
    writeVector(row.normal, hit.normal);
    row.shape = hit.shape.bits;
    row.body = world.shapes().at(hit.shape).body.bits;
    for (int i = 0; i < 3; ++i) row.cell[i] = hit.cell[i];
    return row;
}

void writeHits(const World& world, const std::vector<WorldHit>& hits, rubble_touch* out) {
    for (size_t i = 0; i < hits.size(); ++i) out[i] = hitRow(world, hits[i]);
}

template <class Find>
rubble_result overlap(const char* function, rubble_world world, const rubble_query_shape* region,
                      const rubble_query_filter* filter, uint64_t* out, uint32_t capacity, uint32_t* count,
                      Find&& find) {
    return guarded(function, [&] {
        const auto hosted = Registry::instance().world(world);
        RowWriter<uint64_t> rows(out, capacity, count);
        for (const auto handle :
             find(hosted->loop.world(), readRegion(requireNotNull(region, "region")), readFilter(filter)))
            rows.add([&] { return handle.bits; });
        rows.finish();
    });
}

}  // namespace

rubble_result castRays(rubble_world world, const rubble_ray* rays, uint32_t count, const rubble_query_filter* filter,
                       rubble_touch* out) {
    return guarded("cast_rays", [&] {
        const auto hosted = Registry::instance().world(world);
        const QueryFilter read = readFilter(filter);
        if (count) requireNotNull(rays, "rays"), requireNotNull(out, "out");
        std::vector<RayQuery> queries(count);
        std::vector<WorldHit> hits(count);
        for (uint32_t i = 0; i < count; ++i)
            queries[i] = {readVector(rays[i].origin, "origin"), readDirection(rays[i].direction),
                          readOrDefault(rays[i].max_distance, 1e-6, 1e6, 0.0, "max_distance"),
                          readOrDefault(rays[i].radius, 0.0, 1e3, 0.0, "radius")};
        castRays(hosted->loop.world(), queries, hits, read);
        writeHits(hosted->loop.world(), hits, out);
    });
}

rubble_result castShapes(rubble_world world, const rubble_shape_cast* casts, uint32_t count,
                         const rubble_query_filter* filter, rubble_touch* out) {
    return guarded("cast_shapes", [&] {
        const auto hosted = Registry::instance().world(world);
        const QueryFilter read = readFilter(filter);
        if (count) requireNotNull(casts, "casts"), requireNotNull(out, "out");
        std::vector<CastQuery> queries(count);
        std::vector<WorldHit> hits(count);
        for (uint32_t i = 0; i < count; ++i)
            queries[i] = {readRegion(casts[i].shape), readDirection(casts[i].direction),
                          readOrDefault(casts[i].max_distance, 1e-6, 1e6, 0.0, "max_distance")};
        castShapes(hosted->loop.world(), queries, hits, read);
        writeHits(hosted->loop.world(), hits, out);
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

rubble_result closestPoint(rubble_world world, const double position[3], double maxDistance,
                           const rubble_query_filter* filter, rubble_touch* out) {
    return guarded("find_closest_point", [&] {
        const auto hosted = Registry::instance().world(world);
        const glm::dvec3 point =
            readVector(reinterpret_cast<const double(&)[3]>(requireNotNull(position, "position")), "position");
        const double reach = readOrDefault(maxDistance, 0.0, 1e6, 0.0, "max_distance");
        requireNotNull(out, "out") =
            hitRow(hosted->loop.world(), closestPoint(hosted->loop.world(), point, reach, readFilter(filter)));
    });
}

}  // namespace rubble::abi
