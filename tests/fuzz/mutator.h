#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "runtime/assets/state_fields.h"
#include "tests/fuzz/mutate_bytes.h"

namespace rubble {

/// An archive (fields.h) that changes fields of a value at random: files of it have valid checksums and lying contents.
class Mutator {
public:
    /// One field in `cases` is changed. `keepsNames`: enums keep a value that has a name, which JSON stores.
    Mutator(Decisions& decisions, uint32_t cases, bool keepsNames = false)
        : m_decisions(decisions), m_cases(cases), m_keepsNames(keepsNames) {}

    template <class T>
    void operator()(const char*, T& value) {
        change(value);
    }

private:
    bool wants() { return m_decisions.oneIn(m_cases); }

    void change(bool& value) { value ^= wants(); }
    template <class T>
    requires std::is_floating_point_v<T>
    void change(T& value) {
        if (wants()) value = T(std::clamp(m_decisions.wild(), -1e38, 1e38));
        if (wants() && m_decisions.oneIn(8)) value = std::numeric_limits<T>::quiet_NaN();
    }
    template <class T>
    requires std::is_integral_v<T>
    void change(T& value) {
        if (!wants()) return;
        const uint64_t bits = m_decisions.bits();
        value = m_decisions.oneIn(2) ? T(bits % 5) : m_decisions.oneIn(2) ? T(value + T(bits % 3) - 1) : T(bits);
    }
    template <class T>
    requires std::is_enum_v<T>
    void change(T& value) {
        if (wants()) value = T(m_decisions.below(m_keepsNames ? uint32_t(enumNames(value).size()) : 8));
    }
    void change(std::string& text) {
        if (wants())
            text = m_decisions.oneIn(2) ? "shape" : std::string(m_decisions.below(40), char(m_decisions.below(256)));
    }
    template <class T>
    void change(glm::vec<3, T>& v) {
        change(v.x), change(v.y), change(v.z);
    }
    void change(glm::dquat& q) { change(q.w), change(q.x), change(q.y), change(q.z); }
    void change(VoxelGrid& grid) {
        if (!wants()) return;
        const glm::ivec3 size(1 + m_decisions.below(40), 1 + m_decisions.below(40), 1 + m_decisions.below(40));
        grid = m_decisions.oneIn(4) ? VoxelGrid() : VoxelGrid(size);
        if (grid.size().x && m_decisions.oneIn(2)) GridWriter(grid).set(size / 2, uint8_t(m_decisions.below(256)));
    }
    void change(PaletteRef& palette) {
        if (!palette || !wants()) return;
        auto copy = std::make_shared<Palette>(*palette);
        fields(*this, (*copy)[m_decisions.below(256)]);
        palette = std::move(copy);
    }
    void change(PaintColorsRef& colors) {
        if (wants()) colors = std::make_shared<PaintColors>(PaintColors{.count = uint8_t(m_decisions.below(16))});
    }
    template <HandleType kType>
    void change(Handle<kType>& handle) {
        if (wants())
            handle = Handle<kType>::make(uint8_t(m_decisions.oneIn(20) ? 3 : 1), 1 + m_decisions.below(3),
                                         m_decisions.below(8));
        if (wants()) handle = {};
    }
    void change(WholeShape& shape) { change(static_cast<LevelShape&>(shape)); }
    template <class T, size_t kSize>
    void change(std::array<T, kSize>& values) {
        for (T& value : values) change(value);
    }
    template <class... T>
    void change(std::variant<T...>& value) {
        if (wants() && m_decisions.oneIn(2)) {
            const uint32_t index = m_decisions.below(sizeof...(T));
            uint32_t i = 0;
            ((index == i++ ? void(value.template emplace<T>()) : void()), ...);
        }
        std::visit([&](auto& each) { change(each); }, value);
    }
    template <class T>
    void change(std::vector<T>& values) {
        if (wants() && !values.empty()) values.erase(values.begin() + m_decisions.below(uint32_t(values.size())));
        if (wants() && values.size() < 1000)
            values.push_back(
                values.empty() || m_decisions.oneIn(2) ? T{} : values[m_decisions.below(uint32_t(values.size()))]);
        if constexpr (!std::is_same_v<T, uint8_t>)
            for (T& value : values) change(value);
        else if (wants() && !values.empty())
            values[m_decisions.below(uint32_t(values.size()))] = uint8_t(m_decisions.below(256));
    }
    template <class T>
    requires std::is_class_v<T>
    void change(T& value) { fields(*this, value); }

    Decisions& m_decisions;
    uint32_t m_cases;
    bool m_keepsNames;

public:
    static constexpr bool kIsBinary = true;  ///< fields of binary files too
    /// Changes one value and all that it holds.
    template <class T>
    void mutate(T& value) {
        change(value);
    }
};

}  // namespace rubble
