#pragma once
#include <span>
#include <utility>
#include <vector>

#include "physics/character/character.h"
#include "physics/stages/physics_bodies.h"

namespace rubble {

/// The characters of a World as physics moves them, after the bodies. [main-thread]
class PhysicsCharacters {
public:
    /// Replaces all characters by those of World, and wakes what one no longer stands on.
    void load(const World& world, PhysicsBodies& bodies);
    /// Begins a step: clears what the last one reported.
    void begin() { m_moves.clear(); }
    /// Moves all characters, in the order of slots, and applies their pushes to the bodies. waters: null: none.
    /// gravity: m/s2. Returns the joules that they gave the bodies.
    double move(PhysicsBodies& bodies, const WaterVolumes* waters, glm::dvec3 gravity, double seconds);
    /// The characters that moved or changed in this step, in the order of slots.
    std::span<const CharacterMove> moves() const { return m_moves; }

private:
    /// Sorts the characters along x.
    void sortByPlace();
    /// The characters that are at most `radius` metres from one along x, by slot.
    std::vector<const Character*> near(size_t index, double radius) const;

    std::vector<std::pair<CharacterHandle, Character>> m_characters;  ///< by slot
    std::vector<std::pair<double, size_t>> m_places;                  ///< x when the step began, and index; sorted
    double m_maxRadius = 0.0;                                         ///< of a character, metres
    std::vector<CharacterPush> m_pushes;
    std::vector<CharacterMove> m_moves;
};

}  // namespace rubble
