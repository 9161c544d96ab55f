#pragma once

namespace rubble {

inline constexpr int kLanes = 8;  ///< on every processor, so that results do not depend on it

/// Eight floats in memory: see float8.h.
struct alignas(32) Lanes {
    float at[kLanes];
};

}  // namespace rubble
