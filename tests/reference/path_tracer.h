#pragma once
#include <string>

#include "render/float_image.h"
#include "render/renderer.h"
#include "tests/reference/scene.h"

namespace rubble::reference {

/// What of the light a picture shows, as the renderer's targets hold it. Terms are per pixel of what is opaque; Full is
/// all of them as shaders/passes/composite.frag adds them up, with glass, haze and what lies behind.
enum class Term {
    SunShare,     ///< x: share of the sun's disc that is seen (target "noisyLight", a)
    Sky,          ///< mean radiance over the cosine-weighted hemisphere ("noisyLight", rgb, from sky rays)
    LocalLights,  ///< irradiance / pi ("noisyLight", rgb, from lights)
    Reflection,   ///< what smooth surfaces mirror ("reflection")
    Full          ///< "radiance"
};

struct Settings {
    Term term = Term::Full;
    int samples = 64;  ///< paths a pixel
    int bounces =
        32;  ///< surfaces that light may come from before it reaches the one that is seen; 0: what rays hit is black
    double maxDistance = 1e30;  ///< metres: sky and mirror rays that get that far see the sky
    bool filterPixels =
        false;  ///< over the pixel and its neighbours, as the temporal anti-aliasing does; else its centre
    bool lobeSamples = true;  ///< for highlights of lamps; without, the same mean with more noise
    uint64_t seed = 1;
};

struct Estimate {
    FloatImage mean;
    FloatImage variance;  ///< of one sample, estimated: / samples is that of the mean
    int samples = 0;
};

/// Unbiased: light of every path, with the materials of shaders/lib/brdf.glsl and composite.frag. On all processors,
/// with a progress bar if `what` names the work.
Estimate render(const Scene& scene, const View& view, const Settings& settings, const std::string& what = {});

}  // namespace rubble::reference
