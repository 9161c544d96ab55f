#include "tests/abi/endurance/library.h"

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

namespace rubble {

Library::Library(const std::string& path) : m_library(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    using GetApi = rubble_result (*)(uint32_t, const rubble_api**);
    const auto getApi = m_library ? reinterpret_cast<GetApi>(dlsym(m_library, "rubble_get_api")) : nullptr;
    if (getApi && getApi(RUBBLE_VERSION, &m_api) == RUBBLE_OK) return;
    std::fprintf(stderr, "%s: expected a library with the interface of rubble.h: %s\n", path.c_str(), dlerror());
    std::exit(1);
}

Library::~Library() {
    dlclose(m_library);
}

void require(const Library& library, rubble_result result) {
    if (result == RUBBLE_OK) return;
    std::fprintf(stderr, "%s\n", library->get_last_error());
    std::exit(1);
}

}  // namespace rubble
