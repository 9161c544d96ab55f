#include <string>

#include "runtime/assets/assets.h"
#include "runtime/core/log.h"
#include "runtime/plugin/c_abi/checks.h"
#include "runtime/plugin/c_abi/edits.h"
#include "runtime/plugin/c_abi/guard.h"
#include "runtime/plugin/c_abi/joints.h"
#include "runtime/plugin/c_abi/lights.h"
#include "runtime/plugin/c_abi/queries.h"
#include "runtime/plugin/c_abi/reads.h"
#include "runtime/plugin/c_abi/regions.h"
#include "runtime/plugin/c_abi/registry.h"

// The table of rubble.h. Inside a function a wrong call throws; guarded() makes a result of it, and nothing gets out.
namespace rubble::abi {
namespace {

thread_local std::string g_lastError;
rubble_host g_host = {};

}  // namespace

rubble_result storeLastError(const char* function, const ApiError& refusal) {
    g_lastError = std::string(function) + ": " + refusal.text;
    return refusal.code;
}

namespace {

const char* getLastError() {
    return g_lastError.c_str();
}

void logToHost(void*, LogLevel level, std::string_view message) {
    const std::string text(message);
    g_host.log(g_host.user, int32_t(level), text.c_str());
}

rubble_result setHost(const rubble_host* host) {
    return guarded("set_host", [&] {
        const rubble_host services = host ? readStruct(host, "host") : rubble_host{};
        setLogSink(nullptr, nullptr);
        g_host = services;
        if (g_host.log) setLogSink(logToHost, nullptr);
    });
}

// ---- worlds ----

FrameLoopSettings loopSettings(uint32_t flags) {
    constexpr uint32_t known = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_SHADOW_INLINE | RUBBLE_WORLD_WAIT_FOR_SHADOW;
    if (flags & ~known)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "settings->flags has unknown bits: " + std::to_string(flags)};
    FrameLoopSettings settings;
    settings.publish = settings.shadowVolume = !(flags & RUBBLE_WORLD_NO_RENDERER);
    settings.shadow = flags & RUBBLE_WORLD_SHADOW_INLINE ? ShadowWorker::Mode::Inline : ShadowWorker::Mode::Thread;
    settings.waitForShadow = flags & RUBBLE_WORLD_WAIT_FOR_SHADOW;
    return settings;
}

rubble_result createWorld(const rubble_world_settings* settings, rubble_world* out) {
    return guarded("create_world", [&] {
        requireNotNull(out, "out") = 0;
        const FrameLoopSettings read = loopSettings(settings ? readStruct(settings, "settings").flags : 0);
        *out = Registry::instance().createWorld(read, read.publish).bits;
    });
}

rubble_result destroyWorld(rubble_world world) {
    return guarded("destroy_world",
                   [&] { Registry::instance().destroyWorld(readHandle<HandleType::World>(world, "world")); });
}

rubble_result loadLevel(rubble_world world, const char* path, const char* vdbTool) {
    return guarded("load_level", [&] {
        const auto hosted = Registry::instance().world(world);
        const Result<Level> level = readLevel(&requireNotNull(path, "path"), vdbTool ? vdbTool : "");
        if (!level) throw ApiError{RUBBLE_ERROR_FILE, level.error()};
        hosted->loop.load(*level);
    });
}

rubble_result step(rubble_world world) {
    return guarded("step", [&] {
        const auto hosted = Registry::instance().world(world);
        hosted->loop.step();
        hosted->events.fill(hosted->loop.changes());
    });
}

// ---- edits ----

constexpr auto kToEdit = [](const World& world, const auto& given) { return toEdit(world, given); };

rubble_result carve(rubble_world world, const rubble_carve* edit) {
    return pushEdit("carve", world, edit, kToEdit);
}
rubble_result breakVoxels(rubble_world world, const rubble_break* edit) {
    return pushEdit("break_voxels", world, edit, kToEdit);
}
rubble_result explode(rubble_world world, const rubble_explosion* edit) {
    return pushEdit("explode", world, edit, kToEdit);
}
rubble_result paint(rubble_world world, const rubble_paint* edit) {
    return pushEdit("paint", world, edit, kToEdit);
}
rubble_result applyImpulse(rubble_world world, const rubble_impulse* edit) {
    return pushEdit("apply_impulse", world, edit, kToEdit);
}

// ---- reads ----

rubble_result events(rubble_world world, rubble_events* out) {
    return guarded("get_events", [&] { writeStruct(out, Registry::instance().world(world)->events.view()); });
}

rubble_result getBodyStates(rubble_world world, rubble_body_state* out, uint32_t capacity, uint32_t* count) {
    return guarded("get_body_states", [&] {
        const auto hosted = Registry::instance().world(world);
        RowWriter<rubble_body_state> rows(out, capacity, count);
        hosted->loop.world().bodies().forEach(
            [&](BodyHandle handle, const Body& body) { rows.add([&] { return bodyState(handle, body); }); });
        rows.finish();
    });
}

const Body& bodyOf(const World& world, rubble_body bits) {
    const Body* body = world.bodies().find(readHandle<HandleType::Body>(bits, "body"));
    if (!body) throw ApiError{RUBBLE_ERROR_STALE, bits ? "body is stale" : "body is 0"};
    return *body;
}

rubble_result getBodyState(rubble_world world, rubble_body body, rubble_body_state* out) {
    return guarded("get_body_state", [&] {
        const auto hosted = Registry::instance().world(world);
        requireNotNull(out, "out") = bodyState(BodyHandle{body}, bodyOf(hosted->loop.world(), body));
    });
}

rubble_result getShapeStates(rubble_world world, rubble_body body, rubble_shape_state* out, uint32_t capacity,
                             uint32_t* count) {
    return guarded("get_shape_states", [&] {
        const auto hosted = Registry::instance().world(world);
        const World& inside = hosted->loop.world();
        RowWriter<rubble_shape_state> rows(out, capacity, count);
        const auto add = [&](ShapeHandle handle, const Shape& shape) {
            rows.add([&] { return shapeState(inside, handle, shape); });
        };
        if (body)
            for (const ShapeHandle handle : bodyOf(inside, body).shapes) add(handle, inside.shapes().at(handle));
        else
            inside.shapes().forEach(add);
        rows.finish();
    });
}

rubble_result raycast(rubble_world world, const double origin[3], const double direction[3], double maxDistance,
                      rubble_hit* out) {
    return guarded("raycast", [&] {
        const auto hosted = Registry::instance().world(world);
        const glm::dvec3 from =
            readVector(reinterpret_cast<const double(&)[3]>(requireNotNull(origin, "origin")), "origin");
        const glm::dvec3 along =
            readVector(reinterpret_cast<const double(&)[3]>(requireNotNull(direction, "direction")), "direction");
        if (along == glm::dvec3(0.0)) throw ApiError{RUBBLE_ERROR_ARGUMENT, "direction is zero"};
        const double reach = readOrDefault(maxDistance, 1e-6, 1e6, 0.0, "max_distance");
        const World& inside = hosted->loop.world();
        writeStruct(out, hitState(inside, inside.raycast(from, along, reach)));
    });
}

rubble_result getStateHash(rubble_world world, uint64_t* out) {
    return guarded("get_state_hash",
                   [&] { requireNotNull(out, "out") = Registry::instance().world(world)->loop.world().hash(); });
}

rubble_result ledger(rubble_world world, rubble_voxel_accounting* out) {
    return guarded("get_voxel_accounting", [&] {
        const VoxelAccounting all = Registry::instance().world(world)->loop.world().voxelAccounting();
        rubble_voxel_accounting rows = {};
        rows.imported = all.imported;
        rows.standing = all.standing;
        rows.in_pieces = all.inPieces;
        rows.removed = all.removed;
        writeStruct(out, rows);
    });
}

rubble_result figures(rubble_world world, rubble_step_stats* out) {
    return guarded("get_step_stats", [&] {
        const auto hosted = Registry::instance().world(world);
        FrameLoop& loop = hosted->loop;
        const PhysicsStats physics = loop.physics().stats();
        const StageTimes& times = loop.times();
        rubble_step_stats rows = {};
        rows.bodies = uint32_t(physics.bodies);
        rows.bodies_awake = uint32_t(physics.awake);
        rows.contacts = uint32_t(physics.contacts);
        rows.step = loop.world().step();
        rows.shadow_lag = loop.shadowLag();
        rows.edits_ms = times[Stage::ApplyEdits];
        rows.physics_ms = times[Stage::Physics];
        rows.poses_ms = times[Stage::Poses];
        rows.impacts_ms = times[Stage::Impacts];
        rows.shadow_ms = times[Stage::Shadow];
        rows.publish_ms = times[Stage::Publish];
        writeStruct(out, rows);
    });
}

// ---- renderer ----

std::string readPreset(const char* preset) {
    const std::string name = preset ? preset : "balanced";
    if (name != "fast" && name != "balanced" && name != "accurate")
        throw ApiError{RUBBLE_ERROR_ARGUMENT,
                       "settings->preset is \"" + name + "\", expected fast, balanced or accurate"};
    return name;
}

rubble_result createRenderer(rubble_world world, const rubble_renderer_settings* settings, rubble_renderer* out) {
    return guarded("create_renderer", [&] {
        requireNotNull(out, "out") = 0;
        const auto hosted = Registry::instance().world(world);
        const rubble_renderer_settings& read = readStruct(settings, "settings");
        const std::string folder = &requireNotNull(read.shader_folder, "settings->shader_folder");
        const RenderSettings preset = RenderSettings::preset(readPreset(read.preset));
        if (!g_host.gl_get_proc_address) throw ApiError{RUBBLE_ERROR_GL, "the host has set no gl_get_proc_address"};
        if (!hosted->drawable)
            throw ApiError{RUBBLE_ERROR_ARGUMENT, "the world was created with RUBBLE_WORLD_NO_RENDERER"};
        if (hosted->hadRenderer)
            throw ApiError{RUBBLE_ERROR_ARGUMENT, "the world has or had a renderer; it can have one"};
        Result<std::unique_ptr<Renderer>> renderer = Renderer::create(g_host.gl_get_proc_address, folder, preset);
        if (!renderer) throw ApiError{RUBBLE_ERROR_GL, renderer.error()};
        hosted->hadRenderer = true;
        *out = Registry::instance()
                   .addRenderer(std::make_shared<HostedRenderer>(HostedRenderer{hosted, std::move(*renderer)}))
                   .bits;
    });
}

View readView(const rubble_view& given) {
    constexpr uint32_t largest = 16384;
    if (given.width < 1 || given.width > largest || given.height < 1 || given.height > largest)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "view is " + std::to_string(given.width) + " x " +
                                                  std::to_string(given.height) + " pixels, expected 1 to 16384"};
    if (given.flags & ~uint32_t(RUBBLE_VIEW_CUT)) throw ApiError{RUBBLE_ERROR_ARGUMENT, "view->flags has unknown bits"};
    View view;
    view.position = readVector(given.position, "position");
    view.rotation = readRotation(given.rotation, "rotation");
    view.verticalFov = float(readOrDefault(given.vertical_fov, 0.01, 3.0, view.verticalFov, "vertical_fov"));
    view.size = glm::ivec2(given.width, given.height);
    view.framebuffer = given.framebuffer;
    view.cut = given.flags & RUBBLE_VIEW_CUT;
    return view;
}

rubble_result draw(rubble_renderer renderer, const rubble_view* view) {
    return guarded("draw", [&] {
        const auto hosted = Registry::instance().renderer(renderer);
        const auto world = hosted->world.lock();
        if (!world) throw ApiError{RUBBLE_ERROR_STALE, "the renderer's world is destroyed"};
        const rubble_view& given = readStruct(view, "view");
        const double alpha = readOrDefault(given.alpha, 0.0, 1.0, 0.0, "alpha");
        world->loop.draw(*hosted->renderer, readView(given), float(alpha));
        if (const std::string& lastError = hosted->renderer->lastError(); !lastError.empty())
            throw ApiError{RUBBLE_ERROR_GL, lastError};
        hosted->applyMs = world->loop.times()[Stage::Apply];
        hosted->drawMs = world->loop.times()[Stage::Draw];
    });
}

rubble_result setDebugView(rubble_renderer renderer, const char* name) {
    return guarded("set_debug_view", [&] {
        const auto hosted = Registry::instance().renderer(renderer);
        if (hosted->renderer->showPass(name ? name : "final")) return;
        std::string text = "no pass \"" + std::string(name ? name : "final") + "\", there are:";
        for (const std::string& pass : hosted->renderer->passNames()) text += " " + pass;
        throw ApiError{RUBBLE_ERROR_ARGUMENT, text};
    });
}

rubble_result getDrawStats(rubble_renderer renderer, rubble_draw_stats* out) {
    return guarded("get_draw_stats", [&] {
        const auto hosted = Registry::instance().renderer(renderer);
        const RenderFigures& all = hosted->renderer->figures();
        rubble_draw_stats rows = {};
        rows.draw_calls = uint32_t(all.drawCalls);
        rows.shapes = uint32_t(all.shapes);
        rows.bricks = uint32_t(all.bricks);
        rows.upload_bytes = all.uploadBytes;
        rows.texture_bytes = all.textureBytes;
        rows.apply_ms = hosted->applyMs;
        rows.draw_ms = hosted->drawMs;
        writeStruct(out, rows);
    });
}

rubble_result destroyRenderer(rubble_renderer renderer) {
    return guarded("destroy_renderer", [&] {
        Registry::instance().destroyRenderer(readHandle<HandleType::Renderer>(renderer, "renderer"));
    });
}

// ---- saves, recordings, undo ----

void requireDone(const Result<Done>& done) {
    if (!done) throw ApiError{RUBBLE_ERROR_FILE, done.error()};
}

rubble_result save(rubble_world world, const char* path) {
    return guarded("save_game", [&] {
        const auto hosted = Registry::instance().world(world);
        requireDone(writeSave(&requireNotNull(path, "path"), hosted->loop.save()));
    });
}

rubble_result loadGame(rubble_world world, const char* path) {
    return guarded("load_game", [&] {
        const auto hosted = Registry::instance().world(world);
        Result<SavedGame> game = readSave(&requireNotNull(path, "path"), hosted->loop.world().id());
        if (!game) throw ApiError{RUBBLE_ERROR_FILE, game.error()};
        hosted->loop.load(std::move(*game));
    });
}

rubble_result startRecording(rubble_world world, const char* path) {
    return guarded("start_recording", [&] {
        requireDone(Registry::instance().world(world)->loop.startRecording(&requireNotNull(path, "path")));
    });
}

rubble_result stopRecording(rubble_world world) {
    return guarded("stop_recording", [&] { requireDone(Registry::instance().world(world)->loop.stopRecording()); });
}

rubble_result replay(rubble_world world, const char* path, uint64_t* steps) {
    return guarded("play_recording", [&] {
        if (steps) *steps = 0;
        const auto hosted = Registry::instance().world(world);
        FrameLoop& loop = hosted->loop;
        Result<Recording> recording = readRecording(&requireNotNull(path, "path"), loop.world().id());
        if (!recording) throw ApiError{RUBBLE_ERROR_FILE, recording.error()};
        loop.load(std::move(recording->start));
        for (const RecordedStep& step : recording->steps) {
            loop.replay(step);
            hosted->events.fill(loop.changes());
            if (loop.world().hash() != step.hash)
                throw ApiError{RUBBLE_ERROR_FILE, std::string(path) + ": step " + std::to_string(step.step) +
                                                      " went another way than was recorded"};
            if (steps) ++*steps;
        }
    });
}

rubble_result pushHistory(const char* function, rubble_world world, HistoryAction action) {
    return guarded(function, [&] { Registry::instance().world(world)->loop.edits().push(HistoryEdit{action}); });
}

rubble_result setUndoLimit(rubble_world world, uint32_t marks) {
    return guarded("set_undo_limit", [&] {
        const auto hosted = Registry::instance().world(world);
        WorldSettings settings = hosted->loop.world().settings();
        settings.undoMarks = marks;
        hosted->loop.edits().push(SettingsEdit{settings});
    });
}

rubble_result addUndoMark(rubble_world world) {
    return pushHistory("add_undo_mark", world, HistoryAction::Mark);
}
rubble_result undo(rubble_world world) {
    return pushHistory("undo", world, HistoryAction::Undo);
}
rubble_result redo(rubble_world world) {
    return pushHistory("redo", world, HistoryAction::Redo);
}

// ---- joints ----

rubble_result addJoint(rubble_world world, const rubble_joint_settings* settings) {
    return pushEdit("add_joint", world, settings, kToEdit);
}
rubble_result removeJoint(rubble_world world, rubble_joint joint) {
    return removeOne<RemoveJointEdit, HandleType::Joint>("remove_joint", world, joint, "joint", &World::joints);
}
rubble_result setJointMotor(rubble_world world, const rubble_joint_motor* motor) {
    return pushEdit("set_joint_motor", world, motor, kToEdit);
}
rubble_result drive(rubble_world world, const rubble_drive* edit) {
    return pushEdit("drive_wheels", world, edit, kToEdit);
}
rubble_result grab(rubble_world world, const rubble_grab* edit) {
    return pushEdit("grab_body", world, edit, kToEdit);
}
rubble_result release(rubble_world world, const rubble_release* edit) {
    return pushEdit("release_body", world, edit, kToEdit);
}
rubble_result getJointStates(rubble_world world, rubble_joint_state* out, uint32_t capacity, uint32_t* count) {
    return guarded("get_joint_states", [&] {
        const auto hosted = Registry::instance().world(world);
        const World& inside = hosted->loop.world();
        RowWriter<rubble_joint_state> rows(out, capacity, count);
        inside.joints().forEach([&](JointHandle handle, const Joint& joint) {
            rows.add([&] { return jointState(inside, handle, joint); });
        });
        rows.finish();
    });
}
rubble_result ropePoints(rubble_world world, rubble_joint joint, double* out, uint32_t capacity, uint32_t* count) {
    return guarded("get_rope_points", [&] {
        const auto hosted = Registry::instance().world(world);
        RowWriter<double> rows(out, capacity, count);
        for (const RopePoint& point : jointOf(hosted->loop.world(), joint).points)
            for (int i = 0; i < 3; ++i) rows.add([&] { return point.position[i]; });
        rows.finish();
    });
}

constexpr rubble_api kApi = {
    sizeof(rubble_api),
    RUBBLE_VERSION,
    getLastError,
    setHost,
    createWorld,
    destroyWorld,
    loadLevel,
    step,
    carve,
    explode,
    paint,
    applyImpulse,
    events,
    getBodyStates,
    getBodyState,
    getShapeStates,
    raycast,
    getStateHash,
    ledger,
    figures,
    createRenderer,
    draw,
    setDebugView,
    getDrawStats,
    destroyRenderer,
    save,
    loadGame,
    startRecording,
    stopRecording,
    replay,
    setUndoLimit,
    addUndoMark,
    undo,
    redo,
    breakVoxels,
    addJoint,
    removeJoint,
    setJointMotor,
    grab,
    release,
    getJointStates,
    ropePoints,
    setCollision,
    addWater,
    removeWater,
    addTrigger,
    removeTrigger,
    addCharacter,
    removeCharacter,
    moveCharacter,
    teleportCharacter,
    waters,
    triggers,
    getCharacterStates,
    triggerEvents,
    getTriggerBodies,
    castRays,
    castShapes,
    overlapBodies,
    overlapShapes,
    closestPoint,
    drive,
    environment,
    setEnvironment,
    applySkyModel,
    lights,
    lightState,
    setLight,
    addLight,
    removeLight,
    getAddedLights,
};

}  // namespace
}  // namespace rubble::abi

extern "C" rubble_result rubble_get_api(uint32_t version, const rubble_api** table) {
    return rubble::abi::guarded("rubble_get_api", [&] {
        rubble::abi::requireNotNull(table, "table") = nullptr;
        if (version != RUBBLE_VERSION) {
            const std::string text = "version " + std::to_string(version) + " asked for, this plugin speaks " +
                                     std::to_string(RUBBLE_VERSION);
            rubble::logError("rubble_get_api: " + text);  // without a table the host cannot ask for the last error
            throw rubble::abi::ApiError{RUBBLE_ERROR_VERSION, text};
        }
        *table = &rubble::abi::kApi;
    });
}
