#include "runtime/plugin/c_abi/host.h"

#include <string>

#include "runtime/assets/file_hooks.h"
#include "runtime/core/assertion.h"
#include "runtime/core/log.h"
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

rubble_host g_host = {};
thread_local const WorldServices* t_services = nullptr;

void logToWorld(void* services, LogLevel level, std::string_view message) {
    const auto& to = *static_cast<const WorldServices*>(services);
    to.log(to.user, int32_t(level), std::string(message).c_str());
}

void logToHost(void*, LogLevel level, std::string_view message) {
    const std::string text(message);
    g_host.log(g_host.user, int32_t(level), text.c_str());
}

/// In a call of the host an assert ends the call, and breaks its world; a worker of a call hands that on. There is
/// nobody to tell on a thread of the plugin's own outside of a call: those catch what their work throws.
void endCall(const char* message) {
    if (t_services && t_services->assertionFailed)
        t_services->assertionFailed(t_services->user, message);
    else if (g_host.assertion_failed)
        g_host.assertion_failed(g_host.user, message);
    throw AssertionFailed(message);
}

rubble_result setHost(const rubble_host* host) {
    return guarded("set_host", [&] {
        const rubble_host services = host ? readStruct(host, "host") : rubble_host{};
        if (!services.file_size != !services.read_file)
            refuse(RUBBLE_ERROR_NULL, "expected file_size and read_file, or neither: one of them is null");
        if (isRefused()) return;
        setFileHooks({services.user, services.file_size, services.read_file, services.write_file});
        setLogSink(nullptr, nullptr);
        g_host = services;
        if (g_host.log) setLogSink(logToHost, nullptr);
    });
}

}  // namespace

ServiceScope::ServiceScope(const WorldServices& services) : m_outer(t_services) {
    t_services = &services;
    if (services.log) m_log.emplace(logToWorld, const_cast<WorldServices*>(&services));
}

ServiceScope::~ServiceScope() {
    t_services = m_outer;
}

const rubble_host& host() {
    return g_host;
}

void setHostFunctions(rubble_api& api) {
    api.get_last_error = lastError;
    api.set_host = setHost;
    setAssertionHandler(endCall);
}

}  // namespace rubble::abi
