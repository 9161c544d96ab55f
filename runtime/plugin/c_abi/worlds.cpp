#include "runtime/assets/assets.h"
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/host_jobs.h"
#include "runtime/plugin/c_abi/waiting.h"
#include "runtime/plugin/layers.h"
#include "runtime/world/settings/settings_error.h"

namespace rubble::abi {
namespace {

constexpr NumberRange kPhysicsThreads{1, 64};

FrameLoopSettings loopSettings(const rubble_world_settings& given) {
    const uint32_t flags = given.flags;
    readFlags(flags,
              RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_SHADOW_INLINE | RUBBLE_WORLD_WAIT_FOR_SHADOW |
                  RUBBLE_WORLD_HOST_PHYSICS | RUBBLE_WORLD_ONE_THREAD | RUBBLE_WORLD_SHADOW_DATA |
                  RUBBLE_WORLD_PARTICLES,
              "settings->flags");
    FrameLoopSettings settings;
    settings.publish = hasRenderer() && !(flags & RUBBLE_WORLD_NO_RENDERER);
    settings.moveParticles = flags & RUBBLE_WORLD_PARTICLES;
    settings.copyShadow = flags & RUBBLE_WORLD_SHADOW_DATA;
    settings.shadowVolume = settings.publish || settings.copyShadow;
    settings.hostPhysics = flags & RUBBLE_WORLD_HOST_PHYSICS;
    if (!settings.hostPhysics && !hasPhysics())
        refuse(RUBBLE_ERROR_UNSUPPORTED,
               "this library has no physics: expected settings->flags with RUBBLE_WORLD_HOST_PHYSICS, or the library "
               "rubble::physics");
    settings.shadow = flags & RUBBLE_WORLD_SHADOW_INLINE ? ShadowWorker::Mode::Inline : ShadowWorker::Mode::Thread;
    settings.waitForShadow = flags & RUBBLE_WORLD_WAIT_FOR_SHADOW;
    settings.physicsThreads =
        int(readOrDefault(given.physics_threads, kPhysicsThreads, 1, "settings->physics_threads"));
    if (given.parallel_for) settings.parallelFor = HostJobs{given.user, given.parallel_for};
    return settings;
}

WorldOptions worldOptions(const rubble_world_settings& given, const FrameLoopSettings& loop) {
    WorldOptions out{.drawable = loop.publish, .services = {given.user, given.log, given.assertion_failed}};
    if (given.flags & RUBBLE_WORLD_ONE_THREAD) out.thread = std::this_thread::get_id();
    return out;
}

rubble_result createWorld(const rubble_world_settings* settings, rubble_world* out) {
    return guarded("create_world", [&] {
        if (!isGiven(out, "out")) return;
        *out = 0;
        const auto given = settings ? readStruct(settings, "settings") : rubble_world_settings{};
        const FrameLoopSettings read = loopSettings(given);
        if (!isRefused()) *out = Registry::instance().createWorld(read, worldOptions(given, read)).bits;
    });
}

rubble_result destroyWorld(rubble_world world) {
    return guarded("destroy_world", [&] {
        const auto id = readHandle<HandleType::World>(world, "world");
        if (!isRefused()) Registry::instance().destroyWorld(id);
    });
}

rubble_result loadLevel(rubble_world world, const char* path, const char* vdbTool) {
    return inWorld("load_level", world, [&](HostedWorld& hosted) {
        if (!isGiven(path, "path")) return;
        const Result<Level> level = readLevel(path, vdbTool ? vdbTool : "");
        if (!level) return refuse(RUBBLE_ERROR_FILE, "{}", level.error());
        change(hosted, [&] { hosted.loop.load(*level); });
        hosted.forgetSteps();
    });
}

rubble_result saveLevel(rubble_world world, const char* path, const char* vdbTool) {
    return inWorld("save_level", world, [&](const HostedWorld& hosted) {
        if (!isGiven(path, "path")) return;
        const Level level = toLevel(hosted.loop.world().data());
        const Result<Done> written = writeLevel(path, level, vdbTool ? vdbTool : "");
        if (!written) refuse(RUBBLE_ERROR_FILE, "{}", written.error());
    });
}

rubble_result applyEdits(rubble_world world) {
    return inWorld("apply_edits", world, [&](HostedWorld& hosted) {
        change(hosted, [&] {
            if (!hosted.loop.step(World::Follows::Nothing))
                return refuse(RUBBLE_ERROR_ARGUMENT, "a recording runs, whose steps are whole: stop it before");
            hosted.listEdits();
        });
    });
}

rubble_result hasChanged(rubble_world world, uint32_t* out) {
    return inWorld("has_changed", world, [&](const HostedWorld& hosted) {
        const std::optional<bool> differs = differsFromMark(hosted.loop.world());
        if (!differs)
            return refuse(RUBBLE_ERROR_ARGUMENT, "expected undo marks, found none: set_undo_limit() comes first");
        if (isGiven(out, "out")) *out = *differs;
    });
}

rubble_result getLevelHash(rubble_world world, uint64_t* out) {
    return inWorld("get_level_hash", world, [&](const HostedWorld& hosted) {
        if (isGiven(out, "out")) *out = hashLevel(toLevel(hosted.loop.world().data()));
    });
}

rubble_result step(rubble_world world) {
    return inWorld("step", world, [&](HostedWorld& hosted) {
        change(hosted, [&] {
            hosted.loop.step();
            hosted.listStep();
        });
    });
}

rubble_result setBounds(rubble_world world, const rubble_bounds* bounds) {
    return pushEdit("set_bounds", world, bounds, "bounds", [](const World&, const rubble_bounds& given) {
        BoundsSettings out;
        out.rule = BoundsRule(readEnum(given.rule, RUBBLE_BOUNDS_GROUND, "rule"));
        out.low = readVector(given.low, "low");
        out.high = readVector(given.high, "high");
        requireNoError(boundsError(out));
        return SetBoundsEdit{out};
    });
}

rubble_result getBounds(rubble_world world, rubble_bounds* out) {
    return inWorld("get_bounds", world, [&](const HostedWorld& hosted) {
        const World& from = hosted.loop.world();
        const WorldBox box = from.data().boundsInUse();
        rubble_bounds bounds{};
        bounds.rule = uint32_t(from.settings().bounds.rule);
        for (int a = 0; a < 3; ++a) bounds.low[a] = box.low[a], bounds.high[a] = box.high[a];
        writeStruct(out, bounds);
    });
}

rubble_result setPhysicsThreads(rubble_world world, uint32_t threads) {
    return inWorld("set_physics_threads", world, [&](HostedWorld& hosted) {
        const int count = int(readInRange(threads, kPhysicsThreads, "threads"));
        if (!isRefused()) hosted.loop.setPhysicsThreads(count);
    });
}

// ---- undo ----

rubble_result setUndoLimit(rubble_world world, uint32_t marks) {
    return inWorld("set_undo_limit", world, [&](HostedWorld& hosted) {
        WorldSettings settings = waitingSettings(hosted);
        settings.undoMarks = marks;
        push(hosted, SettingsEdit{settings});
    });
}

rubble_result pushHistory(const char* function, rubble_world world, HistoryAction action) {
    return inWorld(function, world, [&](HostedWorld& hosted) {
        if (action != HistoryAction::Mark && hasWaitingUndo(hosted))
            refuse(RUBBLE_ERROR_ARGUMENT, "expected one undo or redo in a step, found one in the queue");
        push(hosted, HistoryEdit{action});
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

}  // namespace

void setWorldFunctions(rubble_api& api) {
    api.create_world = createWorld;
    api.destroy_world = destroyWorld;
    api.load_level = loadLevel;
    api.save_level = saveLevel;
    api.step = step;
    api.apply_edits = applyEdits;
    api.has_changed = hasChanged;
    api.get_level_hash = getLevelHash;
    api.set_physics_threads = setPhysicsThreads;
    api.set_bounds = setBounds;
    api.get_bounds = getBounds;
    api.set_undo_limit = setUndoLimit;
    api.add_undo_mark = addUndoMark;
    api.undo = undo;
    api.redo = redo;
}

}  // namespace rubble::abi
