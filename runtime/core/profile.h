#pragma once
#include <array>
#include <chrono>
#include <cstdint>

namespace rubble {

/// The stages of FrameLoop::step() and draw(), in the order in which they run.
enum class Stage : uint8_t { ApplyEdits, Physics, Poses, Impacts, Shadow, Publish, Apply, Draw, kCount };
/// Short names of the stages, by Stage, for tables and logs.
constexpr std::array<const char*, size_t(Stage::kCount)> kStageNames = {"edits",  "physics", "poses", "impacts",
                                                                        "shadow", "publish", "apply", "draw"};

/// The time of one step and one draw by stage, in milliseconds. Only for display: no decision depends on a clock.
struct StageTimes {
    /// Milliseconds by Stage.
    std::array<double, size_t(Stage::kCount)> ms{};
    double& operator[](Stage stage) { return ms[size_t(stage)]; }
    double operator[](Stage stage) const { return ms[size_t(stage)]; }
};

/// Measures a scope: adds the time from its construction to its destruction to a sum in milliseconds.
class ScopedTimer {
public:
    /// `ms`: the sum; it must outlive the timer.
    explicit ScopedTimer(double& ms) : m_ms(ms), m_start(std::chrono::steady_clock::now()) {}
    ~ScopedTimer() {
        m_ms += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_start).count();
    }
    ScopedTimer(const ScopedTimer&) = delete;
    ScopedTimer& operator=(const ScopedTimer&) = delete;

private:
    double& m_ms;
    std::chrono::steady_clock::time_point m_start;
};

}  // namespace rubble
