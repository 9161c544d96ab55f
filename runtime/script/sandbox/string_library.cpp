#include <cstring>
#include <string_view>

#include "runtime/script/sandbox/libraries.h"
#include "runtime/script/sandbox/pattern.h"
#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {
namespace {

std::string_view checkString(lua_State* L, int index) {
    size_t length = 0;
    const char* bytes = luaL_checklstring(L, index, &length);
    return {bytes, length};
}

/// The place that an argument of string functions names: 0 for 1, from the end for what is negative, and one beyond the
/// text for all that lie behind it.
size_t startAt(lua_State* L, int index, size_t length) {
    const lua_Integer given = luaL_optinteger(L, index, 1);
    if (given > 0) return lua_Unsigned(given) - 1 > length ? length + 1 : size_t(given - 1);
    if (given == 0 || given < -lua_Integer(length)) return 0;
    return length - size_t(-given);
}

/// string.find with `plain`, or with a pattern that has nothing special: memmem() takes time in proportion.
int findPlain(lua_State* L, std::string_view text, std::string_view wanted, size_t start) {
    Sandbox::of(L).charge(L, int64_t((text.size() - start + wanted.size()) >> 3));
    const void* found = wanted.empty() ? text.data() + start
                                       : memmem(text.data() + start, text.size() - start, wanted.data(), wanted.size());
    if (!found) {
        lua_pushnil(L);
        return 1;
    }
    const size_t at = size_t(static_cast<const char*>(found) - text.data());
    lua_pushinteger(L, lua_Integer(at) + 1);
    lua_pushinteger(L, lua_Integer(at + wanted.size()));
    return 2;
}

/// string.find and string.match.
int searchPattern(lua_State* L, bool finds) {
    const std::string_view text = checkString(L, 1), given = checkString(L, 2);
    const size_t start = startAt(L, 3, text.size());
    if (start > text.size()) {
        lua_pushnil(L);
        return 1;
    }
    if (finds && (lua_toboolean(L, 4) || given.find_first_of("^$*+?.([%-") == given.npos))
        return findPlain(L, text, given, start);
    const bool isAnchored = !given.empty() && given[0] == '^';
    PatternMatcher matcher(L, text, given.substr(isAnchored));
    for (size_t at = start; at <= text.size(); ++at) {
        const size_t end = matcher.matchAt(at);
        if (end != PatternMatcher::kNoMatch) {
            if (!finds) return matcher.pushCaptures(at, end, true);
            lua_pushinteger(L, lua_Integer(at) + 1);
            lua_pushinteger(L, lua_Integer(end));
            return matcher.pushCaptures(at, end, false) + 2;
        }
        if (isAnchored) break;
    }
    lua_pushnil(L);
    return 1;
}

int find(lua_State* L) {
    return searchPattern(L, true);
}

int match(lua_State* L) {
    return searchPattern(L, false);
}

/// The iterator of gmatch. Upvalues: text, pattern, where to look next, where the last match ended or -1.
int nextMatch(lua_State* L) {
    size_t textLength = 0, patternLength = 0;
    const char* text = lua_tolstring(L, lua_upvalueindex(1), &textLength);
    const char* pattern = lua_tolstring(L, lua_upvalueindex(2), &patternLength);
    const lua_Integer lastEnd = lua_tointeger(L, lua_upvalueindex(4));
    PatternMatcher matcher(L, {text, textLength}, {pattern, patternLength});
    for (size_t at = size_t(lua_tointeger(L, lua_upvalueindex(3))); at <= textLength; ++at) {
        const size_t end = matcher.matchAt(at);
        if (end == PatternMatcher::kNoMatch || lua_Integer(end) == lastEnd) continue;
        lua_pushinteger(L, lua_Integer(end));
        lua_copy(L, -1, lua_upvalueindex(3));
        lua_replace(L, lua_upvalueindex(4));
        return matcher.pushCaptures(at, end, true);
    }
    lua_pushinteger(L, lua_Integer(textLength) + 1);
    lua_replace(L, lua_upvalueindex(3));
    return 0;
}

int gmatch(lua_State* L) {
    const std::string_view text = checkString(L, 1);
    checkString(L, 2);
    const size_t start = startAt(L, 3, text.size());
    lua_settop(L, 2);
    lua_pushinteger(L, lua_Integer(start));
    lua_pushinteger(L, -1);
    lua_pushcclosure(L, nextMatch, 4);
    return 1;
}

/// Adds the replacement text at index 3 to the result, with %0 to %9 filled in.
void addTemplate(lua_State* L, luaL_Buffer& result, const PatternMatcher& matcher, size_t start, size_t end) {
    const std::string_view text = checkString(L, 3);
    Sandbox::of(L).charge(L, int64_t(text.size() >> 3));
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            luaL_addchar(&result, text[i]);
            continue;
        }
        const char next = ++i < text.size() ? text[i] : '\0';
        if (next == '%') {
            luaL_addchar(&result, '%');
        } else if (next == '0') {
            luaL_addlstring(&result, checkString(L, 1).data() + start, end - start);
        } else if (next >= '1' && next <= '9') {
            matcher.pushCapture(next - '1', start, end);
            luaL_tolstring(L, -1, nullptr);  // of a position
            lua_remove(L, -2);
            luaL_addvalue(&result);
        } else {
            luaL_error(L, "invalid use of '%c' in replacement string", '%');
        }
    }
}

/// Adds what replaces a match to the result.
void addReplacement(lua_State* L, luaL_Buffer& result, const PatternMatcher& matcher, size_t start, size_t end) {
    const int kind = lua_type(L, 3);
    if (kind == LUA_TSTRING || kind == LUA_TNUMBER) return addTemplate(L, result, matcher, start, end);
    if (kind == LUA_TTABLE) {
        matcher.pushCapture(0, start, end);
        lua_gettable(L, 3);
    } else {
        lua_pushvalue(L, 3);
        lua_call(L, matcher.pushCaptures(start, end, true), 1);
    }
    if (!lua_toboolean(L, -1)) {
        lua_pop(L, 1);
        luaL_addlstring(&result, checkString(L, 1).data() + start, end - start);
    } else if (lua_isstring(L, -1)) {
        luaL_addvalue(&result);
    } else {
        luaL_error(L, "invalid replacement value (a %s)", luaL_typename(L, -1));
    }
}

int gsub(lua_State* L) {
    const std::string_view text = checkString(L, 1), given = checkString(L, 2);
    const int kind = lua_type(L, 3);
    luaL_argexpected(L, kind == LUA_TNUMBER || kind == LUA_TSTRING || kind == LUA_TFUNCTION || kind == LUA_TTABLE, 3,
                     "string/function/table");
    if (kind == LUA_TNUMBER) luaL_checkstring(L, 3);
    Sandbox::of(L).makeRoom(L);
    const lua_Integer most = luaL_optinteger(L, 4, lua_Integer(text.size()) + 1);
    const bool isAnchored = !given.empty() && given[0] == '^';
    PatternMatcher matcher(L, text, given.substr(isAnchored));
    luaL_Buffer result;
    luaL_buffinit(L, &result);
    lua_Integer count = 0;
    size_t at = 0, lastEnd = PatternMatcher::kNoMatch;
    while (count < most) {
        const size_t end = matcher.matchAt(at);
        if (end != PatternMatcher::kNoMatch && end != lastEnd) {
            ++count;
            addReplacement(L, result, matcher, at, end);
            at = lastEnd = end;
        } else if (at < text.size()) {
            luaL_addchar(&result, text[at++]);
        } else {
            break;
        }
        if (isAnchored) break;
    }
    if (at < text.size()) luaL_addlstring(&result, text.data() + at, text.size() - at);
    luaL_pushresult(&result);
    lua_pushinteger(L, count);
    return 2;
}

int rep(lua_State* L) {
    const std::string_view text = checkString(L, 1);
    const lua_Integer count = luaL_checkinteger(L, 2);
    const size_t separator = lua_isnoneornil(L, 3) ? 0 : checkString(L, 3).size();
    const size_t longest = Sandbox::of(L).limits().longestString;
    if (text.size() + separator == 0 || count <= 0) {
        lua_pushliteral(L, "");
        return 1;
    }
    if (lua_Unsigned(count) > longest / (text.size() + separator) + 1)
        return luaL_error(L, "string.rep: the result is too long: expected at most %d bytes", int(longest));
    Sandbox::of(L).makeRoom(L);
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

int unpack(lua_State* L) {
    const std::string_view layout = checkString(L, 1), text = checkString(L, 2);
    if (lua_Integer(layout.size()) > kMaxResults)
        return luaL_error(L, "string.unpack: expected a format of at most %d bytes, found %d", int(kMaxResults),
                          int(layout.size()));
    Sandbox::of(L).charge(L, int64_t(layout.size() + (text.size() >> 4)));
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/// string.format, in which objects have the text of tostring(), and no address has one.
int format(lua_State* L) {
    const std::string_view given = checkString(L, 1);
    int64_t work = int64_t(given.size());
    for (size_t at = given.find('%'); at != given.npos; at = given.find('%', at + 1)) {
        at = given.find_first_not_of("-+ #0123456789.", at + 1);
        if (at == given.npos) break;
        if (given[at] == 'p') return luaL_error(L, "string.format: expected no %%p: addresses are not in reach");
    }
    for (int i = 2; i <= lua_gettop(L); ++i) {
        work += lua_type(L, i) == LUA_TSTRING ? 10 + int64_t(lua_rawlen(L, i) >> 4) : 10;
        const int kind = lua_type(L, i);
        if (kind == LUA_TTABLE || kind >= LUA_TFUNCTION) {
            pushText(L, i);
            lua_replace(L, i);
        }
    }
    Sandbox::of(L).charge(L, work);
    Sandbox::of(L).makeRoom(L);
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

}  // namespace

void openString(lua_State* L) {
    lua_getglobal(L, LUA_STRLIBNAME);
    lua_pushnil(L);
    lua_setfield(L, -2, "dump");
    static constexpr const char* kCharged[] = {"char", "len",  "lower",    "upper", "reverse",
                                               "sub",  "pack", "packsize", nullptr};
    static constexpr const char* kMany[] = {"byte", nullptr};
    chargeArguments(L, kCharged);
    limitResults(L, kMany);
    wrapField(L, "unpack", unpack);
    wrapField(L, "rep", rep);
    wrapField(L, "format", format);
    static constexpr luaL_Reg kPatterns[] = {
        {"find", find}, {"match", match}, {"gmatch", gmatch}, {"gsub", gsub}, {nullptr, nullptr}};
    luaL_setfuncs(L, kPatterns, 0);
    lua_pop(L, 1);
}

}  // namespace rubble::script
