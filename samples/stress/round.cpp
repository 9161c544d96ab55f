#include "samples/stress/round.h"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <thread>

#include "runtime/assets/recording_file.h"
#include "samples/stress/mechanical_energy.h"
#include "samples/stress/random_demolition.h"

namespace rubble {
namespace {

constexpr int kHashInterval = 60;
/// Joules that may come from nothing in one round, as a share of what contacts and friction take: what a cut left
/// overlapping is pushed apart. More is something that blew up. For all rounds together see main.cpp.
constexpr double kMaxGainSharePerRound = 2e-2;

/// As a host might supply it at its simplest.
ParallelFor threadsFor(int count) {
    if (count < 2) return {};
    return [count](size_t items, const std::function<void(size_t)>& body) {
        std::vector<std::jthread> threads;
        for (int t = 0; t < count; ++t)
            threads.emplace_back([&, t] {
                for (size_t i = size_t(t); i < items; i += size_t(count)) body(i);
            });
    };
}

/// Of this thread: what else the machine does is left out.
double processorMs() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

/// "" if all is well, else what is error.
std::string brokenInvariant(const World& world) {
    std::string error;
    if (!world.voxelAccounting().balances()) error = "the ledger does not balance";
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        const double sum = body.pose.position.x + body.pose.position.y + body.pose.position.z +
                           glm::length(body.velocity) + glm::length(body.angularVelocity) + body.pose.rotation.w;
        if (!std::isfinite(sum)) error = fmt::format("body {:x} is not finite", handle.bits);
        if (body.shapes.empty()) error = fmt::format("body {:x} has no shape", handle.bits);
    });
    return error;
}

/// The recording again, from its save and its edits: every step must come to the hash that it had.
std::string replayError(const std::string& path) {
    FrameLoop loop(stressLoop(1));
    Result<Recording> recording = readRecording(path, loop.world().id());
    if (!recording) return recording.error();
    loop.load(recording->start);
    for (const RecordedStep& step : recording->steps) {
        loop.replay(step);
        if (loop.world().hash() != step.hash)
            return fmt::format("step {}: saved, loaded and replayError it comes to another hash", step.step);
    }
    return {};
}

/// A recording in a file that goes with it.
class RecordingCheck {
public:
    explicit RecordingCheck(const Round& round)
        : m_path((std::filesystem::temp_directory_path() /
                  fmt::format("rubble_stress_{}_{}.rubblelog", getpid(), round.number))
                     .string()),
          m_from(round.recordedSteps ? round.steps / 2 : -1),
          m_to(m_from + round.recordedSteps) {}
    ~RecordingCheck() { std::remove(m_path.c_str()); }

    /// Before a step. What is error with what was recorded, if anything.
    std::string update(FrameLoop& loop, int step) {
        if (m_from < 0) return {};
        if (step == m_from)
            if (const Result<Done> started = loop.startRecording(m_path); !started) return started.error();
        if (step != m_to) return {};
        if (const Result<Done> stopped = loop.stopRecording(); !stopped) return stopped.error();
        return replayError(m_path);
    }

private:
    std::string m_path;
    int m_from, m_to;
};

void summarizeTimes(std::vector<double> ms, RoundResult& result) {
    if (ms.empty()) return;
    std::sort(ms.begin(), ms.end());
    result.meanMs = std::accumulate(ms.begin(), ms.end(), 0.0) / double(ms.size());
    result.medianMs = ms[ms.size() / 2], result.p99Ms = ms[ms.size() * 99 / 100], result.worstMs = ms.back();
}

}  // namespace

FrameLoopSettings stressLoop(int threads) {
    FrameLoopSettings settings;
    settings.publish = settings.shadowVolume = false;
    settings.shadow = ShadowWorker::Mode::Inline;
    settings.particles.maxAlive = 0;
    settings.physics.parallelFor = threadsFor(threads);
    return settings;
}

void loadRound(const Round& round, FrameLoop& loop) {
    loop.world().setSettings(stressSettings());
    loop.load(round.level ? *round.level : makeStressLevel(round.seed + uint64_t(round.number)));
}

RoundResult playRound(const Round& round, FrameLoop& loop, const std::function<void()>& onStep) {
    RoundResult result;
    std::vector<double> ms;
    MechanicalEnergy energy;
    Random random(round.seed, 77 + uint64_t(round.number));
    RecordingCheck recorded(round);
    for (int step = 0; step < round.steps && result.error.empty(); ++step) {
        if (result.error = recorded.update(loop, step); !result.error.empty()) break;
        if (step % round.editInterval == 0) {
            Edits edits = randomEdits(loop.world(), random);
            result.edits += edits.size();
            loop.edits().push(std::move(edits));
        }
        const double before = processorMs();
        loop.step();
        ms.push_back(processorMs() - before);
        energy.update(loop.world(), loop.changes());
        for (const ShapeSplit& split : loop.changes().splits) result.pieces += split.children.size();
        for (const RemovedVoxels& removed : loop.changes().removed) result.removed += removed.count;
        result.maxBodies = std::max(result.maxBodies, loop.world().bodies().size());
        if ((step + 1) % kHashInterval == 0) {
            result.hashes.push_back(loop.world().hash());
            result.maxHeapBytes = std::max(result.maxHeapBytes, heapBytes());
        }
        result.error = brokenInvariant(loop.world());
        if (!result.error.empty()) result.error = fmt::format("step {}: {}", step, result.error);
        onStep();
    }
    summarizeTimes(std::move(ms), result);
    result.comparedSteps = energy.comparedSteps(), result.lost = energy.lost(), result.gained = energy.gained();
    if (result.error.empty() && result.gained > kMaxGainSharePerRound * result.lost)
        result.error = fmt::format("energy from nothing: {:.0f} J, and {:.0f} J were lost", result.gained, result.lost);
    return result;
}

size_t heapBytes() {
    const struct mallinfo2 memory = mallinfo2();
    return memory.uordblks + memory.hblkhd;
}

size_t heapBytesWhenEmptied(FrameLoop& loop) {
    loop.load(Level{});
    for (int i = 0; i < 2; ++i) loop.step();  // the journal of the first says that all is gone
    return heapBytes();
}

size_t residentBytes() {
    std::ifstream file("/proc/self/statm");
    size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * size_t(sysconf(_SC_PAGESIZE));
}

}  // namespace rubble
