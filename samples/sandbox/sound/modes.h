#pragma once
#include <array>
#include <cstddef>

#include "samples/sandbox/sound/acoustic_material.h"

namespace sandbox::sound {

inline constexpr size_t kModes = 24;  ///< of a body that is struck: the lowest ones

/// One way in which a body vibrates: a sine that decays.
struct Mode {
    double frequency = 0.0;  ///< Hz
    double decay = 0.0;      ///< 1/s, of the amplitude
    double gain = 0.0;       ///< of a unit strike; those of a body come to at most 1
};
using Modes = std::array<Mode, kModes>;

enum class BodyForm { Bar, Plate, Block };

/// The three sides of a box, the longest first, in metres: what is one voxel thick gets the thickness of its material's
/// sheets.
std::array<double, 3> bodySize(const AcousticMaterial& material, std::array<double, 3> sides, double voxel);

/// Which theory holds for sides in that order.
BodyForm formOf(const std::array<double, 3>& size);

/// The modes of a free body of a material, the lowest first. One whose lowest mode could not be heard vibrates in
/// parts: all its frequencies are higher by the same factor.
Modes modesOf(const AcousticMaterial& material, const std::array<double, 3>& size);

/// Seconds that a mass touches a body, by Hertz, at a speed in m/s.
double contactTime(const AcousticMaterial& a, const AcousticMaterial& b, double mass, double speed);

}  // namespace sandbox::sound
