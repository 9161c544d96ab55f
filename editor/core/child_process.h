#pragma once
#include <string>
#include <vector>

namespace editor {

/// How a program ended.
struct ChildResult {
    bool isDone = false;  ///< with code 0
    std::string output;   ///< what it printed
    std::string end;      ///< how it ended otherwise, for people
};

/// Runs a program, its path first, without a shell, and waits for its end; after so many seconds it is stopped.
ChildResult runChild(const std::vector<std::string>& command, int seconds);

/// A folder that is removed with all in it when the object is destroyed. Throws Refused where none can be made.
class ScratchFolder {
public:
    /// Makes it, in TMPDIR or /tmp.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    /// The path of a file in it.
    std::string operator/(const std::string& name) const { return m_path + "/" + name; }

private:
    std::string m_path;
};

}  // namespace editor
