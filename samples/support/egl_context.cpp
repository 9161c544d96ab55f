#include "samples/support/egl_context.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <span>

namespace rubble {

bool EglContext::open(void* display, bool isEmbedded) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return false;
    m_display = display;
    const EGLint kind = isEmbedded ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT;
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, kind, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    eglChooseConfig(display, wanted, &config, 1, &count);
    if (!eglBindAPI(isEmbedded ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) return false;
    static constexpr GlVersion kWantedEmbedded[] = {{3, 0}};
    const std::span<const GlVersion> versions = isEmbedded ? std::span<const GlVersion>(kWantedEmbedded) : kWantedGl;
    for (const GlVersion wantedGl : versions) {
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  wantedGl.major,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  wantedGl.minor,
                                  isEmbedded ? EGL_NONE : EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
        m_context = eglCreateContext(display, count ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
        if (m_context != EGL_NO_CONTEXT) break;
    }
    return m_context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context);
}

Result<std::unique_ptr<GlContext>> EglContext::create(bool isEmbedded) {
    const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto platformDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!platformDisplay) return Error{"EGL: expected eglGetPlatformDisplayEXT, found none"};
    EGLDeviceEXT devices[8];
    EGLint count = 0;
    if (queryDevices) queryDevices(8, devices, &count);
    for (EGLint i = 0; i <= count; ++i) {
        auto result = std::make_unique<EglContext>();
        const bool surfaceless = i == count;
        EGLDisplay display = surfaceless ? platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                                         : platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
        if (result->open(display, isEmbedded)) return std::unique_ptr<GlContext>(std::move(result));
    }
    return Error{std::string("EGL: no device gave a context of OpenGL ") + (isEmbedded ? "ES 3.0" : "3.3 core") +
                 " without a surface"};
}

void EglContext::makeCurrent() {
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context);
}

EglContext::~EglContext() {
    if (!m_display) return;
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (m_context) eglDestroyContext(m_display, m_context);
    eglTerminate(m_display);
}

GlLoader EglContext::loader() const {
    return [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); };
}

}  // namespace rubble
