#pragma once
#include <optional>

#include "runtime/core/handle.h"
#include "runtime/destruction/attachment_search.h"

namespace rubble {

/// A shape that was cut and waits for its connectivity test; see SplitSettings. First come, first served. A shape that
/// is cut again keeps its place in the line, and its test starts again.
struct PendingSplit {
    ShapeHandle shape;
    BrickSet cut;                            ///< bricks that lost voxels
    std::optional<AttachmentSearch> search;  ///< the test, once it has begun
};

}  // namespace rubble
