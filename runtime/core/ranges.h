#pragma once
#include "runtime/core/number_range.h"

/// The one table of the numbers that a world may hold. Levels, saves, recordings, edits and the C interface all check
/// against it, so what one of them accepts the others do. Both ends are allowed. Not a number is in no range.
namespace rubble::ranges {

// Places and motion
inline constexpr NumberRange kCoordinate{-1e9, 1e9};          ///< m
inline constexpr NumberRange kPlace{-2e9, 2e9};               ///< m, of bodies and shapes: physics may move them on
inline constexpr NumberRange kDistance{0.0, 1e6};             ///< m, of rays, casts and searches
inline constexpr NumberRange kQuerySize{0.0, 1e4};            ///< m: radii of rays, casts and overlaps
inline constexpr NumberRange kVelocity{-1e9, 1e9};            ///< m/s and rad/s, of bodies: physics clamps far below
inline constexpr NumberRange kImpulse{-1e16, 1e16};           ///< N s: the largest mass at twice the highest speed
inline constexpr NumberRange kRotationLength2{0.998, 1.002};  ///< of a rotation, its squared length
inline constexpr NumberRange kGravityScale{-100.0, 100.0};    ///< of a body, multiple of the world's gravity
inline constexpr NumberRange kDamping{0.0, 1e3};              ///< 1/s, of a body's velocities
inline constexpr double kMaxCharacterSpeed = 1e3;             ///< m/s, the length of a wish or a velocity

// Names
inline constexpr NumberRange kNameBytes{0, 4'096};  ///< of names, of tags, of their values and of paths of scripts
inline constexpr NumberRange kScripts{0, 10'000};   ///< of a level, by an edit
inline constexpr NumberRange kParameterBytes{0, 65'536};  ///< of a script of a level

// Shapes and materials
inline constexpr NumberRange kVoxelSize{1e-3, 1e3};         ///< m
inline constexpr NumberRange kSolidCells{1, 1 << 30};       ///< of a box or sphere that is made
inline constexpr NumberRange kStrength{1e-6, 1e6};          ///< of a shape, multiple of its materials'
inline constexpr NumberRange kDensityFactor{1e-3, 1e3};     ///< of a shape, multiple of its materials' density
inline constexpr NumberRange kEmissionFactor{0.0, 1e3};     ///< of a shape, multiple of its palette's emission
inline constexpr NumberRange kAnchors{0, 10'000};           ///< of a shape, by an edit
inline constexpr NumberRange kEmission{0.0, 1e6};           ///< of a palette entry
inline constexpr NumberRange kMaterials{1, 256};            ///< in a level
inline constexpr NumberRange kDensity{0, 30'000};           ///< kg/m3: moments of the largest grid fit into 64 bits
inline constexpr NumberRange kMaterialStrength{0.0, 1e15};  ///< Pa
inline constexpr NumberRange kFriction{0.0, 100.0};         ///< Coulomb coefficient
inline constexpr NumberRange kRestitution{0.0, 1.0};        ///< more would add energy
inline constexpr NumberRange kHeatCapacity{0.0, 1e6};       ///< J/(kg K)
inline constexpr NumberRange kTemperature{0.0, 1e5};        ///< K
inline constexpr NumberRange kBurnTime{0.0, 1e6};           ///< s

// Lights and environment
inline constexpr NumberRange kColor{0.0, 1e6};         ///< linear, each channel
inline constexpr NumberRange kLightSize{0.0, 1e3};     ///< m: radius, width and height
inline constexpr NumberRange kLightReach{0.0, 1e5};    ///< m
inline constexpr NumberRange kConeAngle{0.0, 3.15};    ///< rad
inline constexpr NumberRange kThreshold{0.0, 1.0};     ///< of a light group
inline constexpr NumberRange kSunAngle{0.0, 1.5};      ///< rad
inline constexpr NumberRange kDirection{-1e6, 1e6};    ///< each component of a direction of any length
inline constexpr NumberRange kFogDistance{1e-3, 1e9};  ///< m
inline constexpr NumberRange kFogDensity{0.0, 1e6};    ///< 1/m
inline constexpr NumberRange kFogBase{-1e6, 1e6};      ///< m
inline constexpr NumberRange kFogHeight{1e-3, 1e6};    ///< m
inline constexpr NumberRange kFogForward{-0.9, 0.9};   ///< mean cosine
inline constexpr NumberRange kShare{0.0, 1.0};         ///< clouds, wetness, colour of water
inline constexpr NumberRange kBrightness{0.0, 1e6};    ///< stars, exposure
inline constexpr NumberRange kGravity{-1e3, 1e3};      ///< m/s2, each component

// Water and triggers
inline constexpr NumberRange kOutlinePoints{3, 10'000};
inline constexpr NumberRange kWaterSurface{-1e6, 1e6};   ///< m
inline constexpr NumberRange kWaterDepth{1e-3, 1e5};     ///< m
inline constexpr NumberRange kWaterDensity{0.0, 1e5};    ///< kg/m3
inline constexpr NumberRange kWaterDrag{0.0, 1e5};       ///< 1/s
inline constexpr NumberRange kWaterFlow{-100.0, 100.0};  ///< m/s, each component
inline constexpr NumberRange kClarity{1e-6, 1e6};        ///< m
inline constexpr NumberRange kWaves{0.0, 1e6};           ///< m: height and length of waves
inline constexpr NumberRange kWaveMotion{-1e6, 1e6};     ///< m/s and rad
inline constexpr NumberRange kTriggerSize{1e-3, 1e5};    ///< m: radius, half sides, height

// Characters
inline constexpr NumberRange kCharacterRadius{0.02, 10.0};  ///< m
inline constexpr double kMaxCharacterHeight = 100.0;        ///< m; at least two radii
inline constexpr NumberRange kSlope{0.0, 1e3};              ///< rise over run
inline constexpr NumberRange kCharacterMass{1e-3, 1e6};     ///< kg
inline constexpr NumberRange kCharacterSpeed{0.0, 100.0};   ///< m/s: walking, crouching, jumping, swimming
inline constexpr NumberRange kForce{0.0, 1e9};              ///< N, of a character's push and of a grab

// Joints
inline constexpr NumberRange kJointNumber{0.0, 1e12};       ///< forces, torques, lengths, frequencies
inline constexpr NumberRange kJointTarget{-1e12, 1e12};     ///< limits and a motor's target
inline constexpr NumberRange kHingeAngle{-3.1416, 3.1416};  ///< rad: limits of a hinge, and what its motor goes to
inline constexpr NumberRange kConeLimit{0.0, 3.1416};       ///< rad
inline constexpr NumberRange kAnchorRadius{0.0, 100.0};     ///< m within which the voxel is that holds an end
inline constexpr NumberRange kRopePoints{2, 256};
inline constexpr NumberRange kRopeRadius{1e-3, 10.0};      ///< m
inline constexpr NumberRange kRopeMass{1e-4, 1e6};         ///< kg/m
inline constexpr NumberRange kWheelSpin{0.0, 1e4};         ///< rad/s
inline constexpr NumberRange kSteerAngle{0.0, 1.5};        ///< rad to each side, of a wheel's settings
inline constexpr NumberRange kSteer{-3.0, 3.0};            ///< rad, of a wheel
inline constexpr NumberRange kSteerRate{0.0, 100.0};       ///< rad/s
inline constexpr NumberRange kGrabHertz{0.1, 60.0};        ///< of the spring that pulls
inline constexpr NumberRange kConstraintForce{-1e9, 1e9};  ///< N and N m, of a constraint of bodies
inline constexpr NumberRange kHand{0, 4'294'967'294.0};    ///< a joint stores it plus one
inline constexpr NumberRange kPedal{0.0, 1.0};             ///< brake
inline constexpr NumberRange kLever{-1.0, 1.0};            ///< throttle and steering of a vehicle

// Edits
inline constexpr NumberRange kBrushRadius{0.0, 100.0};   ///< m; of a host above 0.001, or 0 for none
inline constexpr NumberRange kExplosionSize{0.5, 4.0};   ///< m
inline constexpr NumberRange kBlast{0.0, 1e9};           ///< N s, of an explosion; 0: by its size
inline constexpr NumberRange kPaintRadius{0.0, 10.0};    ///< m
inline constexpr NumberRange kHeatRadius{0.0, 1e3};      ///< m
inline constexpr NumberRange kHeat{0.0, 1e15};           ///< J
inline constexpr NumberRange kWetSeconds{0.0, 6'000.0};  ///< s

// Settings of a world
inline constexpr NumberRange kImpactThreshold{0.0, 1e12};  ///< N s
inline constexpr NumberRange kImpactSpeed{0.0, 1e6};       ///< m/s
inline constexpr NumberRange kImpactRadius{0.0, 4.0};      ///< m
inline constexpr NumberRange kImpactsPerStep{1, 1'000};
inline constexpr NumberRange kFragments{1, 100'000};  ///< of one break
inline constexpr NumberRange kStrengthScale{1e-6, 1e6};
inline constexpr NumberRange kStressWork{1, 1e12};      ///< units of about 20 ns a step
inline constexpr NumberRange kContactTime{1e-4, 10.0};  ///< s
inline constexpr NumberRange kFireSpread{0.0, 100.0};
inline constexpr NumberRange kFireBurnTime{1e-3, 1e3};  ///< multiple of Material::burnTime

}  // namespace rubble::ranges
