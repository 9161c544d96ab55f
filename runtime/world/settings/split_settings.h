#pragma once
#include <cstddef>

namespace rubble {

/// When pieces come off.
struct SplitSettings {
    /// 0: in the step of the cut. Else shapes that were cut wait in line, and each step tests this many of their parts
    /// (components inside a directory node, at most 32x32x32 voxels): a detached piece may hang for some steps.
    size_t partsPerStep = 0;

    friend bool operator==(const SplitSettings&, const SplitSettings&) = default;
};

}  // namespace rubble
