#pragma once
#include <utility>
#include <vector>

#include "render/gl/name.h"

namespace rubble {

/// Times the passes of a frame: by GL_TIME_ELAPSED, read one frame later, on a GPU; after glFinish on a software
/// renderer, whose queries do not see the work.
class PassTimer {
public:
    /// processorTime: on a software renderer, the milliseconds that all threads of this process worked, not those on
    /// the wall.
    PassTimer(bool software, bool processorTime) : m_software(software), m_processorTime(processorTime) {}
    /// True if a pass's time is known when it ends; else it comes with the next frame.
    bool isImmediate() const { return m_software; }
    /// Collects the frame before and starts a new one. `out` gets the times in the order drawn.
    void beginFrame(std::vector<std::pair<const char*, double>>& out);
    void begin(const char* name);
    void end(std::vector<std::pair<const char*, double>>& out);

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
