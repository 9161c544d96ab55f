#pragma once
#include <cstdint>

namespace rubble {

/// Where paint goes.
enum class PaintMode : uint8_t {
    Default,  ///< of an edit: as the world's settings say; there: Blend
    Blend,    ///< blended colours take free entries of the shape's palette; short of entries, the nearest stand in
    Layer,    ///< a byte beside each voxel of painted bricks: 15 colours a shape in 16 steps, over any palette
};

struct PaintSettings {
    PaintMode mode = PaintMode::Blend;
};

}  // namespace rubble
