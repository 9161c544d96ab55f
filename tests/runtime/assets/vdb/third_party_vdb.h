#pragma once
#include <string>

namespace rubble {

/// Files as other programs write them, each with cells that the tests know.
void writeThirdPartyVdb(const std::string& kind, const std::string& path);
/// Takes a field with a number or a truth out of the profile's metadata, as if whoever wrote the file did not know it.
void removeField(const std::string& path, const std::string& field);

}  // namespace rubble
