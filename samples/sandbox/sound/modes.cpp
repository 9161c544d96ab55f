#include "samples/sandbox/sound/modes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace sandbox::sound {
namespace {

using std::numbers::pi;

constexpr double kPoisson = 0.3;
constexpr double kLowest = 45.0, kHighest = 14000.0;  ///< Hz that a mode may have
constexpr double kDamping = 5.0;                      ///< 1/s: what lies about takes this from all modes
constexpr double kMaxDecay = 2300.0;                  ///< 1/s: so that nothing is denormal within a block
constexpr double kSpeedOfSound = 343.0;               ///< m/s, in air
constexpr double kRadius = 0.05;                      ///< metres: of the corners with which voxels touch

/// (beta L)^2 of the bending modes of a free bar: Fletcher & Rossing, The Physics of Musical Instruments, 2.15.
double barNumber(size_t n) {
    static constexpr double kFirst[] = {4.7300, 7.8532, 10.9956};
    const double root = n < 3 ? kFirst[n] : (2.0 * double(n) + 3.0) * pi / 2.0;
    return root * root;
}

/// Frequencies of a bar: f = (beta L)^2 h / (2 pi sqrt(12) L^2) sqrt(E / rho), bending over either of its thin sides.
void addBar(std::vector<double>& out, double speed, const std::array<double, 3>& size) {
    for (const double side : {size[2], size[1]})
        for (size_t n = 0; n < kModes / 2; ++n)
            out.push_back(barNumber(n) * side * speed / (2.0 * pi * std::sqrt(12.0) * size[0] * size[0]));
}

/// Frequencies of a plate: f = lambda / (2 pi a b) sqrt(E h^2 / (12 rho (1 - nu^2))). The first ten lambdas are those
/// of a free square (Leissa, Vibration of Plates, NASA SP-160, and The Free Vibration of Rectangular Plates, 1973), the
/// others sums of the numbers of two bars.
void addPlate(std::vector<double>& out, double speed, const std::array<double, 3>& size) {
    static constexpr double kFree[] = {13.47, 19.60, 24.27, 34.80, 35.50, 61.09, 62.30, 63.69, 69.27, 77.17};
    std::vector<double> numbers(std::begin(kFree), std::end(kFree));
    for (size_t i = 2; i < 9; ++i)
        for (const double other : {0.0, barNumber(1 + i % 2)}) numbers.push_back(barNumber(i) + other);
    std::sort(numbers.begin(), numbers.end());
    const double stiffness = size[2] * speed / std::sqrt(12.0 * (1.0 - kPoisson * kPoisson));
    for (const double number : numbers) out.push_back(number / (2.0 * pi * size[0] * size[1]) * stiffness);
}

/// Frequencies of a block: f = c / 2 sqrt((l/a)^2 + (m/b)^2 + (n/c)^2) with the speed c of shear waves and at least two
/// numbers above 0. For a cube the first is that of Lame, c / (sqrt(2) a), which is exact.
void addBlock(std::vector<double>& out, double speed, const std::array<double, 3>& size) {
    const double shear = speed / std::sqrt(2.0 * (1.0 + kPoisson));
    for (int l = 0; l < 5; ++l)
        for (int m = 0; m < 5; ++m)
            for (int n = 0; n < 5; ++n)
                if ((l > 0) + (m > 0) + (n > 0) >= 2) {
                    const double x = l / size[0], y = m / size[1], z = n / size[2];
                    out.push_back(shear / 2.0 * std::sqrt(x * x + y * y + z * z));
                }
}

/// Bubbles under water of 12 to 1 mm: Minnaert's frequency 3.26 m/s / r, and the damping that van den Doel gives,
/// Physically Based Models for Liquid Sounds, 2005.
Modes bubbleModes() {
    Modes modes;
    for (size_t i = 0; i < kModes; ++i) {
        const double radius = 0.012 * std::pow(1.0 / 12.0, double(i) / double(kModes - 1));
        modes[i] = {3.26 / radius, 0.13 / radius + 0.0072 * std::pow(radius, -1.5), 1.0 / double(kModes) * 2.5};
    }
    return modes;
}

/// The rumble of an explosion: no body vibrates, but air between all that stands around.
Modes blastModes() {
    Modes modes;
    for (size_t i = 0; i < kModes; ++i)
        modes[i] = {26.0 * std::pow(1.12, double(i)), 5.0 + 0.9 * double(i), 1.6 / double(kModes)};
    return modes;
}

/// How well a body radiates: what is small beside the wavelength hardly does, because front and back cancel.
double radiation(double frequency, double size) {
    const double ka = 2.0 * pi * frequency / kSpeedOfSound * size / 2.0;
    return ka * ka / (1.0 + ka * ka);
}

}  // namespace

std::array<double, 3> bodySize(const AcousticMaterial& material, std::array<double, 3> sides, double voxel) {
    std::sort(sides.begin(), sides.end(), std::greater<>());
    if (material.sheet > 0.0 && sides[2] < 1.5 * voxel) sides[2] = std::min(sides[2], material.sheet);
    return sides;
}

BodyForm formOf(const std::array<double, 3>& size) {
    if (size[1] < 0.4 * size[0]) return BodyForm::Bar;
    return size[2] < 0.3 * size[1] ? BodyForm::Plate : BodyForm::Block;
}

Modes modesOf(const AcousticMaterial& material, const std::array<double, 3>& size) {
    if (material.vibration == Vibration::Bubbles) return bubbleModes();
    if (material.vibration == Vibration::Blast) return blastModes();
    const double speed = std::sqrt(material.stiffness / material.density);
    std::vector<double> frequencies;
    const BodyForm form = formOf(size);
    (form == BodyForm::Bar ? addBar : form == BodyForm::Plate ? addPlate : addBlock)(frequencies, speed, size);
    std::sort(frequencies.begin(), frequencies.end());
    const double factor = std::max(1.0, kLowest / frequencies[0]);
    Modes modes;
    double sum = 0.0;
    for (size_t i = 0; i < kModes; ++i) {
        const double frequency = frequencies[i] * factor;
        const double weight = 1.0 / std::sqrt(1.0 + double(i));
        sum += weight;
        const bool isHeard = frequency < kHighest;
        modes[i].frequency = std::min(frequency, kHighest);
        modes[i].decay = std::min(pi * frequency * material.loss + kDamping, kMaxDecay);
        modes[i].gain = isHeard ? weight * radiation(frequency, size[0]) : 0.0;
    }
    for (Mode& mode : modes) mode.gain /= sum;
    return modes;
}

/// t = 2.87 (m^2 / (R E*^2 v))^(1/5): Johnson, Contact Mechanics, 11.4.
double contactTime(const AcousticMaterial& a, const AcousticMaterial& b, double mass, double speed) {
    const double compliance = (1.0 - kPoisson * kPoisson) * (1.0 / a.stiffness + 1.0 / b.stiffness);
    const double quotient = mass * mass * compliance * compliance / (kRadius * std::max(speed, 0.01));
    return std::clamp(2.87 * std::pow(quotient, 0.2), 2e-5, 0.02);
}

}  // namespace sandbox::sound
