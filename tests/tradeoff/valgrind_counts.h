#pragma once
#include <cstdint>
#include <map>
#include <string>

namespace rubble::tradeoff {

/// Instructions of a run of this program with --feature-scene `scene`, counted by valgrind; 0 without it.
double instructionsOf(const std::string& scene);
/// The same by function, with all that each calls, named as in "rubble::EditStep::burn()"; empty without valgrind.
std::map<std::string, double> instructionsByFunction(const std::string& scene);
/// Bytes of memory that such a run asked for, by each function that asked or had others ask, named as above.
std::map<std::string, double> bytesByFunction(const std::string& scene);

}  // namespace rubble::tradeoff
