#include "runtime/assets/vox_file.h"

#include <algorithm>

#include "runtime/assets/byte_reader.h"
#include "runtime/assets/grid_limits.h"
#include "runtime/assets/vox_packed_model.h"

namespace rubble {
namespace {

constexpr int kMaxModelSize = 256;  // cell coordinates are bytes

VoxAttributes readAttributes(ByteReader& in) {
    VoxAttributes attributes;
    const uint32_t count = in.readCount(8, "attributes");
    for (uint32_t i = 0; i < count && !in.failed(); ++i) {
        std::string key = in.readString();
        attributes[std::move(key)] = in.readString();
    }
    return attributes;
}

glm::ivec3 readModelSize(ByteReader& in) {
    const size_t start = in.offset();
    const auto size = in.read<glm::ivec3>();
    for (int axis = 0; axis < 3; ++axis)
        if (size[axis] < 0 || size[axis] > kMaxModelSize)
            in.fail(fmt::format("a model size of 0 to {}", kMaxModelSize), std::to_string(size[axis]),
                    start + size_t(axis) * 4);
    return in.failed() ? glm::ivec3(0) : size;
}

void readSize(ByteReader& in, VoxFile& file) {
    file.models.push_back({readModelSize(in), {}});
}

/// `sizesUsed`: SIZE chunks that have their voxels. Fails in the reader if there is not one more.
bool requireSize(ByteReader& in, const VoxFile& file, size_t sizesUsed) {
    if (file.models.size() == sizesUsed + 1) return true;
    in.fail("a SIZE chunk before each XYZI chunk",
            fmt::format("{} SIZE chunks before XYZI chunk {}", file.models.size(), sizesUsed + 1));
    return false;
}

/// A TDCZ chunk says its size again. Where no SIZE chunk came before, it makes a model of its own.
void readPackedModel(ByteReader& in, VoxFile& file, size_t sizesUsed) {
    const size_t start = in.offset();
    const glm::ivec3 size = readModelSize(in);
    if (in.failed()) return;
    if (file.models.size() == sizesUsed) file.models.push_back({size, {}});
    if (!requireSize(in, file, sizesUsed)) return;
    VoxModel& model = file.models.back();
    if (model.size != size)
        return in.fail(fmt::format("{}x{}x{}, as its SIZE chunk says", model.size.x, model.size.y, model.size.z),
                       fmt::format("{}x{}x{}", size.x, size.y, size.z), start);
    if (in.takeMemory(directoryMemory(directoryNodes(size)))) readPackedVoxels(in, model);
}

void readVoxels(ByteReader& in, VoxFile& file, size_t sizesUsed) {
    if (!requireSize(in, file, sizesUsed)) return;
    VoxModel& model = file.models.back();
    const uint32_t count = in.readCount(4, "voxels");
    const bool hasCells = model.size.x > 0 && model.size.y > 0 && model.size.z > 0;
    if (count == 0 || !in.takeMemory(directoryMemory(directoryNodes(model.size)))) return;
    model.grid = hasCells ? VoxelGrid(model.size) : VoxelGrid();
    GridWriter writer(model.grid);
    for (uint32_t i = 0; i < count; ++i) {
        const size_t start = in.offset();
        const auto voxel = in.read<std::array<uint8_t, 4>>();
        for (int axis = 0; axis < 3; ++axis)
            if (voxel[size_t(axis)] >= model.size[axis])
                return in.fail(
                    fmt::format("a cell inside the model of {}x{}x{}", model.size.x, model.size.y, model.size.z),
                    fmt::format("cell ({}, {}, {})", voxel[0], voxel[1], voxel[2]), start);
        writer.set({voxel[0], voxel[1], voxel[2]}, voxel[3]);
    }
    writer.flush();
    in.takeMemory(model.grid.brickCount() * kBrickMemory);
}

/// The i-th colour belongs to index i + 1; the last of 256 is never used, and Teardown does not write it.
void readColors(ByteReader& in, VoxFile& file) {
    const size_t count = std::min<size_t>(in.remaining() / 4, 256);
    for (size_t i = 0; i < std::min<size_t>(count, 255); ++i) file.colors[i + 1] = in.read<std::array<uint8_t, 4>>();
    if (count < 256)
        file.warnings.push_back(
            fmt::format("RGBA: expected 256 colours, found {}: the others are MagicaVoxel's default colours", count));
    file.defaultColors = false;
}

void readTransform(ByteReader& in, VoxFile& file, size_t chunkOffset) {
    const auto id = in.read<int32_t>();
    VoxNode node{VoxNodeKind::Transform, readAttributes(in), {}, {}, -1, chunkOffset};
    node.children.push_back(in.read<int32_t>());
    in.read<int32_t>();  // reserved
    node.layer = in.read<int32_t>();
    const uint32_t frames = in.readCount(4, "frames");
    for (uint32_t i = 0; i < frames && !in.failed(); ++i) node.frames.push_back(readAttributes(in));
    file.nodes[id] = std::move(node);
}

void readGroup(ByteReader& in, VoxFile& file, size_t chunkOffset) {
    const auto id = in.read<int32_t>();
    VoxNode node{VoxNodeKind::Group, readAttributes(in), {}, {}, -1, chunkOffset};
    const uint32_t count = in.readCount(4, "children");
    for (uint32_t i = 0; i < count && !in.failed(); ++i) node.children.push_back(in.read<int32_t>());
    file.nodes[id] = std::move(node);
}

void readShape(ByteReader& in, VoxFile& file, size_t chunkOffset) {
    const auto id = in.read<int32_t>();
    VoxNode node{VoxNodeKind::Shape, readAttributes(in), {}, {}, -1, chunkOffset};
    const uint32_t count = in.readCount(8, "models");
    for (uint32_t i = 0; i < count && !in.failed(); ++i) {
        node.children.push_back(in.read<int32_t>());
        node.frames.push_back(readAttributes(in));
    }
    file.nodes[id] = std::move(node);
}

void readLayer(ByteReader& in, VoxFile& file) {
    const auto id = in.read<int32_t>();
    file.layers[id].attributes = readAttributes(in);
}

/// The old material chunk, stored as the attributes that MATL would have.
void readOldMaterial(ByteReader& in, VoxFile& file) {
    static constexpr const char* kTypes[] = {"_diffuse", "_metal", "_glass", "_emit"};
    static constexpr const char* kProperties[] = {"_plastic", "_rough", "_spec", "_ior", "_att", "_flux", "_glow"};
    const auto id = in.read<int32_t>();
    const auto type = in.read<uint32_t>();
    if (type > 3) in.fail("a material type of 0 to 3", std::to_string(type), in.offset() - 4);
    VoxAttributes& attributes = file.materials[id];
    const float weight = in.read<float>();
    const auto bits = in.read<uint32_t>();
    if (in.failed()) return;
    attributes["_type"] = kTypes[type];
    attributes["_weight"] = fmt::format("{}", weight);
    for (size_t i = 0; i < std::size(kProperties); ++i)
        if (bits >> i & 1) attributes[kProperties[i]] = fmt::format("{}", in.read<float>());
}

void readNotes(ByteReader& in, VoxFile& file) {
    const uint32_t count = in.readCount(4, "names");
    for (uint32_t i = 0; i < count && !in.failed(); ++i) file.colorNotes.push_back(in.readString());
}

void readCamera(ByteReader& in, VoxFile& file) {
    const auto id = in.read<int32_t>();
    file.cameras[id] = readAttributes(in);
}

/// The id of a MATL chunk is a stored colour index; some versions write 256 for 0.
void readMaterial(ByteReader& in, VoxFile& file) {
    const auto id = in.read<int32_t>();
    file.materials[id & 255] = readAttributes(in);
}

void readIndexMap(ByteReader& in, VoxFile& file) {
    const auto map = in.read<std::array<uint8_t, 256>>();
    std::array<bool, 256> seen{};
    for (uint8_t stored : map) seen[stored] = true;
    for (bool present : seen)
        if (!present) {
            file.warnings.push_back(
                "IMAP: expected a permutation of 0 to 255, found another table: ignored, colours do not depend on it");
            return;
        }
    file.indexMap = map;
}

/// Reads chunks one after another.
class ChunkParser {
public:
    explicit ChunkParser(VoxFile& file) : m_file(file) {}

    /// Reads the chunks of a whole file.
    void parseFile(ByteReader& in) {
        while (in.remaining() > 0 && !in.failed()) parseChunk(in, true);
    }
    void finish(ByteReader& in) const {
        if (m_file.models.size() != m_modelsRead)
            in.fail("an XYZI or TDCZ chunk after each SIZE chunk",
                    fmt::format("{} models and {} chunks of voxels", m_file.models.size(), m_modelsRead));
        if (m_file.models.empty()) in.fail("at least one model", "none");
        if (m_packed && *m_packed != m_modelsRead)
            m_file.warnings.push_back(fmt::format("PACK: expected {} models, found {}", *m_packed, m_modelsRead));
    }

private:
    void parseChunk(ByteReader& in, bool isOutermost) {
        const size_t start = in.offset();
        const auto id = in.read<std::array<char, 4>>();
        const auto contentBytes = in.read<uint32_t>();
        const auto childBytes = in.read<uint32_t>();
        if (in.failed()) return;
        std::string kind(id.data(), 4);
        for (char& c : kind)
            if (c < 32 || c > 126) c = '?';
        if (uint64_t(contentBytes) + childBytes > in.remaining())
            return in.fail(fmt::format("{} bytes of chunk {}", uint64_t(contentBytes) + childBytes, kind),
                           fmt::format("{} before the end", in.remaining()), start + 4);
        ByteReader content = in.part(contentBytes, kind + " chunk");
        readContent(kind, content, start);
        in.takeErrorOf(content);
        ByteReader children = in.part(childBytes, "inside " + kind);
        if (kind == "MAIN" && !isOutermost) in.fail("no MAIN chunk inside another", "one", start);
        while (kind == "MAIN" && isOutermost && children.remaining() > 0 && !children.failed())
            parseChunk(children, false);
        in.takeErrorOf(children);
    }

    void readContent(const std::string& kind, ByteReader& in, size_t chunkOffset) {
        if (kind == "SIZE")
            readSize(in, m_file);
        else if (kind == "XYZI")
            readVoxels(in, m_file, m_modelsRead++);
        else if (kind == "TDCZ")
            readPackedModel(in, m_file, m_modelsRead++);
        else if (kind == "RGBA")
            readColors(in, m_file);
        else if (kind == "IMAP")
            readIndexMap(in, m_file);
        else if (kind == "nTRN")
            readTransform(in, m_file, chunkOffset);
        else if (kind == "nGRP")
            readGroup(in, m_file, chunkOffset);
        else if (kind == "nSHP")
            readShape(in, m_file, chunkOffset);
        else if (kind == "LAYR")
            readLayer(in, m_file);
        else if (kind == "MATL")
            readMaterial(in, m_file);
        else if (kind == "MATT")
            readOldMaterial(in, m_file);
        else if (kind == "rOBJ")
            m_file.renderSettings.push_back(readAttributes(in));
        else if (kind == "rCAM")
            readCamera(in, m_file);
        else if (kind == "NOTE")
            readNotes(in, m_file);
        else if (kind == "PACK")
            m_packed = in.read<uint32_t>();
        else if (kind != "MAIN")
            ++m_file.skippedChunks[kind];
    }

    VoxFile& m_file;
    size_t m_modelsRead = 0;
    std::optional<uint32_t> m_packed;
};

}  // namespace

std::array<std::array<uint8_t, 4>, 256> defaultVoxColors() {
    std::array<std::array<uint8_t, 4>, 256> colors{};
    for (int i = 0; i < 215; ++i)
        colors[size_t(i) + 1] = {uint8_t(255 - 51 * (i / 36)), uint8_t(255 - 51 * (i / 6 % 6)),
                                 uint8_t(255 - 51 * (i % 6)), 255};
    static constexpr uint8_t kSteps[10] = {0xee, 0xdd, 0xbb, 0xaa, 0x88, 0x77, 0x55, 0x44, 0x22, 0x11};
    for (size_t ramp = 0; ramp < 4; ++ramp)
        for (size_t step = 0; step < 10; ++step) {
            auto& color = colors[216 + ramp * 10 + step];
            color = {0, 0, 0, 255};
            for (size_t channel = 0; channel < 3; ++channel)
                if (ramp == channel || ramp == 3) color[channel] = kSteps[step];
        }
    return colors;
}

Result<VoxFile> parseVox(std::span<const uint8_t> bytes, const std::string& name) {
    VoxFile file;
    file.colors = defaultVoxColors();
    ByteReader in(bytes, "header");
    const auto magic = in.read<std::array<char, 4>>();
    if (!in.failed() && std::string_view(magic.data(), 4) != "VOX ")
        in.fail("a MagicaVoxel file (\"VOX \")", "other bytes", 0);
    file.version = in.read<uint32_t>();
    if (file.version < 150 || file.version > 299) in.fail("version 150 to 299", std::to_string(file.version), 4);
    if (in.remaining() == 0) in.fail("a MAIN chunk", "the end");
    ChunkParser parser(file);
    parser.parseFile(in);
    if (!in.failed()) parser.finish(in);
    if (in.failed()) return Error{name + ": " + in.error()};
    return file;
}

}  // namespace rubble
