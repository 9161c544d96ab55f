// One large object: our walk against two walks over 3D textures, with the same rays, in one process.
#include <fmt/format.h>

#include <cmath>

#include "render/gl/framebuffer.h"
#include "render/renderer.h"
#include "runtime/voxel/ray_walk.h"
#include "samples/support/camera.h"
#include "tests/benchmark/houses.h"
#include "tests/benchmark/render/dense_grid.h"
#include "tests/benchmark/render/gbuffer_rig.h"
#include "tests/benchmark/render/ties.h"
#include "tests/render/test_scene.h"

namespace rubble::bench {
namespace {

constexpr double kVoxelSize = 0.1f;  // metres; a float, as in the shaders

struct Eye {
    const char* name;
    glm::dvec3 from, to;
};
constexpr Eye kEyes[] = {{"from above", {-4, 16, -6}, {14, 3, 14}},
                         {"in a street", {6.3, 1.7, 1.0}, {6.5, 3.0, 20.0}},
                         {"in a house", {9.6, 4.0, 9.6}, {16.0, 4.5, 13.0}}};

struct Drawn {
    double ms;
    std::vector<glm::vec4> found;
};

Drawn drawRays(GBufferRig& rig, const Program& program, const Texture& target, const DenseGrid& dense, int frames) {
    Framebuffer framebuffer({&target});
    program.use();
    rig.scene.bodies().bind(program);
    dense.bind(program);
    program.set("uVoxelSize", float(kVoxelSize));
    Drawn drawn;
    drawn.ms = medianMs(frames, [&] {
        framebuffer.begin();
        rig.context().drawTriangle();
    });
    drawn.found.resize(size_t(target.size().x) * size_t(target.size().y));
    glBindTexture(GL_TEXTURE_2D, target.name());
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, drawn.found.data());
    return drawn;
}

/// Pixels where two walks hit different voxels.
Differences differences(const VoxelGrid& grid, const FrameBlock& block, int width, const std::vector<glm::vec4>& a,
                        const std::vector<glm::vec4>& b) {
    Differences count;
    const auto find = [&](const PixelRay& ray) {
        const CellHit hit = walkRay(grid, {ray.origin / kVoxelSize, ray.direction / kVoxelSize, 1e30});
        return hit.hit ? glm::vec3(hit.cell) : glm::vec3(-1.0f);
    };
    for (size_t i = 0; i < a.size(); ++i) {
        const glm::vec3 first(a[i]), second(b[i]);
        if (first == second) continue;
        count.add(
            pixelRay(block, {int(i) % width, int(i) / width}), kVoxelSize, find,
            [&](glm::vec3 cell) { return cell == first; }, [&](glm::vec3 cell) { return cell == second; });
    }
    return count;
}

}  // namespace

bool benchWalk(const Options& options) {
    const VoxelGrid grid = makeHouses();
    TestScene made;
    made.add(grid, {}, testPalette());
    GBufferRig rig(options.shaders, made.take());
    const DenseGrid dense(grid);
    const std::string folder = "../tests/benchmark/render/shaders/";
    const Program& ours = rig.shaders.load(folder + "walk_ours.frag");
    const Program& dda = rig.shaders.load(folder + "walk_dda.frag");
    const Program& reference = rig.shaders.load(folder + "walk_teardown.frag");
    for (const std::string& error : rig.shaders.errors()) fmt::print(stderr, "{}\n", error);
    if (!rig.shaders.errors().empty()) return false;

    fmt::print("\none object of 256x128x256, a ray a pixel: milliseconds of processors' time\n");
    const Texture target(GL_RGBA32F, options.size);
    double sums[3] = {0, 0, 0};
    int64_t wrong = 0;
    for (const Eye& eye : kEyes) {
        Camera camera;
        camera.position = eye.from;
        camera.lookAt(eye.to);
        rig.beginFrame(camera.view(options.size, 0));
        const Drawn a = drawRays(rig, ours, target, dense, options.frames),
                    b = drawRays(rig, dda, target, dense, options.frames),
                    c = drawRays(rig, reference, target, dense, options.frames);
        const Differences fromDda = differences(grid, rig.block, options.size.x, a.found, b.found),
                          fromTeardown = differences(grid, rig.block, options.size.x, a.found, c.found);
        fmt::print(
            "  {:<12} ours {:6.1f}   plain DDA {:6.1f} ({:.2f}x)   bits and mips {:6.1f} ({:.2f}x)   other voxels {} "
            "and {} of {}; wrong: "
            "ours {} and {}, theirs {} and {}\n",
            eye.name, a.ms, b.ms, b.ms / a.ms, c.ms, c.ms / a.ms, fromDda.all, fromTeardown.all, a.found.size(),
            fromDda.firstWrong, fromTeardown.firstWrong, fromDda.secondWrong, fromTeardown.secondWrong);
        sums[0] += a.ms, sums[1] += b.ms, sums[2] += c.ms;
        wrong += fromDda.firstWrong + fromTeardown.firstWrong;
    }
    fmt::print(
        "  together: {:.2f}x plain DDA (wanted 2.8), {:.2f}x bits and mips (wanted 1.15), {} of our voxels are not the "
        "exact walk's\n",
        sums[1] / sums[0], sums[2] / sums[0], wrong);
    return true;
}

}  // namespace rubble::bench
