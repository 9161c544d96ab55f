#pragma once
#include <optional>

#include "runtime/core/log.h"
#include "runtime/plugin/include/rubble/rubble.h"

namespace rubble::abi {

/// What a world's calls use in place of the host's services; null ones are those of the host.
struct WorldServices {
    void* user = nullptr;
    /// As rubble_host.log.
    void (*log)(void* user, int32_t level, const char* message) = nullptr;
    /// As rubble_host.assertion_failed.
    void (*assertionFailed)(void* user, const char* message) = nullptr;
};

/// While it lives, a world's services are those of its thread. `services` must outlive it.
class ServiceScope {
public:
    /// Begins.
    explicit ServiceScope(const WorldServices& services);
    ~ServiceScope();
    ServiceScope(const ServiceScope&) = delete;
    ServiceScope& operator=(const ServiceScope&) = delete;

private:
    const WorldServices* m_outer;
    std::optional<LogScope> m_log;
};

/// The services that set_host() has copied; all null at first. Changes only in set_host(), which no other call runs
/// beside.
const rubble_host& host();

}  // namespace rubble::abi
