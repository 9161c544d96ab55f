#include "runtime/plugin/c_abi/call.h"

namespace rubble::abi {
namespace {

thread_local Call* t_call = nullptr;
thread_local std::string t_lastError;

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
        t_lastError.clear();
        t_lastError.append(m_function).append(": ").append(m_text.data(), m_text.size());
    }
    return m_code;
}

const char* lastError() {
    return t_lastError.c_str();
}

}  // namespace rubble::abi
