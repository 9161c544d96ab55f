// ./rubble bench frame|first|programs|views|city|primary: the cost of a frame by pass, of what is first seen, of two
// views, in ever larger worlds, and against other methods.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "render/gl/gl.h"
#include "samples/support/image_size.h"
#include "tests/benchmark/render/benchmarks.h"

double rubble::bench::median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

int main(int argc, char** argv) {
    using namespace rubble;
    bench::Options options;
    std::string subject, gl = "osmesa", size = "640x360";
    CLI::App app{"The cost of a frame", "bench_render"};
    app.add_option("subject", subject, "frame, first, programs, views, city or primary")
        ->required()
        ->check(CLI::IsMember({"frame", "first", "programs", "views", "city", "primary"}));
    app.add_option("--frames", options.frames, "measured")->capture_default_str()->check(CLI::Range(1, 1000000000));
    app.add_option("--size", size, "WIDTHxHEIGHT")->capture_default_str();
    app.add_option("--gl", gl, "osmesa, egl or auto")->capture_default_str();
    app.add_flag("--processor-time", options.processorTime,
                 "milliseconds of all threads together: steady on a busy machine");
    app.add_option("--preset", options.preset, "frame: draft, fast, balanced or accurate")
        ->capture_default_str()
        ->check(CLI::IsMember({"draft", "fast", "balanced", "accurate"}));
    app.add_option("--fullscreen", options.fullscreen,
                   "frame: what draws full-screen passes; both: fragment and compute side by side")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "fragment", "compute", "fastest", "both"}));
    app.add_option("--shaders", options.shaders, "folder of the shaders")->capture_default_str();
    app.add_option("--against", options.against, "frame: another folder of shaders, drawn by turns with the first");
    app.add_option("--images", options.imageFolder, "folder for images of the measured views");
    CLI11_PARSE(app, argc, argv);
    if (const std::string error = readImageSize(size, options.size.x, options.size.y); !error.empty()) {
        fmt::print(stderr, "--size: {}\n", error);
        return 1;
    }
    setvbuf(stdout, nullptr, _IOLBF, 0);
    auto context = GlContext::create(GlContext::kindOf(gl));
    if (!context) {
        fmt::print(stderr, "{}\n", context.error());
        return 1;
    }
    if (auto loaded = loadGl(context.value()->loader()); !loaded) {
        fmt::print(stderr, "{}\n", loaded.error());
        return 1;
    }
    fmt::print("{}, {}x{}\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)), options.size.x, options.size.y);
    if (subject == "frame") return bench::benchFrame(options, *context.value());
    if (subject == "first") return bench::benchFirstFrames(options, *context.value());
    if (subject == "programs") return bench::benchPrograms(options, *context.value());
    if (subject == "views") return bench::benchViews(options, *context.value());
    return subject == "city" ? bench::benchCityFrames(options, *context.value()) : bench::benchPrimary(options);
}
