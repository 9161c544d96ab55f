#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/script/binding/arguments.h"
#include "runtime/script/binding/script_context.h"

namespace rubble::script {

/// The table of functions of the script that runs, and its world.
inline const rubble_api& apiOf(lua_State* L) {
    return *ScriptContext::of(L).shared.api;
}
/// Its world.
inline rubble_world worldOf(lua_State* L) {
    return ScriptContext::of(L).shared.world;
}

/// Whether a script has made it since the last step: its handle is valid, but there is nothing to read yet.
inline bool isMadeInThisStep(lua_State* L, uint64_t object) {
    return ScriptContext::of(L).shared.pending.created.contains(object);
}

/// Into a field of the interface, and out of one.
template <size_t N>
void copy(double (&to)[N], const std::array<double, N>& from) {
    std::copy(from.begin(), from.end(), to);
}
/// Three numbers of a field.
inline Vector vectorOf(const double* values) {
    return {values[0], values[1], values[2]};
}
/// A position and a rotation of fields.
inline Placement placementOf(const double* position, const double* rotation) {
    return {vectorOf(position), {rotation[0], rotation[1], rotation[2], rotation[3]}};
}

/// A list of handles in ScriptContext::rows, which lives until the next such call: read(out, capacity, count) is a
/// function of the interface. Empty where something is gone.
template <class Read>
const std::vector<uint64_t>& readHandles(lua_State* L, Read&& read) {
    std::vector<uint64_t>& rows = ScriptContext::of(L).rows;
    uint32_t count = 0;
    rows.resize(std::max<size_t>(rows.capacity(), 64));
    rubble_result result = read(rows.data(), uint32_t(rows.size()), &count);
    if (result == RUBBLE_ERROR_CAPACITY) {
        rows.resize(count);
        result = read(rows.data(), count, &count);
    }
    rows.resize(isDone(L, result) ? count : 0);
    Sandbox::of(L).charge(L, int64_t(rows.size()) * 4);
    return rows;
}

/// The shapes, joints or lights of a body, or of a shape.
inline const std::vector<uint64_t>& readOwned(lua_State* L, uint64_t owner, uint32_t kind) {
    return readHandles(L, [&](uint64_t* out, uint32_t capacity, uint32_t* count) {
        return apiOf(L).get_objects_of(worldOf(L), owner, kind, out, capacity, count);
    });
}

/// Pushes the two corners of the box around the grids of shapes, in the world.
int pushBounds(lua_State* L, const std::vector<uint64_t>& shapes);

}  // namespace rubble::script
