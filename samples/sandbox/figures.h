#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "runtime/plugin/frame_loop.h"

namespace rubble {

/// Collects what a run cost and did, step by step and frame by frame, and prints it.
class Figures {
public:
    void addStep(FrameLoop& loop, uint64_t allocations);
    void addFrame(const FrameLoop& loop, const Renderer& renderer);
    /// Figures that are one value for the whole run.
    void set(const std::string& name, double value) { m_single[name] = value; }

    /// Table for people.
    std::string table() const;
    /// The same with the state hash of every step, for programs.
    bool writeJson(const std::string& path) const;
    const std::vector<uint64_t>& hashes() const { return m_hashes; }

private:
    struct Series {
        std::string name;
        std::vector<double> values;
    };
    std::vector<double>& series(const std::string& name);
    std::vector<Series> m_series;  ///< in the order first seen
    std::map<std::string, double> m_single;
    std::vector<uint64_t> m_hashes;
    std::vector<std::string> m_computePasses;  ///< of the last frame
    uint64_t m_removed = 0, m_splits = 0, m_pieces = 0, m_painted = 0, m_groupsOut = 0;
    VoxelAccounting m_accounting;
};

/// Allocations by operator new in this process so far.
uint64_t allocationCount();

}  // namespace rubble
