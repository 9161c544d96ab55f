#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "runtime/assets/state_fields.h"
#include "runtime/world/objects/object_errors.h"
#include "runtime/world/settings/settings_error.h"

namespace rubble {
namespace {

/// An archive (fields.h) that makes one number of an object, the given one of all in order, not a number.
class MakeNan {
public:
    static constexpr bool kIsBinary = true;
    explicit MakeNan(int number) : m_left(number) {}

    template <class T>
    void operator()(const char* name, T& value) {
        if (!m_isDone) m_name = name;
        visit(value);
    }
    /// Whether there was such a number.
    bool isDone() const { return m_isDone; }
    /// The field that it is in.
    const std::string& name() const { return m_name; }

private:
    template <class T>
    void visit(T& value) {
        if constexpr (std::is_floating_point_v<T>) {
            if (m_left-- != 0) return;
            value = std::numeric_limits<T>::quiet_NaN();
            m_isDone = true;
        } else if constexpr (HasFields<T>) {
            fields(*this, value);
        }
    }
    template <class T>
    void visit(glm::vec<3, T>& v) {
        visit(v.x), visit(v.y), visit(v.z);
    }
    void visit(glm::dquat& q) { visit(q.w), visit(q.x), visit(q.y), visit(q.z); }
    template <class T, size_t kSize>
    void visit(std::array<T, kSize>& values) {
        for (T& value : values) visit(value);
    }
    template <class T>
    void visit(std::vector<T>& values) {
        for (T& value : values) visit(value);
    }

    int m_left;
    bool m_isDone = false;
    std::string m_name;
};

template <class T, class ErrorOf>
void expectAllChecked(const T& valid, int atLeast, ErrorOf errorOf) {
    ASSERT_EQ(errorOf(valid), "");
    int numbers = 0;
    for (bool isDone = true; isDone; ++numbers) {
        T object = valid;
        MakeNan nan(numbers);
        fields(nan, object);
        isDone = nan.isDone();
        if (isDone) {
            EXPECT_NE(errorOf(object), "") << "in field " << nan.name();
        }
    }
    EXPECT_GT(numbers, atLeast);
}

template <class T>
void expectAllChecked(const T& valid, int atLeast) {
    expectAllChecked(valid, atLeast, [](const T& object) { return objectError(object); });
}

/// What one way into a world accepts and a save cannot hold would be lost.
TEST(ObjectFields, NoObjectMayHaveANumberThatIsNone) {
    for (const JointKind kind : {JointKind::Ball, JointKind::Hinge, JointKind::Wheel, JointKind::Rope}) {
        Joint joint{.kind = kind};
        if (kind == JointKind::Rope) joint.rope.points = 2, joint.points.resize(2);
        expectAllChecked(joint, 30);
    }
    for (const LightKind kind : {LightKind::Sphere, LightKind::Cone, LightKind::Screen})
        expectAllChecked(Light{.kind = kind}, 10);
    const GroundPolygon outline = {{0, 0}, {1, 0}, {1, 1}};
    for (const TriggerKind kind : {TriggerKind::Sphere, TriggerKind::Polygon})
        expectAllChecked(Trigger{.kind = kind, .outline = outline}, 10);
    expectAllChecked(Water{.outline = outline}, 10);
    expectAllChecked(Character{}, 10);
    expectAllChecked(Body{}, 10);
    expectAllChecked(Shape{}, 8);
    expectAllChecked(LightGroup{}, 1);
    expectAllChecked(WorldBox{}, 6);
    expectAllChecked(BoundsSettings{}, 6, [](const BoundsSettings& bounds) { return boundsError(bounds); });
    expectAllChecked(Material{}, 6);
    expectAllChecked(PaletteEntry{}, 1);
    expectAllChecked(Environment{}, 10, [](const Environment& environment) { return environmentError(environment); });
}

}  // namespace
}  // namespace rubble
