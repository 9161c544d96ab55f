#pragma once
#include <string>

namespace rubble {

/// Files as other programs write them, each with cells that the tests know.
void writeForeignVdb(const std::string& kind, const std::string& path);

}  // namespace rubble
