#pragma once
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "runtime/core/handle.h"
#include "runtime/core/number_range.h"
#include "runtime/plugin/include/rubble/rubble.h"

namespace rubble::abi {

/// Why a call of the host is refused. Thrown inside the plugin only; guarded() turns it into a result.
struct ApiError {
    rubble_result code;
    std::string text;
};

/// No struct of the interface is longer, so a larger struct_size is not a size.
inline constexpr uint32_t kMaxStructSize = 4096;

template <class T>
T& requireNotNull(T* pointer, const char* name) {
    if (!pointer) throw ApiError{RUBBLE_ERROR_NULL, std::string(name) + " is null"};
    return *pointer;
}

/// Fields that this version does not know must be zero: a newer host does not get less than it asked for without a
/// word.
template <class T>
void checkStructSize(const T& given, const char* name) {
    const uint32_t size = given.struct_size;
    if (size < sizeof(T) || size > kMaxStructSize)
        throw ApiError{RUBBLE_ERROR_STRUCT_SIZE, std::string(name) + "->struct_size is " + std::to_string(size) +
                                                     ", expected " + std::to_string(sizeof(T))};
    const auto* bytes = reinterpret_cast<const unsigned char*>(&given);
    for (size_t i = sizeof(T); i < size; ++i)
        if (bytes[i])
            throw ApiError{RUBBLE_ERROR_STRUCT_SIZE, std::string(name) + " sets a field at byte " + std::to_string(i) +
                                                         " that this plugin does not know"};
}

template <class T>
const T& readStruct(const T* given, const char* name) {
    checkStructSize(requireNotNull(given, name), name);
    return *given;
}

/// Writes all fields of a struct of results but its size. What the host knows beyond them stays zero.
template <class T>
void writeStruct(T* out, T values) {
    values.struct_size = readStruct(out, "out").struct_size;
    *out = values;
}

/// Refuses what lightError(), jointError() and their like have found.
inline void requireNoError(const std::string& error) {
    if (!error.empty()) throw ApiError{RUBBLE_ERROR_ARGUMENT, error};
}

inline glm::dvec3 readVector(const double (&values)[3], const char* name) {
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(values[i]) || std::abs(values[i]) > 1e9)
            throw ApiError{RUBBLE_ERROR_ARGUMENT,
                           std::string(name) + "[" + std::to_string(i) + "] is " + std::to_string(values[i])};
    return {values[0], values[1], values[2]};
}

/// In [low, high]; 0 is a number like any other.
inline double readInRange(double value, double low, double high, const std::string& name) {
    if (isWithin(value, low, high)) return value;
    throw ApiError{RUBBLE_ERROR_ARGUMENT, name + " is " + std::to_string(value) + ", expected " + std::to_string(low) +
                                              " to " + std::to_string(high)};
}

/// The same, but a value of 0 stands for `ifZero`.
inline double readOrDefault(double value, double low, double high, double ifZero, const char* name) {
    return value == 0.0 ? ifZero : readInRange(value, low, high, name);
}

/// x, y, z, w; all zero is no rotation.
inline glm::dquat readRotation(const double (&values)[4], const char* name) {
    const glm::dquat rotation(values[3], values[0], values[1], values[2]);
    const double length = glm::length(rotation);
    if (length == 0.0) return {1.0, 0.0, 0.0, 0.0};
    if (!(std::abs(length - 1.0) < 1e-2))
        throw ApiError{RUBBLE_ERROR_ARGUMENT,
                       std::string(name) + " has length " + std::to_string(length) + ", expected 1"};
    return rotation / length;
}

template <HandleType kType>
Handle<kType> readHandle(uint64_t bits, const char* name) {
    const Handle<kType> handle{bits};
    if (handle && handle.type() != kType)
        throw ApiError{RUBBLE_ERROR_STALE, std::string(name) + " is a handle of another type"};
    return handle;
}

inline void writeVector(double (&out)[3], glm::dvec3 value) {
    out[0] = value.x, out[1] = value.y, out[2] = value.z;
}
inline void writeRotation(double (&out)[4], glm::dquat value) {
    out[0] = value.x, out[1] = value.y, out[2] = value.z, out[3] = value.w;
}

}  // namespace rubble::abi
