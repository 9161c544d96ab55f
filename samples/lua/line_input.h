#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lua_sample {

/// Lines from standard input. At a terminal they can be edited, Tab completes the last word, and the lines of earlier
/// runs come back, where the program was built with libedit.
class LineInput {
public:
    /// What the last word of a line can become.
    using Complete = std::function<std::vector<std::string>(std::string_view line)>;

    /// One at a time. `history`: the file that keeps the lines.
    LineInput(Complete complete, std::string history);
    ~LineInput();
    LineInput(const LineInput&) = delete;
    LineInput& operator=(const LineInput&) = delete;

    /// Shows the prompt and waits for a line; nothing: the input has ended.
    std::optional<std::string> read(const char* prompt);

private:
    bool m_isEdited;
    std::string m_history;
};

}  // namespace lua_sample
