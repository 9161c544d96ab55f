#include "runtime/plugin/c_abi/host.h"

#include <string>

#include "runtime/core/log.h"
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

thread_local std::string g_lastError;
rubble_host g_host = {};

const char* getLastError() {
    return g_lastError.c_str();
}

void logToHost(void*, LogLevel level, std::string_view message) {
    const std::string text(message);
    g_host.log(g_host.user, int32_t(level), text.c_str());
}

rubble_result setHost(const rubble_host* host) {
    return guarded("set_host", [&] {
        const rubble_host services = host ? readStruct(host, "host") : rubble_host{};
        setLogSink(nullptr, nullptr);
        g_host = services;
        if (g_host.log) setLogSink(logToHost, nullptr);
    });
}

}  // namespace

rubble_result storeLastError(const char* function, const ApiError& error) {
    g_lastError = std::string(function) + ": " + error.text;
    return error.code;
}

const rubble_host& host() {
    return g_host;
}

void setHostFunctions(rubble_api& api) {
    api.get_last_error = getLastError;
    api.set_host = setHost;
}

}  // namespace rubble::abi
