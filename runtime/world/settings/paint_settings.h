#pragma once
#include <cstdint>

namespace rubble {

/// Where paint goes.
enum class PaintMode : uint8_t {
    Default,  ///< of an edit: the mode of the world's settings; of settings: Blend
    Blend,    ///< blended colours take free entries of the shape's palette; if none is free, the nearest entry is used
    Layer,    ///< a byte beside each voxel of painted bricks: 15 colours a shape in 16 strengths, over any palette
};

struct PaintSettings {
    PaintMode mode = PaintMode::Blend;

    friend bool operator==(const PaintSettings&, const PaintSettings&) = default;
};

}  // namespace rubble
