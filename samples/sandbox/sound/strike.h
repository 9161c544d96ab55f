#pragma once
#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace sandbox::sound {

/// Hits of one kind near each other: one, or what many come to.
struct Strike {
    glm::dvec3 position{0.0};
    size_t material = 0;                        ///< row of acousticMaterials()
    std::array<double, 3> size{0.5, 0.5, 0.5};  ///< metres of the body that sounds, the longest first
    double joules = 0.0;                        ///< of all hits together
    double contact = 0.001;                     ///< seconds that each takes
    double count = 1.0;                         ///< how many
    double spread = 0.0;                        ///< seconds over which they fall, most of them early
    double openness = 1.0;  ///< share of it that comes straight to the ear, not around or through walls
};

inline constexpr double kLoudnessPower = 0.35;  ///< of the energy

/// How loud so many joules are: a tenfold energy is 2.2 times as loud, where 3.2 is physical, so that a falling tower
/// and a falling cup are heard in one mix.
double loudness(double joules);

/// Joins strikes of a step that the ear cannot tell apart: of one material, of sizes within an octave, and so close to
/// each other that they come from one direction. Their energies add up. The loudest `limit` stay; what the others have
/// goes to those. The order of strikes does not matter but for rounding.
std::vector<Strike> joinStrikes(std::span<const Strike> strikes, glm::dvec3 ear, size_t limit);

}  // namespace sandbox::sound
