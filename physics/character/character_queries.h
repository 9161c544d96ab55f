#pragma once
#include "physics/character/character.h"
#include "runtime/voxel/grid_cast.h"

namespace rubble {

inline const glm::dvec3 kUp(0.0, 1.0, 0.0);  ///< of the world, against which characters stand

/// Where a character's capsule touches something.
struct CharacterHit {
    bool hit = false;
    double t = 1.0;                      ///< fraction of the displacement
    glm::dvec3 normal{0.0}, point{0.0};  ///< world
    CollisionObject* object = nullptr;
    bool isFlat = false;   ///< a face that it can stand on is touched
    bool isSlope = false;  ///< as isFlat, and `normal` is that face's
};

/// Sweeps and overlap tests of a character's capsule against the voxels around it. They use the character's size as it
/// is at the call; positions are those of its feet, world.
class CharacterQueries {
public:
    /// The character and its surroundings must outlive it.
    CharacterQueries(const Character& character, const CharacterSurroundings& around);

    /// The first contact of the capsule on a displacement.
    CharacterHit sweep(glm::dvec3 from, glm::dvec3 displacement) const;
    /// Whether a capsule of this height (metres) would overlap nothing.
    bool isFree(glm::dvec3 feet, double height) const;
    /// Whether the capsule would overlap nothing static.
    bool isFreeOfStatic(glm::dvec3 feet) const;
    /// The fraction of a displacement that a point can move, world, until it meets something; 1: all of it.
    double castPoint(glm::dvec3 from, glm::dvec3 displacement) const;
    /// The deepest overlap of a capsule that is wider by `extra` metres; of a static object if there is one. depth:
    /// metres.
    CharacterHit findDeepest(glm::dvec3 feet, double extra, double& depth) const;
    /// Sets whether dynamic bodies are ignored; at first they are not.
    void setIgnoresBodies(bool ignores) { m_ignoresBodies = ignores; }

private:
    template <class F>
    void forEachPart(F&& f) const;
    CellShape capsule(const CollisionObject& object, size_t part, glm::dvec3 feet, double height, double radius) const;
    void classifyFace(const ColliderPart& part, const CellTransform& cells, const CellContact& contact,
                      CharacterHit& out) const;

    const Character& m_c;
    const CharacterSurroundings& m_around;
    bool m_ignoresBodies = false;
    double m_minNormalY;  ///< of a face that it can stand on
};

}  // namespace rubble
