#pragma once
#include <utility>
#include <vector>

#include "render/gl/name.h"

namespace rubble {

/// Times the passes of a frame. On a GPU by GL_TIME_ELAPSED queries, which are read one frame later, so that nothing
/// waits; on a software renderer by the clock after glFinish, because queries do not see its work.
class PassTimer {
public:
    using Times = std::vector<std::pair<const char*, double>>;  ///< milliseconds by pass, in the order drawn

    /// processorTime: on a software renderer, the milliseconds that all threads of this process worked, instead of the
    /// elapsed ones.
    PassTimer(bool software, bool processorTime) : m_software(software), m_processorTime(processorTime) {}
    /// Whether a pass's time is known when it ends; else it comes with the next frame.
    bool isImmediate() const { return m_software; }
    /// Starts a frame. `out` gets the times of the frame before, if they are not immediate.
    void beginFrame(Times& out);
    /// Starts a pass. `name` must outlive the next beginFrame().
    void begin(const char* name);
    /// Ends the pass; appends its time to `out`, if that is immediate.
    void end(Times& out);

private:
    struct Timed {
        const char* name;
        GlName<QueryKind> query;
    };
    double nowMs() const;
    bool m_software, m_processorTime;
    double m_start = 0.0;
    std::vector<Timed> m_running;
    size_t m_count = 0;
};

}  // namespace rubble
