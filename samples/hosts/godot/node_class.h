#pragma once
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "samples/hosts/godot/variant.h"

namespace rubble_godot {

/// The arguments of a call from Godot.
class Arguments {
public:
    /// Of values that live as long as the call.
    Arguments(const gd::VariantBytes* const* values, int32_t count) : m_values(values), m_count(count) {}
    /// Argument `index`, or `fallback` where the caller gave fewer.
    template <class T>
    T get(int32_t index, T fallback = T{}) const {
        if (index >= m_count) return fallback;
        gd::VariantBytes copy;
        gd::variantCopy(&copy, m_values[index]);
        return Variant::take(copy).as<T>();
    }

private:
    const gd::VariantBytes* const* m_values;
    int32_t m_count;
};

/// How the inspector edits a property.
struct Hint {
    int32_t kind = 0;  ///< gd::kHintRange, kHintEnum, kHintFile
    const char* text = "";
};

/// Godot's type of a type of C++.
template <class T>
constexpr gd::Type typeOf() {
    if (std::is_same_v<T, bool>) return gd::Type::Bool;
    if (std::is_same_v<T, int64_t>) return gd::Type::Int;
    if (std::is_same_v<T, double>) return gd::Type::Real;
    if (std::is_same_v<T, std::string>) return gd::Type::String;
    return std::is_same_v<T, Vec3> ? gd::Type::Vector3 : gd::Type::Color;
}

/// Registers a class T, made with its node, under a name as one that extends a class of Godot.
template <class T>
class NodeClass {
public:
    /// handle: of the library, as Godot gave it.
    NodeClass(void* handle, const char* name, const char* base) : m_handle(handle), m_name(name) {
        gd::registerClass(handle, name, base, {[](gd::Object* node, void*) -> void* { return new T(node); }},
                          {[](gd::Object*, void*, void* self) { delete static_cast<T*>(self); }});
    }

    /// A method, whose member takes Arguments and returns a Variant.
    template <auto member>
    NodeClass& method(const char* name) {
        const auto call = [](gd::Object*, void*, void* self, int32_t count, const gd::VariantBytes* const* values) {
            return (static_cast<T*>(self)->*member)(Arguments(values, count)).release();
        };
        gd::registerMethod(m_handle, m_name, name, {0}, {call});
        return *this;
    }

    /// A property that is a member; its value in a new object is the default.
    template <auto member>
    NodeClass& property(const char* name, Hint hint = {}) {
        using Value = std::remove_reference_t<decltype(std::declval<T&>().*member)>;
        gd::PropertyAttributes attributes{};
        attributes.type = typeOf<Value>();
        attributes.hint = hint.kind;
        attributes.hintText = makeString(hint.text);
        attributes.usage = gd::kUsageDefault;
        attributes.value = Variant(T(nullptr).*member).release();
        const auto set = [](gd::Object*, void*, void* self, const gd::VariantBytes* value) {
            static_cast<T*>(self)->*member = Arguments(&value, 1).template get<Value>(0);
        };
        const auto get = [](gd::Object*, void*, void* self) {
            return Variant(static_cast<T*>(self)->*member).release();
        };
        gd::registerProperty(m_handle, m_name, name, &attributes, {set}, {get});
        gd::stringDestroy(&attributes.hintText);
        gd::variantDestroy(&attributes.value);
        return *this;
    }

    /// A signal with named arguments.
    NodeClass& signal(const char* name, const std::vector<std::pair<const char*, gd::Type>>& arguments) {
        std::vector<gd::SignalArgument> rows;
        for (const auto& [text, type] : arguments)
            rows.push_back({makeString(text), type, 0, makeString(""), gd::kUsageDefault, Variant().release()});
        gd::Signal signal{makeString(name), int32_t(rows.size()), rows.data(), 0, nullptr};
        gd::registerSignal(m_handle, m_name, &signal);
        gd::stringDestroy(&signal.name);
        for (gd::SignalArgument& row : rows) gd::stringDestroy(&row.name), gd::stringDestroy(&row.hintText);
        return *this;
    }

private:
    static gd::StringBytes makeString(const char* text) {
        gd::StringBytes string;
        gd::stringNew(&string);
        gd::stringParseUtf8(&string, text);
        return string;
    }
    void* m_handle;
    const char* m_name;
};

}  // namespace rubble_godot
