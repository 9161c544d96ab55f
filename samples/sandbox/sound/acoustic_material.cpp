#include "samples/sandbox/sound/acoustic_material.h"

namespace sandbox::sound {
namespace {

using enum Vibration;

// Young's moduli, densities: Ashby & Jones, Engineering Materials 1; soils: Das, Principles of Geotechnical
// Engineering. Loss factors: Cremer, Heckl & Petersson, Structure-Borne Sound, table 4.2, times two or three, because
// things lie on others that damp them. The columns of noise and level are by ear and by spectrogram.
constexpr AcousticMaterial kRows[] = {
    // name         Pa       kg/m3 loss   sheet  noise Hz    s     level
    {"generic", 5e9, 1000, .03, 0, .30, 1200, .030, 1.0},
    {"glass", 70e9, 2500, .004, .006, .12, 6000, .012, 1.3},
    {"foliage", 0.2e9, 300, .30, 0, .90, 3500, .060, .5},
    {"dirt", 0.05e9, 1500, .25, 0, .75, 500, .045, .8},
    {"rock", 50e9, 2700, .010, 0, .25, 1800, .020, 1.1},
    {"wood", 11e9, 500, .025, .025, .20, 1500, .018, 1.1},
    {"concrete", 30e9, 2400, .015, 0, .35, 1200, .030, 1.1},
    {"brick", 15e9, 1900, .018, 0, .35, 1600, .025, 1.1},
    {"plaster", 3e9, 900, .040, .0125, .50, 1500, .035, .8},
    {"metal", 210e9, 7850, .003, .008, .06, 4000, .010, 1.2},
    {"heavy metal", 210e9, 7850, .002, .040, .06, 2500, .012, 1.2},
    {"plastic", 2.5e9, 1050, .060, .010, .20, 2200, .012, .9},
    {"hard metal", 210e9, 7850, .0025, .020, .06, 3000, .010, 1.2},
    {"hard masonry", 40e9, 2500, .012, 0, .30, 1500, .025, 1.1},
    {"ice", 9e9, 917, .015, 0, .25, 3500, .020, 1.0},
    {"snow", 0.01e9, 200, .40, 0, .95, 900, .060, .4},
    {"wire", 110e9, 8900, .004, .008, .10, 5000, .010, .7},
    {"rubber", 0.05e9, 1100, .15, 0, .15, 300, .015, .8},
    // Sounds of their own.
    {"bubbles", 1, 1000, .02, 0, .35, 900, .110, .8, Bubbles},
    {"blast", 1, 1, .1, 0, .75, 220, .55, 1.6, Blast},
    {"burst", 1, 1, .1, 0, .95, 1600, .09, 1.3, Blast},
    {"shot", 1, 1, .1, 0, .90, 2200, .035, 1.0, Blast},
};

}  // namespace

std::span<const AcousticMaterial> acousticMaterials() {
    return kRows;
}

size_t findAcousticMaterial(std::string_view name) {
    for (size_t i = 1; i < std::size(kRows); ++i)
        if (kRows[i].name == name) return i;
    return 0;
}

}  // namespace sandbox::sound
