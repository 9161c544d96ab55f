#pragma once
#include <span>
#include <vector>

#include "runtime/frame/frame_snapshot.h"
#include "runtime/world/world.h"

namespace rubble {

/// Rings on water around what moves through its surface: bodies and characters. There are at most kMaxRipples; a new
/// one replaces the oldest. They are only drawn: the World knows nothing of them. Owned by Snapshots. [main-thread]
class Ripples {
public:
    static constexpr size_t kMaxRipples = 64;  ///< as kMaxRipples of shaders/shared/constants.h
    static constexpr float kLife = 3.0f;       ///< seconds

    /// Ages what is there by 1/60 s and adds what the bodies that moved in this step make. Looks at them only where
    /// there is water.
    void step(std::span<const BodyPose> moved, const World& world);
    /// Removes all, as a new level does.
    void clear() { m_alive.clear(); }
    bool empty() const { return m_alive.empty(); }  ///< no water is disturbed
    std::vector<SnapshotRipple> snapshot() const;   ///< as they are to be drawn

private:
    struct Ripple {
        SnapshotRipple drawn;
        uint64_t source;  ///< bits of the handle of what made it
    };
    void disturb(const Water& water, const WorldBox& box, glm::dvec3 velocity, uint64_t source);

    std::vector<Ripple> m_alive;  ///< oldest first
};

}  // namespace rubble
