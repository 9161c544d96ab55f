#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/frame/shader_constants.h"
#include "render/gl/texture.h"

namespace rubble {

/// Detail maps: tileable maps of kSide x kSide texels, one texel per voxel face, for materials with grain, joints or
/// pores, below each other in one texture. A texel: r colour (128: unchanged, 255: brighter by half), g roughness
/// likewise, ba tilt of the face along the map's axes (128: none, 127 more: kMaxTilt).
class DetailMaps {
public:
    static constexpr int kSide = 32;
    static constexpr float kMaxTilt = shared::kMaxTilt;  ///< tangent of the angle

    /// The map of each material, from 1 on, by the material's name; 0: it has none. Without names: of the default
    /// table.
    static std::array<uint8_t, 256> mapsOf(std::span<const std::string> materials);
    /// All maps, RGBA, rows from the first map on. Always the same.
    static std::vector<uint8_t> make();
    /// Number of maps.
    static int count();

    /// Makes the texture.
    DetailMaps();
    /// All maps, the first one at the bottom.
    const Texture& texture() const { return m_texture; }
    /// What stands for them where there are none.
    static Texture none();

private:
    Texture m_texture;
};

}  // namespace rubble
