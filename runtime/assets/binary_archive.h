#pragma once
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "runtime/assets/byte_reader.h"
#include "runtime/assets/level_fields.h"
#include "runtime/assets/palette_list.h"
#include "runtime/core/handle.h"

namespace rubble {

inline constexpr uint64_t kMaxDirectoryNodes = 1u << 24;  // of all grids together: 128 MiB; a grid of 4096^3 takes 2^21

/// An archive that writes fields, little-endian, in their order.
class BinaryOutputArchive {
public:
    static constexpr bool kIsBinary = true;
    BinaryOutputArchive(std::vector<uint8_t>& bytes, PaletteList& palettes) : m_bytes(bytes), m_palettes(palettes) {}

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
    void put(const PaintColorsRef& colors) {
        put(colors ? colors->count : uint8_t(0));
        if (colors && colors->count)
            for (const Srgb& color : colors->colors) put(color);
    }
    template <HandleType kType>
    void put(Handle<kType> handle) {
        put(uint64_t(handle ? Handle<kType>::make(0, handle.generation(), handle.slot()).bits : 0));
    }
    template <class T, size_t kSize>
    void put(const std::array<T, kSize>& values) {
        for (const T& value : values) put(value);
    }
    template <class... T>
    void put(const std::variant<T...>& value) {
        put(uint8_t(value.index()));
        std::visit([&](const auto& each) { put(each); }, value);
    }
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

/// An archive that reads them back. Handles become those of the world with the given number. Fails in the reader.
class BinaryInputArchive {
public:
    static constexpr bool kIsBinary = true;
    BinaryInputArchive(ByteReader& in, const std::vector<PaletteRef>& palettes, uint8_t world = 0)
        : m_in(in), m_palettes(palettes), m_world(world) {}

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
            return m_in.fail(fmt::format("a value below {}", enumNames(value).size()), std::to_string(byte),
                             m_in.offset() - 1);
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
                return m_in.fail(fmt::format("a grid size of 1 to {}", kMaxGridSize), std::to_string(size[i]),
                                 m_in.offset() - 12);
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
            m_in.fail(fmt::format("a palette number below {}", m_palettes.size()), std::to_string(number),
                      m_in.offset() - 4);
    }
    void get(PaintColorsRef& colors) {
        const auto count = m_in.read<uint8_t>();
        colors = nullptr;
        if (count == 0) return;
        if (count > kPaintColors)
            return m_in.fail(fmt::format("at most {} colours of paint", kPaintColors), std::to_string(count),
                             m_in.offset() - 1);
        auto read = std::make_shared<PaintColors>();
        read->count = count;
        get(read->colors);
        colors = std::move(read);
    }
    template <HandleType kType>
    void get(Handle<kType>& handle) {
        const auto bits = m_in.read<uint64_t>();
        handle = {bits};
        if (bits && (handle.type() != kType || handle.world() != 0))
            return m_in.fail("a handle", fmt::format("{:x}", bits), m_in.offset() - 8);
        if (bits) handle = Handle<kType>::make(m_world, handle.generation(), handle.slot());
    }
    template <class T, size_t kSize>
    void get(std::array<T, kSize>& values) {
        for (T& value : values) get(value);
    }
    template <class... T>
    void get(std::variant<T...>& value) {
        const auto index = m_in.read<uint8_t>();
        size_t i = 0;
        const bool isKnown = ((index == i++ ? (get(value.template emplace<T>()), true) : false) || ...);
        if (!isKnown) m_in.fail(fmt::format("a kind below {}", sizeof...(T)), std::to_string(index), m_in.offset() - 1);
    }
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
    uint8_t m_world;
    uint64_t m_nodes = 0;
};

}  // namespace rubble
