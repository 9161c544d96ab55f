#pragma once
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "runtime/core/handle.h"
#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"
#include "runtime/plugin/include/rubble/rubble.h"

// Reads the host's arguments. Every function throws ApiError with the name of the argument, what was expected and what
// was found.
namespace rubble::abi {

/// Why a call of the host fails. Thrown inside the plugin only; guarded() turns it into a result.
struct ApiError {
    rubble_result code;
    std::string text;
};

/// No struct of the interface is longer, so a larger struct_size is an error of the host.
inline constexpr uint32_t kMaxStructSize = 4096;

/// What the pointer points at.
template <class T>
T& requireNotNull(T* pointer, const char* name) {
    if (!pointer) throw ApiError{RUBBLE_ERROR_NULL, std::string(name) + " is null"};
    return *pointer;
}

/// Checks struct_size. Fields behind those of this version must be zero: a newer host is told that this plugin does not
/// know them, instead of getting less than it asked for.
template <class T>
void checkStructSize(const T& given, const char* name) {
    const uint32_t size = given.struct_size;
    if (size < sizeof(T) || size > kMaxStructSize)
        throw ApiError{RUBBLE_ERROR_STRUCT_SIZE,
                       fmt::format("{}->struct_size is {}, expected {}", name, size, sizeof(T))};
    const auto* bytes = reinterpret_cast<const unsigned char*>(&given);
    for (size_t i = sizeof(T); i < size; ++i)
        if (bytes[i])
            throw ApiError{RUBBLE_ERROR_STRUCT_SIZE,
                           fmt::format("{} sets a field at byte {} that this plugin does not know", name, i)};
}

/// A struct that the host has filled in.
template <class T>
const T& readStruct(const T* given, const char* name) {
    checkStructSize(requireNotNull(given, name), name);
    if constexpr (requires { given->reserved; })
        if (given->reserved)
            throw ApiError{RUBBLE_ERROR_ARGUMENT, fmt::format("{}->reserved is {}, expected 0", name, given->reserved)};
    return *given;
}

/// Writes all fields of a struct of results except its struct_size. Fields of a newer host stay zero.
template <class T>
void writeStruct(T* out, T values) {
    checkStructSize(requireNotNull(out, "out"), "out");
    values.struct_size = out->struct_size;
    *out = values;
}

/// Throws what lightError(), jointError() and their like have found, if anything.
inline void requireNoError(const std::string& error) {
    if (!error.empty()) throw ApiError{RUBBLE_ERROR_ARGUMENT, error};
}

/// Three numbers in a range.
inline glm::dvec3 readVector(const double (&values)[3], const char* name, NumberRange range = ranges::kCoordinate) {
    const glm::dvec3 vector(values[0], values[1], values[2]);
    requireNoError(RangeCheck().vector(name, vector, range).error());
    return vector;
}

/// The same from an argument that C passes as a pointer.
inline glm::dvec3 readVectorAt(const double* values, const char* name) {
    return readVector(reinterpret_cast<const double(&)[3]>(requireNotNull(values, name)), name);
}

/// Three finite numbers that are not all zero.
inline glm::dvec3 readDirection(const double (&values)[3], const char* name) {
    const glm::dvec3 direction = readVector(values, name);
    if (direction == glm::dvec3(0.0))
        throw ApiError{RUBBLE_ERROR_ARGUMENT, std::string(name) + " is zero, expected any other length"};
    return direction;
}

/// A number in a range; 0 is a number like any other.
inline double readInRange(double value, NumberRange range, const char* name) {
    requireNoError(RangeCheck().number(name, value, range).error());
    return value;
}

/// A number in a range, or ifZero for a value of 0.
inline double readOrDefault(double value, NumberRange range, double ifZero, const char* name) {
    if (value == 0.0) return ifZero;
    if (isWithin(value, range)) return value;
    throw ApiError{RUBBLE_ERROR_ARGUMENT,
                   fmt::format("{} is {}, expected {}{} to {}", name, value,
                               range.low > 0.0 ? "0 (the default) or " : "", range.low, range.high)};
}

/// A number of an enum that ends with `last`.
inline uint32_t readEnum(uint32_t value, uint32_t last, const char* name) {
    if (value <= last) return value;
    throw ApiError{RUBBLE_ERROR_ARGUMENT, fmt::format("{} is {}, expected 0 to {}", name, value, last)};
}

/// Flags of which all are in `known`.
inline uint32_t readFlags(uint32_t flags, uint32_t known, const char* name) {
    if (!(flags & ~known)) return flags;
    throw ApiError{RUBBLE_ERROR_ARGUMENT, fmt::format("{} has unknown bits: {:#x}", name, flags & ~known)};
}

/// Bits of collision layers, or ifZero for 0. RUBBLE_COLLISION_NONE gives no bits.
inline uint8_t readLayers(uint32_t bits, uint8_t ifZero, const char* name) {
    readEnum(bits, RUBBLE_COLLISION_NONE, name);
    return bits == 0 ? ifZero : uint8_t(bits & 255);
}

/// A unit quaternion from x, y, z, w; all zeros means no rotation. Lengths within a hundredth of 1 are normalised.
inline glm::dquat readRotation(const double (&values)[4], const char* name) {
    const glm::dquat rotation(values[3], values[0], values[1], values[2]);
    const double length = glm::length(rotation);
    if (length == 0.0) return {1.0, 0.0, 0.0, 0.0};
    if (!(std::abs(length - 1.0) < 1e-2))
        throw ApiError{RUBBLE_ERROR_ARGUMENT, fmt::format("{} has length {}, expected 1", name, length)};
    return rotation / length;
}

/// A handle of the right type, or 0. It may be stale.
template <HandleType kType>
Handle<kType> readHandle(uint64_t bits, const char* name) {
    const Handle<kType> handle{bits};
    if (handle && handle.type() != kType)
        throw ApiError{RUBBLE_ERROR_STALE, std::string(name) + " is a handle of another type"};
    return handle;
}

/// A handle that names something in a SlotMap.
template <HandleType kType, class Map>
Handle<kType> readLiveHandle(const Map& map, uint64_t bits, const char* name) {
    const Handle<kType> handle = readHandle<kType>(bits, name);
    if (!map.find(handle)) throw ApiError{RUBBLE_ERROR_STALE, std::string(name) + (handle ? " is stale" : " is 0")};
    return handle;
}

/// 0, or a handle that names something in a SlotMap.
template <HandleType kType, class Map>
Handle<kType> readOptionalHandle(const Map& map, uint64_t bits, const char* name) {
    return bits ? readLiveHandle<kType>(map, bits, name) : Handle<kType>{};
}

/// Copies a vector into a row.
inline void writeVector(double (&out)[3], glm::dvec3 value) {
    out[0] = value.x, out[1] = value.y, out[2] = value.z;
}
/// Copies a cell of a grid into a row.
inline void writeCell(int32_t (&out)[3], glm::ivec3 cell) {
    out[0] = cell.x, out[1] = cell.y, out[2] = cell.z;
}
/// Copies a rotation into a row as x, y, z, w.
inline void writeRotation(double (&out)[4], glm::dquat value) {
    out[0] = value.x, out[1] = value.y, out[2] = value.z, out[3] = value.w;
}

}  // namespace rubble::abi
