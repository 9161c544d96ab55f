#pragma once
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "runtime/plugin/include/rubble/rubble.h"

namespace rubble::abi {

/// A call of the host while it runs, and why it is refused, if it is. Readers of arguments refuse() and go on with a
/// harmless value: a refusal costs no exception and no memory, and a function asks isRefused() before it does anything.
/// Calls nest: a log callback may call the plugin.
class Call {
public:
    /// Begins a call of this thread. `function`: the name that messages begin with; must outlive the call.
    explicit Call(const char* function);
    ~Call();
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    /// The innermost call of this thread; there must be one.
    static Call& current();

    /// Refuses the call. The first reason counts.
    void refuse(rubble_result code, fmt::string_view format, fmt::format_args arguments);
    /// Puts what names the place of the first error, such as "rays[2].", before its text.
    void locate(std::string_view place);
    /// RUBBLE_OK until the call is refused.
    rubble_result result() const { return m_code; }
    /// What the call returns to the host. Keeps "function: reason" for get_last_error() of this thread.
    rubble_result finish();

private:
    Call* m_outer;
    const char* m_function;
    rubble_result m_code = RUBBLE_OK;
    fmt::basic_memory_buffer<char, 256> m_text;  ///< longer ones take memory
};

/// Refuses the running call, for a reason in the format of fmt.
template <class... Args>
void refuse(rubble_result code, fmt::format_string<Args...> format, Args&&... args) {
    Call::current().refuse(code, format, fmt::make_format_args(args...));
}

/// Whether the running call is refused.
inline bool isRefused() {
    return Call::current().result() != RUBBLE_OK;
}

/// The text of the last refused call of this thread; what is longer than 4095 bytes is cut.
const char* lastError();

}  // namespace rubble::abi
