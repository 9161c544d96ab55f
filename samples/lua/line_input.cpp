#include "samples/lua/line_input.h"

#include <termios.h>
#include <unistd.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#ifdef RUBBLE_HAS_LIBEDIT
#include <editline/readline.h>
#endif

namespace lua_sample {
#ifdef RUBBLE_HAS_LIBEDIT
namespace {

constexpr int kMaxLines = 1000;  ///< of the history
constexpr int kInterrupt = 3;    ///< Ctrl+C as a key

LineInput::Complete complete;    ///< libedit knows one input and calls functions without an argument for it
std::vector<std::string> words;  ///< that it offered last

/// Gives the first word for state 0, else the next one; null after the last.
char* nextWord(const char*, int state) {
    static size_t index = 0;
    index = state ? index + 1 : 0;
    return index < words.size() ? strdup(words[index].c_str()) : nullptr;
}

char** completeWord(const char* text, int, int end) {
    rl_attempted_completion_over = 1;  // no names of files
    words = complete(std::string_view(rl_line_buffer).substr(0, size_t(end)));
    return words.empty() ? nullptr : rl_completion_matches(text, nextWord);
}

int endInput(int, int) {
    rl_done = 1;
    return 0;
}

/// While one lives Ctrl+C is a key of the line that is read, which ends the input, and no signal.
class InterruptAsKey {
public:
    InterruptAsKey() : m_isKnown(tcgetattr(STDIN_FILENO, &m_before) == 0) {
        termios changed = m_before;
        changed.c_cc[VINTR] = _POSIX_VDISABLE;
        if (m_isKnown) tcsetattr(STDIN_FILENO, TCSANOW, &changed);
    }
    ~InterruptAsKey() {
        if (m_isKnown) tcsetattr(STDIN_FILENO, TCSANOW, &m_before);
    }
    InterruptAsKey(const InterruptAsKey&) = delete;
    InterruptAsKey& operator=(const InterruptAsKey&) = delete;

private:
    termios m_before{};
    bool m_isKnown;
};

}  // namespace

LineInput::LineInput(Complete given, std::string history)
    : m_isEdited(isatty(STDIN_FILENO) && isatty(STDOUT_FILENO)), m_history(std::move(history)) {
    static char breaks[] = " \t\n\"'`~!@#$%^&*()-+={}[]|\\;<>,?/";  // all but what names with dots and colons have
    if (!m_isEdited) return;
    complete = std::move(given);
    rl_readline_name = "rubble";
    rl_completer_word_break_characters = breaks;
    rl_completion_append_character = '\0';
    rl_attempted_completion_function = completeWord;
    std::setlocale(LC_CTYPE, "C.UTF-8");  // letters beyond ASCII
    rl_initialize();
    rl_add_defun("end", endInput, kInterrupt);
    using_history();
    stifle_history(kMaxLines);
    read_history(m_history.c_str());
}

LineInput::~LineInput() {
    if (m_isEdited) write_history(m_history.c_str());
}
#else
LineInput::LineInput(Complete, std::string) : m_isEdited(false) {}
LineInput::~LineInput() = default;
#endif

std::optional<std::string> LineInput::read(const char* prompt) {
#ifdef RUBBLE_HAS_LIBEDIT
    if (m_isEdited) {
        const InterruptAsKey key;
        char* typed = readline(prompt);
        if (!typed) return std::nullopt;
        std::string line = typed;
        std::free(typed);
        if (!line.empty()) add_history(line.c_str());
        return line;
    }
#endif
    std::string line;
    std::fputs(prompt, stdout);
    std::fflush(stdout);
    return std::getline(std::cin, line) ? std::optional(line) : std::nullopt;
}

}  // namespace lua_sample
