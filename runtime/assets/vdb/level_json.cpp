#include "runtime/assets/vdb/level_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "runtime/assets/grid_limits.h"
#include "runtime/assets/level_fields.h"
#include "runtime/assets/palette_list.h"

namespace rubble {
namespace {

using nlohmann::json;

/// An archive that makes JSON objects: enums as names, palettes as numbers, grids as sizes.
class JsonOutputArchive {
public:
    JsonOutputArchive(PaletteList& palettes, const std::vector<std::string>& gridNames)
        : m_palettes(palettes), m_gridNames(gridNames) {}

    template <class T>
    void operator()(const char* name, const T& value) {
        (*m_object)[name] = make(value);
    }
    template <class T>
    requires std::is_arithmetic_v<T> json make(T value) { return value; }
    template <class T>
    requires std::is_enum_v<T> json make(T value) { return enumNames(value)[size_t(value)]; }
    json make(const std::string& text) { return text; }
    template <class T>
    json make(const glm::vec<3, T>& v) {
        return {v.x, v.y, v.z};
    }
    json make(const glm::dquat& q) { return {q.w, q.x, q.y, q.z}; }
    json make(const VoxelGrid& grid) { return make(grid.size()); }
    json make(const PaletteRef& palette) { return m_palettes.add(palette); }
    json make(const PaintColorsRef& paint) {
        json list = json::array();
        for (size_t i = 0; paint && i < paint->count; ++i)
            list.push_back({paint->colors[i][0], paint->colors[i][1], paint->colors[i][2]});
        return list;
    }
    template <class T>
    json make(const std::vector<T>& values) {
        json list = json::array();
        for (const T& value : values) list.push_back(make(value));
        return list;
    }
    template <class T>
    requires std::is_class_v<T> json make(const T& value) {
        json object = json::object();
        json* outer = std::exchange(m_object, &object);
        fields(*this, value);
        if constexpr (std::is_same_v<T, LevelShape>) object["grid"] = m_gridNames[m_shape++];
        m_object = outer;
        return object;
    }

private:
    PaletteList& m_palettes;
    const std::vector<std::string>& m_gridNames;
    size_t m_shape = 0;
    json* m_object = nullptr;
};

/// An archive that reads them back and keeps the path to the first error.
class JsonInputArchive {
public:
    JsonInputArchive(const std::vector<PaletteRef>& palettes, std::vector<std::string>& gridNames)
        : m_palettes(palettes), m_gridNames(gridNames) {}

    template <class T>
    void operator()(const char* name, T& value) {
        const auto found = m_object->find(name);
        if (found == m_object->end() || !m_error.empty()) return;
        enter(fmt::format(".{}", name), *found, value);
    }
    template <class T>
    void enter(const std::string& step, const json& from, T& value) {
        const size_t length = m_path.size();
        m_path += step;
        get(from, value);
        m_path.resize(length);
    }
    void get(const json& from, bool& value) {
        if (!from.is_boolean()) return fail("true or false", from);
        value = from.get<bool>();
    }
    template <class T>
    requires std::is_floating_point_v<T>
    void get(const json& from, T& value) {
        if (!from.is_number()) return fail("a number", from);
        value = from.get<T>();
    }
    template <class T>
    requires std::is_integral_v<T>
    void get(const json& from, T& value) {
        const bool fits = from.is_number_unsigned() ? from.get<uint64_t>() <= uint64_t(std::numeric_limits<T>::max())
                                                    : from.is_number_integer() && std::is_signed_v<T> &&
                                                          from.get<int64_t>() >= int64_t(std::numeric_limits<T>::min());
        if (!fits)
            return fail(fmt::format("a whole number from {} to {}", std::numeric_limits<T>::min(),
                                    std::numeric_limits<T>::max()),
                        from);
        value = from.get<T>();
    }
    template <class T>
    requires std::is_enum_v<T>
    void get(const json& from, T& value) {
        const auto names = enumNames(value);
        for (size_t i = 0; i < names.size(); ++i)
            if (from == names[i]) return void(value = T(i));
        fail(fmt::format("a name such as \"{}\"", names[0]), from);
    }
    void get(const json& from, std::string& text) {
        if (!from.is_string()) return fail("a text", from);
        text = from.get<std::string>();
    }
    template <class T>
    void get(const json& from, glm::vec<3, T>& v) {
        if (!from.is_array() || from.size() != 3) return fail("three numbers", from);
        get(from[0], v.x), get(from[1], v.y), get(from[2], v.z);
    }
    void get(const json& from, glm::dquat& q) {
        if (!from.is_array() || from.size() != 4) return fail("four numbers (w, x, y, z)", from);
        get(from[0], q.w), get(from[1], q.x), get(from[2], q.y), get(from[3], q.z);
    }
    void get(const json& from, VoxelGrid& grid) {
        glm::ivec3 size(0);
        get(from, size);
        if (!m_error.empty() || size == glm::ivec3(0)) return;
        for (int i = 0; i < 3; ++i)
            if (size[i] < 1 || size[i] > kMaxGridSize) return fail(fmt::format("sizes of 1 to {}", kMaxGridSize), from);
        if ((m_nodes += directoryNodes(size)) > kMaxDirectoryNodes) return fail("grids of 2^39 cells in all", from);
        grid = VoxelGrid(size);
    }
    void get(const json& from, PaletteRef& palette) {
        uint32_t number = 0;
        get(from, number);
        if (!m_error.empty()) return;
        if (number >= m_palettes.size()) return fail(fmt::format("a palette number below {}", m_palettes.size()), from);
        palette = m_palettes[number];
    }
    void get(const json& from, PaintColorsRef& paint) {
        if (!from.is_array() || from.size() > kPaintColors)
            return fail(fmt::format("a list of at most {} colours", kPaintColors), from);
        PaintColors colors;
        for (const json& color : from) {
            if (!color.is_array() || color.size() != 3) return fail("three numbers", color);
            for (size_t i = 0; i < 3; ++i) get(color[i], colors.colors[colors.count][i]);
            ++colors.count;
        }
        paint = colors.count ? std::make_shared<const PaintColors>(colors) : nullptr;
    }
    template <class T>
    void get(const json& from, std::vector<T>& values) {
        if (!from.is_array()) return fail("a list", from);
        values.clear();
        for (size_t i = 0; i < from.size() && m_error.empty(); ++i)
            enter(fmt::format("[{}]", i), from[i], values.emplace_back());
    }
    template <class T>
    requires std::is_class_v<T>
    void get(const json& from, T& value) {
        if (!from.is_object()) return fail("an object", from);
        const json* outer = std::exchange(m_object, &from);
        fields(*this, value);
        if constexpr (std::is_same_v<T, LevelShape>) {
            (*this)("grid", m_gridNames.emplace_back());
            if (m_gridNames.back().empty() && m_error.empty()) fail("a \"grid\" in each shape", from);
        }
        m_object = outer;
    }
    const std::string& error() const { return m_error; }

private:
    void fail(const std::string& expected, const json& found) {
        if (!m_error.empty()) return;
        std::string text = found.dump(-1, ' ', false, json::error_handler_t::replace);
        if (text.size() > 60) text = text.substr(0, 57) + "...";
        m_error = fmt::format("metadata rubble{}: expected {}, found {}", m_path, expected, text);
    }
    const std::vector<PaletteRef>& m_palettes;
    std::vector<std::string>& m_gridNames;
    uint64_t m_nodes = 0;
    const json* m_object = nullptr;
    std::string m_path, m_error;
};

constexpr int kMaxNesting = 64;  // a level needs fewer; messages print what they found, one inside the other

/// How deep lists and objects are nested in a JSON text.
int nestingOf(const std::string& text) {
    int depth = 0, deepest = 0;
    bool isInText = false;
    for (size_t i = 0; i < text.size(); ++i) {
        if (isInText && text[i] == '\\')
            ++i;
        else if (text[i] == '"')
            isInText = !isInText;
        else if (!isInText && (text[i] == '[' || text[i] == '{'))
            deepest = std::max(deepest, ++depth);
        else if (!isInText && (text[i] == ']' || text[i] == '}'))
            --depth;
    }
    return deepest;
}

/// The entries that differ from the default, each with its "index".
json paletteToJson(const Palette& palette, JsonOutputArchive& out) {
    json list = json::array();
    for (size_t i = 0; i < palette.size(); ++i) {
        if (palette[i] == PaletteEntry{}) continue;
        json entry = out.make(palette[i]);
        entry["index"] = i;
        list.push_back(std::move(entry));
    }
    return list;
}

std::vector<PaletteRef> palettesFromJson(const json& list, JsonInputArchive& in) {
    std::vector<PaletteRef> palettes;
    if (!list.is_array()) return palettes;
    for (const json& entries : list) {
        auto palette = std::make_shared<Palette>();
        for (size_t i = 0; entries.is_array() && i < entries.size() && in.error().empty(); ++i) {
            uint8_t index = 0;
            if (entries[i].is_object() && entries[i].contains("index"))
                in.enter(fmt::format(".palettes[{}][{}].index", palettes.size(), i), entries[i]["index"], index);
            in.enter(fmt::format(".palettes[{}][{}]", palettes.size(), i), entries[i], (*palette)[index]);
        }
        palettes.push_back(std::move(palette));
    }
    return palettes;
}

}  // namespace

std::map<std::string, std::string> levelToJson(const Level& level, const std::vector<std::string>& gridNames) {
    PaletteList palettes;
    JsonOutputArchive out(palettes, gridNames);
    json all = out.make(level);
    if (!level.scripts.empty()) all["scripts"] = out.make(level.scripts);
    all["palettes"] = json::array();
    for (const PaletteRef& palette : palettes.palettes()) all["palettes"].push_back(paletteToJson(*palette, out));
    std::map<std::string, std::string> topics;
    for (const auto& [topic, value] : all.items()) topics[topic] = value.dump();
    return topics;
}

Result<JsonLevel> levelFromJson(const std::map<std::string, std::string>& topics) {
    json all = json::object();
    for (const auto& [topic, text] : topics) {
        if (const int nesting = nestingOf(text); nesting > kMaxNesting)
            return Error{fmt::format("metadata rubble.{}: expected at most {} nested lists and objects, found {}",
                                     topic, kMaxNesting, nesting)};
        try {
            all[topic] = json::parse(text);
        } catch (const json::exception& error) {
            return Error{fmt::format("metadata rubble.{}: expected JSON, found an error: {}", topic, error.what())};
        }
    }
    JsonLevel out;
    std::vector<PaletteRef> palettes;
    JsonInputArchive in(palettes, out.gridNames);
    if (all.contains("palettes")) palettes = palettesFromJson(all["palettes"], in);
    if (in.error().empty()) in.get(all, out.level);
    if (in.error().empty() && all.contains("scripts")) in.get(all["scripts"], out.level.scripts);
    if (!in.error().empty()) return Error{in.error()};
    return out;
}

}  // namespace rubble
