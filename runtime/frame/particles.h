#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "runtime/core/random.h"
#include "runtime/frame/frame_snapshot.h"
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/impacts/impact.h"
#include "runtime/world/state/fires.h"
#include "runtime/world/world.h"

namespace rubble {

/// Colour of the light of flames, linear.
inline constexpr glm::vec3 kFireColor{1.0f, 0.42f, 0.12f};

struct ParticleSettings {
    uint32_t maxAlive = 4096;            ///< particles at once; 0: none, at no cost
    uint32_t maxLights = 4;              ///< that sparks and the flames of explosions together make
    glm::vec3 wind{0.9f, 0.0f, -0.25f};  ///< m/s, carries dust and smoke
};

/// Particles of one kind that a host adds.
struct ParticleBurst {
    ParticleKind kind = ParticleKind::Dust;
    uint32_t count = 1;
    glm::dvec3 position{0.0};  ///< world
    double radius = 0.0;       ///< metres around it within which they begin
    glm::vec3 velocity{0.0f};  ///< m/s
    float spread = 0.0f;       ///< m/s that each has more, in any direction
    glm::vec3 color{1.0f};     ///< linear
    float size = 0.1f;         ///< metres: their radius at birth
    float growth = 0.0f;       ///< metres a second
    float opacity = 1.0f;      ///< at its thickest
    float life = 2.0f;         ///< seconds
    float glow = 0.0f;         ///< radiant intensity at birth
    float gravity = 0.0f;      ///< m/s2 downward, beside what their kind has
    float drag = 0.0f;         ///< 1/s, beside that of their kind
    float spin = 0.0f;         ///< rad/s of their image
    float stretch = 0.0f;      ///< seconds of their motion by which their image is longer along it
    bool passes = false;       ///< they fall through the ground
};

/// What breaking and burning throw into the air: dust, crumbs, sparks, glints of glass, flames, embers, smoke. Made
/// from the journal of each step and moved by rules of thumb. They are only drawn: the World and its hash know nothing
/// of them. Owned by Snapshots. [main-thread]
class Particles {
public:
    /// Nothing is in the air yet.
    explicit Particles(const ParticleSettings& settings) : m_settings(settings) {}

    /// Moves what is there by 1/60 s and adds what the step has thrown up; a still step does neither. Costs nothing
    /// while nothing is in the air.
    void step(const FrameChanges& changes, std::span<const Impact> impacts, std::span<const Fire> fires,
              const World& world);
    /// Adds what a host throws up, as far as there is room for it. It moves from the next step on.
    void spawn(const ParticleBurst& burst, const World& world);
    /// Removes all, as a new level does.
    void clear() { m_alive.clear(); }
    /// As they are to be drawn.
    std::vector<SnapshotParticle> snapshot() const;
    /// The light of what glows, in a few merged lights, the brightest first. Not that of fires, which have their own.
    std::vector<SnapshotLight> lights() const;
    bool empty() const { return m_alive.empty(); }  ///< nothing is in the air

private:
    struct Particle {
        ParticleKind kind;
        glm::dvec3 position;
        glm::vec3 velocity;
        glm::vec3 color;    ///< linear
        float radius;       ///< metres, at birth
        float growth;       ///< metres a second
        float opacity;      ///< at its thickest
        float age = 0.0f;   ///< seconds
        float life;         ///< seconds
        float glow = 0.0f;  ///< radiant intensity at birth; it fades with age
        double floor;       ///< height of the ground below it
        uint32_t seed;
        float gravity = 0.0f, drag = 0.0f;  ///< beside what the kind has: see ParticleBurst
        float spin = 0.0f, stretch = 0.0f;  ///< the same
    };
    void move(Particle& particle) const;

    // particle_emitters.cpp
    void addDust(const DustCloud& cloud, const World& world);
    void addBlast(const Blast& blast, const World& world);
    void addImpact(const Impact& impact, const World& world);
    void addFires(std::span<const Fire> fires);
    void add(const Particle& particle);
    double floorBelow(glm::dvec3 position, const World& world);
    glm::vec3 anyDirection();
    float between(float low, float high) { return low + (high - low) * m_random.unit(); }
    /// How many of `wanted` particles an emitter may add: fewer as the budget fills, so that late events still show.
    /// `ofBudget`: share of the budget that this kind may fill. Fractions are rounded up at random, so that many small
    /// events together throw up what one large one does.
    int share(double wanted, double ofBudget = 1.0);

    ParticleSettings m_settings;
    std::vector<Particle> m_alive;  ///< oldest first
    Random m_random{1, 41};
    glm::dvec3 m_floorQuery{1e30};  ///< where floorBelow() last looked
    double m_floorFound = 0.0;
    uint32_t m_nextFire = 0;
};

}  // namespace rubble
