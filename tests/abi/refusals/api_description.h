#pragma once
#include <rubble/rubble.h>

#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace rubble {

/// Arguments of a call, eight bytes each: a pointer, or a number in the first bytes.
using Slots = std::array<uint64_t, 8>;

/// An argument of a function.
struct ArgumentDescription {
    std::string type;  ///< as C writes it
    std::string name;
    int rows;  ///< of an array of fixed length; 0: it is none
};
/// A function of the table.
struct FunctionDescription {
    std::string name, thread;  ///< thread: "main", "render" or "any"
    std::vector<ArgumentDescription> arguments;
    /// Calls it.
    rubble_result (*call)(const rubble_api& api, const Slots& slots);
};
/// A field of a struct.
struct FieldDescription {
    std::string type, name;
    size_t offset;
    int rows;  ///< of an array; 0: it is none
};
/// A struct of the interface.
struct StructDescription {
    std::string name;
    size_t size;
    std::vector<FieldDescription> fields;
};

/// All functions of the table that give a result, as describe_api.py found them in rubble.h.
const std::vector<FunctionDescription>& describedFunctions();
/// All structs of rubble.h.
const std::vector<StructDescription>& describedStructs();

/// Calls a function of the table with arguments of any types.
template <class... A>
rubble_result callWith(rubble_result (*function)(A...), const Slots& slots) {
    const auto read = [&]<class T>(size_t i, T*) {
        T value{};
        std::memcpy(&value, &slots[i], sizeof value);
        return value;
    };
    return [&]<size_t... kIndex>(std::index_sequence<kIndex...>) {
        return function(read(kIndex, static_cast<A*>(nullptr))...);
    }
    (std::index_sequence_for<A...>());
}
/// FunctionDescription::call of a function.
template <auto kFunction>
rubble_result callBySlots(const rubble_api& api, const Slots& slots) {
    return callWith(api.*kFunction, slots);
}

}  // namespace rubble
