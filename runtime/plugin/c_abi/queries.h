#pragma once
#include "runtime/plugin/include/rubble/rubble.h"

// Functions of the table: queries.
namespace rubble::abi {

rubble_result castRays(rubble_world world, const rubble_ray* rays, uint32_t count, const rubble_query_filter* filter,
                       rubble_touch* out);
rubble_result castShapes(rubble_world world, const rubble_shape_cast* casts, uint32_t count,
                         const rubble_query_filter* filter, rubble_touch* out);
rubble_result overlapBodies(rubble_world world, const rubble_query_shape* region, const rubble_query_filter* filter,
                            rubble_body* out, uint32_t capacity, uint32_t* count);
rubble_result overlapShapes(rubble_world world, const rubble_query_shape* region, const rubble_query_filter* filter,
                            rubble_shape* out, uint32_t capacity, uint32_t* count);
rubble_result closestPoint(rubble_world world, const double position[3], double maxDistance,
                           const rubble_query_filter* filter, rubble_touch* out);

}  // namespace rubble::abi
