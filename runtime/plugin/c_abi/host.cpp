#include "runtime/plugin/c_abi/host.h"

#include <array>
#include <new>
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

/// Hands a message to a host's callback; without memory for a copy of it, its beginning.
void handOver(void (*log)(void*, int32_t, const char*), void* user, LogLevel level, std::string_view message) {
    std::array<char, 512> beginning{};
    message.copy(beginning.data(), beginning.size() - 1);
    std::string whole;
    try {
        whole = message;
    } catch (const std::bad_alloc&) {
        return log(user, int32_t(level), beginning.data());
    }
    log(user, int32_t(level), whole.c_str());
}

void logToWorld(void* services, LogLevel level, std::string_view message) {
    const auto& to = *static_cast<const WorldServices*>(services);
    handOver(to.log, to.user, level, message);
}

void logToHost(void*, LogLevel level, std::string_view message) {
    handOver(g_host.log, g_host.user, level, message);
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
