#pragma once
#include <map>
#include <set>
#include <string>

namespace rubble {

/// The name in valid UTF-8 without control characters, at most 200 bytes; "unnamed" if nothing is left.
std::string printableName(const std::string& name);
bool isUtf8(const std::string& text);

/// Hands out names once each: "door", "door 2", "door 3".
class UniqueNames {
public:
    std::string unique(const std::string& name);

private:
    std::set<std::string> m_taken;
    std::map<std::string, int> m_next;
};

}  // namespace rubble
