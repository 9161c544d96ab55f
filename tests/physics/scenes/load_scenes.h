#pragma once
#include <string>

#include "tests/physics/physics_scene.h"

/// Scenes of floating, of ropes and of who walks on planks, with known answers.
namespace rubble::known {

/// A pool whose surface is at y = 0, in which nothing sleeps. Entry 1 of the palette has the given density.
struct Pool : PhysicsScene {
    /// density: kg/m3. drag: 1/s. halfSide, depth: metres.
    Pool(const PhysicsSettings& settings, uint32_t density, double drag, double halfSide = 50.0, double depth = 40.0);
    /// Of the volume of a body whose grid is solid, the share that is in the water.
    double submerged(int index) const;
};
/// The share of a body of `size` voxels that is in the water of 0.3 m in which it has floated for 20 s.
double floatInShallowWater(const PhysicsSettings& settings, glm::ivec3 size, uint32_t density);

/// An entry of a palette whose voxels make a body of this many voxels as heavy as `mass`, kg.
uint8_t entryOfMass(PhysicsScene& scene, double mass, int voxels, uint8_t entry = 8);
/// Adds a joint between bodies by name; "" is the world. in, at: where it holds them, each in its frame.
LevelJoint& addJoint(PhysicsScene& scene, JointKind kind, std::string first, std::string second, glm::dvec3 in,
                     glm::dvec3 at);

struct Winding {
    double gained = 0.0;  ///< joules by which it was ever above the start
    double lost = 0.0;    ///< joules, on the way
    double energy = 0.0;  ///< joules at the end
};
/// A cube (body 1) on a rope of 6 m that flies round a pole (body 0) of `diameter` voxels, on which the rope winds.
void addWinding(PhysicsScene& scene, int diameter, double mass, double speed);
/// addWinding() for `steps` steps. gravity: m/s2, downward.
Winding windRope(const PhysicsSettings& settings, double gravity, int diameter, double mass, double speed, int steps);

/// A plank of 5 m whose middle lies 1 m from the edge of a block (at x = 0, its top at y = 0), and a character of 80 kg
/// that stands on it, at x = -0.5.
struct PlankWalk : PhysicsScene {
    /// mass: of the plank, kg.
    PlankWalk(const PhysicsSettings& settings, double mass);
    /// The character.
    const Character& me() const { return world.characters().at(world.characters().handleAt(0)); }
    /// Its handle.
    CharacterHandle who() const { return world.characters().handleAt(0); }
    /// Walks at 1 m/s until its feet are at x, stands there, and says how far the plank's outer end has sunk, metres.
    double walkTo(double x, double seconds = 3.0);
    /// Height of the outer end, metres.
    double tip() const { return body(2).pose.transformPoint({5.0, 0.0, 0.25}).y; }
    /// Whether the plank sleeps.
    bool asleep() const { return body(2).asleep; }
};

}  // namespace rubble::known
