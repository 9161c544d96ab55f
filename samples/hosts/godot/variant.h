#pragma once
#include <array>
#include <bit>
#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "samples/hosts/godot/gdnative.h"

namespace rubble_godot {

using Vec3 = std::array<float, 3>;   ///< Godot's Vector3
using Color = std::array<float, 4>;  ///< Godot's Color: red, green, blue, alpha
/// Godot's Transform: the rows of its basis, then its origin.
struct Transform {
    std::array<Vec3, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Vec3 origin{};
};

/// A value of Godot. [main-thread]
class Variant {
public:
    /// Null.
    Variant() { gd::variantNil(&m_bytes); }
    /// A bool.
    Variant(bool value) { gd::variantBool(&m_bytes, value); }
    /// An int, which has 64 bits.
    template <std::integral T>
    Variant(T value) {
        gd::variantInt(&m_bytes, int64_t(value));
    }
    /// A float, which has 64 bits.
    Variant(double value) { gd::variantReal(&m_bytes, value); }
    /// A string of UTF-8.
    Variant(const char* text);
    /// The same.
    Variant(const std::string& text) : Variant(text.c_str()) {}
    /// A Vector3.
    Variant(const Vec3& value);
    /// A Color.
    Variant(const Color& value);
    /// A Transform.
    Variant(const Transform& value);
    /// An object; of a reference it holds a count.
    Variant(gd::Object* object) { gd::variantObject(&m_bytes, object); }
    /// The same value; arrays and objects are shared.
    Variant(const Variant& other) { gd::variantCopy(&m_bytes, &other.m_bytes); }
    /// Leaves null.
    Variant(Variant&& other) noexcept : Variant() { std::swap(m_bytes, other.m_bytes); }
    /// Takes over a value.
    Variant& operator=(Variant other) noexcept {
        std::swap(m_bytes, other.m_bytes);
        return *this;
    }
    ~Variant() { gd::variantDestroy(&m_bytes); }

    /// An array of values.
    static Variant array(const std::vector<Variant>& values);
    /// A pool array of ints.
    static Variant pool(const std::vector<int32_t>& values);
    /// A pool array of vectors.
    static Variant pool(const std::vector<Vec3>& values);
    /// A pool array of colours.
    static Variant pool(const std::vector<Color>& values);
    /// Takes over the bytes of a value.
    static Variant take(const gd::VariantBytes& bytes);

    /// The value as one of C++: bool, int64_t, double, std::string, Vec3, Color, Transform, gd::Object*.
    template <class T>
    T as() const {
        if constexpr (std::is_same_v<T, bool>) return gd::asBool(&m_bytes);
        if constexpr (std::is_same_v<T, int64_t>) return gd::asInt(&m_bytes);
        if constexpr (std::is_same_v<T, double>) return gd::asReal(&m_bytes);
        if constexpr (std::is_same_v<T, std::string>) return asString();
        if constexpr (std::is_same_v<T, Vec3>) return std::bit_cast<T>(gd::asVector3(&m_bytes));
        if constexpr (std::is_same_v<T, Color>) return std::bit_cast<T>(gd::asColor(&m_bytes));
        if constexpr (std::is_same_v<T, Transform>) return std::bit_cast<T>(gd::asTransform(&m_bytes));
        if constexpr (std::is_same_v<T, gd::Object*>) return gd::asObject(&m_bytes);
    }
    /// Width and height of a Vector2, rounded.
    std::array<int32_t, 2> asSize() const;
    /// The content of a PoolByteArray.
    std::vector<uint8_t> asBytes() const;
    /// A number that equal RIDs share: Godot keeps their pointer behind the type of the value.
    uint64_t ridKey() const;
    /// The bytes, for a call.
    const gd::VariantBytes& bytes() const { return m_bytes; }
    /// The bytes, for Godot to destroy.
    gd::VariantBytes release();

private:
    std::string asString() const;
    gd::VariantBytes m_bytes{};
};

/// A method of a class of Godot, found when it is first called.
class Method {
public:
    /// owner: the class that has it, as Godot names it.
    constexpr Method(const char* owner, const char* name) : m_owner(owner), m_name(name) {}
    /// Calls it; an error is printed and gives an empty value.
    template <class... Arguments>
    Variant operator()(gd::Object* object, const Arguments&... arguments) const {
        const std::array<Variant, sizeof...(Arguments)> values{Variant(arguments)...};
        std::array<const gd::VariantBytes*, sizeof...(Arguments) + 1> pointers{};
        for (size_t i = 0; i < values.size(); ++i) pointers[i] = &values[i].bytes();
        return call(object, pointers.data(), int32_t(values.size()));
    }

private:
    Variant call(gd::Object* object, const gd::VariantBytes* const* arguments, int32_t count) const;
    const char* m_owner;
    const char* m_name;
    mutable gd::MethodBind* m_bind = nullptr;
};

/// A singleton such as "VisualServer".
gd::Object* singleton(const char* name);
/// Prints an error of Godot.
void printError(std::string_view text);
/// Prints a warning of Godot.
void printWarning(std::string_view text);
/// The content of a file by Godot's path, also of one in a package ("res://..."); false: it cannot be read.
bool readFile(const std::string& path, std::vector<uint8_t>& out);

}  // namespace rubble_godot
