#pragma once
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "generated/paths.h"
#include "runtime/frame/frame_snapshot.h"
#include "samples/support/gl_context.h"

namespace rubble::bench {

struct Options {
    glm::ivec2 size{640, 360};
    int frames = 15;             ///< measured; the median is printed
    bool processorTime = false;  ///< of all threads, instead of wall time
    std::string shaders = RUBBLE_SOURCE_DIR "/shaders";
    std::string against;              ///< another folder of shaders, drawn by turns with the first; empty: none
    std::string preset = "balanced";  ///< of the renderer, for whole frames
    std::string fullscreen = "auto";  ///< what draws full-screen passes of whole frames; "both": side by side
    std::string imageFolder;          ///< for PNGs of the measured views; empty: none
};

/// Benchmarks print tables and need a current GL context. This one times each pass of whole frames of the town; it
/// returns the program's exit code.
int benchFrame(const Options& options, GlContext& context);
/// How long the programs of all features take to build, and from a cache; returns the program's exit code. Programs of
/// earlier runs that the driver keeps make it faster: MESA_SHADER_CACHE_DISABLE=true, __GL_SHADER_DISK_CACHE=0.
int benchPrograms(const Options& options, GlContext& context);
/// The frames in which explosion, fog, rain and lights are first seen, against the frames after them; returns the
/// program's exit code.
int benchFirstFrames(const Options& options, GlContext& context);
/// Two views of the town in a frame against one; returns the program's exit code.
int benchViews(const Options& options, GlContext& context);
/// One object: our walk against two over 3D textures. False if a shader does not build.
bool benchWalk(const Options& options);
/// Two thousand bodies: our G-buffer against Teardown's method. False if a shader does not build.
bool benchBodies(const Options& options);
/// G-buffer and glass of ever larger cities made of copies of the town.
void benchCity(const Options& options, const FrameSnapshot& town);
/// Whole frames of these cities; returns the program's exit code.
int benchCityFrames(const Options& options, GlContext& context);
/// benchWalk(), benchBodies(), the town and benchCity(); returns the program's exit code.
int benchPrimary(const Options& options);

/// The upper median. values must not be empty.
double median(std::vector<double> values);

}  // namespace rubble::bench
