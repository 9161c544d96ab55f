#include "samples/stress/round.h"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "runtime/assets/recording_file.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/stress/random_demolition.h"

namespace rubble {
namespace {

constexpr int kHashEvery = 60;
constexpr double kGainAllowed = 0.01, kGainOfAnyRound = 1e3;  ///< of what contacts and friction take; J: what overlaps is pushed apart

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

FrameLoopSettings loopSettings(int threads) {
    FrameLoopSettings settings;
    settings.publish = settings.shadowVolume = false;
    settings.shadow = ShadowWorker::Mode::Inline;
    settings.particles.most = 0;
    settings.physics.parallelFor = threadsFor(threads);
    return settings;
}

/// "" if all is well, else what is wrong.
std::string whatIsWrong(const World& world) {
    std::string wrong;
    if (!world.ledger().balances()) wrong = "the ledger does not balance";
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        const double sum = body.pose.position.x + body.pose.position.y + body.pose.position.z + glm::length(body.velocity) +
                           glm::length(body.angularVelocity) + body.pose.rotation.w;
        if (!std::isfinite(sum)) wrong = fmt::format("body {:x} is not finite", handle.bits);
        if (body.shapes.empty()) wrong = fmt::format("body {:x} has no shape", handle.bits);
    });
    return wrong;
}

/// The recording again, from its save and its edits: every step must come to the hash that it had.
std::string replayed(const std::string& path) {
    FrameLoop loop(loopSettings(1));
    Result<Recording> recording = readRecording(path, loop.world().id());
    if (!recording) return recording.error();
    loop.load(recording->start);
    for (const RecordedStep& step : recording->steps) {
        loop.replay(step);
        if (loop.world().hash() != step.hash) return fmt::format("step {}: saved, loaded and replayed it comes to another hash", step.step);
    }
    return {};
}

size_t residentBytes() {
    std::ifstream file("/proc/self/statm");
    size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * size_t(sysconf(_SC_PAGESIZE));
}

/// A recording in a file that goes with it.
class RecordedPart {
public:
    explicit RecordedPart(const Round& round)
        : m_path((std::filesystem::temp_directory_path() / fmt::format("rubble_stress_{}_{}_{}.rubblelog", getpid(), round.number, round.threads))
                     .string()),
          m_from(round.recordedSteps ? round.steps / 2 : -1),
          m_to(m_from + round.recordedSteps) {}
    ~RecordedPart() { std::remove(m_path.c_str()); }

    /// Before a step. What is wrong with what was recorded, if anything.
    std::string see(FrameLoop& loop, int step) {
        if (m_from < 0) return {};
        if (step == m_from)
            if (const Result<Done> started = loop.startRecording(m_path); !started) return started.error();
        if (step != m_to) return {};
        if (const Result<Done> stopped = loop.stopRecording(); !stopped) return stopped.error();
        return replayed(m_path);
    }

private:
    std::string m_path;
    int m_from, m_to;
};

void play(const Round& round, RoundResult& result, const std::function<void()>& advanced) {
    FrameLoop loop(loopSettings(round.threads));
    loop.world().setSettings(stressSettings());
    loop.load(round.level ? *round.level : makeStressLevel(round.seed + uint64_t(round.number)));
    Random random(round.seed, 77 + uint64_t(round.number));
    RecordedPart recorded(round);
    for (int step = 0; step < round.steps && result.wrong.empty(); ++step) {
        if (result.wrong = recorded.see(loop, step); !result.wrong.empty()) break;
        if (step % round.editsEvery == 0) {
            Edits edits = randomEdits(loop.world(), random);
            result.edits += edits.size();
            loop.edits().push(std::move(edits));
        }
        {
            const ScopedTimer timer(result.stepMs.emplace_back());
            loop.step();
        }
        result.energy.see(loop.world(), loop.changes());
        for (const ShapeSplit& split : loop.changes().splits) result.pieces += split.children.size();
        for (const RemovedVoxels& removed : loop.changes().removed) result.removed += removed.count;
        result.mostBodies = std::max(result.mostBodies, loop.world().bodies().size());
        if ((step + 1) % kHashEvery == 0) result.hashes.push_back(loop.world().hash());
        result.wrong = whatIsWrong(loop.world());
        if (!result.wrong.empty()) result.wrong = fmt::format("step {}: {}", step, result.wrong);
        advanced();
    }
}

}  // namespace

RoundResult playRound(const Round& round, const std::function<void()>& advanced) {
    RoundResult result;
    play(round, result, advanced);
    if (result.wrong.empty() && result.energy.gained() > kGainAllowed * result.energy.lost() + kGainOfAnyRound)
        result.wrong = fmt::format("energy from nothing: {:.0f} J of {:.0f} J that were lost", result.energy.gained(), result.energy.lost());
    malloc_trim(0);
    const struct mallinfo2 memory = mallinfo2();
    result.liveBytes = memory.uordblks + memory.hblkhd;
    result.residentBytes = residentBytes();
    return result;
}

}  // namespace rubble
