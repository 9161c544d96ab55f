#pragma once
#include <rubble/rubble.h>

#include <string>
#include <vector>

namespace sandbox {

/// What the steps and frames of a film have cost, as a table for people.
class FilmFigures {
public:
    /// What follows belongs to this shot.
    void beginShot(const std::string& name) { m_shots.push_back(name); }
    /// A step of the world, and how often it has allocated.
    void addStep(const rubble_step_stats& stats, uint64_t allocations);
    /// A frame that is kept; milliseconds of its drawing.
    void addFrame(double milliseconds) { m_frames.push_back(milliseconds); }
    /// Times by stage with bars, allocations, the age of the shadow volume, and the longest steps.
    std::string table() const;

private:
    struct Step {
        size_t shot;
        rubble_step_stats stats;
        uint64_t allocations;
    };
    std::string worstSteps() const;

    std::vector<std::string> m_shots;
    std::vector<Step> m_steps;
    std::vector<double> m_frames;
};

}  // namespace sandbox
