#pragma once
#include <array>
#include <chrono>
#include <cstdint>

namespace rubble {

/// The stages of FrameLoop::step() and draw(), in order.
enum class Stage : uint8_t { ApplyEdits, Physics, Poses, Impacts, Shadow, Publish, Apply, Draw, kCount };
constexpr std::array<const char*, size_t(Stage::kCount)> kStageNames = {"edits",  "physics", "poses", "impacts",
                                                                        "shadow", "publish", "apply", "draw"};

/// What one step and one draw cost, by stage, in milliseconds. Time is only reported: nothing is decided by it.
struct StageTimes {
    std::array<double, size_t(Stage::kCount)> ms{};
    double& operator[](Stage stage) { return ms[size_t(stage)]; }
    double operator[](Stage stage) const { return ms[size_t(stage)]; }
};

/// Adds the time from its construction to its destruction to a figure in milliseconds.
class ScopedTimer {
public:
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
