#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace rubble::architecture {

/// A line that breaks a rule of the source tree.
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

/// A row of the table of folders in ARCHITECTURE.md: what its files may include, as beginnings of paths, itself among
/// them.
struct Module {
    std::string folder;  ///< with a slash at its end
    std::vector<std::string> mayInclude;
};

/// Every #include of every source file in the folders of the tree, sorted by file.
std::vector<Include> readIncludes(const std::filesystem::path& root);

/// The table of folders of ROOT/ARCHITECTURE.md; empty if there is none.
std::vector<Module> readModules(const std::filesystem::path& root);
/// Includes against the table, and libraries outside the folders that may include them.
std::vector<Violation> checkModules(const std::vector<Include>& includes, const std::vector<Module>& modules);
/// Folders that need each other, directly or through others.
std::vector<Violation> checkFolderCycles(const std::vector<Include>& includes);
/// Files of `from` that reach the file `to` through any chain of includes; the text shows the chain.
std::vector<Violation> checkNeverReaches(const std::vector<Include>& includes, const std::string& from,
                                         const std::string& to);
/// x.cpp includes its own x.h first, so that the header compiles alone.
std::vector<Violation> checkOwnHeaderFirst(const std::filesystem::path& root, const std::vector<Include>& includes);
/// Folders at the top, names of folders and names of classes.
std::vector<Violation> checkNames(const std::filesystem::path& root);

}  // namespace rubble::architecture
