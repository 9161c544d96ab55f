#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace sandbox::sound {

/// How what is struck vibrates.
enum class Vibration { Solid, Bubbles, Blast };

/// What a material sounds like: the constants of its elasticity, and what they leave out.
struct AcousticMaterial {
    std::string_view name;  ///< as in the world's table of materials; others are sounds of their own
    double stiffness;       ///< Young's modulus, Pa
    double density;         ///< kg/m3
    double loss;            ///< loss factor: share of the energy of a vibration that a radian takes
    double sheet;  ///< metres: thickness of what is one voxel thick in the level, as a pane or a car's door; 0: a voxel
    double noise;  ///< share of a hit that is not vibration but grains which part: 0 rings, 1 rustles
    double noiseCenter;  ///< Hz
    double noiseDecay;   ///< s until it has fallen to 1/e
    double level;        ///< how loud a joule is
    Vibration vibration = Vibration::Solid;
};

/// All rows. Row 0 is what unknown materials are.
std::span<const AcousticMaterial> acousticMaterials();
/// The row of a name; 0: there is none.
size_t findAcousticMaterial(std::string_view name);

}  // namespace sandbox::sound
