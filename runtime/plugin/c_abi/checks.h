#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "runtime/core/handle.h"
#include "runtime/core/ranges.h"
#include "runtime/core/unit_length.h"
#include "runtime/plugin/c_abi/call.h"
#include "runtime/plugin/c_abi/first_sizes.h"
#include "runtime/plugin/include/rubble/rubble.h"

// Reads the host's arguments. Every function refuses the running call with the name of the argument, what was expected
// and what was found, and returns a value that does no harm.
namespace rubble::abi {

/// No struct of the interface is longer, so a larger struct_size is an error of the host.
inline constexpr uint32_t kMaxStructSize = 4096;

/// Whether a pointer is not null; refuses the call if it is.
inline bool isGiven(const void* pointer, const char* name) {
    if (!pointer) refuse(RUBBLE_ERROR_NULL, "{} is null", name);
    return pointer != nullptr;
}

/// Whether struct_size is right. A host that was built with an older version gives less than is known here, but never
/// less than the first version. What a newer host gives beyond must be zero: it is told that this plugin does not know
/// it, instead of getting less than it asked for.
template <class T>
bool hasKnownSize(const T& given, const char* name) {
    static_assert(kFirstSize<T> > 0, "a struct without a line in RUBBLE_FIRST_SIZES");
    const uint32_t size = given.struct_size;
    if (size < kFirstSize<T> || size > kMaxStructSize) {
        refuse(RUBBLE_ERROR_STRUCT_SIZE, "{}->struct_size is {}, expected {}, or {} at least", name, size, sizeof(T),
               kFirstSize<T>);
        return false;
    }
    const auto* bytes = reinterpret_cast<const unsigned char*>(&given);
    for (size_t i = sizeof(T); i < size; ++i)
        if (bytes[i]) {
            refuse(RUBBLE_ERROR_STRUCT_SIZE, "{} sets a field at byte {} that this plugin does not know", name, i);
            return false;
        }
    return true;
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
    if (given) refuse(RUBBLE_ERROR_ARGUMENT, "{} is {}, expected 0", name, given);
}

/// A struct that the host has filled in; fields that the host does not know are zero, and all if the call is refused.
template <class T>
T readStruct(const T* given, const char* name) {
    if (!isGiven(given, name) || !hasKnownSize(*given, name)) return {};
    const T read = copyStruct<T>(given, given->struct_size);
    if constexpr (requires { read.reserved; })
        if (read.reserved) refuse(RUBBLE_ERROR_ARGUMENT, "{}->reserved is {}, expected 0", name, read.reserved);
    return read;
}

/// Writes the fields of a struct of results that the host knows, except its struct_size. Those of a newer host stay
/// zero.
template <class T>
void writeStruct(T* out, T values) {
    if (isRefused() || !isGiven(out, "out") || !hasKnownSize(*out, "out")) return;
    values.struct_size = out->struct_size;
    std::memcpy(static_cast<void*>(out), &values, std::min<size_t>(values.struct_size, sizeof(T)));
}

/// The bytes from one row of a host's array to the next, as it gives them; 0: those of the first version.
template <class Row>
uint32_t readRowSize(uint32_t given, const char* name) {
    if (!given || (given >= kFirstSize<Row> && given <= kMaxStructSize)) return given ? given : kFirstSize<Row>;
    refuse(RUBBLE_ERROR_ARGUMENT, "{} is {}, expected {} to {}", name, given, kFirstSize<Row>, kMaxStructSize);
    return kFirstSize<Row>;
}

/// Writes a row into `size` bytes: the fields that the host knows. Those of a newer host are zero.
template <class Row>
void writeRow(void* out, const Row& row, size_t size) {
    const size_t known = std::min(size, sizeof row);
    std::memcpy(out, &row, known);
    std::memset(static_cast<char*>(out) + known, 0, size - known);
}

/// Refuses the call for what lightError(), jointError() and their like have found, if anything.
inline void requireNoError(const std::string& error) {
    if (!error.empty()) refuse(RUBBLE_ERROR_ARGUMENT, "{}", error);
}

/// A text of so many bytes; empty if the call is refused.
inline std::string readText(const char* text, size_t least, size_t most, const char* name) {
    if (!isGiven(text, name)) return {};
    const size_t length = strnlen(text, most + 1);
    if (length < least || length > most)
        refuse(RUBBLE_ERROR_ARGUMENT, "{} has {}{} bytes, expected {} to {}", name, length > most ? "more than " : "",
               std::min(length, most), least, most);
    return isRefused() ? std::string() : std::string(text, length);
}

/// Three numbers in a range.
inline glm::dvec3 readVector(const double (&values)[3], const char* name, NumberRange range = ranges::kCoordinate) {
    const glm::dvec3 vector(values[0], values[1], values[2]);
    for (int i = 0; i < 3; ++i)
        if (!isWithin(vector[i], range)) {
            refuse(RUBBLE_ERROR_ARGUMENT, "{}[{}] is {:g}, expected {:g} to {:g}", name, i, vector[i], range.low,
                   range.high);
            return glm::clamp(glm::dvec3(0.0), range.low, range.high);
        }
    return vector;
}

/// The same from an argument that C passes as a pointer.
inline glm::dvec3 readVectorAt(const double* values, const char* name) {
    return isGiven(values, name) ? readVector(reinterpret_cast<const double(&)[3]>(*values), name) : glm::dvec3(0.0);
}

/// Three finite numbers that are not all zero, whose squares are numbers of full precision: a very short or very long
/// direction is scaled.
inline glm::dvec3 readDirection(const double (&values)[3], const char* name) {
    const glm::dvec3 direction = readVector(values, name);
    const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    if (largest == 0.0) refuse(RUBBLE_ERROR_ARGUMENT, "{} is zero, expected any other length", name);
    return largest > 0.0 && largest < 1e-12 ? direction / largest : direction;
}

/// The same from an argument that C passes as a pointer.
inline glm::dvec3 readDirectionAt(const double* values, const char* name) {
    return isGiven(values, name) ? readDirection(reinterpret_cast<const double(&)[3]>(*values), name) : glm::dvec3(0.0);
}

/// A number in a range; 0 is a number like any other.
inline double readInRange(double value, NumberRange range, const char* name) {
    if (isWithin(value, range)) return value;
    refuse(RUBBLE_ERROR_ARGUMENT, "{} is {:g}, expected {:g} to {:g}", name, value, range.low, range.high);
    return range.low;
}

/// A number in a range, or ifZero for a value of 0.
inline double readOrDefault(double value, NumberRange range, double ifZero, const char* name) {
    if (value == 0.0) return ifZero;
    if (isWithin(value, range)) return value;
    refuse(RUBBLE_ERROR_ARGUMENT, "{} is {}, expected {}{} to {}", name, value,
           range.low > 0.0 ? "0 (the default) or " : "", range.low, range.high);
    return ifZero;
}

/// A number of an enum that ends with `last`.
inline uint32_t readEnum(uint32_t value, uint32_t last, const char* name) {
    if (value <= last) return value;
    refuse(RUBBLE_ERROR_ARGUMENT, "{} is {}, expected 0 to {}", name, value, last);
    return 0;
}

/// Flags of which all are in `known`.
inline uint32_t readFlags(uint32_t flags, uint32_t known, const char* name) {
    if (flags & ~known) refuse(RUBBLE_ERROR_ARGUMENT, "{} has unknown bits: {:#x}", name, flags & ~known);
    return flags & known;
}

/// Bits of collision layers, or ifZero for 0. RUBBLE_COLLISION_NONE gives no bits.
inline uint8_t readLayers(uint32_t bits, uint8_t ifZero, const char* name) {
    const uint32_t read = readEnum(bits, RUBBLE_COLLISION_NONE, name);
    return read == 0 ? ifZero : uint8_t(read & 255);
}

/// A unit quaternion from x, y, z, w; all zeros means no rotation. Lengths within a hundredth of 1 are normalised.
inline glm::dquat readRotation(const double (&values)[4], const char* name) {
    const glm::dquat rotation(values[3], values[0], values[1], values[2]);
    const double length = glm::length(rotation);
    if (std::abs(length - 1.0) < 1e-2) return unitLength(rotation);
    if (length != 0.0) refuse(RUBBLE_ERROR_ARGUMENT, "{} has length {}, expected 1", name, length);
    return {1.0, 0.0, 0.0, 0.0};
}

/// A handle of the right type, or 0. It may be stale.
template <HandleType kType>
Handle<kType> readHandle(uint64_t bits, const char* name) {
    const Handle<kType> handle{bits};
    if (!handle || handle.type() == kType) return handle;
    refuse(RUBBLE_ERROR_STALE, "{} is a handle of another type", name);
    return {};
}

/// What a handle names in a SlotMap; null, and the call is refused, if it names nothing.
template <HandleType kType, class Map>
auto* findLive(const Map& map, uint64_t bits, const char* name) {
    const Handle<kType> handle = readHandle<kType>(bits, name);
    const auto* value = map.find(handle);
    if (!value)
        refuse(RUBBLE_ERROR_STALE, "{}{}", name,
               !handle                  ? " is 0"
               : map.isReserved(handle) ? " names nothing before the next step()"
                                        : " is stale");
    return value;
}

/// A handle for an edit: it names something in a SlotMap, or something that an edit will make before this one has its
/// turn. Empty if the call is refused.
template <HandleType kType, class Map>
Handle<kType> readLiveHandle(const Map& map, uint64_t bits, const char* name) {
    if (map.isReserved(Handle<kType>{bits})) return {bits};
    return findLive<kType>(map, bits, name) ? Handle<kType>{bits} : Handle<kType>{};
}

/// 0, or a handle as readLiveHandle() reads it.
template <HandleType kType, class Map>
Handle<kType> readOptionalHandle(const Map& map, uint64_t bits, const char* name) {
    return bits ? readLiveHandle<kType>(map, bits, name) : Handle<kType>{};
}

/// All bytes for the host, or none: how many there are, and the bytes if it has given an array. Whether it has got
/// them.
template <class Count>
bool writeBytes(const void* bytes, Count size, void* out, Count capacity, Count* count) {
    *count = size;
    if (!capacity) return false;
    if (capacity < size) {
        refuse(RUBBLE_ERROR_CAPACITY, "there are {} bytes, the array holds {}", size, capacity);
        return false;
    }
    if (size) std::memcpy(out, bytes, size);
    return true;
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
