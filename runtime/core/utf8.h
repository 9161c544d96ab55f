#pragma once
#include <cstddef>
#include <string_view>

namespace rubble {

/// How many bytes the character at byte `at` of a UTF-8 text has (Unicode 15, table 3-7); 0 if it is not well-formed.
size_t utf8Length(std::string_view text, size_t at);
/// Whether a text is well-formed UTF-8.
bool isUtf8(std::string_view text);

}  // namespace rubble
