#include "runtime/script/sandbox/pattern.h"

#include <cctype>
#include <cstring>

namespace rubble::script {
namespace {

constexpr int kMaxDepth = 200;  ///< of the recursion, as in Lua

/// Whether a byte is of a class: %a, %D, ... A letter that names no class stands for itself.
bool isOfClass(unsigned char byte, unsigned char name) {
    bool is;
    switch (std::tolower(name)) {
        case 'a':
            is = std::isalpha(byte);
            break;
        case 'c':
            is = std::iscntrl(byte);
            break;
        case 'd':
            is = std::isdigit(byte);
            break;
        case 'g':
            is = std::isgraph(byte);
            break;
        case 'l':
            is = std::islower(byte);
            break;
        case 'p':
            is = std::ispunct(byte);
            break;
        case 's':
            is = std::isspace(byte);
            break;
        case 'u':
            is = std::isupper(byte);
            break;
        case 'w':
            is = std::isalnum(byte);
            break;
        case 'x':
            is = std::isxdigit(byte);
            break;
        default:
            return name == byte;
    }
    return std::isupper(name) ? !is : is;
}

}  // namespace

size_t PatternMatcher::matchAt(size_t start) {
    m_count = 0;
    m_depth = 0;
    return match(start, 0);
}

size_t PatternMatcher::match(size_t at, size_t item) {
    if (++m_depth > kMaxDepth) luaL_error(m_state, "pattern too complex");
    size_t found = kNoMatch;
    for (;;) {
        Sandbox::of(m_state).charge(m_state, 1);
        if (item == m_pattern.size()) {
            found = at;
            break;
        }
        const char first = m_pattern[item], second = patternAt(item + 1);
        if (first == '(') {
            found = second == ')' ? openCapture(at, item + 2, Capture::kPosition)
                                  : openCapture(at, item + 1, Capture::kOpen);
            break;
        }
        if (first == ')') {
            found = closeCapture(at, item + 1);
            break;
        }
        if (first == '$' && item + 1 == m_pattern.size()) {
            if (at == m_subject.size()) found = at;
            break;
        }
        if (first == '%' && (second == 'b' || second == 'f' || std::isdigit(static_cast<unsigned char>(second)))) {
            if (second == 'f') {
                const size_t set = item + 2;
                if (patternAt(set) != '[') luaL_error(m_state, "missing '[' after '%%f' in pattern");
                item = endOfItem(set);
                if (!isFrontier(at, set, item)) break;
            } else {
                at = second == 'b' ? skipBalanced(at, item + 2) : skipCaptured(at, item + 1);
                if (at == kNoMatch) break;
                item += second == 'b' ? 4 : 2;
            }
            continue;
        }
        const size_t itemEnd = endOfItem(item);
        const char repeat = patternAt(itemEnd);
        if (repeat == '*' || repeat == '+') {
            if (repeat == '*' || matchesItem(at, item, itemEnd))
                found = matchRepeated(repeat == '*' ? at : at + 1, item, itemEnd);
            break;
        }
        if (repeat == '-') {
            found = matchShortest(at, item, itemEnd);
            break;
        }
        const bool matches = matchesItem(at, item, itemEnd);
        if (repeat == '?') {
            if (matches && (found = match(at + 1, itemEnd + 1)) != kNoMatch) break;
            item = itemEnd + 1;
        } else {
            if (!matches) break;
            ++at;
            item = itemEnd;
        }
    }
    --m_depth;
    return found;
}

/// "*": as many as there are, then fewer, until the rest of the pattern matches.
size_t PatternMatcher::matchRepeated(size_t at, size_t item, size_t itemEnd) {
    size_t count = 0;
    while (matchesItem(at + count, item, itemEnd)) {
        Sandbox::of(m_state).charge(m_state, 1);
        ++count;
    }
    for (;; --count) {
        const size_t end = match(at + count, itemEnd + 1);
        if (end != kNoMatch || count == 0) return end;
    }
}

/// "-": as few as possible.
size_t PatternMatcher::matchShortest(size_t at, size_t item, size_t itemEnd) {
    for (;; ++at) {
        const size_t end = match(at, itemEnd + 1);
        if (end != kNoMatch) return end;
        if (!matchesItem(at, item, itemEnd)) return kNoMatch;
    }
}

size_t PatternMatcher::openCapture(size_t at, size_t item, size_t kind) {
    if (m_count >= kMaxCaptures) luaL_error(m_state, "too many captures");
    m_captures[size_t(m_count++)] = {at, kind};
    const size_t end = match(at, item);
    if (end == kNoMatch) --m_count;
    return end;
}

size_t PatternMatcher::closeCapture(size_t at, size_t item) {
    int open = m_count - 1;
    while (open >= 0 && m_captures[size_t(open)].length != Capture::kOpen) --open;
    if (open < 0) luaL_error(m_state, "invalid pattern capture");
    Capture& capture = m_captures[size_t(open)];
    capture.length = at - capture.start;
    const size_t end = match(at, item);
    if (end == kNoMatch) capture.length = Capture::kOpen;
    return end;
}

/// %bxy: the end of the text from an x to the y that balances it.
size_t PatternMatcher::skipBalanced(size_t at, size_t item) {
    if (item + 1 >= m_pattern.size()) luaL_error(m_state, "malformed pattern (missing arguments to '%%b')");
    const char open = m_pattern[item], close = m_pattern[item + 1];
    if (at >= m_subject.size() || m_subject[at] != open) return kNoMatch;
    for (int depth = 1; ++at < m_subject.size();) {
        Sandbox::of(m_state).charge(m_state, 1);
        if (m_subject[at] == close) {
            if (--depth == 0) return at + 1;
        } else if (m_subject[at] == open) {
            ++depth;
        }
    }
    return kNoMatch;
}

/// %1: the end of the same text as that of a capture.
size_t PatternMatcher::skipCaptured(size_t at, size_t item) {
    const int index = m_pattern[item] - '1';
    if (index < 0 || index >= m_count || m_captures[size_t(index)].length == Capture::kOpen)
        luaL_error(m_state, "invalid capture index %%%d", index + 1);
    const Capture& capture = m_captures[size_t(index)];
    if (capture.length > m_subject.size() - at) return kNoMatch;  // as that of a position
    Sandbox::of(m_state).charge(m_state, int64_t(capture.length >> 4));
    const bool isSame = std::memcmp(m_subject.data() + capture.start, m_subject.data() + at, capture.length) == 0;
    return isSame ? at + capture.length : kNoMatch;
}

bool PatternMatcher::isFrontier(size_t at, size_t set, size_t setEnd) {
    const unsigned char before = at == 0 ? 0 : static_cast<unsigned char>(m_subject[at - 1]);
    const unsigned char here = at < m_subject.size() ? static_cast<unsigned char>(m_subject[at]) : 0;
    Sandbox::of(m_state).charge(m_state, int64_t((setEnd - set) >> 3));
    return !matchesSet(before, set, setEnd - 1) && matchesSet(here, set, setEnd - 1);
}

bool PatternMatcher::matchesItem(size_t at, size_t item, size_t itemEnd) {
    if (at >= m_subject.size()) return false;
    const auto byte = static_cast<unsigned char>(m_subject[at]);
    switch (m_pattern[item]) {
        case '.':
            return true;
        case '%':
            return isOfClass(byte, static_cast<unsigned char>(m_pattern[item + 1]));
        case '[':
            Sandbox::of(m_state).charge(m_state, int64_t((itemEnd - item) >> 3));
            return matchesSet(byte, item, itemEnd - 1);
        default:
            return static_cast<unsigned char>(m_pattern[item]) == byte;
    }
}

/// Whether a byte is in the set that begins with "[" at `set` and ends with "]" at `setEnd`.
bool PatternMatcher::matchesSet(unsigned char byte, size_t set, size_t setEnd) const {
    const auto at = [&](size_t i) { return static_cast<unsigned char>(m_pattern[i]); };
    size_t i = set + 1;
    const bool isInverse = at(i) == '^';
    if (isInverse) ++i;
    for (; i < setEnd; ++i) {
        if (at(i) == '%') {
            if (isOfClass(byte, at(++i))) return !isInverse;
        } else if (i + 2 < setEnd && at(i + 1) == '-') {
            if (at(i) <= byte && byte <= at(i + 2)) return !isInverse;
            i += 2;
        } else if (at(i) == byte) {
            return !isInverse;
        }
    }
    return isInverse;
}

/// Where the single item ends that begins at `item`: a byte, an escape, or a set.
size_t PatternMatcher::endOfItem(size_t item) const {
    const char first = m_pattern[item++];
    if (first == '%') {
        if (item >= m_pattern.size()) luaL_error(m_state, "malformed pattern (ends with '%%')");
        return item + 1;
    }
    if (first != '[') return item;
    if (patternAt(item) == '^') ++item;
    do {  // a "]" that stands first is of the set
        if (item >= m_pattern.size()) luaL_error(m_state, "malformed pattern (missing ']')");
        if (m_pattern[item++] == '%') {
            if (item >= m_pattern.size()) luaL_error(m_state, "malformed pattern (missing ']')");
            ++item;
        }
    } while (item >= m_pattern.size() || m_pattern[item] != ']');
    return item + 1;
}

void PatternMatcher::pushCapture(int index, size_t start, size_t end) const {
    if (index >= m_count) {
        if (index != 0) luaL_error(m_state, "invalid capture index %%%d", index + 1);
        lua_pushlstring(m_state, m_subject.data() + start, end - start);
        return;
    }
    const Capture& capture = m_captures[size_t(index)];
    if (capture.length == Capture::kOpen) luaL_error(m_state, "unfinished capture");
    if (capture.length == Capture::kPosition)
        lua_pushinteger(m_state, lua_Integer(capture.start) + 1);
    else
        lua_pushlstring(m_state, m_subject.data() + capture.start, capture.length);
}

int PatternMatcher::pushCaptures(size_t start, size_t end, bool wholeIfNone) const {
    const int count = m_count == 0 && wholeIfNone ? 1 : m_count;
    luaL_checkstack(m_state, count, "too many captures");
    for (int i = 0; i < count; ++i) pushCapture(i, start, end);
    return count;
}

}  // namespace rubble::script
