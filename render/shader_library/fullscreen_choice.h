#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "render/shader_library/fullscreen_source.h"

namespace rubble {

/// By what each pass draws its full-screen programs. Where it is to be found out, a pass draws its first frames by
/// turns both ways, the same picture, and stays with what was faster.
class FullscreenChoice {
public:
    using Times = std::vector<std::pair<const char*, double>>;  ///< milliseconds by pass, as in RenderFigures
    static constexpr int kWarmUpFrames = 2,
                         kTimedFrames = 7;  ///< frames each way: drivers finish programs in their first

    /// Of all passes.
    explicit FullscreenChoice(FullscreenMethod always) : m_always(always), m_measures(false) {}
    /// For each pass what is faster.
    static FullscreenChoice fastest();

    /// This pass draws from here on.
    void beginPass(const char* name);
    /// By what.
    FullscreenMethod by() const { return m_now ? m_now->by : m_always; }
    /// By what from now on: nothing else is needed any more.
    bool isDecided() const { return !m_measures || (m_now && m_now->isDecided); }
    /// The pass has drawn a full-screen program, by that.
    void recordDraw(FullscreenMethod by) {
        if (m_now) m_now->isUsed = true;
        m_hasDrawnByCompute |= by == FullscreenMethod::Compute;
    }
    /// Since beginPass(), any of its programs by compute.
    bool hasDrawnByCompute() const { return m_hasDrawnByCompute; }
    /// What the last frame's passes took.
    void addPassTimes(const Times& passMs);
    /// The passes that have been decided since it was last asked, in words; empty: none, or some are still measured.
    std::string takeDecisions();

private:
    struct Pass {
        FullscreenMethod by = FullscreenMethod::Fragment;
        bool isUsed = false, isDecided = false, isUnreported = false;
        int frames = 0;
        std::vector<double> ms[2];
    };
    static double median(std::vector<double> values);

    FullscreenMethod m_always;
    bool m_measures, m_hasDrawnByCompute = false;
    std::map<std::string, Pass, std::less<>> m_passes;
    Pass* m_now = nullptr;
};

}  // namespace rubble
