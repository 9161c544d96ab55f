// Two thousand bodies in view: our G-buffer against Teardown's method, for the same image, in one process.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/core/random.h"
#include "runtime/voxel/ray_walk.h"
#include "tests/benchmark/render/teardown_bodies.h"
#include "tests/benchmark/render/ties.h"
#include "tests/render/test_scene.h"

namespace rubble::bench {
namespace {

constexpr int kBodies = 2000;

/// A lump of debris: an ellipsoid with holes.
VoxelGrid lump(Random& random) {
    const glm::ivec3 size(random.between(6, 24), random.between(6, 24), random.between(6, 24));
    VoxelGrid grid(size);
    GridWriter writer(grid);
    const glm::dvec3 half = glm::dvec3(size) * 0.5;
    const uint8_t index = uint8_t(random.between(1, 200));
    const uint64_t seed = random.next();
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 p = (glm::dvec3(x, y, z) + 0.5 - half) / half;
                if (glm::dot(p, p) < 1.0 && hashCell(x / 3, y / 3, z / 3 + int(seed & 1023)) % 4)
                    writer.set({x, y, z}, uint8_t(index + (x + y + z) % 3));
            }
    writer.flush();
    return grid;
}

glm::dquat turned(Random& random) {
    glm::dquat q;
    for (int i = 0; i < 4; ++i) q[i] = random.unit() - 0.5;
    return glm::normalize(q);
}

/// Depth of the first voxel on a ray, by an exact walk in double through each body; infinite if there is none.
double exactDepth(const std::vector<VoxelGrid>& grids, const std::vector<Pose>& poses, const PixelRay& ray) {
    constexpr double kVoxelSize = 0.1f;
    double nearest = INFINITY;
    for (size_t i = 0; i < grids.size(); ++i) {
        const glm::dquat back = glm::conjugate(poses[i].rotation);
        const CellHit hit = walkRay(grids[i], {back * (ray.origin - poses[i].position) / kVoxelSize,
                                               back * ray.direction / kVoxelSize, nearest});
        if (hit.hit) nearest = std::min(nearest, hit.t);
    }
    return nearest;
}

/// Pixels where the depths differ.
Differences differences(const std::vector<glm::vec4>& ours, const std::vector<glm::vec4>& teardown, int width,
                        const FrameBlock& block, const std::vector<VoxelGrid>& grids, const std::vector<Pose>& poses) {
    Differences count;
    const auto find = [&](const PixelRay& ray) { return exactDepth(grids, poses, ray); };
    for (size_t i = 0; i < ours.size(); ++i) {
        const double a = ours[i].x, b = teardown[i].x;
        if (std::abs(a - b) <= 1e-5 * a) continue;
        const auto is = [](double depth) {
            return [depth](double found) {
                return depth > 1e4 ? std::isinf(found) : std::abs(found - depth) <= 1e-5 * depth;
            };
        };
        count.add(pixelRay(block, {int(i) % width, int(i) / width}), 0.1, find, is(a), is(b));
    }
    return count;
}

std::vector<glm::vec4> read(const Texture& texture) {
    std::vector<glm::vec4> out(size_t(texture.size().x) * size_t(texture.size().y));
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, out.data());
    return out;
}

}  // namespace

bool benchBodies(const Options& options) {
    Random random(5);
    TestScene made;
    std::vector<VoxelGrid> grids;
    std::vector<Pose> poses;
    const PaletteRef palette = testPalette();
    for (int i = 0; i < kBodies; ++i) {
        grids.push_back(lump(random));
        const double z = -3.0 - 27.0 * std::sqrt(random.unit()), across = -z * 0.9,
                     x = (random.unit() - 0.5) * across * 1.2, y = (random.unit() - 0.5) * across * 0.7;
        poses.push_back({{x, y, z}, turned(random)});
        made.add(grids.back(), poses.back(), palette);
    }
    GBufferRig rig(options.shaders, made.take());
    TeardownBodies reference(rig.shaders);
    for (const std::string& error : rig.shaders.errors()) fmt::print(stderr, "{}\n", error);
    if (!rig.shaders.errors().empty()) return false;
    for (const VoxelGrid& grid : grids) reference.add(grid);

    View view;
    view.verticalFov = 0.9f;
    view.size = options.size;
    rig.beginFrame(view);
    const double ours = medianMs(options.frames, [&] { rig.gbuffer.draw(rig.context()); });
    const auto depthOurs = read(rig.targets.at(Target::Depth)), albedoOurs = read(rig.targets.at(Target::Albedo));
    const std::vector<int> order = rig.gbuffer.tiles().order();
    const double teardown = medianMs(options.frames, [&] { reference.draw(rig.context(), order); });
    const auto depthTeardown = read(rig.targets.at(Target::Depth)),
               albedoTeardown = read(rig.targets.at(Target::Albedo));
    const auto seen =
        std::count_if(albedoOurs.begin(), albedoOurs.end(), [](const glm::vec4& albedo) { return albedo.w > 0.0f; });
    const Differences differ = differences(depthOurs, depthTeardown, options.size.x, rig.block, grids, poses);
    fmt::print(
        "\n{} bodies in view, on {} of {} pixels\n  ours {:.1f} ms, Teardown's method {:.1f} ms: {:.2f}x (wanted "
        "3); {} pixels differ; wrong: "
        "ours {}, Teardown's {}\n",
        order.size(), seen, depthOurs.size(), ours, teardown, teardown / ours, differ.all, differ.firstWrong,
        differ.secondWrong);
    return true;
}

}  // namespace rubble::bench
