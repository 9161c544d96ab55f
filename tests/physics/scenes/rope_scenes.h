#pragma once
#include "tests/physics/physics_scene.h"

/// Scenes of ropes that are pulled over something, with known answers.
namespace rubble::known {

/// A rope from the world over a static beam along z (body 0, its middle at the origin) to a load (body 1) that falls
/// until the rope is taut.
struct BeamDrop {
    int thickness = 2;    ///< of the beam, voxels
    double mass = 100.0;  ///< kg
    double drop = 1.0;    ///< metres before the rope is taut
    double anchor = 1.5;  ///< metres from the beam's surface to the rope's fixed end, at the beam's height
    int seams = 0;        ///< 1: the beam is two shapes that meet at z = 0, under the rope
    double spin = 0.0;    ///< rad/s about z, by which a motor turns the beam
    double seconds = 10.0;
};

struct BeamRope {
    double inside = 0.0;  ///< metres by which a place of the rope was ever deeper in the beam than its surface
    double below = 0.0;   ///< metres by which the load hangs lower at the end than theory
    bool isOver = true;   ///< whether the rope crosses x = 0 above the beam only, at the end
    double gained = 0.0;  ///< joules from nothing
    double lost = 0.0;    ///< joules
};
/// Drops the load, and compares with a rope without friction round the square of the beam.
BeamRope dropOverBeam(const PhysicsSettings& settings, const BeamDrop& drop);

}  // namespace rubble::known
