// The C interface: random sequences of calls with usual and wild arguments, on worlds that come and go.
#include <rubble/rubble.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "runtime/assets/rubble_file.h"
#include "tests/fuzz/random_host.h"
#include "tests/fuzz/random_world.h"
#include "tests/fuzz/scratch_folder.h"
#include "tests/fuzz/stages.h"
#include "tests/fuzz/world_model.h"

namespace rubble {

thread_local rubble_world worldInCall = 0;

namespace {

/// A log callback that calls back: it is in a call of its world, which is refused.
void callBack() {
    uint64_t hash = 0;
    if (worldInCall && api().get_state_hash(worldInCall, &hash) != RUBBLE_ERROR_BUSY) std::abort();
    if (worldInCall) reached("calls from a callback");
}

}  // namespace

const rubble_api& api() {
    static const rubble_api* table = [] {
        const rubble_api* found = nullptr;
        rubble_get_api(RUBBLE_VERSION, &found);
        rubble_host host = {};
        host.struct_size = sizeof host;
        host.log = [](void*, int32_t, const char*) { callBack(); };
        host.assertion_failed = [](void*, const char* message) {
            std::fprintf(stderr, "%s\n", message);
            std::abort();
        };
        found->set_host(&host);
        return found;
    }();
    return *table;
}

void RandomHost::run() {
    m_isHostMoved = m_decisions.oneIn(8);
    m_world = makeWorld();
    m_level = levelToRubble(randomLevel(m_decisions));
    if (api().load_level_data(m_world, m_level.data(), m_level.size()) != RUBBLE_OK) return;  // no valid level
    if (!m_decisions.oneIn(16)) limitDebris();
    if (m_decisions.oneIn(4)) {
        m_other = makeWorld();
        load(m_other);
        m_foreign = list(api().get_lights, m_other);
        for (const rubble_shape_state& each : shapeStates(m_other)) m_foreign.push_back(each.shape);
    }
    m_model.emplace(api(), m_world);
    m_isObserved = m_decisions.oneIn(8);
    if (m_other && m_decisions.oneIn(2)) startRecording();
    worldInCall = m_world;
    if (m_decisions.oneIn(16)) readInAnotherThread();
    for (uint32_t i = 8 + m_decisions.below(24); i-- > 0;) {
        m_decisions.oneIn(4) ? callWhole() : call();
        if (m_isObserved && !m_hasLoaded) m_model->requireUnchanged();
        if (m_hasLoaded) m_model->restart(), m_hasLoaded = false;
    }
    worldInCall = 0;
    if (m_isRecorded) playInOther();
    if (m_decisions.oneIn(4)) saveAndLoad();
    reached("inputs run to their end");
}

void RandomHost::call() {
    if (m_decisions.oneIn(m_isHostMoved ? 4 : 16)) callHostPhysics();
    switch (m_decisions.below(15)) {
        case 13:
        case 14:
            return callCreate();
        case 12:
            return callState();
        case 0:
        case 1:
        case 2:
            return m_model->step();
        case 3:
        case 4:
            return callEdit();
        case 5:
            return callJoint();
        case 6:
            return callRegion();
        case 7:
            return callCharacter();
        case 8:
            return callLight();
        case 9:
            return callQuery();
        case 10:
            return callUndo();
        default:
            return m_decisions.oneIn(6) ? callFile() : callEdit();
    }
}

void RandomHost::callRows() {
    auto rows = sized<rubble_row_list>();
    rows.kind = whole(9), rows.row_size = m_decisions.oneIn(2) ? 0 : whole(400), rows.body = any(bodies());
    if (m_decisions.oneIn(2)) rows.body = 0;
    if (rows.row_size > 400) rows.row_size = 8;
    std::vector<unsigned char> bytes(4 * 400);
    uint32_t count = 0;
    api().read_rows(m_world, &rows, bytes.data(), m_decisions.below(5), &count);
    uint64_t here = 0;
    api().translate_handle(m_world, any(shapes()), &here);
    rubble_body_state body = {};
    api().get_body_state(m_world, any(bodies()), &body);
    rubble_shape_state shape = {};
    api().get_shape_state(m_world, any(shapes()), &shape);
    rubble_character_state character = {};
    api().get_character_state(m_world, any(characters()), &character);
    rubble_hit hit = {};
    double from[3], along[3];
    place(from), fill(along, 1.0);
    api().cast_ray(m_world, from, along, number(100.0), &hit);
}

void RandomHost::callQuery() {
    rubble_hit hit = {};
    rubble_ray ray = {};
    place(ray.origin), fill(ray.direction, 1.0);
    ray.max_distance = number(100.0), ray.radius = m_decisions.oneIn(2) ? 0.0 : number(2.0);
    auto filter = sized<rubble_query_filter>();
    filter.flags = whole(16), filter.layer_mask = whole(256);
    api().cast_rays(m_world, &ray, 1, m_decisions.oneIn(2) ? &filter : nullptr, &hit);
    rubble_shape_cast cast = {};
    cast.shape.kind = whole(3), place(cast.shape.position), place(cast.shape.end), rotation(cast.shape.rotation);
    cast.shape.radius = number(2.0), fill(cast.shape.half_size, 2.0), fill(cast.direction, 1.0);
    cast.max_distance = number(50.0);
    api().cast_shapes(m_world, &cast, 1, nullptr, &hit);
    uint64_t found[4];
    uint32_t count = 0;
    api().overlap_bodies(m_world, &cast.shape, nullptr, found, 4, &count);
    api().overlap_shapes(m_world, &cast.shape, &filter, found, 4, &count);
    api().find_closest_point(m_world, ray.origin, ray.max_distance, nullptr, &hit);
}

void RandomHost::callState() {
    auto events = sized<rubble_events>();
    api().get_events(m_world, &events);
    uint64_t found[4];
    uint32_t count = 0;
    api().get_trigger_bodies(m_world, any(list(api().get_triggers)), found, 4, &count);
    api().get_added_lights(m_world, found, 4, &count);
    auto light = sized<rubble_light_settings>();
    api().get_light_settings(m_world, any(list(api().get_lights)), &light);
    auto accounting = sized<rubble_voxel_accounting>();
    api().get_voxel_accounting(m_world, &accounting);
    auto stats = sized<rubble_step_stats>();
    api().get_step_stats(m_world, &stats);
    auto weather = sized<rubble_environment>();
    double direction[3];
    fill(direction, 1.0);
    api().get_environment(m_world, &weather);
    api().apply_sky_model(&weather, direction);
    if (m_decisions.oneIn(2)) api().set_environment(m_world, &weather);
    auto bounds = sized<rubble_bounds>();
    api().get_bounds(m_world, &bounds);
    bounds.rule = whole(3), place(bounds.low), place(bounds.high);
    if (m_decisions.oneIn(2)) api().set_bounds(m_world, &bounds);
    callObjects();
    callPalette();
    callMaterials();
    callProperties();
    callReports();
    callBricks();
    callParticles();
    const uint64_t stale = any({});
    api().set_debug_view(stale, "normal");
    api().destroy_renderer(stale);
    api().draw(stale, nullptr);
    api().get_draw_stats(stale, nullptr);
}

void RandomHost::callMaterials() {
    const char* names[] = {"wood", "own", "", "\xff", nullptr};
    const char* styles[] = {"chunk", "pane", "none", "dust", nullptr};
    auto row = sized<rubble_material>();
    uint32_t count = 0;
    api().get_material_count(m_world, &count);
    api().find_material(m_world, names[m_decisions.below(5)], &count);
    if (api().get_material(m_world, whole(21), &row) != RUBBLE_OK || !m_decisions.oneIn(3)) return;
    if (m_decisions.oneIn(4)) row.name = names[m_decisions.below(5)];
    if (m_decisions.oneIn(4)) row.fragments = styles[m_decisions.below(5)];
    row.density = whole(9000), row.hardness = whole(6), row.tools = whole(16);
    row.friction = number(1.0), row.restitution = number(1.0), row.burn_time = number(20.0);
    api().set_materials(m_world, whole(22), &row, m_decisions.oneIn(m_wildness * 4) ? 0 : 1);
}

void RandomHost::callProperties() {
    auto body = sized<rubble_body_properties>();
    api().get_body_properties(m_world, any(bodies()), &body);
    auto properties = sized<rubble_shape_properties>();
    rubble_cell_box boxes[4] = {};
    uint32_t count = 0;
    api().get_shape_properties(m_world, any(shapes()), &properties);
    api().get_anchors(m_world, any(shapes()), boxes, 4, &count);
    auto change = sized<rubble_shape_change>();
    change.shape = any(shapes()), change.fields = whole(64);
    change.strength = number(3.0), change.density = number(3.0), change.emission = number(3.0);
    change.bears_load = whole(2);
    for (rubble_cell_box& box : boxes)
        for (int a = 0; a < 3; ++a) box.low[a] = int32_t(whole(8)) - 2, box.size[a] = int32_t(1 + whole(4));
    change.anchors = boxes, change.anchor_count = m_decisions.below(5);
    if (m_decisions.oneIn(4)) api().set_shape(m_world, &change);
    const auto groups = [](rubble_world world, uint64_t* out, uint32_t capacity, uint32_t* all) {
        return api().get_objects(world, RUBBLE_KIND_LIGHT_GROUP, out, capacity, all);
    };
    auto state = sized<rubble_light_group_state>();
    auto made = sized<rubble_light_group_settings>();
    made.flicker_steps = whole(9), made.threshold = number(1.0);
    rubble_light_group held = 0;
    if (m_decisions.oneIn(8) && api().create_light_group(m_world, &made, &held) == RUBBLE_OK)
        m_model->mirror().made(RUBBLE_KIND_LIGHT_GROUP, held);
    auto group = sized<rubble_light_group_change>();
    group.group = any(list(groups)), group.fields = whole(8), group.on = whole(2), group.threshold = number(1.0);
    group.supply_shape = any(shapes());
    api().get_light_group(m_world, group.group, &state);
    if (m_decisions.oneIn(4)) api().set_light_group(m_world, &group);
}

void RandomHost::callPalette() {
    auto range = sized<rubble_palette_range>();
    range.shape = any(shapes());
    range.first = whole(8), range.count = 1 + whole(4);
    range.entry_size = m_decisions.oneIn(8) ? whole(64) : 0;
    constexpr size_t kLargest = 4096;  // bytes of a row that a host may name
    const size_t rows = std::min(range.count, 255u) + 1, row = sizeof(rubble_palette_entry);
    const size_t bytes = rows * std::clamp<size_t>(range.entry_size, row, kLargest);
    std::vector<rubble_palette_entry> entries((bytes + row - 1) / row);
    api().get_palette(m_world, &range, entries.data());
    entries[0].material = uint8_t(whole(20)), entries[0].emission = number(4.0);
    const auto groups = [](rubble_world world, uint64_t* out, uint32_t capacity, uint32_t* count) {
        return api().get_objects(world, RUBBLE_KIND_LIGHT_GROUP, out, capacity, count);
    };
    if (m_decisions.oneIn(4)) entries[0].light_group = any(list(groups));
    range.flags = whole(2);
    api().set_palette(m_world, &range, entries.data());
}

void RandomHost::callUndo() {
    switch (m_decisions.below(4)) {
        case 0:
            return void(api().set_undo_limit(m_world, whole(5)));
        case 1:
            return void(api().add_undo_mark(m_world));
        case 2:
            if (api().undo(m_world) == RUBBLE_OK) m_model->mirror().forget(), m_undoWaits = true;
            return;
        default:
            if (api().redo(m_world) == RUBBLE_OK) m_model->mirror().forget(), m_undoWaits = true;
    }
}

void RandomHost::callFile() {
    if (std::exchange(m_undoWaits, false)) m_model->step();
    m_isRecorded = false, m_hasLoaded = true;
    if (m_decisions.oneIn(4)) return loadData();
    if (m_decisions.oneIn(4)) return followByDeltas();
    if (m_decisions.oneIn(2)) return saveAndLoad();
    api().start_recording(m_world, scratchPath("game.rubblelog").c_str());
    for (uint32_t i = m_decisions.below(4); i-- > 0;) callEdit(), m_model->step();
    if (api().stop_recording(m_world) != RUBBLE_OK) std::abort();
    uint64_t steps = 0;
    if (api().play_recording(m_world, scratchPath("game.rubblelog").c_str(), &steps) != RUBBLE_OK)
        fail("play_recording");
}

void RandomHost::saveAndLoad() {
    if (std::exchange(m_undoWaits, false)) m_model->step();
    uint64_t before = 0, after = 0;
    api().get_resolved_hash(m_world, &before);   // the state has searches that a save begins again
    const bool usesFile = m_decisions.oneIn(8);  // files cost more than worlds
    const std::vector<uint8_t> data = usesFile ? std::vector<uint8_t>() : saved();
    if (usesFile && api().save_game(m_world, scratchPath("game.rubble").c_str()) != RUBBLE_OK) fail("save_game");
    api().get_resolved_hash(m_world, &after);
    if (before != after) fail("a save changed the world");
    api().get_state_hash(m_world, &before);
    const rubble_result loaded = usesFile ? api().load_game(m_world, scratchPath("game.rubble").c_str())
                                          : api().load_game_data(m_world, data.data(), data.size());
    if (loaded != RUBBLE_OK) fail("load_game");
    api().get_state_hash(m_world, &after);
    if (before != after) fail("another hash after load_game");
    m_isRecorded = false, m_hasLoaded = true;
}

std::vector<uint8_t> RandomHost::saved() {
    uint64_t size = 0;
    std::vector<uint8_t> data(64 * 1024);
    rubble_result result = api().save_game_data(m_world, data.data(), data.size(), &size);
    data.resize(size);
    if (result == RUBBLE_ERROR_CAPACITY) result = api().save_game_data(m_world, data.data(), size, &size);
    if (result != RUBBLE_OK) fail("save_game_data");
    return data;
}

std::string RandomHost::levelPath() const {
    std::string path = scratchPath("level.rubble");
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(m_level.data()), long(m_level.size()));
    return path;
}

void RandomHost::loadData() {
    std::vector<uint8_t> data = saved();
    uint64_t size = data.size(), steps = 0;
    for (uint32_t i = m_decisions.below(3); i-- > 0;)
        data[m_decisions.below(uint32_t(size))] ^= uint8_t(m_decisions.bits());
    if (m_decisions.oneIn(4)) size = m_decisions.below(uint32_t(size));
    if (api().load_game_data(m_world, data.data(), size) == RUBBLE_OK) reached("games loaded from memory");
    double progress = 0.0;
    api().get_loading_progress(m_world, &progress);
    if (m_decisions.oneIn(2)) api().start_loading(m_world, levelPath().c_str(), nullptr);
    if (m_decisions.oneIn(2)) api().finish_loading(m_world);
    api().load_level_data(m_world, data.data(), size);
    api().play_recording_data(m_world, data.data(), size, &steps);
}

rubble_world RandomHost::makeWorld() {
    rubble_world_settings settings = {};
    settings.struct_size = sizeof settings;
    settings.flags = m_decisions.oneIn(8) ? RUBBLE_WORLD_SHADOW_INLINE : RUBBLE_WORLD_NO_RENDERER;
    if (m_isHostMoved) settings.flags |= RUBBLE_WORLD_HOST_PHYSICS;
    if (m_decisions.oneIn(8)) settings.flags |= RUBBLE_WORLD_SHADOW_DATA;
    if (m_decisions.oneIn(8)) settings.flags |= RUBBLE_WORLD_PARTICLES;
    settings.physics_threads = m_decisions.oneIn(2048) ? 3 : 0;  // threads that wait for each other are slow
    rubble_world world = 0;
    if (api().create_world(&settings, &world) != RUBBLE_OK) fail("create_world");
    return world;
}

void RandomHost::load(rubble_world world) {
    if (api().load_level(world, levelPath().c_str(), nullptr) != RUBBLE_OK) fail("load_level");
}

void RandomHost::limitDebris() {
    auto settings = rubble_settings{.struct_size = sizeof(rubble_settings)};
    if (api().get_settings(m_world, &settings) != RUBBLE_OK) fail("get_settings");
    settings.debris_bodies = 24, settings.awake_debris_bodies = 8, settings.fragments_per_break = 12;
    if (api().set_settings(m_world, &settings) != RUBBLE_OK) fail("set_settings");
}

void RandomHost::startRecording() {
    if (api().start_recording(m_world, scratchPath("whole.rubblelog").c_str()) != RUBBLE_OK) fail("start_recording");
    m_isRecorded = true;
    m_model->restart();
}

void RandomHost::playInOther() {
    uint64_t steps = 0, here = 0, there = 0;
    m_model->step();  // what waits is in no recorded step
    if (api().stop_recording(m_world) != RUBBLE_OK) fail("stop_recording");
    if (api().play_recording(m_other, scratchPath("whole.rubblelog").c_str(), &steps) != RUBBLE_OK)
        fail("play_recording in another world");
    api().get_state_hash(m_world, &here);
    api().get_state_hash(m_other, &there);
    if (here != there) fail("another hash of a recording in another world");
    reached("recordings played in another world");
}

void RandomHost::readInAnotherThread() {
    worldInCall = 0;
    std::thread reader([world = m_world] {
        for (int i = 0; i < 20; ++i) {
            rubble_voxel_accounting sums = {};
            sums.struct_size = sizeof sums;
            uint64_t hash = 0;
            const rubble_result hashed = api().get_state_hash(world, &hash);
            const rubble_result counted = api().get_voxel_accounting(world, &sums);
            if (hashed != RUBBLE_OK && hashed != RUBBLE_ERROR_BUSY) std::abort();
            if (counted != RUBBLE_OK && counted != RUBBLE_ERROR_BUSY) std::abort();
        }
    });
    for (int i = 0; i < 4; ++i) callEdit(), api().step(m_world);  // not by the model, whose reads would be refused
    reader.join();
    worldInCall = m_world;
    m_model->restart();
    reached("inputs with two threads");
}

void fuzz(Decisions& decisions) {
    RandomHost(decisions).run();
}

}  // namespace rubble
