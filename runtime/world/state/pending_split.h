#pragma once
#include <optional>

#include "runtime/core/handle.h"
#include "runtime/destruction/attachment_search.h"

namespace rubble {

/// A shape that was cut and waits for its split; see SplitSettings. First come, first served; cut again, it keeps its
/// place and is searched from the start.
struct PendingSplit {
    ShapeHandle shape;
    BrickSet cut;
    std::optional<AttachmentSearch> search;
};

}  // namespace rubble
