#pragma once
#include <string>

namespace rubble {

/// Makes a folder for what a program writes and tries to write there: before the work begins. What is wrong, or "".
std::string makeOutFolder(const std::string& folder);
/// The same for the folder of a file.
std::string makeFolderOf(const std::string& file);

}  // namespace rubble
