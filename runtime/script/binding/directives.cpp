#include "runtime/script/binding/directives.h"

#include <string_view>

namespace rubble::script {

std::string withoutDirectives(std::string text) {
    for (size_t at = 0; at < text.size();) {
        const std::string_view rest = std::string_view(text).substr(at), line = rest.substr(0, rest.find('\n'));
        const size_t open = line.find('"'), close = line.rfind('"');
        if (line.starts_with("#version"))
            text.insert(at, "--");
        else if (line.starts_with("#include") && open < close && close != line.npos)
            text.replace(at, line.size(), "require(" + std::string(line.substr(open, close - open + 1)) + ")");
        const size_t next = text.find('\n', at);
        at = next == text.npos ? text.size() : next + 1;
    }
    return text;
}

}  // namespace rubble::script
