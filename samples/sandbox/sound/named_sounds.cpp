#include "samples/sandbox/sound/named_sounds.h"

#include <algorithm>
#include <cmath>

#include "samples/sandbox/sound/acoustic_material.h"

namespace sandbox::sound {
namespace {

struct Layer {
    std::string_view name, material;
    double size, joules, contact, count, spread;
};

// Found by ear and by spectrogram.
constexpr Layer kLayers[] = {
    // name        material   m    J     s      hits  s
    {"explosion", "blast", 1.00, 1e4, 3e-3, 2, .02}, {"explosion", "burst", 1.00, 1500, 2e-4, 2, .01},
    {"explosion", "dirt", .30, 300, 1e-3, 24, .70},  {"shot", "shot", 1.00, 120, 1e-4, 1, 0},
    {"shot", "blast", 1.00, 40, 2e-3, 1, 0},         {"blast", "shot", 1.00, 350, 2e-4, 2, .01},
    {"blast", "blast", 1.00, 400, 3e-3, 1, 0},       {"launch", "burst", 1.00, 60, 1e-3, 3, .08},
    {"launch", "blast", 1.00, 120, 4e-3, 1, 0},      {"click", "plastic", .06, 40, 8e-5, 1, 0},
    {"crack", "wood", .40, 200, 5e-5, 8, .12},       {"splash", "bubbles", 1.00, 800, 1e-3, 24, .50},
    {"thud", "rubber", .40, 500, 6e-3, 1, 0},
};

}  // namespace

std::span<const std::string_view> soundNames() {
    static constexpr std::string_view kNames[] = {"explosion", "shot",  "blast",  "launch",
                                                  "click",     "crack", "splash", "thud"};
    return kNames;
}

std::span<const std::string_view> loopNames() {
    static constexpr std::string_view kNames[] = {"fire",  "water", "wind",   "rain", "engine",
                                                  "motor", "jet",   "rocket", "alarm"};
    return kNames;
}

std::vector<Strike> soundStrikes(std::string_view name, glm::dvec3 position, double volume) {
    std::vector<Strike> strikes;
    const double energy = std::pow(std::clamp(volume, 0.0, 10.0), 1.0 / kLoudnessPower);
    for (const Layer& layer : kLayers) {
        if (layer.name != name || energy <= 0.0) continue;
        const std::array<double, 3> size = {layer.size, 0.8 * layer.size, 0.6 * layer.size};
        strikes.push_back({position, findAcousticMaterial(layer.material), size, layer.joules * energy, layer.contact,
                           layer.count, layer.spread});
    }
    return strikes;
}

}  // namespace sandbox::sound
