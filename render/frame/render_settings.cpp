#include "render/frame/render_settings.h"

#include <chrono>

namespace rubble {

double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

RenderSettings RenderSettings::preset(std::string_view name) {
    RenderSettings settings;
    if (name == "fast") {
        settings.resolutionScale = 0.75f;
        settings.skyDistance = 12.0f;
        settings.skyExactDistance = 1.6f;
        settings.bounceColors = false;
        settings.bounces = 1;
        settings.filterPasses = 2;
    }
    if (name == "accurate") {
        settings.skyRays = 8;
        settings.sunRays = 4;
        settings.filterPasses = 5;
        settings.bounces = 3;
    }
    return settings;
}

Fullscreen RenderSettings::fullscreenFromName(std::string_view name) {
    if (name == "fastest") return Fullscreen::Fastest;
    return name == "compute" ? Fullscreen::Compute : name == "fragment" ? Fullscreen::Fragment : Fullscreen::Auto;
}

}  // namespace rubble
