#pragma once
#include <map>
#include <string>

namespace rubble {

/// "FUNCTION ARGUMENT[.FIELD]: VALUE" of what looks wrong and is right, or is refused for something else, with the
/// reason.
const std::map<std::string, std::string>& acceptedValues();

}  // namespace rubble
