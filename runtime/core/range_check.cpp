#include "runtime/core/range_check.h"

#include <cstdio>
#include <utility>

#include "runtime/core/ranges.h"
#include "runtime/core/utf8.h"

namespace rubble {

RangeCheck& RangeCheck::number(const char* name, double value, NumberRange range) {
    const bool isRoundedEnd = value == double(float(range.low)) || value == double(float(range.high));
    if (!m_error.empty() || isRoundedEnd || isWithin(value, range)) return *this;
    char text[96];
    std::snprintf(text, sizeof text, " is %g, expected %g to %g", value, range.low, range.high);
    m_error = std::string(name) + text;
    return *this;
}

RangeCheck& RangeCheck::vector(const char* name, const glm::dvec3& value, NumberRange range) {
    for (int i = 0; i < 3 && m_error.empty(); ++i)
        if (!isWithin(value[i], range))
            number((std::string(name) + "[" + char('0' + i) + "]").c_str(), value[i], range);
    return *this;
}

RangeCheck& RangeCheck::rotation(const char* name, const glm::dquat& q) {
    const double length2 = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    if (!m_error.empty() || isWithin(length2, ranges::kRotationLength2)) return *this;
    return number(("the squared length of " + std::string(name)).c_str(), length2, ranges::kRotationLength2);
}

RangeCheck& RangeCheck::pose(const char* name, const Pose& value) {
    if (!m_error.empty()) return *this;
    vector((std::string(name) + ".position").c_str(), value.position, ranges::kPlace);
    return rotation((std::string(name) + ".rotation").c_str(), value.rotation);
}

RangeCheck& RangeCheck::text(const char* name, std::string_view value) {
    if (m_error.empty() && !isUtf8(value)) m_error = std::string(name) + " is no text in UTF-8";
    return *this;
}

RangeCheck& RangeCheck::require(bool isGood, const char* error) {
    if (m_error.empty() && !isGood) m_error = error;
    return *this;
}

RangeCheck& RangeCheck::include(std::string error) {
    if (m_error.empty()) m_error = std::move(error);
    return *this;
}

}  // namespace rubble
