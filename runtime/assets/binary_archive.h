#pragma once
#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "runtime/assets/byte_reader.h"
#include "runtime/assets/grid_limits.h"
#include "runtime/assets/level_bytes.h"
#include "runtime/assets/level_fields.h"
#include "runtime/assets/memory_budget.h"
#include "runtime/assets/palette_list.h"
#include "runtime/core/handle.h"
#include "runtime/world/edits/create_edits.h"

namespace rubble {

/// Writes values in the order of the calls, little-endian, without padding. Vectors, lists and texts begin with a count
/// of 32 bits, variants with their index. Palettes become numbers of a PaletteList; handles lose the world's number.
class BinaryOutputArchive {
public:
    static constexpr bool kIsBinary = true;  ///< fields() visits some fields for binary archives only
    /// Appends to `bytes`, and new palettes to `palettes`. Both must outlive the archive.
    BinaryOutputArchive(std::vector<uint8_t>& bytes, PaletteList& palettes) : m_bytes(bytes), m_palettes(palettes) {}

    template <class T>
    void operator()(const char*, const T& value) {
        write(value);
    }
    /// Appends one value.
    template <class T>
    void put(const T& value) {
        write(value);
    }
    /// Counts memory that reading takes for what is not a value of the archive.
    void addMemory(uint64_t bytes) { m_memory += bytes; }
    /// The memory that BinaryInputArchive takes from its reader's budget for what was written.
    uint64_t memory() const { return m_memory; }

private:
    template <class T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void write(T value) {
        const auto* raw = reinterpret_cast<const uint8_t*>(&value);
        m_bytes.insert(m_bytes.end(), raw, raw + sizeof value);
    }
    void write(const std::string& text) {
        write(uint32_t(text.size()));
        m_bytes.insert(m_bytes.end(), text.begin(), text.end());
    }
    template <class T>
    void write(const glm::vec<3, T>& v) {
        write(v.x), write(v.y), write(v.z);
    }
    void write(const glm::dquat& q) { write(q.w), write(q.x), write(q.y), write(q.z); }
    void write(const VoxelGrid& grid) {
        m_memory += directoryMemory(directoryNodes(grid.size()));
        write(grid.size());
    }
    void write(const PaletteRef& palette) { write(m_palettes.add(palette)); }
    /// Its palette and its bricks too: what holds it may have no list of palettes.
    void write(const WholeShape& shape) {
        write(shape.palette != nullptr);
        if (shape.palette) write(*shape.palette);
        PaletteList only;
        BinaryOutputArchive inner(m_bytes, only);
        inner.put(static_cast<const LevelShape&>(shape));
        write(uint32_t(shape.grid.brickCount()));
        shape.grid.forEachBrick(
            [&](glm::ivec3 position, const BrickRef& brick) { appendBrick(m_bytes, position, *brick); });
        m_memory += inner.memory() + sizeof(Palette) + shape.grid.brickCount() * kBrickMemory;
    }
    void write(const PaintColorsRef& colors) {
        write(colors ? colors->count : uint8_t(0));
        if (colors && colors->count)
            for (const Srgb& color : colors->colors) write(color);
    }
    void write(AnyHandle handle) { write(withWorld(handle.bits, 0)); }
    template <HandleType kType>
    void write(Handle<kType> handle) {
        write(uint64_t(handle ? Handle<kType>::make(0, handle.generation(), handle.slot()).bits : 0));
    }
    template <class T, size_t kSize>
    void write(const std::array<T, kSize>& values) {
        for (const T& value : values) write(value);
    }
    template <class... T>
    void write(const std::variant<T...>& value) {
        write(uint8_t(value.index()));
        std::visit([&](const auto& each) { write(each); }, value);
    }
    void write(const std::vector<uint8_t>& bytes) {
        write(uint32_t(bytes.size()));
        m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    }
    template <class T>
    void write(const std::vector<T>& values) {
        m_memory += listMemory(values.size(), sizeof(T));
        write(uint32_t(values.size()));
        for (const T& value : values) write(value);
    }
    template <class T>
    requires std::is_class_v<T>
    void write(const T& value) { fields(*this, value); }

    std::vector<uint8_t>& m_bytes;
    PaletteList& m_palettes;
    uint64_t m_memory = 0;
};

/// Reads values that BinaryOutputArchive has written. A value that cannot be valid is a failure of the reader, after
/// which everything reads as zero.
class BinaryInputArchive {
public:
    static constexpr bool kIsBinary = true;  ///< see BinaryOutputArchive
    /// `palettes`: those that palette numbers mean. `world`: whose handles the handles become. All must outlive the
    /// archive.
    BinaryInputArchive(ByteReader& in, const std::vector<PaletteRef>& palettes, uint8_t world = 0)
        : m_in(in), m_palettes(palettes), m_world(world) {}

    template <class T>
    void operator()(const char*, T& value) {
        read(value);
    }
    /// Reads one value.
    template <class T>
    void get(T& value) {
        read(value);
    }

private:
    template <class T>
    requires std::is_arithmetic_v<T>
    void read(T& value) { value = m_in.read<T>(); }
    void read(bool& value) {
        const auto byte = m_in.read<uint8_t>();
        if (byte > 1) m_in.fail("0 or 1", std::to_string(byte), m_in.offset() - 1);
        value = byte == 1;
    }
    template <class T>
    requires std::is_enum_v<T>
    void read(T& value) {
        const auto byte = m_in.read<uint8_t>();
        if (byte >= enumNames(value).size())
            return m_in.fail(fmt::format("a value below {}", enumNames(value).size()), std::to_string(byte),
                             m_in.offset() - 1);
        value = T(byte);
    }
    void read(std::string& text) { text = m_in.readString(); }
    template <class T>
    void read(glm::vec<3, T>& v) {
        read(v.x), read(v.y), read(v.z);
    }
    void read(glm::dquat& q) { read(q.w), read(q.x), read(q.y), read(q.z); }
    void read(VoxelGrid& grid) {
        glm::ivec3 size(0);
        read(size);
        if (size == glm::ivec3(0)) return;
        for (int i = 0; i < 3; ++i)
            if (size[i] < 1 || size[i] > kMaxGridSize)
                return m_in.fail(fmt::format("a grid size of 1 to {}", kMaxGridSize), std::to_string(size[i]),
                                 m_in.offset() - 12);
        m_nodes += directoryNodes(size);
        if (m_nodes > kMaxDirectoryNodes) return m_in.fail("grids of 2^39 cells in all", "more", m_in.offset() - 12);
        if (m_in.takeMemory(directoryMemory(directoryNodes(size)))) grid = VoxelGrid(size);
    }
    void read(PaletteRef& palette) {
        const auto number = m_in.read<uint32_t>();
        if (number < m_palettes.size())
            palette = m_palettes[number];
        else
            m_in.fail(fmt::format("a palette number below {}", m_palettes.size()), std::to_string(number),
                      m_in.offset() - 4);
    }
    void read(WholeShape& shape) {
        bool hasPalette = false;
        read(hasPalette);
        auto palette = std::make_shared<Palette>();
        if (!m_in.takeMemory(sizeof(Palette))) return;
        if (hasPalette) read(*palette);
        const std::vector<PaletteRef> only = {palette};
        BinaryInputArchive inner(m_in, only, m_world);
        inner.get(static_cast<LevelShape&>(shape));
        if (!hasPalette) shape.palette = nullptr;
        for (uint32_t i = m_in.readCount(7, "bricks"); i-- > 0 && !m_in.failed();) readBrick(m_in, shape.grid);
    }
    void read(PaintColorsRef& colors) {
        const auto count = m_in.read<uint8_t>();
        colors = nullptr;
        if (count == 0) return;
        if (count > kPaintColors)
            return m_in.fail(fmt::format("at most {} colours of paint", kPaintColors), std::to_string(count),
                             m_in.offset() - 1);
        auto paint = std::make_shared<PaintColors>();
        paint->count = count;
        read(paint->colors);
        colors = std::move(paint);
    }
    void read(AnyHandle& handle) {
        handle = {m_in.read<uint64_t>()};
        if (handle.world() != 0) return m_in.fail("a handle", fmt::format("{:x}", handle.bits), m_in.offset() - 8);
        if (handle) handle = {withWorld(handle.bits, m_world)};
    }
    template <HandleType kType>
    void read(Handle<kType>& handle) {
        const auto bits = m_in.read<uint64_t>();
        handle = {bits};
        if (bits && (handle.type() != kType || handle.world() != 0))
            return m_in.fail("a handle", fmt::format("{:x}", bits), m_in.offset() - 8);
        if (bits) handle = Handle<kType>::make(m_world, handle.generation(), handle.slot());
    }
    template <class T, size_t kSize>
    void read(std::array<T, kSize>& values) {
        for (T& value : values) read(value);
    }
    template <class... T>
    void read(std::variant<T...>& value) {
        const auto index = m_in.read<uint8_t>();
        size_t i = 0;
        const bool isKnown = ((index == i++ ? (read(value.template emplace<T>()), true) : false) || ...);
        if (!isKnown) m_in.fail(fmt::format("a kind below {}", sizeof...(T)), std::to_string(index), m_in.offset() - 1);
    }
    void read(std::vector<uint8_t>& bytes) {
        const auto raw = m_in.readBytes(m_in.readCount(1, "bytes"));
        bytes.assign(raw.begin(), raw.end());
    }
    template <class T>
    void read(std::vector<T>& values) {
        const uint32_t count = m_in.readCount(1, "elements");
        if (!m_in.takeMemory(listMemory(count, sizeof(T)))) return;
        values.reserve(count);
        for (uint32_t i = 0; i < count && !m_in.failed(); ++i) read(values.emplace_back());
    }
    template <class T>
    requires std::is_class_v<T>
    void read(T& value) { fields(*this, value); }

    ByteReader& m_in;
    const std::vector<PaletteRef>& m_palettes;
    uint8_t m_world;
    uint64_t m_nodes = 0;
};

}  // namespace rubble
