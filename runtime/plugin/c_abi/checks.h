#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "runtime/core/handle.h"
#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"
#include "runtime/plugin/c_abi/first_sizes.h"
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

/// Checks struct_size. A host that was built with an older version gives less than is known here, but never less than
/// the first version. What a newer host gives beyond must be zero: it is told that this plugin does not know it,
/// instead of getting less than it asked for.
template <class T>
void checkStructSize(const T& given, const char* name) {
    static_assert(kFirstSize<T> > 0, "a struct without a line in RUBBLE_FIRST_SIZES");
    const uint32_t size = given.struct_size;
    if (size < kFirstSize<T> || size > kMaxStructSize)
        throw ApiError{RUBBLE_ERROR_STRUCT_SIZE, fmt::format("{}->struct_size is {}, expected {}, or {} at least", name,
                                                             size, sizeof(T), kFirstSize<T>)};
    const auto* bytes = reinterpret_cast<const unsigned char*>(&given);
    for (size_t i = sizeof(T); i < size; ++i)
        if (bytes[i])
            throw ApiError{RUBBLE_ERROR_STRUCT_SIZE,
                           fmt::format("{} sets a field at byte {} that this plugin does not know", name, i)};
}

/// The `size` bytes that a host knows of a struct, and zeros.
template <class T>
T copyStruct(const void* given, size_t size) {
    T out = {};
    std::memcpy(static_cast<void*>(&out), given, std::min(size, sizeof(T)));
    return out;
}

/// A field that has no meaning yet: one that a host sets would get another meaning later.
inline void readReserved(uint64_t given, const char* name) {
    if (given) throw ApiError{RUBBLE_ERROR_ARGUMENT, fmt::format("{} is {}, expected 0", name, given)};
}

/// A struct that the host has filled in; fields that the host does not know are zero.
template <class T>
T readStruct(const T* given, const char* name) {
    checkStructSize(requireNotNull(given, name), name);
    const T read = copyStruct<T>(given, given->struct_size);
    if constexpr (requires { read.reserved; })
        if (read.reserved) readReserved(read.reserved, (std::string(name) + "->reserved").c_str());
    return read;
}

/// Writes the fields of a struct of results that the host knows, except its struct_size. Those of a newer host stay
/// zero.
template <class T>
void writeStruct(T* out, T values) {
    checkStructSize(requireNotNull(out, "out"), "out");
    values.struct_size = out->struct_size;
    std::memcpy(static_cast<void*>(out), &values, std::min<size_t>(values.struct_size, sizeof(T)));
}

/// The bytes from one row of a host's array to the next, as it gives them; 0: those of the first version.
template <class Row>
uint32_t readRowSize(uint32_t given, const char* name) {
    if (!given) return kFirstSize<Row>;
    if (given >= kFirstSize<Row> && given <= kMaxStructSize) return given;
    throw ApiError{RUBBLE_ERROR_ARGUMENT,
                   fmt::format("{} is {}, expected {} to {}", name, given, kFirstSize<Row>, kMaxStructSize)};
}

/// Writes a row into `size` bytes: the fields that the host knows. Those of a newer host are zero.
template <class Row>
void writeRow(void* out, const Row& row, size_t size) {
    const size_t known = std::min(size, sizeof row);
    std::memcpy(out, &row, known);
    std::memset(static_cast<char*>(out) + known, 0, size - known);
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

/// Three finite numbers that are not all zero, whose squares are numbers of full precision: a very short or very long
/// direction is scaled.
inline glm::dvec3 readDirection(const double (&values)[3], const char* name) {
    const glm::dvec3 direction = readVector(values, name);
    const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    if (largest == 0.0)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, std::string(name) + " is zero, expected any other length"};
    return largest < 1e-12 ? direction / largest : direction;
}

/// The same from an argument that C passes as a pointer.
inline glm::dvec3 readDirectionAt(const double* values, const char* name) {
    return readDirection(reinterpret_cast<const double(&)[3]>(requireNotNull(values, name)), name);
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
