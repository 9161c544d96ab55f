#include "samples/support/osmesa_context.h"

#include <GL/osmesa.h>

namespace rubble {
namespace {

constexpr int kSide = 16;  ///< pixels

}  // namespace

Result<std::unique_ptr<GlContext>> OsMesaContext::create(Profile profile) {
    auto result = std::make_unique<OsMesaContext>();
    for (const GlVersion wanted : kWantedGl) {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  24,
                                  OSMESA_PROFILE,
                                  profile == Profile::Core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  wanted.major,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  wanted.minor,
                                  0};
        result->m_context = OSMesaCreateContextAttribs(attributes, nullptr);
        if (result->m_context) break;
    }
    if (!result->m_context) return Error{"OSMesa: no OpenGL 3.3 context of that profile (Debian package libosmesa6)"};
    result->m_pixels.resize(kSide * kSide * 4);
    if (!OSMesaMakeCurrent(result->m_context, result->m_pixels.data(), GL_UNSIGNED_BYTE, kSide, kSide))
        return Error{"OSMesa: the context cannot be made current"};
    return std::unique_ptr<GlContext>(std::move(result));
}

void OsMesaContext::makeCurrent() {
    OSMesaMakeCurrent(m_context, m_pixels.data(), GL_UNSIGNED_BYTE, kSide, kSide);
}

OsMesaContext::~OsMesaContext() {
    OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    if (m_context) OSMesaDestroyContext(m_context);
}

GlLoader OsMesaContext::loader() const {
    return [](const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); };
}

}  // namespace rubble
