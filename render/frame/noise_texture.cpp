#include "render/frame/noise_texture.h"

#include <array>

#include "runtime/core/blue_noise.h"

namespace rubble {

Texture makeNoiseTexture() {
    constexpr int kSide = kBlueNoiseSize, kShiftX = 37, kShiftY = 11;
    const std::vector<uint8_t> tile = makeBlueNoise();
    const auto at = [&](int x, int y) { return tile[size_t(y % kSide * kSide + x % kSide)]; };
    std::vector<std::array<uint8_t, 2>> texels;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) texels.push_back({at(x, y), at(x + kShiftX, y + kShiftY)});
    Texture texture(GL_RG8, glm::ivec2(kSide), Filter::Nearest, Wrap::Repeat);
    texture.upload(texels.data());
    return texture;
}

}  // namespace rubble
