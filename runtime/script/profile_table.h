#pragma once
#include <cstdint>
#include <list>
#include <map>
#include <string>
#include <vector>

#include "runtime/script/script.h"

namespace rubble::script {

/// What scripts have cost lately, a frame on average, as a table over the image: each script with its callbacks and the
/// functions that it calls, the costliest first.
class ProfileTable {
public:
    static constexpr int kFrames = 30;      ///< whose mean the table shows
    static constexpr size_t kMaxRows = 30;  ///< below the head

    /// Looks at what scripts have cost so far: once a frame. Functions are in it whose ScriptContext::costs are kept.
    void update(const std::list<Script>& scripts);
    /// The lines of the table, whose columns are aligned in a font of equal widths. The first one is its head.
    const std::vector<std::string>& lines() const { return m_lines; }

private:
    /// What was counted from the beginning on; of a frame, once a row shows it.
    struct Cost {
        double calls = 0.0, seconds = 0.0, allocations = 0.0;
    };
    /// By place: callbacks, then functions.
    using Costs = std::vector<Cost>;

    static Costs costsOf(const Script& script);
    void write(const std::list<Script>& scripts);
    void writeScript(const Script& script, const Costs& costs);

    int m_frames = 0;                          ///< since the table was written
    std::map<const Script*, Costs> m_written;  ///< what had been counted then
    std::vector<std::string> m_lines;
};

}  // namespace rubble::script
