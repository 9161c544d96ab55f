// Levels (.rubble): random ones with random fields changed, in files with valid checksums.
#include <cstdio>
#include <cstdlib>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/rubble_file.h"
#include "tests/fuzz/content_hash.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/random_world.h"
#include "tests/fuzz/stages.h"

namespace rubble {
namespace {

/// The file of a level, some bytes of its fields or bricks changed, packed with valid checksums.
std::vector<uint8_t> fileOf(Decisions& decisions, const Level& level, uint64_t hash) {
    ChunkWriter out;
    PaletteList palettes;
    std::vector<uint8_t> fieldBytes = levelToBytes(level, palettes),
                         paletteBytes = palettesToBytes(palettes.palettes());
    if (decisions.oneIn(4)) mutateBytes(decisions, fieldBytes);
    if (decisions.oneIn(8)) mutateBytes(decisions, paletteBytes);
    out.add({'P', 'A', 'L', 'T'}, paletteBytes);
    out.add({'L', 'E', 'V', 'L'}, fieldBytes);
    uint32_t number = 0;
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes) {
            if (!decisions.oneIn(8)) GridChunkWriter(out).addGrid(number++, shape.grid);
            if (!decisions.oneIn(16)) continue;
            std::vector<uint8_t> bricks(8);
            bricks[0] = uint8_t(number), bricks[4] = uint8_t(1 + decisions.below(3));
            shape.grid.forEachBrick([&](glm::ivec3 at, const BrickRef& brick) { appendBrick(bricks, at, *brick); });
            mutateBytes(decisions, bricks);
            out.add({'G', 'R', 'I', 'D'}, bricks);
        }
    std::vector<uint8_t> file = out.file(hash);
    if (decisions.oneIn(16)) mutateBytes(decisions, file);
    return file;
}

}  // namespace

void fuzz(Decisions& decisions) {
    Level level = randomLevel(decisions);
    if (!decisions.oneIn(8)) Mutator(decisions, 1u << (4 + decisions.below(8))).mutate(level);
    const Result<Level> read =
        readWithItsHash(fileOf(decisions, level, 0), [](const auto& file) { return levelFromRubble(file, "fuzz"); });
    if (!read) {
        if (read.error().empty()) std::abort();
        return;
    }
    reached("files accepted");
    if (!levelFromRubble(levelToRubble(*read), "again")) std::abort();
    World world;
    world.load(*read);
    for (int i = 0; i < 2; ++i) world.applyEdits({randomEdit(decisions, world, 0)});
    requireReadableSave(world);
}

}  // namespace rubble
