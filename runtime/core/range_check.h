#pragma once
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <string_view>

#include "runtime/core/number_range.h"
#include "runtime/core/pose.h"

namespace rubble {

/// Looks at the numbers of an object in turn and keeps what is wrong with the first bad one: "NAME is VALUE, expected
/// LOW to HIGH".
class RangeCheck {
public:
    /// A number. An end of the range may be rounded to single precision, in which most objects keep their numbers.
    RangeCheck& number(const char* name, double value, NumberRange range);
    /// Three numbers of one range.
    RangeCheck& vector(const char* name, const glm::dvec3& value, NumberRange range);
    /// A quaternion of length 1, but for rounding.
    RangeCheck& rotation(const char* name, const glm::dquat& value);
    /// A place and a rotation.
    RangeCheck& pose(const char* name, const Pose& value);
    /// A name, in UTF-8.
    RangeCheck& text(const char* name, std::string_view value);
    /// Anything else. `error`: what is wrong, with what was expected; used if `isGood` is false.
    RangeCheck& require(bool isGood, const char* error);
    /// The error of another check, if there is one.
    RangeCheck& include(std::string error);

    /// What is wrong; empty: nothing.
    std::string error() const { return m_error; }

private:
    std::string m_error;
};

}  // namespace rubble
