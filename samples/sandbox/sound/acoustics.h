#pragma once
#include <rubble/rubble.h>

#include <array>
#include <span>
#include <vector>

#include "samples/sandbox/sound/output.h"

namespace sandbox::sound {

/// What the world does to sound, by rays: walls between, and the room around the ear.
class Acoustics {
public:
    /// The world must outlive it.
    Acoustics(const rubble_api& api, rubble_world world) : m_api(api), m_world(world) { m_distances.fill(1e9); }
    /// Looks around from the ear in a few of its directions; after twelve steps it knows the room.
    void listen(glm::dvec3 ear);
    /// What stands around, as far as it has looked.
    const Room& room() const { return m_room; }
    /// What share of sound from each place comes straight to the ear.
    void findOpenness(std::span<const glm::dvec3> places, std::vector<double>& openness);

private:
    const rubble_api& m_api;
    rubble_world m_world;
    glm::dvec3 m_ear{0.0};
    Room m_room;
    size_t m_next = 0;  ///< direction
    static constexpr size_t kDirections = 48;
    std::array<double, kDirections> m_distances{};  ///< along each; beyond kFar: open
    std::vector<rubble_ray> m_rays;
    std::vector<rubble_hit> m_hits;
};

}  // namespace sandbox::sound
