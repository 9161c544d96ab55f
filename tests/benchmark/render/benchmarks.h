#pragma once
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "runtime/frame/frame_snapshot.h"
#include "samples/support/gl_context.h"

namespace rubble::bench {

struct Options {
    glm::ivec2 size{640, 360};
    int frames = 15;             ///< of which the median is told
    bool processorTime = false;  ///< of all threads, instead of the wall's
    std::string shaders = RUBBLE_SOURCE_DIR "/shaders";
    std::string preset = "balanced";  ///< of the renderer, where a whole frame is measured
    std::string fullscreen =
        "auto";               ///< what draws full-screen passes, where a whole frame is measured; "both": side by side
    std::string imageFolder;  ///< folder for PNGs of what was measured; empty: none
};

/// Each prints its tables and returns the program's exit code. The context is current.
int benchFrame(const Options& options, GlContext& context);
bool benchWalk(const Options& options);
bool benchBodies(const Options& options);
void benchCity(const Options& options, const FrameSnapshot& town);
int benchCityFrames(const Options& options, GlContext& context);
int benchPrimary(const Options& options);

double median(std::vector<double> values);

}  // namespace rubble::bench
