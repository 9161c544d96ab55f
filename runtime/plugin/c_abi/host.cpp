#include "runtime/plugin/c_abi/host.h"

#include <string>

#include "runtime/core/assertion.h"
#include "runtime/core/log.h"
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

rubble_host g_host = {};

void logToHost(void*, LogLevel level, std::string_view message) {
    const std::string text(message);
    g_host.log(g_host.user, int32_t(level), text.c_str());
}

/// In a call of the host an assert ends the call, and breaks its world; a worker of a call hands that on. There is
/// nobody to tell on a thread of the plugin's own outside of a call: those catch what their work throws.
void endCall(const char* message) {
    if (g_host.assertion_failed) g_host.assertion_failed(g_host.user, message);
    throw AssertionFailed(message);
}

rubble_result setHost(const rubble_host* host) {
    return guarded("set_host", [&] {
        const rubble_host services = host ? readStruct(host, "host") : rubble_host{};
        if (isRefused()) return;
        setLogSink(nullptr, nullptr);
        g_host = services;
        if (g_host.log) setLogSink(logToHost, nullptr);
    });
}

}  // namespace

const rubble_host& host() {
    return g_host;
}

void setHostFunctions(rubble_api& api) {
    api.get_last_error = lastError;
    api.set_host = setHost;
    setAssertionHandler(endCall);
}

}  // namespace rubble::abi
