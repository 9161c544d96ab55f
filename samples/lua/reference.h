#pragma once
#include <map>
#include <string>

namespace lua_sample {

/// The pages of the reference of scripts by file name: one for each subject of the vocabulary, with the example of each
/// function, and an index. `examples` is the path of examples.lua.
std::map<std::string, std::string> makeReference(const std::string& examples);

}  // namespace lua_sample
