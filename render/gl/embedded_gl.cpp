#include "render/gl/embedded_gl.h"

#include <string>

#include "render/gl/state_guard.h"

namespace rubble {
namespace {

/// Functions of ES that are called with more than it knows.
struct Originals {
    PFNGLENABLEPROC enable;
    PFNGLDISABLEPROC disable;
    PFNGLISENABLEDPROC isEnabled;
    PFNGLGETINTEGERVPROC getIntegerv;
    PFNGLPIXELSTOREIPROC pixelStorei;
    PFNGLTEXIMAGE2DPROC texImage2D;
    PFNGLTEXIMAGE3DPROC texImage3D;
} g_es;

/// Whether ES lacks a switch or value that the renderer sets or asks for.
bool isDesktopOnly(GLenum name) {
    switch (name) {
        case GL_COLOR_LOGIC_OP:
        case GL_POLYGON_SMOOTH:
        case GL_DEPTH_CLAMP:
        case GL_SAMPLE_MASK:
        case GL_FRAMEBUFFER_SRGB:
        case GL_UNPACK_SWAP_BYTES:
        case GL_PACK_SWAP_BYTES:
        case GL_POLYGON_MODE:
        case GL_PROVOKING_VERTEX:
            return true;
    }
    return name >= GL_CLIP_DISTANCE0 && name <= GL_CLIP_DISTANCE7;
}

/// The value that desktop-only state has.
GLint desktopValue(GLenum name) {
    return name == GL_POLYGON_MODE ? GL_FILL : name == GL_PROVOKING_VERTEX ? GL_LAST_VERTEX_CONVENTION : 0;
}

void completeSwitches() {
    glad_glEnable = [](GLenum name) { isDesktopOnly(name) ? void() : g_es.enable(name); };
    glad_glDisable = [](GLenum name) { isDesktopOnly(name) ? void() : g_es.disable(name); };
    glad_glIsEnabled = [](GLenum name) { return isDesktopOnly(name) ? GLboolean(GL_FALSE) : g_es.isEnabled(name); };
    glad_glGetIntegerv = [](GLenum name, GLint* out) {
        isDesktopOnly(name) ? void(*out = desktopValue(name)) : g_es.getIntegerv(name, out);
    };
    glad_glPixelStorei = [](GLenum name, GLint value) { isDesktopOnly(name) ? void() : g_es.pixelStorei(name, value); };
    glad_glPolygonMode = [](GLenum, GLenum) {};
    glad_glProvokingVertex = [](GLenum) {};
}

void completeTargets() {
    glad_glEnablei = [](GLenum name, GLuint i) { i == 0 ? glEnable(name) : void(); };
    glad_glDisablei = [](GLenum name, GLuint i) { i == 0 ? glDisable(name) : void(); };
    glad_glIsEnabledi = [](GLenum name, GLuint) { return glIsEnabled(name); };
    glad_glColorMaski = [](GLuint i, GLboolean r, GLboolean g, GLboolean b, GLboolean a) {
        i == 0 ? glColorMask(r, g, b, a) : void();
    };
    glad_glGetBooleani_v = [](GLenum name, GLuint, GLboolean* out) { glGetBooleanv(name, out); };
}

/// Whether there was memory for a texture shows in its width; ES tells it by an error alone.
void completeAllocations() {
    glad_glTexImage2D = [](GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height,
                           GLint border, GLenum format, GLenum type, const void* pixels) {
        dropErrors();  // of before, as of a host's calls
        g_es.texImage2D(target, level, internalFormat, width, height, border, format, type, pixels);
    };
    glad_glTexImage3D = [](GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height,
                           GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels) {
        dropErrors();  // of before, as of a host's calls
        g_es.texImage3D(target, level, internalFormat, width, height, depth, border, format, type, pixels);
    };
    glad_glGetTexLevelParameteriv = [](GLenum, GLint, GLenum, GLint* out) { *out = glGetError() == GL_NO_ERROR; };
}

void completeValues() {
    glad_glDepthRange = [](GLdouble nearest, GLdouble farthest) { glDepthRangef(GLfloat(nearest), GLfloat(farthest)); };
    glad_glGetDoublev = [](GLenum name, GLdouble* out) {
        GLfloat values[2] = {};  // the depth range, which is all that is asked for
        glGetFloatv(name, values);
        out[0] = values[0], out[1] = values[1];
    };
}

}  // namespace

Result<Done> loadEmbeddedGl(GLADloadfunc find) {
    const int version = gladLoadGLES2(find);
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    if (version < GLAD_MAKE_VERSION(3, 0)) return Error{std::string("OpenGL ES: expected 3.0 or newer, found ") + text};
    for (const std::string extension : {"EXT_color_buffer_float", "OES_texture_float_linear"})
        if (!offers("GL_" + extension))
            return Error{"OpenGL ES: expected the extension " + extension + ", which " + text + " lacks"};
    GLint targets = 0;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &targets);
    if (targets < GLint(GlState::kTargets))
        return Error{"OpenGL ES: expected " + std::to_string(GlState::kTargets) + " targets of a draw, found " +
                     std::to_string(targets)};
    g_es = {glad_glEnable,      glad_glDisable,    glad_glIsEnabled, glad_glGetIntegerv,
            glad_glPixelStorei, glad_glTexImage2D, glad_glTexImage3D};
    completeSwitches();
    completeTargets();
    completeAllocations();
    completeValues();
    return Done{};
}

}  // namespace rubble
