#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/gl/texture.h"

namespace rubble {

/// Detail maps: tiles of kSide x kSide texels, one texel a voxel's face, for materials that have a grain. Below each
/// other in one texture. A texel: r colour (128 = as it is, 255 = half as bright again), g roughness likewise, ba how
/// far the face is tilted along the tile's axes (128 = not; 127 more is kMaxTilt).
class DetailMaps {
public:
    static constexpr int kSide = 32;
    static constexpr float kMaxTilt = 0.3f;  ///< tangent of the angle

    /// Numbers of materials' maps, from 1 on, by their names; 0 = it has none. Without names: for the default material
    /// table.
    static std::array<uint8_t, 256> mapsOf(std::span<const std::string> materials);
    /// All maps, RGBA, rows from the first map on. Always the same.
    static std::vector<uint8_t> make();
    static int count();

    DetailMaps();
    const Texture& texture() const { return m_texture; }

private:
    Texture m_texture;
};

}  // namespace rubble
