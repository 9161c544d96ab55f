#define GLAD_GL_IMPLEMENTATION
#include "render/gl/gl.h"

#include <string>
#include <string_view>

#include "render/gl/embedded_gl.h"

namespace rubble {
namespace {

using ResetStatus = GLenum(GLAD_API_PTR*)();
ResetStatus g_resetStatus = nullptr;
using PixelTransfer = void(GLAD_API_PTR*)(GLenum, GLfloat);
PixelTransfer g_pixelTransfer = nullptr;  ///< null in core profiles
using CompilerThreads = void(GLAD_API_PTR*)(GLuint);
CompilerThreads g_compilerThreads = nullptr;
constexpr GLenum kCompilerThreads = 0x91B0;   ///< of KHR_parallel_shader_compile
constexpr GLenum kUnmaskedRenderer = 0x9246;  ///< of WEBGL_debug_renderer_info
bool g_hasCompute = false, g_isEmbedded = false;

/// The function that tells of lost contexts: of GL 4.5, KHR_robustness or ARB_robustness; null: there is none.
const char* resetStatusName(int version) {
    if (version >= GLAD_MAKE_VERSION(4, 5)) return "glGetGraphicsResetStatus";
    if (offers("GL_KHR_robustness")) return "glGetGraphicsResetStatusKHR";
    return offers("GL_ARB_robustness") ? "glGetGraphicsResetStatusARB" : nullptr;
}

/// The function that sets the number of the driver's compiler threads; null: there is none.
const char* compilerThreadsName() {
    if (offers("GL_KHR_parallel_shader_compile")) return "glMaxShaderCompilerThreadsKHR";
    return offers("GL_ARB_parallel_shader_compile") ? "glMaxShaderCompilerThreadsARB" : nullptr;
}

/// The version of the context, as its driver writes it.
std::string versionText() {
    const GLubyte* text = glGetString(GL_VERSION);
    return text ? reinterpret_cast<const char*>(text) : "none";
}

}  // namespace

Result<Done> loadGl(void* (*loader)(const char* name)) {
    static thread_local void* (*current)(const char*);
    current = loader;
    const auto find = [](const char* name) { return reinterpret_cast<GLADapiproc>(current(name)); };
    const int version = gladLoadGL(find);
    if (!version) return Error{"OpenGL: no functions could be loaded; is a context current?"};
    const std::string found = versionText();
    g_isEmbedded = found.starts_with("OpenGL ES");
    if (g_isEmbedded) {
        g_hasCompute = false, g_resetStatus = nullptr, g_pixelTransfer = nullptr, g_compilerThreads = nullptr;
        return loadEmbeddedGl(find);
    }
    if (version < GLAD_MAKE_VERSION(3, 3)) return Error{"OpenGL: expected 3.3 or newer, found " + found};
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    const int context = GLAD_MAKE_VERSION(major, minor);  // `version` is the newest one that glad knows
    g_hasCompute = context >= GLAD_MAKE_VERSION(4, 3) && glDispatchCompute && glBindImageTexture && glMemoryBarrier;
    const char* name = resetStatusName(context);
    g_resetStatus = name ? reinterpret_cast<ResetStatus>(loader(name)) : nullptr;
    GLint profiles = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profiles);
    const bool isCompatible = profiles & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT;
    g_pixelTransfer = isCompatible ? reinterpret_cast<PixelTransfer>(loader("glPixelTransferf")) : nullptr;
    const char* threads = compilerThreadsName();
    g_compilerThreads = threads ? reinterpret_cast<CompilerThreads>(loader(threads)) : nullptr;
    return Done{};
}

bool offers(std::string_view extension) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i)
        if (extension == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, GLuint(i)))) return true;
    return false;
}

bool isEmbedded() {
    return g_isEmbedded;
}

bool hasCompute() {
    return g_hasCompute;
}

bool isCompatibility() {
    return g_pixelTransfer;
}

void setPixelTransfer(GLenum name, GLfloat value) {
    g_pixelTransfer(name, value);
}

GLuint setCompilerThreads(GLuint count) {
    GLint before = 0;
    if (!g_compilerThreads) return 0;
    glGetIntegerv(kCompilerThreads, &before);
    g_compilerThreads(count);
    return GLuint(before);
}

bool isContextLost() {
    return g_resetStatus && g_resetStatus() != GL_NO_ERROR;
}

bool isSoftwareGl() {
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    if (isEmbedded() && offers("GL_WEBGL_debug_renderer_info")) {  // browsers hide the name behind an extension
        const auto* unmasked = reinterpret_cast<const char*>(glGetString(kUnmaskedRenderer));
        text = glGetError() == GL_NO_ERROR && unmasked ? unmasked : text;
    }
    const std::string_view name = text ? text : "";
    for (const char* software : {"llvmpipe", "softpipe", "SwiftShader"})
        if (name.find(software) != std::string_view::npos) return true;
    return false;
}

}  // namespace rubble
