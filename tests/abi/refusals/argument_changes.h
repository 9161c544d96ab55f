#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tests/abi/refusals/host_call.h"

namespace rubble {

/// A wrong value of one argument, or of a field of what it points at.
struct ArgumentChange {
    std::string place;       ///< "argument" or "argument.field"
    std::string what;        ///< "NaN", "stale"
    rubble_result expected;  ///< what the call shall answer
    std::function<void(HostCall&)> make;

    /// The name that the message must have.
    std::string word() const { return place.substr(place.rfind('.') + 1); }
};

/// Worlds whose handles are wrong in a call.
struct WrongWorlds {
    const FullWorld& other;            ///< one that lives
    rubble_world gone;                 ///< one that was destroyed
    rubble_renderer goneRenderer = 0;  ///< a renderer that was destroyed; 0: there was none
};

/// All wrong values of a function's arguments: null, handles that are stale, of another world or another kind, numbers
/// that are not finite, huge or negative, sizes of structs, reserved fields.
std::vector<ArgumentChange> changesOf(const FunctionDescription& function, const WrongWorlds& wrong);

}  // namespace rubble
