#pragma once
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace rubble {

/// The text as valid UTF-8, with "?" for each invalid byte and for each control character but line feeds.
std::string printableText(std::string_view text);
/// The name as valid UTF-8 of at most 200 bytes, with "?" for each invalid byte and control character; "unnamed" for an
/// empty one.
std::string printableName(std::string_view name);

/// Makes names unique by numbering them: "door", "door 2", "door 3".
class UniqueNames {
public:
    /// The name, or the name and the lowest number from 2 on that makes it a new one.
    std::string unique(const std::string& name);

private:
    std::set<std::string> m_taken;
    std::map<std::string, int> m_next;
};

}  // namespace rubble
