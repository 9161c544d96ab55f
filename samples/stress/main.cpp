// Random demolition at speed, with everything that must always hold checked at every step. Prints one line and its seed.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "runtime/core/random.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/town.h"

namespace rubble {
namespace {

/// Where edits land: near solid voxels of a random shape.
glm::dvec3 randomPlace(const World& world, Random& random) {
    std::vector<ShapeHandle> shapes;
    world.shapes().forEach([&](ShapeHandle handle, const Shape&) { shapes.push_back(handle); });
    if (shapes.empty()) return {};
    const ShapeHandle handle = shapes[random.below(uint32_t(shapes.size()))];
    const Shape& shape = world.shapes().at(handle);
    const glm::ivec3 size = shape.grid.size();
    const int x = random.between(0, size.x - 1), y = random.between(0, size.y - 1), z = random.between(0, size.z - 1);
    return world.shapeToWorld(handle).transformPoint(glm::dvec3(x, y, z) * double(shape.voxelSize));
}

Edit randomEdit(const World& world, Random& random) {
    const glm::dvec3 place = randomPlace(world, random);
    const double radius = 0.2 + 1.5 * double(random.unit());
    const uint32_t kind = random.below(8);
    if (kind == 0) return ExplodeEdit{place, radius, 0.0};
    if (kind == 1) {
        PaintEdit paint;
        paint.position = place;
        paint.radius = radius;
        paint.seed = random.next();
        return paint;
    }
    CarveEdit carve;
    carve.position = place;
    carve.radii = {radius, radius * 0.8, radius * 0.5};
    if (kind == 2) {
        carve.kind = BrushKind::Box;
        carve.halfSize = glm::dvec3(radius, radius * 0.3, radius * 0.6);
    } else if (kind == 3) {
        carve.kind = BrushKind::Capsule;
        carve.end = randomPlace(world, random);
    }
    return carve;
}

/// "" if all is well, else what is wrong.
std::string whatIsWrong(const World& world) {
    std::string wrong;
    if (!world.ledger().balances()) wrong = "the ledger does not balance";
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        const double sum = body.pose.position.x + body.pose.position.y + body.pose.position.z + glm::length(body.velocity) +
                           glm::length(body.angularVelocity) + body.pose.rotation.w;
        if (!std::isfinite(sum)) wrong = fmt::format("body {:x} is not finite", handle.bits);
        if (body.shapes.empty()) wrong = fmt::format("body {:x} has no shape", handle.bits);
    });
    return wrong;
}

int run(int argc, char** argv) {
    uint64_t seed = 1;
    int steps = 600, editsEvery = 10;
    std::string file;
    CLI::App app{"Random demolition with every invariant checked at every step", "stress"};
    app.add_option("--seed", seed)->capture_default_str();
    app.add_option("--steps", steps, "of 1/60 s")->capture_default_str();
    app.add_option("--edits-every", editsEvery, "steps between edits")->capture_default_str()->check(CLI::PositiveNumber);
    app.add_option("--level", file, ".vdb, .vox or .rubble; the town if not given");
    CLI11_PARSE(app, argc, argv);

    Level level;
    if (file.empty()) {
        level = makeTown(seed);
    } else {
        const auto tool = std::filesystem::weakly_canonical(std::filesystem::path(argv[0])).parent_path() / "rubble-vdb";
        Result<Level> read = readLevel(file, tool.string());
        if (!read) return logError(read.error()), 1;
        level = std::move(*read);
    }
    FrameLoopSettings settings;
    settings.publish = settings.shadowVolume = false;
    FrameLoop loop(settings);
    loop.load(level);
    Random random(seed, 77);
    size_t mostBodies = 0;
    double worstMs = 0.0;
    for (int step = 0; step < steps; ++step) {
        if (step % editsEvery == 0) loop.edits().push(randomEdit(loop.world(), random));
        double ms = 0.0;
        {
            const ScopedTimer timer(ms);
            loop.step();
        }
        worstMs = std::max(worstMs, ms);
        mostBodies = std::max(mostBodies, loop.world().bodies().size());
        if (const std::string wrong = whatIsWrong(loop.world()); !wrong.empty()) {
            fmt::print("stress: FAILED at step {} with seed {}: {}\n", step, seed, wrong);
            return 1;
        }
    }
    fmt::print("stress: {} steps, seed {}: {} bodies at most, worst step {:.1f} ms, state {:016x}\n", steps, seed, mostBodies, worstMs,
               loop.world().hash());
    return 0;
}

}  // namespace
}  // namespace rubble

int main(int argc, char** argv) {
    return rubble::run(argc, argv);
}
