// Constants of the shaders alone; those that C++ knows too are in shared/constants.h.
#include "shared/constants.h"

const float kTwoPi = 6.2831853;
const float kPi = 0.5 * kTwoPi;
const float kInversePi = 0.3183;  // to four digits, for painted colours

const float kShadowCellsPerMetre = 10.0;  // 1 / kShadowCell
const float kFineVoxels = 1.0 / 16384.0;  // lib/gbuffer.glsl: the least normal number of 16 bits

/// The step of the R2 sequence: 1 / p and 1 / p^2 of the plastic number p (Martin Roberts 2018, "The unreasonable
/// effectiveness of quasirandom sequences").
const vec2 kR2Step = vec2(0.7548776662, 0.5698402910);
/// The steps of the R5 sequence: powers of 1 / g, where g^6 = g + 1.
const vec4 kR5Steps = vec4(0.8812714616, 0.7766393890, 0.6844301295, 0.6031687406);
const float kR5LastStep = 0.5315553977;
