#include <algorithm>

#include "runtime/assets/assets.h"
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/settings.h"
#include "runtime/world/settings/settings_error.h"

namespace rubble::abi {
namespace {

constexpr NumberRange kPhysicsThreads{1, 64};

FrameLoopSettings loopSettings(const rubble_world_settings& given) {
    const uint32_t flags = given.flags;
    readFlags(flags,
              RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_SHADOW_INLINE | RUBBLE_WORLD_WAIT_FOR_SHADOW |
                  RUBBLE_WORLD_SHADOW_DATA | RUBBLE_WORLD_PARTICLES,
              "settings->flags");
    FrameLoopSettings settings;
    settings.publish = !(flags & RUBBLE_WORLD_NO_RENDERER);
    settings.moveParticles = flags & RUBBLE_WORLD_PARTICLES;
    settings.copyShadow = flags & RUBBLE_WORLD_SHADOW_DATA;
    settings.shadowVolume = settings.publish || settings.copyShadow;
    settings.shadow = flags & RUBBLE_WORLD_SHADOW_INLINE ? ShadowWorker::Mode::Inline : ShadowWorker::Mode::Thread;
    settings.waitForShadow = flags & RUBBLE_WORLD_WAIT_FOR_SHADOW;
    settings.physicsThreads =
        int(readOrDefault(given.physics_threads, kPhysicsThreads, 1, "settings->physics_threads"));
    return settings;
}

rubble_result createWorld(const rubble_world_settings* settings, rubble_world* out) {
    return guarded("create_world", [&] {
        if (!isGiven(out, "out")) return;
        *out = 0;
        const FrameLoopSettings read =
            loopSettings(settings ? readStruct(settings, "settings") : rubble_world_settings{});
        if (!isRefused()) *out = Registry::instance().createWorld(read, read.publish).bits;
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

rubble_result step(rubble_world world) {
    return inWorld("step", world, [&](HostedWorld& hosted) {
        change(hosted, [&] { hosted.loop.step(); });
        hosted.listStep();
    });
}

rubble_result setBounds(rubble_world world, const rubble_bounds* bounds) {
    return pushEdit("set_bounds", world, bounds, [](const World&, const rubble_bounds& given) {
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

// ---- undo ----

rubble_result setUndoLimit(rubble_world world, uint32_t marks) {
    return inWorld("set_undo_limit", world, [&](HostedWorld& hosted) {
        WorldSettings settings = waitingSettings(hosted);
        settings.undoMarks = marks;
        push(hosted, SettingsEdit{settings});
    });
}

bool goesBackOrForth(const Edit& edit) {
    const auto* history = std::get_if<HistoryEdit>(&edit);
    return history && history->action != HistoryAction::Mark;
}

rubble_result pushHistory(const char* function, rubble_world world, HistoryAction action) {
    return inWorld(function, world, [&](HostedWorld& hosted) {
        const Edits& waiting = hosted.loop.edits().waiting();
        if (action != HistoryAction::Mark && std::any_of(waiting.begin(), waiting.end(), goesBackOrForth))
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
    api.step = step;
    api.set_bounds = setBounds;
    api.get_bounds = getBounds;
    api.set_undo_limit = setUndoLimit;
    api.add_undo_mark = addUndoMark;
    api.undo = undo;
    api.redo = redo;
}

}  // namespace rubble::abi
