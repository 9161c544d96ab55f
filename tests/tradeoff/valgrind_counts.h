#pragma once
#include <cstdint>
#include <map>
#include <string>

namespace rubble::tradeoff {

/// Instructions of a run of this program with --feature-scene `scene`, counted by valgrind; 0 without valgrind.
double instructionsOf(const std::string& scene);
/// The same by function, such as "rubble::World::hash", each with all functions that it calls; empty without valgrind.
std::map<std::string, double> instructionsByFunction(const std::string& scene);
/// Bytes that such a run allocated, by function, each with all functions that it calls; empty without valgrind.
std::map<std::string, double> bytesByFunction(const std::string& scene);

}  // namespace rubble::tradeoff
