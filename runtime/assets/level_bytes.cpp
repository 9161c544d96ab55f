#include "runtime/assets/level_bytes.h"

#include "runtime/assets/level_fields.h"

namespace rubble {
namespace {

constexpr uint64_t kMaxDirectoryNodes = 1u << 24;  // of all grids together: 128 MiB; a grid of 4096^3 takes 2^21

class ByteOut {
public:
    ByteOut(std::vector<uint8_t>& bytes, PaletteList& palettes) : m_bytes(bytes), m_palettes(palettes) {}

    template <class T>
    void operator()(const char*, const T& value) {
        put(value);
    }
    template <class T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void put(T value) {
        const auto* raw = reinterpret_cast<const uint8_t*>(&value);
        m_bytes.insert(m_bytes.end(), raw, raw + sizeof value);
    }
    void put(const std::string& text) {
        put(uint32_t(text.size()));
        m_bytes.insert(m_bytes.end(), text.begin(), text.end());
    }
    template <class T>
    void put(const glm::vec<3, T>& v) {
        put(v.x), put(v.y), put(v.z);
    }
    void put(const glm::dquat& q) { put(q.w), put(q.x), put(q.y), put(q.z); }
    void put(const VoxelGrid& grid) { put(grid.size()); }
    void put(const PaletteRef& palette) { put(m_palettes.add(palette)); }
    void put(const PaintColorsRef&) {}  // in chunks of their own, where there are some
    template <class T>
    void put(const std::vector<T>& values) {
        put(uint32_t(values.size()));
        for (const T& value : values) put(value);
    }
    template <class T>
    requires std::is_class_v<T>
    void put(const T& value) { fields(*this, value); }

private:
    std::vector<uint8_t>& m_bytes;
    PaletteList& m_palettes;
};

class ByteIn {
public:
    ByteIn(ByteReader& in, const std::vector<PaletteRef>& palettes) : m_in(in), m_palettes(palettes) {}

    template <class T>
    void operator()(const char*, T& value) {
        get(value);
    }
    template <class T>
    requires std::is_arithmetic_v<T>
    void get(T& value) { value = m_in.read<T>(); }
    void get(bool& value) {
        const auto byte = m_in.read<uint8_t>();
        if (byte > 1) m_in.fail("0 or 1", std::to_string(byte), m_in.offset() - 1);
        value = byte == 1;
    }
    template <class T>
    requires std::is_enum_v<T>
    void get(T& value) {
        const auto byte = m_in.read<uint8_t>();
        if (byte >= enumNames(value).size())
            return m_in.fail(fmt::format("a value below {}", enumNames(value).size()), std::to_string(byte), m_in.offset() - 1);
        value = T(byte);
    }
    void get(std::string& text) { text = m_in.readString(); }
    template <class T>
    void get(glm::vec<3, T>& v) {
        get(v.x), get(v.y), get(v.z);
    }
    void get(glm::dquat& q) { get(q.w), get(q.x), get(q.y), get(q.z); }
    void get(VoxelGrid& grid) {
        glm::ivec3 size(0);
        get(size);
        if (size == glm::ivec3(0)) return;
        for (int i = 0; i < 3; ++i)
            if (size[i] < 1 || size[i] > kMaxGridSize)
                return m_in.fail(fmt::format("a grid size of 1 to {}", kMaxGridSize), std::to_string(size[i]), m_in.offset() - 12);
        const glm::ivec3 nodes = (size + 31) / 32;
        m_nodes += uint64_t(nodes.x) * uint64_t(nodes.y) * uint64_t(nodes.z);
        if (m_nodes > kMaxDirectoryNodes) return m_in.fail("grids of 2^39 cells in all", "more", m_in.offset() - 12);
        grid = VoxelGrid(size);
    }
    void get(PaletteRef& palette) {
        const auto number = m_in.read<uint32_t>();
        if (number < m_palettes.size())
            palette = m_palettes[number];
        else
            m_in.fail(fmt::format("a palette number below {}", m_palettes.size()), std::to_string(number), m_in.offset() - 4);
    }
    void get(PaintColorsRef&) {}
    template <class T>
    void get(std::vector<T>& values) {
        const uint32_t count = m_in.readCount(1, "elements");
        for (uint32_t i = 0; i < count && !m_in.failed(); ++i) get(values.emplace_back());
    }
    template <class T>
    requires std::is_class_v<T>
    void get(T& value) { fields(*this, value); }

private:
    ByteReader& m_in;
    const std::vector<PaletteRef>& m_palettes;
    uint64_t m_nodes = 0;
};

enum BrickKind : uint8_t { kFull, kUniform, kMixed };
constexpr uint8_t kPainted = 4;  // added to a kind: 512 bytes of paint follow

bool fitsGrid(const Brick& brick, glm::ivec3 position, glm::ivec3 size) {
    const glm::ivec3 room = size - position * 8;
    if (room.x >= 8 && room.y >= 8 && room.z >= 8) return true;
    bool fits = true;
    forEachVoxel(brick.occupancy, [&](int i) {
        const glm::ivec3 cell = voxelInBrick(i);
        fits = fits && cell.x < room.x && cell.y < room.y && cell.z < room.z;
    });
    return fits;
}

}  // namespace

std::vector<uint8_t> levelToBytes(const Level& level, PaletteList& palettes) {
    std::vector<uint8_t> bytes;
    ByteOut(bytes, palettes).put(level);
    return bytes;
}

Level levelFromBytes(ByteReader& in, const std::vector<PaletteRef>& palettes) {
    Level level;
    level.materials.materials.clear();
    ByteIn(in, palettes).get(level);
    return level;
}

std::vector<uint8_t> palettesToBytes(const std::vector<PaletteRef>& palettes) {
    std::vector<uint8_t> bytes;
    PaletteList unused;
    ByteOut out(bytes, unused);
    out.put(uint32_t(palettes.size()));
    for (const PaletteRef& palette : palettes)
        for (const PaletteEntry& entry : *palette) out.put(entry);
    return bytes;
}

std::vector<PaletteRef> palettesFromBytes(ByteReader& in) {
    std::vector<PaletteRef> palettes;
    const uint32_t count = in.readCount(256 * 16, "palettes");
    ByteIn archive(in, palettes);
    for (uint32_t i = 0; i < count && !in.failed(); ++i) {
        auto palette = std::make_shared<Palette>();
        for (PaletteEntry& entry : *palette) archive.get(entry);
        palettes.push_back(std::move(palette));
    }
    return palettes;
}

void appendBrick(std::vector<uint8_t>& out, glm::ivec3 position, const Brick& brick) {
    PaletteList unused;
    ByteOut archive(out, unused);
    for (int i = 0; i < 3; ++i) archive.put(uint16_t(position[i]));
    const BrickKind kind = brick.indices ? kMixed : brick.full() ? kFull : kUniform;
    archive.put(uint8_t(kind + (brick.paint ? kPainted : 0)));
    if (kind == kMixed)
        out.insert(out.end(), brick.indices->begin(), brick.indices->end());
    else
        archive.put(brick.uniform);
    if (kind == kUniform)
        for (uint64_t word : brick.occupancy) archive.put(word);
    if (brick.paint) out.insert(out.end(), brick.paint->begin(), brick.paint->end());
}

void readBrick(ByteReader& in, VoxelGrid& grid) {
    const size_t start = in.offset();
    glm::ivec3 position;
    for (int i = 0; i < 3; ++i) position[i] = in.read<uint16_t>();
    const auto fullKind = in.read<uint8_t>();
    const bool isPainted = fullKind >= kPainted;
    const uint8_t kind = uint8_t(fullKind - (isPainted ? kPainted : 0));
    BrickIndices indices{}, paint{};
    if (kind == kMixed) {
        const auto raw = in.readBytes(kBrickVoxels);
        if (!in.failed()) std::copy(raw.begin(), raw.end(), indices.begin());
    } else if (kind == kFull) {
        indices.fill(in.read<uint8_t>());
    } else if (kind == kUniform) {
        const auto value = in.read<uint8_t>();
        const auto occupancy = in.read<std::array<uint64_t, 8>>();
        forEachVoxel(occupancy, [&](int i) { indices[size_t(i)] = value; });
    } else {
        in.fail("a brick kind of 0 to 2, or 4 to 6 with paint", std::to_string(fullKind), start + 6);
    }
    if (isPainted) {
        const auto raw = in.readBytes(kBrickVoxels);
        if (!in.failed()) std::copy(raw.begin(), raw.end(), paint.begin());
    }
    if (in.failed()) return;
    const glm::ivec3 bricks = grid.sizeInBricks();
    BrickRef brick = makeBrick(indices, isPainted ? &paint : nullptr);
    if (position.x >= bricks.x || position.y >= bricks.y || position.z >= bricks.z || (brick && !fitsGrid(*brick, position, grid.size())))
        return in.fail(fmt::format("a brick inside a grid of {}x{}x{} cells", grid.size().x, grid.size().y, grid.size().z),
                       fmt::format("brick ({}, {}, {})", position.x, position.y, position.z), start);
    if (!brick || grid.brickAt(position))
        return in.fail("each brick once and not empty", fmt::format("brick ({}, {}, {})", position.x, position.y, position.z), start);
    grid.setBrick(position, std::move(brick));
}

std::vector<uint8_t> paintColorsToBytes(const PaintColors& colors) {
    std::vector<uint8_t> bytes{colors.count};
    for (size_t i = 0; i < colors.count; ++i) bytes.insert(bytes.end(), colors.colors[i].begin(), colors.colors[i].end());
    return bytes;
}

PaintColorsRef paintColorsFromBytes(ByteReader& in) {
    PaintColors colors;
    colors.count = in.read<uint8_t>();
    if (colors.count < 1 || colors.count > kPaintColors)
        return in.fail(fmt::format("1 to {} colours of paint", kPaintColors), std::to_string(colors.count), in.offset() - 1), nullptr;
    for (size_t i = 0; i < colors.count; ++i)
        for (uint8_t& channel : colors.colors[i]) channel = in.read<uint8_t>();
    return std::make_shared<const PaintColors>(colors);
}

}  // namespace rubble
