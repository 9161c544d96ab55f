#pragma once
#include <cstddef>

namespace rubble {

/// When what a cut has loosened comes off.
struct SplitSettings {
    /// 0: in the step of the cut. Else shapes that were cut wait in line, and each step looks at this many parts
    /// (components inside a directory node, at most 32x32x32 voxels) of them: a loose piece may hang for some steps.
    size_t partsPerStep = 0;

    friend bool operator==(const SplitSettings&, const SplitSettings&) = default;
};

}  // namespace rubble
