// MagicaVoxel files (.vox): random chunks that mostly fit together, some bytes changed.
#include <cstdlib>

#include "runtime/assets/rubble_file.h"
#include "runtime/assets/vox_import.h"
#include "runtime/core/log.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/random_world.h"
#include "tests/fuzz/stages.h"
#include "tests/runtime/assets/vox_writer.h"

namespace rubble {
namespace {

glm::ivec3 randomSize(Decisions& decisions) {
    const auto side = [&] { return int(decisions.below(decisions.oneIn(64) ? 60 : decisions.oneIn(8) ? 20 : 9)); };
    const int x = side(), y = side(), z = side();
    return {x, y, z};
}

void addModel(Decisions& decisions, VoxWriter& writer) {
    const glm::ivec3 size = randomSize(decisions);
    if (decisions.oneIn(2)) {
        std::vector<uint8_t> cells(size_t(size.x * size.y * size.z) + decisions.below(2));
        for (uint8_t& cell : cells) cell = uint8_t(decisions.oneIn(3) ? 0 : decisions.below(256));
        writer.packedModel(size, cells, decisions.oneIn(2));
        return;
    }
    std::vector<std::array<uint8_t, 4>> voxels(decisions.below(60));
    for (auto& voxel : voxels)
        voxel = {uint8_t(decisions.below(uint32_t(size.x) + (decisions.oneIn(500) ? 2 : 0))),
                 uint8_t(decisions.below(uint32_t(size.y))), uint8_t(decisions.below(uint32_t(size.z))),
                 uint8_t(decisions.below(256))};
    writer.model(size, voxels);
}

void addNodes(Decisions& decisions, VoxWriter& writer, int models) {
    const int nodes = int(decisions.below(12));
    for (int id = 0; id < nodes; ++id) {
        const int child = decisions.oneIn(20) ? int(decisions.below(20)) : id + 1 + int(decisions.below(2));
        if (id + 2 >= nodes || decisions.oneIn(3)) {
            writer.shape(id, {int(decisions.below(uint32_t(models))), int(decisions.below(uint32_t(models)))});
        } else if (decisions.oneIn(2)) {
            VoxWriter::Attributes frame;
            if (decisions.oneIn(2)) frame["_r"] = std::to_string(decisions.below(128));
            if (decisions.oneIn(2)) frame["_t"] = std::to_string(int(decisions.below(2000)) - 1000) + " 5 -7";
            writer.transform(id, child, {frame}, {{"_name", "part"}}, int(decisions.below(3)));
        } else {
            writer.group(id, {child, child + 1, child});
        }
    }
}

VoxWriter::Bytes randomFile(Decisions& decisions) {
    VoxWriter writer;
    const int models = 1 + int(decisions.below(3));
    for (int i = 0; i < models; ++i) addModel(decisions, writer);
    addNodes(decisions, writer, models);
    if (decisions.oneIn(2)) {
        std::array<std::array<uint8_t, 4>, 256> colors{};
        for (auto& color : colors)
            color = {uint8_t(decisions.below(256)), uint8_t(decisions.below(256)), uint8_t(decisions.below(256)), 255};
        writer.colors(colors, decisions.oneIn(2) ? 256 : decisions.below(257));
    }
    const char* types[] = {"_diffuse", "_metal", "_glass", "_emit", "_blend", "odd"};
    for (uint32_t i = decisions.below(4); i-- > 0;)
        writer.described("MATL", int(decisions.below(257)),
                         {{"_type", types[decisions.below(6)]},
                          {"_weight", std::to_string(decisions.wild())},
                          {"_emit", "0.7"},
                          {"_flux", std::to_string(decisions.below(9))}});
    if (decisions.oneIn(4)) writer.described("LAYR", int(decisions.below(3)), {{"_name", "layer"}, {"_hidden", "1"}});
    if (decisions.oneIn(4)) writer.described("rCAM", 0, {{"_focus", "1 2 1e30"}});
    if (decisions.oneIn(4)) writer.chunk("IMAP", std::vector<uint8_t>(256, uint8_t(decisions.below(256))));
    if (decisions.oneIn(4)) writer.chunk("NOTE", {1, 0, 0, 0, 2, 0, 0, 0, 'h', 'i'});
    return writer.file(decisions.oneIn(2) ? 150 : 200);
}

void run(Decisions& decisions) {
    VoxWriter::Bytes file = randomFile(decisions);
    const bool isChanged = !decisions.oneIn(3);
    if (isChanged) mutateBytes(decisions, file, 8);
    VoxImportSettings settings;
    settings.voxelSize = decisions.oneIn(2) ? 0.1 : decisions.wild();
    settings.oneBody = decisions.oneIn(2);
    settings.teardownPalette = decisions.oneIn(2);
    const Result<Level> level = importVoxBytes(file, "fuzz.vox", settings);
    if (!level) {
        if (level.error().empty()) std::abort();
        return;
    }
    reached("files accepted");
    if (!levelFromRubble(levelToRubble(*level), "again")) std::abort();
    World world;
    world.load(*level);
    requireReadableSave(world);
}

}  // namespace
}  // namespace rubble

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    rubble::setLogSink([](void*, rubble::LogLevel, std::string_view) {}, nullptr);
    // Inputs of libFuzzer may be files as they are.
    if (size > 8 && data[0] == 'V' && data[1] == 'O') {
        if (!rubble::importVoxBytes({data, size}, "fuzz.vox", {})) return 0;
    }
    rubble::Decisions decisions(data, size);
    rubble::run(decisions);
    return 0;
}
