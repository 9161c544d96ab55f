// The shadow worker with moving bodies of 16^3 voxels: cost of an update, and age of the shadow volume at 60 Hz.
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "runtime/core/random.h"
#include "runtime/shadow/rasterize_large.h"
#include "runtime/shadow/shadow_worker.h"
#include "runtime/shadow/surface_bricks.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

using Clock = std::chrono::steady_clock;
double msSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

LevelBody makeBody(VoxelGrid grid, glm::dvec3 position, bool isStatic) {
    LevelBody body;
    body.pose.position = position;
    body.isStatic = isStatic;
    auto palette = std::make_shared<Palette>();
    (*palette)[1].material = defaultMaterials().find("brick");
    LevelShape shape;
    shape.grid = std::move(grid);
    shape.palette = palette;
    body.shapes.push_back(std::move(shape));
    return body;
}

/// Bodies over a floor that fall at about 10 m/s and rotate.
class Fall {
public:
    explicit Fall(int bodies) {
        Level level;
        level.bodies.push_back(makeBody(solidGrid({512, 8, 512}), {0, 0, 0}, true));
        for (int i = 0; i < bodies; ++i) {
            glm::dvec3 position;
            for (int a = 0; a < 3; ++a) position[a] = 50.0 * double(m_random.unit());
            level.bodies.push_back(makeBody(solidGrid(glm::ivec3(16)), position * glm::dvec3(1.0, 0.2, 1.0), false));
        }
        m_world.load(level);
        m_world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (!body.isStatic) m_moved.push_back({handle, body.pose, {}, {}, false});
        });
    }
    void step() {
        m_changes = m_world.applyEdits({});
        for (BodyPose& body : m_moved) {
            body.pose.position.y -= body.pose.position.y < 0.0 ? -10.0 : 0.17;
            glm::dvec3 turn;
            for (int a = 0; a < 3; ++a) turn[a] = 0.1 * double(m_random.unit());
            body.pose.rotation = glm::normalize(glm::dquat(1.0, turn.x, turn.y, turn.z) * body.pose.rotation);
        }
        m_world.setPoses(m_moved);
    }
    void submitTo(ShadowWorker& worker) const { worker.submit(m_changes, m_moved, m_world); }
    uint64_t stepNumber() const { return m_changes.step; }

private:
    Random m_random{1};
    World m_world;
    FrameChanges m_changes;
    std::vector<BodyPose> m_moved;
};

/// Time of the worker for one step.
void shadowUpdate(benchmark::State& state) {
    Fall fall(int(state.range(0)));
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    size_t patches = 0;
    const auto step = [&] {
        fall.step();
        fall.submitTo(worker);
        for (const ShadowPatches& publication : worker.takePatches()) patches += publication.patches.size();
    };
    step();
    patches = 0;
    for (auto _ : state) step();
    state.counters["bricks_per_step"] = benchmark::Counter(double(patches), benchmark::Counter::kAvgIterations);
}
BENCHMARK(shadowUpdate)->Arg(50)->Arg(200)->Arg(1000)->Unit(benchmark::kMillisecond);

double percentile(std::vector<double> values, double part) {
    std::sort(values.begin(), values.end());
    return values[size_t(part * double(values.size() - 1))];
}

double cpuMs(clockid_t clock) {
    timespec time;
    clock_gettime(clock, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}
/// Involuntary context switches of this process: how often the system preempted one of its threads.
long preemptions() {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_nivcsw;
}

/// Ten seconds at 60 Hz. Age: steps between the world and the newest publication when a step takes the patches. A step
/// takes them right after its submission, so the minimum is 1: everything but the current step. On a busy machine check
/// `preemptions` before relying on the ages; `worker_cpu_ms` is the worker's own processor time for a step.
void shadowLag(benchmark::State& state) {
    Fall fall(int(state.range(0)));
    ShadowWorker worker(ShadowWorker::Mode::Thread);
    fall.step();
    fall.submitTo(worker);
    worker.waitFor(fall.stepNumber());
    std::vector<double> ages, waits;
    const double cpuBefore = cpuMs(CLOCK_PROCESS_CPUTIME_ID) - cpuMs(CLOCK_THREAD_CPUTIME_ID);
    const long preemptionsBefore = preemptions();
    Clock::time_point next = Clock::now();
    for (auto _ : state) {
        fall.step();
        const Clock::time_point start = Clock::now();
        fall.submitTo(worker);
        benchmark::DoNotOptimize(worker.takePatches());
        waits.push_back(msSince(start));
        ages.push_back(double(fall.stepNumber() - worker.publishedVersion()));
        next += std::chrono::microseconds(16'667);
        std::this_thread::sleep_until(next);
    }
    state.counters["age_p50"] = percentile(ages, 0.5);
    state.counters["age_p99"] = percentile(ages, 0.99);
    state.counters["age_max"] = percentile(ages, 1.0);
    state.counters["main_ms_p50"] = percentile(waits, 0.5);
    state.counters["main_ms_p99"] = percentile(waits, 0.99);
    state.counters["main_ms_max"] = percentile(waits, 1.0);
    const double workerMs = cpuMs(CLOCK_PROCESS_CPUTIME_ID) - cpuMs(CLOCK_THREAD_CPUTIME_ID) - cpuBefore;
    state.counters["worker_cpu_ms"] = workerMs / double(state.iterations());
    state.counters["preemptions"] = double(preemptions() - preemptionsBefore);
}
BENCHMARK(shadowLag)->Arg(200)->Iterations(600)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A shadow brick on the surface of a block of voxels of 2 m, at random rotations, by boxes; `rows_ms` is the same row
/// by row.
void shadowBrickOfLargeVoxels(benchmark::State& state) {
    const VoxelGrid grid = solidGrid({8, 6, 8});
    Random random(1);
    double ms = 0.0, rowsMs = 0.0;
    uint64_t cells = 0;
    for (auto _ : state) {
        glm::dquat turn(1.0, 0.0, 0.0, 0.0);
        for (int a = 0; a < 3; ++a) turn[a] = double(random.unit());
        const Pose pose{glm::dvec3(0.0), glm::normalize(turn)};
        ShadowCellTransform transform;
        transform.place(pose, 2.0);
        std::vector<glm::ivec3> bricks;
        listSurfaceBricks(grid, pose, 2.0, bricks);
        const auto measure = [&](auto&& rasterizeBox) {
            const auto start = Clock::now();
            for (const glm::ivec3 brick : bricks) {
                CellRows rows{};
                const glm::ivec3 corner = brick * kShadowBrickCells;
                rasterizeBox(grid, transform, CellBox{corner, corner + kShadowBrickCells}, corner, rows);
                cells += rows[0];
            }
            return msSince(start);
        };
        ms += measure(rasterizeLargeVoxels);
        rowsMs += measure(rasterizeByRows);
    }
    benchmark::DoNotOptimize(cells);
    state.counters["boxes_ms"] = ms / double(state.iterations());
    state.counters["rows_ms"] = rowsMs / double(state.iterations());
    state.counters["rows_over_boxes"] = rowsMs / ms;
}
BENCHMARK(shadowBrickOfLargeVoxels)->Iterations(50)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rubble
