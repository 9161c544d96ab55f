#pragma once
#include <string>

#include "render/float_image.h"
#include "render/renderer.h"
#include "tests/reference/scene.h"

namespace rubble::reference {

/// Which part of the light is estimated, in the units of the renderer's targets. All but Full are for the opaque
/// surface of a pixel. Full is their sum as in shaders/passes/composite.frag, with glass, haze and background.
enum class Term {
    SunShare,     ///< x: visible share of the sun's disc (target "noisyLight", a)
    Sky,          ///< mean radiance over the cosine-weighted hemisphere ("noisyLight", rgb, from sky rays)
    LocalLights,  ///< irradiance / pi ("noisyLight", rgb, from lights)
    Reflection,   ///< radiance that smooth surfaces reflect ("reflection")
    Full          ///< "radiance"
};

/// How an estimate is made.
struct Settings {
    Term term = Term::Full;
    int samples = 64;           ///< paths a pixel
    int bounces = 32;           ///< surfaces between a light and the visible one; 0: what rays hit is black
    double maxDistance = 1e30;  ///< metres: longer sky and mirror rays see the sky
    bool filterPixels = false;  ///< averages over the filter of TAA; else only the centre of the pixel
    bool lobeSamples = true;    ///< multiple importance sampling of highlights; without it only more noise
    uint64_t seed = 1;
};

/// A rendered image and its noise.
struct Estimate {
    FloatImage mean;
    FloatImage variance;  ///< of one sample, estimated; variance / samples is that of the mean
    int samples = 0;
};

/// An unbiased path tracer with the materials of shaders/lib/brdf.glsl and composite.frag.
///
/// The rendering equation L = L_e + integral f L_i cos (Kajiya 1986) is estimated by random paths from the camera. At
/// each surface light is gathered from the sun and one local light (next event estimation), and the path goes on in a
/// direction drawn from the BRDF, with the throughput multiplied by f cos / density. Highlights of local lights use
/// multiple importance sampling (Veach and Guibas 1995), and long paths end by Russian roulette (Arvo and Kirk 1990).
/// Runs on all processors, with a progress bar if `what` names the work. The same seed gives the same numbers.
Estimate render(const Scene& scene, const View& view, const Settings& settings, const std::string& what = {});

}  // namespace rubble::reference
