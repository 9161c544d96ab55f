// What scripts cost: calls against the same calls of C in alternation, rays a second, holes, empty scripts. In
// processor time of this thread; medians.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <optional>
#include <vector>

#include "runtime/script/script_host.h"
#include "samples/lua/yard.h"

namespace rubble::script {
namespace {

constexpr int kRounds = 15;

double processorSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double secondsOf(const std::function<void()>& work) {
    const double before = processorSeconds();
    work();
    return processorSeconds() - before;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// A yard with scripts, whose budgets leave room for loops.
struct Scene {
    Scene() {
        rubble_get_api(RUBBLE_VERSION, &api);
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER;
        api->create_world(&settings, &world);
        if (const std::string error = lua_sample::buildYard(*api, world); !error.empty()) fmt::print("{}\n", error);
        ScriptHostSettings given;
        given.limits.work = int64_t(1) << 40;
        given.limits.processorSeconds = 1000.0;
        given.log = [](int level, const std::string& line) {
            if (level) std::puts(line.c_str());
        };
        host.emplace(*api, world, given);
    }
    ~Scene() {
        host.reset();
        api->destroy_world(world);
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    const rubble_api* api = nullptr;
    rubble_world world = 0;
    std::optional<ScriptHost> host;
};

/// Runs a script's update() alone, in alternation with C; prints both, for each of `count` calls.
void compareCalls(const char* name, const std::string& body, int count, const std::function<void(Scene&)>& inC) {
    Scene scene;
    Script& script = scene.host->add(
        name,
        fmt::format(
            "local s, b = FindShape('crate'), FindBody('crate')\nfunction update()\n for i = 1, {} do {} end\nend",
            count, body));
    std::vector<double> lua, c;
    for (int round = 0; round < kRounds; ++round) {
        lua.push_back(secondsOf([&] { script.call(Callback::Update, [](lua_State*) { return 0; }); }));
        c.push_back(secondsOf([&] {
            for (int i = 0; i < count; ++i) inC(scene);
        }));
    }
    const double fromLua = median(lua) / count, fromC = median(c) / count;
    fmt::print("{:<22} Lua {:7.1f} ns, C {:7.1f} ns: {:6.1f} ns more; {:.0f} a second\n", name, fromLua * 1e9,
               fromC * 1e9, (fromLua - fromC) * 1e9, 1.0 / fromLua);
}

/// Holes in the wall, of a script and of C, each in a world of its own and in each step some. counts: whether C asks
/// how many voxels each removes, as MakeHole() does: the same calls of the interface. Else C has less to do.
void compareHoles(bool counts) {
    constexpr int kSteps = 60;
    std::vector<double> ratios;
    for (int round = 0; round < 40; ++round) {
        Scene scripted, plain;
        scripted.host->add(
            "holes",
            "local i = 0\nfunction update()\n for k = 1, 5 do i = i + 1 MakeHole({(i * 37 % 400) / 100 - 2, "
            "(i * 17 % 250) / 100, 0.15}, 0.3, 0.3) end\nend");
        int i = 0;
        const auto inC = [&] {
            for (int step = 0; step < kSteps; ++step) {
                for (int k = 0; k < 5; ++k) {
                    ++i;
                    auto carve = sized<rubble_carve>();
                    carve.position[0] = (i * 37 % 400) / 100.0 - 2.0;
                    carve.position[1] = (i * 17 % 250) / 100.0;
                    carve.position[2] = 0.15;
                    carve.radii[0] = carve.radii[1] = 0.3;
                    uint64_t removed = 0;
                    if (counts) plain.api->count_carve(plain.world, &carve, &removed);
                    plain.api->carve(plain.world, &carve);
                }
                plain.api->step(plain.world);
                auto events = sized<rubble_events>();  // as every host does
                plain.api->get_events(plain.world, &events);
            }
        };
        const auto inLua = [&] {
            for (int step = 0; step < kSteps; ++step) scripted.host->step();
        };
        const double first = secondsOf(round % 2 ? std::function<void()>(inLua) : inC);  // each is first in turn
        const double second = secondsOf(round % 2 ? std::function<void()>(inC) : inLua);
        ratios.push_back(round % 2 ? first / second : second / first);
        uint64_t hashes[2] = {};
        scripted.api->get_state_hash(scripted.world, &hashes[0]);
        plain.api->get_state_hash(plain.world, &hashes[1]);
        if (hashes[0] != hashes[1]) fmt::print("holes: the two worlds differ\n");
    }
    fmt::print("{:<22} Lua / C{}: {:.3f}, with their steps\n", "MakeHole", counts ? " that counts too" : "",
               median(ratios));
}

void measureEmptyScripts() {
    Scene scene;
    for (int i = 0; i < 1000; ++i) scene.host->add(fmt::format("empty{}", i), "function update(dt) end");
    size_t memory = 0;
    for (const Script& script : scene.host->scripts()) memory += script.sandbox().memoryUsed();
    std::vector<double> with;
    for (int round = 0; round < 60; ++round) {
        with.push_back(secondsOf([&] {
            for (Script& script : scene.host->scripts()) script.call(Callback::Update, [](lua_State*) { return 0; });
        }));
    }
    fmt::print("{:<22} {:.3f} ms a step, {:.0f} KiB each\n", "1,000 empty scripts", median(with) * 1e3,
               double(memory) / 1000.0 / 1024.0);
}

}  // namespace
}  // namespace rubble::script

int main() {
    using namespace rubble::script;
    compareCalls("GetShapeVoxelCount", "GetShapeVoxelCount(s)", 20'000, [](Scene& scene) {
        static uint64_t shape = 0;
        uint32_t count = 0;
        if (!shape) scene.api->find_by_tag(scene.world, RUBBLE_KIND_SHAPE, "crate", nullptr, &shape, 1, &count);
        rubble_shape_state state = {};
        scene.api->get_shape_state(scene.world, shape, &state);
    });
    compareCalls("GetBodyTransform", "GetBodyTransform(b)", 20'000, [](Scene& scene) {
        static uint64_t body = 0;
        uint32_t count = 0;
        if (!body) scene.api->find_by_tag(scene.world, RUBBLE_KIND_BODY, "crate", nullptr, &body, 1, &count);
        rubble_body_state state = {};
        scene.api->get_body_state(scene.world, body, &state);
    });
    compareCalls("QueryRaycast", "QueryRaycast({0, 1.5, -5}, {0, 0, 1}, 100)", 10'000, [](Scene& scene) {
        rubble_ray ray = {.origin = {0, 1.5, -5}, .direction = {0, 0, 1}, .max_distance = 100.0};
        rubble_hit hit = {};
        scene.api->cast_rays(scene.world, &ray, 1, nullptr, &hit);
    });
    compareHoles(true);
    compareHoles(false);
    measureEmptyScripts();
    return 0;
}
