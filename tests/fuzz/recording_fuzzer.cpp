// Recordings (.rubblelog): real ones with random fields and bytes of their steps changed, in files with valid
// checksums.
#include <cstdlib>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/recording_file.h"
#include "runtime/world/history/world_baseline.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/random_world.h"
#include "tests/fuzz/stages.h"

namespace rubble {
namespace {

void mutateStep(Decisions& decisions, RecordedStep& step) {
    Mutator mutator(decisions, 1u << (3 + decisions.below(6)));
    mutator.mutate(step.edits);
    if (decisions.oneIn(2) && !step.delta.empty()) mutateBytes(decisions, step.delta);
    for (BodyPose& pose : step.poses)
        mutator.mutate(pose.body), mutator.mutate(pose.pose), mutator.mutate(pose.velocity);
    for (CharacterMove& move : step.characters)
        mutator.mutate(move.character), mutator.mutate(move.position), mutator.mutate(move.ground);
    if (decisions.oneIn(64)) step.step = decisions.below(5);
}

/// A step of the world, as the frame loop records it.
RecordedStep record(Decisions& decisions, World& world, WorldBaseline& baseline, PaletteList& palettes) {
    RecordedStep step{.edits = {randomEdit(decisions, world, 0), randomEdit(decisions, world, 0)}};
    const FrameChanges changes = world.applyEdits(step.edits);
    step.step = changes.step;
    step.delta = stepDeltaToBytes(baseline.update(world, changes), changes, world, palettes);
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (!body.isStatic && decisions.oneIn(2))
            step.poses.push_back({handle, {body.pose.position + 0.01, body.pose.rotation}, body.velocity});
    });
    world.characters().forEach([&](CharacterHandle handle, const Character& each) {
        step.characters.push_back({handle, each.position + 0.01, each.velocity});
    });
    world.setPoses(step.poses);
    world.setCharacters(step.characters);
    SlotValues<BodyHandle, Body> oldBodies;
    SlotValues<CharacterHandle, Character> oldCharacters;
    baseline.move(world, step.poses, oldBodies);
    baseline.move(world, step.characters, oldCharacters);
    step.hash = world.hash();
    return step;
}

/// Follows a recording by its deltas, as a late joiner does, then by its edits. One that nobody has changed is
/// accepted.
void follow(const Recording& recording, bool isChanged) {
    reached("files accepted");
    World joiner, player;
    joiner.setState(recording.start.world);
    player.setState(recording.start.world);
    std::vector<PaletteRef> palettes;
    for (const RecordedStep& step : recording.steps) {
        const uint64_t before = joiner.hash();
        if (const Result<FrameChanges> applied = applyStepDelta(step.delta, "delta", joiner, palettes); !applied) {
            if (joiner.hash() != before || !isChanged) std::abort();
            reached("deltas refused");
            break;
        }
        joiner.setPoses(step.poses);
        joiner.setCharacters(step.characters);
    }
    requireReadableSave(joiner);
    for (const RecordedStep& step : recording.steps) player.applyEdits(step.edits);
    requireReadableSave(player);
}

}  // namespace

void fuzz(Decisions& decisions) {
    World world;
    world.load(randomLevel(decisions));
    world.applyEdits({});
    world.resetCaches();
    ChunkWriter file;
    file.add({'G', 'A', 'M', 'E'}, gameToBytes({world.state(), {}}));
    WorldBaseline baseline(world);
    PaletteList palettes;
    const bool isChanged = !decisions.oneIn(8);
    for (uint32_t i = 1 + decisions.below(4); i-- > 0;) {
        RecordedStep step = record(decisions, world, baseline, palettes);
        if (isChanged && decisions.oneIn(2)) mutateStep(decisions, step);
        std::vector<uint8_t> bytes = recordedStepToBytes(step);
        if (isChanged && decisions.oneIn(16)) mutateBytes(decisions, bytes);
        file.add({'S', 'T', 'E', 'P'}, bytes);
    }
    const Result<Recording> recording = recordingFromBytes(file.file(0), "fuzz", 1);
    if (recording) return follow(*recording, isChanged);
    if (!isChanged || recording.error().empty()) std::abort();
}

}  // namespace rubble
