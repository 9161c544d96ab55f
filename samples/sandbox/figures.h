#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "runtime/plugin/frame_loop.h"

namespace rubble {

/// Collects times, counts and state hashes of a run, step by step and frame by frame.
class Figures {
public:
    /// Takes the figures of the step that `loop` just made; `allocations`: calls of operator new in it.
    void addStep(FrameLoop& loop, uint64_t allocations);
    /// Takes the figures of the frame that `renderer` just drew.
    void addFrame(const FrameLoop& loop, const Renderer& renderer);

    /// Quantiles of every series and the totals, for people.
    std::string table() const;
    /// The same with all values and the state hash of every step, for programs; false if `path` cannot be written.
    bool writeJson(const std::string& path) const;

private:
    struct Series {
        std::string name;
        std::vector<double> values;
    };
    std::vector<double>& series(const std::string& name);
    std::vector<Series> m_series;  ///< in the order in which they first occur

    std::vector<uint64_t> m_hashes;
    std::vector<std::string> m_computePasses;  ///< of the last frame
    uint64_t m_removed = 0, m_splits = 0, m_pieces = 0, m_painted = 0, m_groupsOut = 0;
    VoxelAccounting m_accounting;
};

}  // namespace rubble
