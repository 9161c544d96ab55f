#pragma once
#include <optional>
#include <vector>

#include "samples/netplay/poses.h"

namespace netplay {

/// The last known poses of one body, and where it was between them. Times are in steps of the server's world.
class PoseTrack {
public:
    /// Adds the pose after a step; those of steps that are known, or long past, are left out.
    void add(uint64_t step, const BodyPose& pose);
    /// The pose at a time; none before the first known one. Between two known ones it is interpolated. A body that
    /// slept in the earlier one begins to move shortly before the later one. Behind the last it goes on as it moved,
    /// for a tenth of a second.
    std::optional<BodyPose> at(double time) const;
    /// Whether the body sleeps at a time, and nothing else is known of later.
    bool isAtRest(double time) const;
    /// The step of the first known pose; 0: none is known.
    uint64_t firstStep() const { return m_samples.empty() ? 0 : m_samples.front().step; }
    /// Forgets what at() does not need from a time on.
    void forgetBefore(double time);

private:
    struct Sample {
        uint64_t step = 0;
        BodyPose pose;
    };
    std::vector<Sample> m_samples;  ///< by step; few
};

}  // namespace netplay
