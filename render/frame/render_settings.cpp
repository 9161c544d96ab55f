#include "render/frame/render_settings.h"

#include <algorithm>
#include <chrono>

#include "runtime/core/log.h"

namespace rubble {

double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double View::Projection::startDepth() const {
    if (!isOrthographic()) return 0.0;
    const auto depthOf = [&](double clip) { return (clipFromEye[3][2] - clip) / clipFromEye[2][2]; };
    return std::min(depthOf(isZeroToOne ? 0.0 : -1.0), depthOf(1.0));
}

double View::Projection::windowDepth(double metres) const {
    const glm::dvec4 clip = clipFromEye * glm::dvec4(0.0, 0.0, -metres, 1.0);
    return isZeroToOne ? clip.z / clip.w : 0.5 * clip.z / clip.w + 0.5;
}

RenderSettings RenderSettings::inRange() const {
    RenderSettings settings = *this;
    if (!(resolutionScale < 1.0f)) settings.resolutionScale = 1.0f;  // NaN too
    if (resolutionScale < kMinScale) settings.resolutionScale = kMinScale;
    if (settings.resolutionScale != resolutionScale)
        logWarning("render settings: expected a resolution scale from " + std::to_string(kMinScale) + " to 1, found " +
                   std::to_string(resolutionScale) + "; it counts as the nearest end");
    return settings;
}

RenderSettings RenderSettings::preset(std::string_view name) {
    RenderSettings settings;
    if (name == "fast" || name == "draft") {
        settings.resolutionScale = 0.75f;
        settings.skyDistance = 12.0f;
        settings.skyExactDistance = 1.6f;
        settings.bounceColors = false;
        settings.bounces = 1;
        settings.filterPasses = 2;
    }
    if (name == "draft") {  // a quarter of the pixels is traced; for software renderers, and for views beside others
        settings.resolutionScale = 0.5f;
        settings.reflections = settings.glare = false;
        settings.bloom = 0.0f;
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
