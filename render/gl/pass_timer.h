#pragma once
#include <deque>
#include <vector>

#include "render/gl/name.h"

namespace rubble {

/// Times the passes of a frame. On a GPU by timestamps, which do not meet a host's own timer queries; they are read
/// when the GPU has passed them, some frames later, so that nothing waits. On a software renderer by the clock after
/// glFinish, because queries do not see its work, and so in OpenGL ES, which has none of time. [render-thread]
class PassTimer {
public:
    /// The time of one pass of one frame.
    struct Time {
        const char* name;
        double ms;
        int tag;  ///< as given to begin()
    };
    using Times = std::vector<Time>;  ///< in the order drawn

    /// software: whether the GL draws on the processor, or has no queries of time. processorTime: if so, the
    /// milliseconds that all threads of this process worked, instead of the elapsed ones.
    PassTimer(bool software, bool processorTime) : m_software(software), m_processorTime(processorTime) {}
    /// Whether a pass's time is known when it ends; else it comes some frames later.
    bool isImmediate() const { return m_software; }
    /// Starts a frame. isOn: whether it is timed; if not, the GL is not called.
    void beginFrame(bool isOn);
    /// Starts a pass. `name` must outlive the timer.
    void begin(const char* name, int tag = 0);
    /// Ends the pass.
    void end();
    /// The times of the newest frame that are known, if they were not taken before.
    Times take();

private:
    static constexpr size_t kMaxFrames = 4;  ///< on their way; while there are as many, frames are not timed
    struct Timed {
        const char* name;
        int tag;
        GlName<QueryKind> begin, end;
    };
    using Frame = std::vector<Timed>;
    double nowMs() const;
    GlName<QueryKind> timestamp();
    void readWhatIsReady();

    bool m_software, m_processorTime;
    bool m_isOn = false;
    double m_start = 0.0;
    std::deque<Frame> m_frames;              ///< oldest first
    std::vector<GlName<QueryKind>> m_spare;  ///< queries to use again
    Times m_times;
};

}  // namespace rubble
