#pragma once
#include <span>
#include <vector>

#include "runtime/world/world.h"

namespace rubble {

/// A step of a character on the ground, or its landing.
struct Footstep {
    CharacterHandle character;
    bool landed = false;
    ShapeHandle shape;         ///< that it steps on; empty: the ground around the level, or nothing that was found
    uint8_t material = 0;      ///< of the voxel under it; 0: as above
    glm::dvec3 position{0.0};  ///< of the feet, world
    double speed = 0.0;        ///< m/s along the ground; of a landing, downward
};

/// A character whose feet got into water.
struct CharacterInWater {
    CharacterHandle character;
    WaterHandle water;
    glm::dvec3 position{0.0};  ///< world, at the surface
    double speed = 0.0;        ///< m/s, relative to the flow
};

/// Watches characters: where they set their feet, and when they get into water. What it sees of one for the first time
/// is no news. Costs what the characters that move cost. [main-thread]
class CharacterReports {
public:
    /// The characters that moved in a step; the World is as the step left it. stride: metres walked from one footstep
    /// to the next. Replaces the lists of the step before.
    void step(std::span<const CharacterMove> moves, const World& world, double stride);
    /// Forgets all characters.
    void forget() { *this = {}; }

    /// Of the last step, by character, in slot order.
    std::span<const Footstep> footsteps() const { return m_footsteps; }
    /// The same.
    std::span<const CharacterInWater> inWater() const { return m_inWater; }

private:
    struct Seen {
        CharacterHandle character;
        bool grounded = false, inWater = false;
        double fallSpeed = 0.0;  ///< m/s, before this step
        double walked = 0.0;     ///< metres since the last footstep
    };
    void walk(const CharacterMove& move, Seen& seen, const World& world, double stride);

    std::vector<Seen> m_seen;  ///< by character slot
    std::vector<Footstep> m_footsteps;
    std::vector<CharacterInWater> m_inWater;
};

}  // namespace rubble
