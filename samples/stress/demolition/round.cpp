#include "samples/stress/demolition/round.h"

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
#include "samples/stress/demolition/mechanical_energy.h"
#include "samples/stress/demolition/random_demolition.h"

namespace rubble {
namespace {

constexpr int kHashInterval = 60;
/// Joules gained in one round, as a share of the joules lost. Depenetration of pieces that a cut leaves overlapping
/// gains a little; more than this share is an instability. main.cpp has the limit for all rounds together.
constexpr double kMaxGainSharePerRound = 2e-2;

/// The simplest ParallelFor that a host might supply; none for one thread.
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

/// Processor time of this thread: other load on the machine is not counted.
double processorMs() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

/// The first invariant that does not hold; "" if all do.
std::string brokenInvariant(const World& world) {
    std::string error;
    if (!voxelAccounting(world).balances()) error = "the voxel accounting does not balance";
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        const double sum = body.pose.position.x + body.pose.position.y + body.pose.position.z +
                           glm::length(body.velocity) + glm::length(body.angularVelocity) + body.pose.rotation.w;
        if (!std::isfinite(sum))
            error = fmt::format("body {:x} has a position or velocity that is not finite", handle.bits);
        if (body.shapes.empty()) error = fmt::format("body {:x} has no shape", handle.bits);
    });
    return error;
}

/// Replays a recording from its save and edits; "" if every step gives the recorded hash.
std::string replayError(const std::string& path) {
    FrameLoop loop(stressLoop(1));
    Result<Recording> recording = readRecording(path, loop.world().id());
    if (!recording) return recording.error();
    loop.load(recording->start);
    for (const RecordedStep& step : recording->steps) {
        loop.replay(step);
        if (loop.world().hash() != step.hash)
            return fmt::format("step {}: replayed from its recording, it gives another hash", step.step);
    }
    return {};
}

/// Records some steps in the middle of a round into a temporary file, and replays the file.
class RecordingCheck {
public:
    explicit RecordingCheck(const Round& round)
        : m_path((std::filesystem::temp_directory_path() /
                  fmt::format("rubble_stress_{}_{}.rubblelog", getpid(), round.number))
                     .string()),
          m_from(round.recordedSteps ? round.steps / 2 : -1),
          m_to(m_from + round.recordedSteps) {}
    ~RecordingCheck() { std::remove(m_path.c_str()); }

    /// Call before each step. After the last recorded step, returns what is wrong with the recording; else "".
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
        energy.update(loop.world(), loop.changes(), loop.physics()->stats().work);
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
        result.error = fmt::format("expected no energy gain, found {:.0f} J gained while {:.0f} J were lost",
                                   result.gained, result.lost);
    return result;
}

size_t heapBytes() {
    const struct mallinfo2 memory = mallinfo2();
    return memory.uordblks + memory.hblkhd;
}

size_t heapBytesWhenEmptied(FrameLoop& loop) {
    loop.load(Level{});
    for (int i = 0; i < 2; ++i) loop.step();  // the first step's journal removes everything; the second is empty
    return heapBytes();
}

size_t residentBytes() {
    std::ifstream file("/proc/self/statm");
    size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * size_t(sysconf(_SC_PAGESIZE));
}

}  // namespace rubble
