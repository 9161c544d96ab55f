#include <new>
#include <optional>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

rubble_result keepDeltas(rubble_world world, uint32_t on) {
    return inWorld("keep_deltas", world, [&](HostedWorld& hosted) {
        const uint32_t kind = readEnum(on & ~uint32_t(RUBBLE_DELTAS_EVENTS), RUBBLE_DELTAS_EDITS, "on");
        const bool withEvents = on & RUBBLE_DELTAS_EVENTS;
        if (withEvents && kind == RUBBLE_DELTAS_NONE)
            refuse(RUBBLE_ERROR_ARGUMENT, "on is RUBBLE_DELTAS_EVENTS alone, expected it beside one of the others");
        if (isRefused()) return;
        std::optional<DeltaContent> content;
        if (kind == RUBBLE_DELTAS_ALL) content = DeltaContent::All;
        if (kind == RUBBLE_DELTAS_EDITS) content = DeltaContent::EditsOnly;
        hosted.loop.keepDeltas(content, withEvents);
    });
}

rubble_result takeDeltas(rubble_world world, uint8_t* out, uint64_t capacity, uint64_t* count) {
    return inWorld("take_deltas", world, [&](HostedWorld& hosted) {
        if (!isGiven(count, "count")) return;
        *count = 0;
        if (capacity) isGiven(out, "out");
        DeltaWriter* kept = hosted.loop.deltas();
        if (!kept) refuse(RUBBLE_ERROR_ARGUMENT, "the world keeps no deltas: call keep_deltas() first");
        if (isRefused()) return;
        const std::vector<uint8_t> bytes = kept->file();
        if (writeBytes(bytes.data(), uint64_t(bytes.size()), out, capacity, count)) kept->clear();
    });
}

rubble_result applyDeltas(rubble_world world, const void* data, uint64_t size) {
    return inWorld("apply_deltas", world, [&](HostedWorld& hosted) {
        if (!isGiven(data, "data")) return;
        const Result<Deltas> deltas =
            deltasFromBytes({static_cast<const uint8_t*>(data), size_t(size)}, "data", hosted.loop.world().id());
        if (!deltas) return refuse(RUBBLE_ERROR_FILE, "{}", deltas.error());
        change(hosted, [&] {
            const FrameLoop& loop = hosted.loop;
            const uint64_t before = loop.world().step();
            const auto noteBricks = [&] { hosted.bricks.follow(loop.changes(), loop.world().data()); };
            if (const Result<Done> done = hosted.loop.follow(*deltas, noteBricks); !done) {
                refuse(RUBBLE_ERROR_FILE, "data: {}", done.error());
                if (loop.world().step() == before) return;
                hosted.bricks.forget();
            }
            hosted.events.fill(hosted.loop.changes());
            hosted.reports.follow(hosted.loop);
        });
    });
}

rubble_result getResolvedHash(rubble_world world, uint64_t* out) {
    return inWorld("get_resolved_hash", world, [&](const HostedWorld& hosted) {
        if (isGiven(out, "out")) *out = resolvedHash(hosted.loop.world());
    });
}

rubble_result getVoxelHash(rubble_world world, uint64_t* out) {
    return inWorld("get_voxel_hash", world, [&](const HostedWorld& hosted) {
        if (isGiven(out, "out")) *out = voxelHash(hosted.loop.world());
    });
}

}  // namespace

void setDeltaFunctions(rubble_api& api) {
    api.keep_deltas = keepDeltas;
    api.take_deltas = takeDeltas;
    api.apply_deltas = applyDeltas;
    api.get_resolved_hash = getResolvedHash;
    api.get_voxel_hash = getVoxelHash;
}

}  // namespace rubble::abi
