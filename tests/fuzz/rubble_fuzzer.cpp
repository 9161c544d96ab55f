#include <cstdlib>
#include <vector>

#include "runtime/assets/level_bytes.h"
#include "runtime/assets/rubble_file.h"

// The first byte selects what reads the rest: the reader of whole files, or, behind the checksums, that of a level's
// fields or that of bricks.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace rubble;
    if (size == 0) return 0;
    const std::span<const uint8_t> rest(data + 1, size - 1);
    if (data[0] % 3 == 0) {
        const auto level = levelFromRubble(rest, "fuzz.rubble");
        if (!level && level.error().empty()) std::abort();
        return 0;
    }
    ByteReader in(rest, "fuzz");
    if (data[0] % 3 == 1) {
        const std::vector<PaletteRef> palettes(4, std::make_shared<Palette>());
        levelFromBytes(in, palettes);
        return 0;
    }
    VoxelGrid grid({20, 9, 33});
    while (!in.failed() && in.remaining() > 0) readBrick(in, grid);
    return 0;
}
