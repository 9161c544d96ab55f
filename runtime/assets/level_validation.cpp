#include "runtime/assets/level_validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <utility>
#include <vector>

#include "runtime/assets/level_fields.h"
#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"
#include "runtime/core/utf8.h"
#include "runtime/voxel/paint_colors.h"
#include "runtime/world/objects/object_errors.h"

namespace rubble {
namespace {

/// An archive that checks all fields and keeps the path to the first bad one.
class LevelValidator {
public:
    Result<Done> run(const Level& level) {
        m_lightGroups = level.lightGroups.size();
        m_materials = level.materials.materials.size();
        m_tagged = {level.lights.size(), level.lightGroups.size(), level.waters.size(), level.characters.size(),
                    level.joints.size()};
        if (!isWithin(double(m_materials), ranges::kMaterials))
            return Error{fmt::format("materials: expected 1 to 256, found {}", m_materials)};
        check(level);
        if (!m_error.empty()) return Error{m_error};
        return Done{};
    }

    template <class T>
    void operator()(const char* name, const T& value) {
        if (!m_error.empty()) return;
        m_path.push_back({name, 0});
        check(value);
        m_path.pop_back();
    }

private:
    template <class T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void check(T value) {
        if constexpr (std::is_floating_point_v<T>)
            if (!std::isfinite(value)) fail("a finite number", fmt::format("{}", value));
    }
    void check(const std::string& text) {
        if (!isUtf8(text)) fail("text in UTF-8", "other bytes");
    }
    template <class T>
    void check(const glm::vec<3, T>& v) {
        for (int i = 0; i < 3; ++i) check(v[i]);
    }
    void check(const glm::dquat& q) {
        const double length2 = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
        if (!isWithin(length2, ranges::kRotationLength2))
            fail("a rotation of length 1", fmt::format("{}", std::sqrt(length2)));
    }
    void check(const VoxelGrid&) {}
    void check(const PaintColorsRef&) {}
    void check(const PaletteRef& palette) {
        if (!palette || !m_checked.insert(palette.get()).second) return;
        for (size_t i = 0; i < palette->size(); ++i) {
            const PaletteEntry& entry = (*palette)[i];
            if (const std::string error = objectError(entry); !error.empty())
                fail("a valid entry", fmt::format("{} in entry {}", error, i));
            if (entry.lightGroup > m_lightGroups)
                fail(fmt::format("a light group of at most {}", m_lightGroups),
                     fmt::format("{} in entry {}", entry.lightGroup, i));
            if (entry.material >= m_materials)
                fail(fmt::format("a material below {}", m_materials), fmt::format("{} in entry {}", entry.material, i));
        }
    }
    template <class T>
    void check(const std::vector<T>& values) {
        for (size_t i = 0; i < values.size() && m_error.empty(); ++i) {
            m_path.push_back({nullptr, i});
            check(values[i]);
            m_path.pop_back();
        }
    }
    template <class T>
    requires std::is_class_v<T>
    void check(const T& value) {
        checkRanges(value);
        fields(*this, value);
    }

    // Rules of one type, beside those of its fields.
    template <class T>
    void checkRanges(const T&) {}
    void checkRanges(const Pose& pose) { require("a valid pose", RangeCheck().pose("it", pose).error()); }
    void checkRanges(const LevelShape& shape) {
        require("a valid shape", shapeError(shape.local, shape.voxelSize, shape.strength));
        require("a valid shape", factorsError(shape.density, shape.emission));
        checkPaint(shape);
    }
    void checkRanges(const LevelBody& body) {
        require("a valid body", objectError(Body{.pose = body.pose,
                                                 .velocity = body.velocity,
                                                 .angularVelocity = body.angularVelocity,
                                                 .gravityScale = body.gravityScale,
                                                 .linearDamping = body.linearDamping,
                                                 .angularDamping = body.angularDamping}));
    }
    void checkRanges(const Material& material) { require("a valid material", objectError(material)); }
    void checkRanges(const LightGroup& group) { require("a valid light group", objectError(group)); }
    void checkRanges(const Water& water) { require("a valid water", objectError(water)); }
    void checkRanges(const LightImage& image) {
        if (!image.isWhole())
            fail(
                fmt::format("whole rows of an image of at most {} x {} texels", kMaxLightImageSide, kMaxLightImageSide),
                fmt::format("{} texels in rows of {}", image.texels.size(), image.width));
    }
    void checkRanges(const LevelLight& light) { require("a valid light", lightError(light.light)); }
    void checkRanges(const Environment& environment) { require("a valid environment", environmentError(environment)); }
    void checkRanges(const WorldBox& box) { require("a valid box", objectError(box)); }
    void checkRanges(const Joint& joint) { require("a valid joint", jointError(joint)); }
    void checkRanges(const Trigger& trigger) { require("a valid trigger", objectError(trigger)); }
    void checkRanges(const LevelTags& tags) {
        const size_t count = m_tagged.at(size_t(tags.kind));
        if (tags.number >= count)
            fail(fmt::format("a number below {}, that of the level's objects of that kind", count),
                 fmt::format("{}", tags.number));
    }
    void checkRanges(const Character& character) { require("a valid character", objectError(character)); }
    /// Painted voxels must have one of the shape's colours.
    void checkPaint(const LevelShape& shape) {
        const int colors = shape.paintColors ? shape.paintColors->count : 0;
        int highest = 0;
        shape.grid.forEachBrick(
            [&](glm::ivec3, const BrickRef& brick) { highest = std::max(highest, highestPaintColor(*brick)); });
        if (highest > colors)
            fail(fmt::format("paint of the {} colours that the shape has", colors), fmt::format("colour {}", highest));
    }

    void require(const char* expected, const std::string& error) {
        if (!error.empty()) fail(expected, error);
    }
    void fail(const std::string& expected, const std::string& found) {
        if (!m_error.empty()) return;
        std::string path;
        for (const auto& [name, index] : m_path)
            path += !name ? fmt::format("[{}]", index) : path.empty() ? name : std::string(".") + name;
        m_error = fmt::format("{}: expected {}, found {}", path, expected, found);
    }

    std::vector<std::pair<const char*, size_t>> m_path;  ///< names of fields; no name: an index
    std::unordered_set<const Palette*> m_checked;        ///< shapes share palettes
    std::string m_error;
    size_t m_lightGroups = 0, m_materials = 0;
    std::array<size_t, 5> m_tagged{};  ///< objects by TaggedKind
};

}  // namespace

Result<Done> validateLevel(const Level& level) {
    return LevelValidator().run(level);
}

}  // namespace rubble
