#include "runtime/plugin/c_abi/call.h"

#include <array>

namespace rubble::abi {
namespace {

thread_local Call* t_call = nullptr;
/// No std::string: a thread that has something to destroy keeps the library in memory after dlclose().
thread_local std::array<char, 4096> t_lastError{};

}  // namespace

Call::Call(const char* function) : m_outer(t_call), m_function(function) {
    t_call = this;
}

Call::~Call() {
    t_call = m_outer;
}

Call& Call::current() {
    return *t_call;
}

void Call::refuse(rubble_result code, fmt::string_view format, fmt::format_args arguments) {
    if (m_code != RUBBLE_OK) return;
    m_code = code;
    m_text.clear();
    fmt::vformat_to(fmt::appender(m_text), format, arguments);
}

void Call::locate(std::string_view place) {
    const std::string text = fmt::to_string(m_text);
    m_text.clear();
    m_text.append(place);
    m_text.append(text);
}

rubble_result Call::finish() {
    if (m_code != RUBBLE_OK) {
        const auto end = fmt::format_to_n(t_lastError.data(), t_lastError.size() - 1, "{}: {}", m_function,
                                          fmt::string_view(m_text.data(), m_text.size()));
        *end.out = '\0';
    }
    return m_code;
}

const char* lastError() {
    return t_lastError.data();
}

}  // namespace rubble::abi
