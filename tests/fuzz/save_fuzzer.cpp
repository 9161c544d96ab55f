// Saved games: those of random worlds with random fields changed, in files with valid checksums.
#include <cstdlib>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/save_file.h"
#include "runtime/core/log.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/random_world.h"

namespace rubble {
namespace {

void mutateState(Decisions& decisions, WorldState& world) {
    Mutator mutator(decisions, 1u << (4 + decisions.below(9)));
    forEachKind(
        [&](auto& map) {
            map.forEach([&](auto, auto& object) { mutator.mutate(object); });
            if (decisions.oneIn(32)) map.setFreeSlots({0, 1, decisions.below(100)});
        },
        world);
    mutator.mutate(world.settings);
    mutator.mutate(world.environment);
    mutator.mutate(world.fire.fields);
    mutator.mutate(world.unsettled);
    mutator.mutate(world.materials.materials);
    mutator.mutate(world.locations);
    if (decisions.oneIn(64)) world.step = decisions.bits();
}

/// Reads a file again whose only fault is its content hash.
Result<SavedGame> readWithHash(std::vector<uint8_t> file) {
    Result<SavedGame> game = gameFromBytes(file, "fuzz", 1);
    const char* expected = "expected the hash of the world, ";
    const size_t at = game ? std::string::npos : game.error().find(expected);
    if (at == std::string::npos) return game;
    uint32_t chunks = 0;
    std::memcpy(&chunks, file.data() + 12, 4);
    const FileHeader header =
        makeFileHeader(chunks, std::strtoull(game.error().c_str() + at + std::strlen(expected), nullptr, 16));
    std::memcpy(file.data(), &header, sizeof header);
    return gameFromBytes(file, "fuzz", 1);
}

void run(Decisions& decisions) {
    World world;
    world.load(randomLevel(decisions));
    for (uint32_t i = decisions.below(6); i-- > 0;) world.applyEdits({randomEdit(decisions, world, 0)});
    world.resetCaches();
    SavedGame game{world.state(), {}};
    for (uint32_t i = decisions.below(4); i-- > 0;) game.pending.push_back(randomEdit(decisions, world, 8));
    if (!decisions.oneIn(8)) mutateState(decisions, game.world);
    std::vector<uint8_t> file = gameToBytes(game, 0, nullptr);
    if (decisions.oneIn(16)) mutateBytes(decisions, file);
    const Result<SavedGame> read = readWithHash(std::move(file));
    if (!read) {
        if (read.error().empty()) std::abort();
        return;
    }
    World loaded;
    loaded.setState(read->world);
    loaded.applyEdits(read->pending);
    for (int i = 0; i < 3; ++i) loaded.applyEdits({randomEdit(decisions, loaded, 0), randomEdit(decisions, loaded, 0)});
    requireReadableSave(loaded);
}

}  // namespace
}  // namespace rubble

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    rubble::setLogSink([](void*, rubble::LogLevel, std::string_view) {}, nullptr);
    rubble::Decisions decisions(data, size);
    rubble::run(decisions);
    return 0;
}
