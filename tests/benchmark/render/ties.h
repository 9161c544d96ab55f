#pragma once
#include <cmath>
#include <glm/geometric.hpp>

#include "render/frame/frame_context.h"

namespace rubble::bench {

/// The ray of a pixel as in the shaders: metres from the render origin, with a length of 1 along the view axis.
struct PixelRay {
    glm::dvec3 origin, direction;
};

/// Through the centre of a pixel, without jitter.
inline PixelRay pixelRay(const FrameBlock& block, glm::ivec2 pixel) {
    const glm::dvec2 p = (glm::dvec2(pixel) + 0.5) / glm::dvec2(block.targetSize) * 2.0 - 1.0;
    const auto axis = [](const glm::vec4& v) { return glm::dvec3(v); };
    return {axis(block.cameraPosition), axis(block.cameraForward) +
                                            axis(block.cameraRight) * (p.x * double(block.cameraRight.w)) +
                                            axis(block.cameraUp) * (p.y * double(block.cameraUp.w))};
}

/// Counts pixels where two methods disagree, and how many of the answers are wrong. An answer is wrong if the exact
/// walk finds it neither for the ray itself nor for rays shifted sideways by up to 1e-4 of a voxel (24 of them, then
/// 1,680). If both are right, the ray grazes an edge and there is a tie.
struct Differences {
    int64_t all = 0, firstWrong = 0, secondWrong = 0;

    /// Adds a pixel. find(ray) walks in double precision; isFirst and isSecond compare with the two answers.
    template <class Find, class IsFirst, class IsSecond>
    void add(const PixelRay& ray, double voxelSize, Find&& find, IsFirst&& isFirst, IsSecond&& isSecond) {
        const glm::dvec3 forward = glm::normalize(ray.direction);
        const glm::dvec3 right =
            glm::normalize(glm::cross(forward, std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
        const glm::dvec3 up = glm::cross(right, forward);
        bool first = false, second = false;
        for (const int half : {2, 20}) {
            const int side = 2 * half + 1;
            for (int i = 0; i < side * side && !(first && second); ++i) {
                const glm::dvec2 aside = (glm::dvec2(i % side, i / side) - double(half)) * (1e-4 * voxelSize / half);
                const auto found = find(PixelRay{ray.origin + right * aside.x + up * aside.y, ray.direction});
                first = first || isFirst(found);
                second = second || isSecond(found);
            }
        }
        ++all;
        firstWrong += !first;
        secondWrong += !second;
    }
};

}  // namespace rubble::bench
