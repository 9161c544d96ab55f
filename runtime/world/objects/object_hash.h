#pragma once
#include "runtime/core/hash.h"
#include "runtime/world/objects/ground_polygon.h"

namespace rubble {

/// Chains the bytes of a value, which must have no padding, into a hash.
template <class T>
void addToHash(uint64_t& hash, const T& value) {
    hash = hashBytes(&value, sizeof value, hash);
}

/// Chains the corners of a polygon, and their number, into a hash.
inline void addToHash(uint64_t& hash, const GroundPolygon& area) {
    hash = hashBytes(area.data(), area.size() * sizeof(GroundPoint), hashValue(area.size(), hash));
}

}  // namespace rubble
