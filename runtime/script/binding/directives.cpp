#include "runtime/script/binding/directives.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace rubble::script {
namespace {

/// Where a long bracket such as [==[ ... ]==] that begins here ends; `at`: none does.
size_t endOfLongBracket(std::string_view text, size_t at) {
    size_t level = at + 1;
    while (level < text.size() && text[level] == '=') ++level;
    if (text[at] != '[' || level >= text.size() || text[level] != '[') return at;
    const std::string close = "]" + std::string(level - at - 1, '=') + "]";
    const size_t end = text.find(close, level + 1);
    return end == text.npos ? text.size() : end + close.size();
}

/// Where a string in quotes that begins here ends, at the end of its line at the latest.
size_t endOfString(std::string_view text, size_t at) {
    const char quote = text[at++];
    while (at < text.size() && text[at] != quote && text[at] != '\n') {
        const bool skipsSpace = text.substr(at, 2) == "\\z";
        at += text[at] == '\\' ? 2 : 1;
        while (skipsSpace && at < text.size() && std::isspace(static_cast<unsigned char>(text[at]))) ++at;
    }
    return at < text.size() && text[at] == quote ? at + 1 : at;
}

/// Where the string, comment or single character that begins here ends. A comment ends before its line's break.
size_t endOfToken(std::string_view text, size_t at) {
    if (text[at] == '"' || text[at] == '\'') return endOfString(text, at);
    const bool isComment = text.substr(at, 2) == "--";
    const size_t content = isComment ? at + 2 : at;
    if (const size_t end = content < text.size() ? endOfLongBracket(text, content) : content; end > content) return end;
    return isComment ? std::min(text.find('\n', at), text.size()) : at + 1;
}

/// Replaces the directive that the line at `at` is, if it is one.
void replaceDirective(std::string& text, size_t at) {
    const std::string_view rest = std::string_view(text).substr(at), line = rest.substr(0, rest.find('\n'));
    const size_t open = line.find('"'), close = line.rfind('"');
    if (line.starts_with("#version"))
        text.insert(at, "--");
    else if (line.starts_with("#include") && open < close && close != line.npos)
        text.replace(at, line.size(), "require(" + std::string(line.substr(open, close - open + 1)) + ")");
}

}  // namespace

std::string withoutDirectives(std::string text) {
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    if (text.starts_with("#!")) text.insert(0, "--");
    bool beginsLine = true;
    for (size_t at = 0; at < text.size();) {
        if (beginsLine) replaceDirective(text, at);
        beginsLine = text[at] == '\n';
        at = endOfToken(text, at);
    }
    return text;
}

}  // namespace rubble::script
