#define GLAD_GL_IMPLEMENTATION
#include "render/gl/gl.h"

#include <string>
#include <string_view>

namespace rubble {

Result<Done> loadGl(void* (*loader)(const char* name)) {
    static thread_local void* (*current)(const char*);
    current = loader;
    const int version = gladLoadGL([](const char* name) { return reinterpret_cast<GLADapiproc>(current(name)); });
    if (!version) return Error{"OpenGL: no functions could be loaded; is a context current?"};
    if (version < GLAD_MAKE_VERSION(3, 3))
        return Error{"OpenGL: expected 3.3 or newer, found " + std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                     std::to_string(GLAD_VERSION_MINOR(version))};
    return Done{};
}

bool isSoftwareGl() {
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string_view name = text ? text : "";
    for (const char* software : {"llvmpipe", "softpipe", "SwiftShader"})
        if (name.find(software) != std::string_view::npos) return true;
    return false;
}

}  // namespace rubble
