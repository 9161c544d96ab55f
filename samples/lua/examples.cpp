#include "samples/lua/examples.h"

#include <fstream>

namespace lua_sample {

std::vector<Example> readExamples(const std::string& path) {
    std::vector<Example> examples;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("--- "))
            examples.push_back({line.substr(4), ""});
        else if (!examples.empty() && !(line.empty() && examples.back().text.empty()))
            examples.back().text += line + "\n";
    }
    for (Example& example : examples)
        while (example.text.ends_with("\n\n")) example.text.pop_back();
    return examples;
}

}  // namespace lua_sample
