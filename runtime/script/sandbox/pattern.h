#pragma once
#include <array>
#include <cstddef>
#include <string_view>

#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {

/// Matches a pattern of Lua with a text, and charges each step to the sandbox: patterns such as ".-.-.-b" take time
/// without an end otherwise. A pattern that is wrong is an error of Lua.
class PatternMatcher {
public:
    static constexpr int kMaxCaptures = 32;
    static constexpr size_t kNoMatch = size_t(-1);

    /// Both texts must outlive the matcher.
    PatternMatcher(lua_State* L, std::string_view subject, std::string_view pattern)
        : m_state(L), m_subject(subject), m_pattern(pattern) {}

    /// The end of the match that begins at `start`, or kNoMatch.
    size_t matchAt(size_t start);
    /// Pushes capture `index`, of none the whole match; an error if there is no such capture.
    void pushCapture(int index, size_t start, size_t end) const;
    /// Pushes all captures, or the whole match if the pattern has none and `wholeIfNone`; returns their number.
    int pushCaptures(size_t start, size_t end, bool wholeIfNone) const;

private:
    struct Capture {
        static constexpr size_t kOpen = size_t(-1), kPosition = size_t(-2);
        size_t start = 0, length = 0;
    };

    size_t match(size_t at, size_t item);
    size_t matchRepeated(size_t at, size_t item, size_t itemEnd);
    size_t matchShortest(size_t at, size_t item, size_t itemEnd);
    size_t openCapture(size_t at, size_t item, size_t kind);
    size_t closeCapture(size_t at, size_t item);
    size_t skipBalanced(size_t at, size_t item);
    size_t skipCaptured(size_t at, size_t item);
    bool isFrontier(size_t at, size_t set, size_t setEnd);
    bool matchesItem(size_t at, size_t item, size_t itemEnd);
    bool matchesSet(unsigned char byte, size_t set, size_t setEnd) const;
    size_t endOfItem(size_t item) const;
    char patternAt(size_t at) const { return at < m_pattern.size() ? m_pattern[at] : '\0'; }

    lua_State* m_state;
    std::string_view m_subject, m_pattern;
    std::array<Capture, kMaxCaptures> m_captures;
    int m_count = 0;
    int m_depth = 0;
};

}  // namespace rubble::script
