#include "samples/hosts/godot/host_services.h"

#include <dlfcn.h>

#include "samples/hosts/godot/variant.h"

namespace rubble_godot {
namespace {

void log(void*, int32_t level, const char* message) {
    if (level == RUBBLE_LOG_ERROR) printError(message);
    if (level == RUBBLE_LOG_WARNING) printWarning(message);
}

/// Godot has made its window with GLX, so the process has its loader.
void* findGl(const char* name) {
    using Finder = void* (*)(const unsigned char*);
    static const auto find = reinterpret_cast<Finder>(dlsym(RTLD_DEFAULT, "glXGetProcAddressARB"));
    return find ? find(reinterpret_cast<const unsigned char*>(name)) : nullptr;
}

}  // namespace

rubble_host hostServices() {
    rubble_host host = {.struct_size = sizeof host};
    host.log = log;
    host.gl_get_proc_address = findGl;
    return host;
}

}  // namespace rubble_godot
