// Saved games: those of random worlds with random fields changed, in files with valid checksums.
#include <cstdlib>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/save_file.h"
#include "tests/fuzz/content_hash.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/random_world.h"
#include "tests/fuzz/stages.h"

namespace rubble {
namespace {

/// Adds an empty slot, and changes a generation.
template <class Map>
void changeGenerations(Decisions& decisions, Map& map) {
    auto slots = map.slots();
    slots.emplace_back();
    auto& slot = slots[decisions.below(uint32_t(slots.size()))];
    (decisions.oneIn(2) ? slot.lastGeneration : slot.generation) = uint32_t(decisions.oneIn(2) ? 0 : decisions.bits());
    map = Map(1, std::move(slots), {});
}

void mutateState(Decisions& decisions, WorldState& world) {
    Mutator mutator(decisions, 1u << (4 + decisions.below(9)));
    forEachKind(
        [&](auto& map) {
            map.forEach([&](auto, auto& object) { mutator.mutate(object); });
            if (decisions.oneIn(32)) map.setFreeSlots({0, 1, decisions.below(100)});
            if (decisions.oneIn(64)) changeGenerations(decisions, map);
        },
        world);
    mutator.mutate(world.settings);
    mutator.mutate(world.environment);
    mutator.mutate(world.fire.fields);
    mutator.mutate(world.unsettled);
    mutator.mutate(world.materials.materials);
    mutator.mutate(world.locations);
    mutator.mutate(world.scripts);
    mutator.mutate(world.hostData);
    mutator.mutate(world.bounds);
    mutator.mutate(world.footprint);
    if (decisions.oneIn(64)) world.step = decisions.bits();
}

}  // namespace

void fuzz(Decisions& decisions) {
    World world;
    world.load(randomLevel(decisions));
    for (uint32_t i = decisions.below(6); i-- > 0;) world.applyEdits({randomEdit(decisions, world, 0)});
    world.resetCaches();
    SavedGame game{world.state(), {}};
    for (uint32_t i = decisions.below(4); i-- > 0;) game.pending.push_back(randomEdit(decisions, world, 8));
    if (!decisions.oneIn(8)) mutateState(decisions, game.world);
    std::vector<uint8_t> file = gameToBytes(game, 0, nullptr);
    if (decisions.oneIn(16)) mutateBytes(decisions, file);
    const Result<SavedGame> read =
        readWithItsHash(std::move(file), [](const auto& bytes) { return gameFromBytes(bytes, "fuzz", 1); });
    if (!read) {
        if (read.error().empty()) std::abort();
        return;
    }
    reached("files accepted");
    World loaded;
    loaded.setState(read->world);
    loaded.applyEdits(read->pending);
    for (int i = 0; i < 3; ++i) loaded.applyEdits({randomEdit(decisions, loaded, 0), randomEdit(decisions, loaded, 0)});
    requireReadableSave(loaded);
}

}  // namespace rubble
