#pragma once
#include <map>
#include <string>
#include <vector>

#include "render/gl/pass_timer.h"
#include "render/shader_library/fullscreen_source.h"

namespace rubble {

/// Decides for each pass by which method its full-screen programs are drawn: always by one, or by the faster one. To
/// find that out a pass alternates between both in its first frames, which gives the same image, and keeps the one with
/// the smaller median time.
class FullscreenChoice {
public:
    /// Frames of each method that are not timed, because drivers finish programs in their first draws.
    static constexpr int kWarmUpFrames = 2;
    static constexpr int kTimedFrames = 7;  ///< of each method

    /// Always this method, for all passes.
    explicit FullscreenChoice(FullscreenMethod always) : m_always(always), m_measures(false) {}
    /// The faster method for each pass.
    static FullscreenChoice fastest();

    /// What follows is drawn by this pass.
    void beginPass(const char* name);
    /// The method of the current pass.
    FullscreenMethod method() const { return m_now ? m_now->method : m_always; }
    /// Whether the current pass keeps its method: programs of the other one can be freed.
    bool isDecided() const { return !m_measures || (m_now && m_now->isDecided); }
    /// The current pass has drawn a full-screen program by this method.
    void recordDraw(FullscreenMethod method) {
        if (m_now) m_now->isUsed = true;
        m_hasDrawnByCompute |= method == FullscreenMethod::Compute;
    }
    /// Whether the current pass has drawn by compute since beginPass().
    bool hasDrawnByCompute() const { return m_hasDrawnByCompute; }
    /// Whether it needs times to decide.
    bool isMeasuring() const;
    /// The times of the passes of a frame. Their tags: the methods that drew them.
    void addPassTimes(const PassTimer::Times& times);
    /// What has been decided since the last call, for a log; empty while any pass is still measured.
    std::string takeDecisions();

private:
    struct Pass {
        FullscreenMethod method = FullscreenMethod::Fragment;
        bool isUsed = false, isDecided = false, isUnreported = false;
        int frames = 0;
        std::vector<double> ms[2];  ///< by method; its median alone, once decided
    };
    static double median(std::vector<double> values);

    FullscreenMethod m_always;
    bool m_measures, m_hasDrawnByCompute = false;
    std::map<std::string, Pass, std::less<>> m_passes;
    Pass* m_now = nullptr;
};

}  // namespace rubble
