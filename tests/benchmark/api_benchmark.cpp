// What a call of the C interface costs a host: plain ones, edits, refused ones, rays alone and in a batch, empty steps.
#include <benchmark/benchmark.h>
#include <rubble/rubble.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "runtime/assets/assets.h"
#include "runtime/core/random.h"
#include "tests/support/cpu_time.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

constexpr int kCalls = 10'000;

const rubble_api& api() {
    static const rubble_api* table = nullptr;
    if (!table) rubble_get_api(RUBBLE_VERSION, &table);
    return *table;
}

void require(rubble_result result) {
    if (result != RUBBLE_OK) throw std::runtime_error(api().get_last_error());
}

/// A field of 20 x 20 blocks over a floor, and a free block.
std::string writeField() {
    Level level;
    auto palette = std::make_shared<Palette>();
    (*palette)[1].material = level.materials.find("brick");
    const auto add = [&](glm::ivec3 size, glm::dvec3 at, bool isStatic) {
        LevelBody body{.name = "block", .pose = {at}, .isStatic = isStatic};
        body.shapes.push_back({.name = "block", .grid = solidGrid(size), .palette = palette});
        level.bodies.push_back(std::move(body));
    };
    add({600, 4, 600}, {0.0, -0.4, 0.0}, true);
    for (int i = 0; i < 400; ++i) add({6 + i % 9, 20, 10}, {3.0 * (i % 20), 0.0, 3.0 * (i / 20)}, true);
    add({8, 8, 8}, {1.5, 0.0, 1.5}, false);
    const std::string path =
        std::filesystem::temp_directory_path() / ("rubble_api_bench_" + std::to_string(getpid()) + ".rubble");
    if (const Result<Done> written = writeRubble(path, level); !written) throw std::runtime_error(written.error());
    return path;
}

/// A world of the host, with that field or empty, on so many threads.
class HostWorld {
public:
    explicit HostWorld(bool withField, uint32_t threads = 1) {
        rubble_world_settings settings = {};
        settings.struct_size = sizeof settings;
        settings.flags = RUBBLE_WORLD_NO_RENDERER;
        settings.physics_threads = threads;
        require(api().create_world(&settings, &m_world));
        if (!withField) return;
        const std::string path = writeField();
        require(api().load_level(m_world, path.c_str(), nullptr));
        std::filesystem::remove(path);
        require(api().step(m_world));
    }
    ~HostWorld() { api().destroy_world(m_world); }
    HostWorld(const HostWorld&) = delete;
    HostWorld& operator=(const HostWorld&) = delete;
    operator rubble_world() const { return m_world; }
    /// The last body of the level: the free block.
    rubble_body freeBody() const {
        uint32_t count = 0;
        require(api().get_body_states(m_world, nullptr, 0, &count));
        std::vector<rubble_body_state> rows(count);
        require(api().get_body_states(m_world, rows.data(), count, &count));
        return rows.back().body;
    }

private:
    rubble_world m_world = 0;
};

std::vector<rubble_ray> makeRays() {
    Random random(4);
    std::vector<rubble_ray> rays(kCalls);
    for (rubble_ray& ray : rays) {
        ray.origin[0] = 60.0 * double(random.unit()), ray.origin[1] = 1.5, ray.origin[2] = 60.0 * double(random.unit());
        ray.direction[0] = double(random.unit()) - 0.5, ray.direction[1] = -0.05;
        ray.direction[2] = double(random.unit()) - 0.5;
        ray.max_distance = 50.0;
    }
    return rays;
}

/// Adds the processor time of kCalls calls to `ms`.
template <class Call>
void timeCalls(double& ms, Call&& call) {
    const double start = threadMs();
    for (int i = 0; i < kCalls; ++i) call(i);
    ms += threadMs() - start;
}

/// Nanoseconds of a call, all of one process in alternation; and ratios to the plain one, which a machine's speed does
/// not change.
void apiCalls(benchmark::State& state) {
    const HostWorld world(true), empty(false);
    const std::vector<rubble_ray> rays = makeRays();
    std::vector<rubble_hit> hits(rays.size());
    rubble_impulse push = {};
    push.struct_size = sizeof push, push.body = world.freeBody();
    rubble_explosion nowhere = {};
    nowhere.struct_size = sizeof nowhere, nowhere.size = 100.0;
    rubble_body_settings frame = {};
    frame.struct_size = sizeof frame, frame.flags = RUBBLE_BODY_STATIC;
    std::vector<rubble_body> made(kCalls);
    double plain = 0.0, edit = 0.0, stale = 0.0, range = 0.0, ray = 0.0, batch = 0.0, step = 0.0, make = 0.0;
    rubble_body_state body = {};
    for (auto _ : state) {
        timeCalls(plain, [&](int) { api().get_body_state(world, push.body, &body); });
        timeCalls(edit, [&](int) { api().apply_impulse(world, &push); });
        require(api().step(world));
        timeCalls(stale, [&](int) { api().get_body_state(world, 0, &body); });
        timeCalls(range, [&](int) { api().explode(world, &nowhere); });
        timeCalls(ray, [&](int i) {
            const rubble_ray& each = rays[size_t(i)];
            api().cast_ray(world, each.origin, each.direction, each.max_distance, &hits[size_t(i)]);
        });
        const double start = threadMs();
        require(api().cast_rays(world, rays.data(), kCalls, nullptr, hits.data()));
        batch += threadMs() - start;
        timeCalls(step, [&](int) { api().step(empty); });
        timeCalls(make, [&](int i) { api().create_body(empty, &frame, &made[size_t(i)]); });
        for (const rubble_body body : made) require(api().destroy_body(empty, body));
        require(api().step(empty));
    }
    const double each = 1e6 / (double(kCalls) * double(state.iterations()));
    state.counters["plain_ns"] = plain * each;
    state.counters["edit_ns"] = edit * each;
    state.counters["stale_ns"] = stale * each;
    state.counters["range_ns"] = range * each;
    state.counters["ray_ns"] = ray * each;
    state.counters["batch_ray_ns"] = batch * each;
    state.counters["empty_step_ns"] = step * each;
    state.counters["make_ns"] = make * each;
    state.counters["make_over_edit"] = make / edit;
    state.counters["edit_over_plain"] = edit / plain;
    state.counters["stale_over_plain"] = stale / plain;
    state.counters["range_over_plain"] = range / plain;
    state.counters["ray_over_batch"] = ray / batch;
}
BENCHMARK(apiCalls)->Unit(benchmark::kMillisecond);

/// A median of wall-clock milliseconds, in which threads can share.
double median(std::vector<double> ms) {
    std::nth_element(ms.begin(), ms.begin() + ptrdiff_t(ms.size() / 2), ms.end());
    return ms[ms.size() / 2];
}

/// 10,000 rays one by one, in a batch on one thread, and in a batch on two: wall-clock time, medians of one process in
/// alternation.
void apiRays(benchmark::State& state) {
    const HostWorld one(true), two(true, 2);
    const std::vector<rubble_ray> rays = makeRays();
    std::vector<rubble_hit> hits(rays.size()), batch(rays.size());
    std::vector<double> single, alone, shared;
    const auto time = [](std::vector<double>& into, auto&& work) {
        const auto start = std::chrono::steady_clock::now();
        work();
        into.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    };
    for (auto _ : state) {
        time(single, [&] {
            for (size_t i = 0; i < rays.size(); ++i)
                api().cast_ray(one, rays[i].origin, rays[i].direction, rays[i].max_distance, &hits[i]);
        });
        time(alone, [&] { require(api().cast_rays(one, rays.data(), kCalls, nullptr, batch.data())); });
        for (size_t i = 0; i < rays.size(); ++i)
            if (hits[i].distance != batch[i].distance) throw std::runtime_error("the batch has another answer");
        time(shared, [&] { require(api().cast_rays(two, rays.data(), kCalls, nullptr, batch.data())); });
    }
    state.counters["single_ms"] = median(single);
    state.counters["batch_ms"] = median(alone);
    state.counters["two_threads_ms"] = median(shared);
    state.counters["single_over_batch"] = median(single) / median(alone);
    state.counters["single_over_two_threads"] = median(single) / median(shared);
}
BENCHMARK(apiRays)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(2.0);
/// The same of palettes, materials and properties: what is read, what is queued, what is refused.
void apiProperties(benchmark::State& state) {
    const HostWorld world(true);
    rubble_shape shape = 0;
    uint32_t shapes = 0;
    const rubble_body block = world.freeBody();
    require(api().get_objects_of(world, block, RUBBLE_KIND_SHAPE, &shape, 1, &shapes));
    rubble_palette_range one = {};
    one.struct_size = sizeof one, one.shape = shape, one.count = 1;
    rubble_palette_range all = one, none = one;
    all.count = 255, none.count = 0;
    rubble_palette_entry entries[255] = {};
    rubble_shape_change change = {};
    change.struct_size = sizeof change, change.shape = shape, change.fields = RUBBLE_SHAPE_STRENGTH;
    change.strength = 1.0;
    rubble_material row = {};
    row.struct_size = sizeof row;
    rubble_body_properties weight = {};
    weight.struct_size = sizeof weight;
    double readOne = 0.0, readAll = 0.0, readRow = 0.0, mass = 0.0, set = 0.0, setShape = 0.0, setRow = 0.0,
           refused = 0.0;
    for (auto _ : state) {
        timeCalls(readAll, [&](int) { api().get_palette(world, &all, entries); });
        timeCalls(readOne, [&](int) { api().get_palette(world, &one, entries); });
        timeCalls(mass, [&](int) { api().get_body_properties(world, block, &weight); });
        timeCalls(set, [&](int) { api().set_palette(world, &one, entries); });
        require(api().step(world));
        timeCalls(setShape, [&](int) { api().set_shape(world, &change); });
        require(api().step(world));
        timeCalls(readRow, [&](int) { api().get_material(world, 5, &row); });
        timeCalls(setRow, [&](int) { api().set_materials(world, 5, &row, 1); });
        require(api().step(world));
        timeCalls(refused, [&](int) { api().set_palette(world, &none, entries); });
    }
    const double each = 1e6 / (double(kCalls) * double(state.iterations()));
    state.counters["get_palette_ns"] = readOne * each;
    state.counters["get_255_entries_ns"] = readAll * each;
    state.counters["get_material_ns"] = readRow * each;
    state.counters["get_body_properties_ns"] = mass * each;
    state.counters["set_palette_ns"] = set * each;
    state.counters["set_shape_ns"] = setShape * each;
    state.counters["set_materials_ns"] = setRow * each;
    state.counters["refused_ns"] = refused * each;
}
BENCHMARK(apiProperties)->Unit(benchmark::kMillisecond);

/// Voxels between host and plugin, a byte each: made into a shape, read back, written over by a call and a step,
/// and copied by memcpy beside it.
void apiVoxels(benchmark::State& state) {
    constexpr int kSide = 128;
    const HostWorld world(false);
    std::vector<uint8_t> cells(size_t(kSide) * kSide * kSide), back(cells.size());
    for (size_t i = 0; i < cells.size(); ++i) cells[i] = uint8_t(1 + i / 777 % 9);
    rubble_body_settings frame = {};
    frame.struct_size = sizeof frame, frame.flags = RUBBLE_BODY_STATIC;
    std::vector<rubble_brick> places;
    for (int i = 0; i < kSide / 8 * kSide / 8 * kSide / 8; ++i) places.push_back({i % 16, i / 16 % 16, i / 256, 0});
    std::vector<uint8_t> bricks(places.size() * RUBBLE_BRICK_BYTES);
    double make = 0.0, read = 0.0, brick = 0.0, write = 0.0, step = 0.0, copy = 0.0;
    std::vector<uint8_t> others(cells);
    for (uint8_t& cell : others) ++cell;
    for (auto _ : state) {
        rubble_body body = 0;
        rubble_shape_settings settings = {};
        rubble_voxel_box box = {};
        settings.struct_size = sizeof settings, settings.source = RUBBLE_SHAPE_INDICES;
        settings.indices = cells.data(), settings.count = cells.size();
        box.struct_size = sizeof box;
        std::fill_n(settings.size, 3, kSide), std::fill_n(box.size, 3, kSide);
        require(api().create_body(world, &frame, &body));
        settings.body = body;
        double start = threadMs();
        require(api().create_shape(world, &settings, &box.shape));
        make += threadMs() - start;
        require(api().step(world));
        uint64_t count = 0;
        start = threadMs();
        require(api().read_voxels(world, &box, back.data(), back.size(), &count));
        read += threadMs() - start;
        start = threadMs();
        require(api().read_bricks(world, box.shape, places.data(), uint32_t(places.size()), bricks.data(),
                                  bricks.size(), &count));
        brick += threadMs() - start;
        if (back != cells) throw std::runtime_error("other voxels were read than written");
        start = threadMs();
        require(api().write_voxels(world, &box, others.data(), others.size()));
        write += threadMs() - start;
        start = threadMs();
        require(api().step(world));
        step += threadMs() - start;
        start = threadMs();
        std::copy(cells.begin(), cells.end(), back.begin());
        benchmark::DoNotOptimize(back.data());
        copy += threadMs() - start;
        require(api().destroy_body(world, body));
        require(api().step(world));
    }
    const double bytes = double(cells.size()) * double(state.iterations());
    state.counters["make_GB_s"] = bytes / make * 1e-6;
    state.counters["read_GB_s"] = bytes / read * 1e-6;
    state.counters["read_bricks_GB_s"] = double(bricks.size()) * double(state.iterations()) / brick * 1e-6;
    state.counters["write_GB_s"] = bytes / write * 1e-6;
    state.counters["write_step_ms"] = step / double(state.iterations());
    state.counters["make_over_copy"] = make / copy;
    state.counters["read_over_copy"] = read / copy;
}
BENCHMARK(apiVoxels)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rubble
