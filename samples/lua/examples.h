#pragma once
#include <string>
#include <vector>

namespace lua_sample {

/// A section of examples.lua.
struct Example {
    std::string name;  ///< of the function
    std::string text;
};

/// Reads the examples out of a file such as examples.lua, in their order.
std::vector<Example> readExamples(const std::string& path);

}  // namespace lua_sample
