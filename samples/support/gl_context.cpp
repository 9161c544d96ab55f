#include "samples/support/gl_context.h"

#include <filesystem>

#include "samples/support/egl_context.h"
#include "samples/support/osmesa_context.h"

namespace rubble {

GlContext::Kind GlContext::kindOf(std::string_view name) {
    if (name == "egl-es") return Kind::EglEs;
    return name == "osmesa" ? Kind::OsMesa : name == "egl" ? Kind::Egl : Kind::Auto;
}

Result<std::unique_ptr<GlContext>> GlContext::create(Kind kind) {
    if (kind == Kind::OsMesa) return OsMesaContext::create();
    if (kind == Kind::Egl || kind == Kind::EglEs) return EglContext::create(kind == Kind::EglEs);
    const bool gpu = std::filesystem::exists("/dev/dri") || std::filesystem::exists("/dev/nvidia0");
    auto first = gpu ? EglContext::create() : OsMesaContext::create();
    if (first) return first;
    return gpu ? OsMesaContext::create() : EglContext::create();
}

}  // namespace rubble
