#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace rubble::architecture {

/// A line that breaks a rule of the house.
struct Violation {
    std::string file;  ///< from the root of the tree
    int line;          ///< 0: the file or folder itself
    std::string text;
};

/// One #include as it stands in a file.
struct Include {
    std::string file;
    int line;
    std::string target;
    bool quoted;  ///< "x.h", not <x.h>
};

/// Every #include of every source file in the folders of the house, sorted by file.
std::vector<Include> readIncludes(const std::filesystem::path& root);

/// Includes against the arrows of the house, and libraries outside their wall.
std::vector<Violation> checkArrows(const std::vector<Include>& includes);
/// Files of `from` that reach the file `to` through any chain of includes; the text shows the chain.
std::vector<Violation> checkNeverReaches(const std::vector<Include>& includes, const std::string& from, const std::string& to);
/// x.cpp includes its own x.h first, so that the header compiles alone.
std::vector<Violation> checkOwnHeaderFirst(const std::filesystem::path& root, const std::vector<Include>& includes);
/// Folders at the top, names of folders and names of classes.
std::vector<Violation> checkNames(const std::filesystem::path& root);

}  // namespace rubble::architecture
