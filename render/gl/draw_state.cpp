#include "render/gl/draw_state.h"

namespace rubble {
namespace {

GLenum askedEnum(GLenum name) {
    GLint value = 0;
    if (GLAD_GL_ARB_draw_buffers_blend)
        glGetIntegeri_v(name, 0, &value);
    else
        glGetIntegerv(name, &value);
    return GLenum(value);
}

}  // namespace

void setBlend(const Blend& blend) {
    setBlendFunctions(blend);
    glEnablei(GL_BLEND, 0);
}

void disableBlend() {
    glDisablei(GL_BLEND, 0);
}

void setBlendFunctions(const Blend& b) {
    if (GLAD_GL_ARB_draw_buffers_blend) {
        glBlendFuncSeparateiARB(0, b.source, b.destination, b.sourceAlpha, b.destinationAlpha);
        glBlendEquationSeparateiARB(0, b.equation, b.equationAlpha);
        return;
    }
    glBlendFuncSeparate(b.source, b.destination, b.sourceAlpha, b.destinationAlpha);
    glBlendEquationSeparate(b.equation, b.equationAlpha);
}

Blend currentBlend() {
    return {.source = askedEnum(GL_BLEND_SRC_RGB),
            .destination = askedEnum(GL_BLEND_DST_RGB),
            .sourceAlpha = askedEnum(GL_BLEND_SRC_ALPHA),
            .destinationAlpha = askedEnum(GL_BLEND_DST_ALPHA),
            .equation = askedEnum(GL_BLEND_EQUATION_RGB),
            .equationAlpha = askedEnum(GL_BLEND_EQUATION_ALPHA)};
}

void setViewport(glm::ivec2 size) {
    setViewport({0.0f, 0.0f, GLfloat(size.x), GLfloat(size.y)});
}

void setViewport(const GLfloat (&r)[4]) {
    if (GLAD_GL_ARB_viewport_array)
        glViewportIndexedf(0, r[0], r[1], r[2], r[3]);
    else
        glViewport(GLint(r[0]), GLint(r[1]), GLsizei(r[2]), GLsizei(r[3]));
}

void setDepthRange(double nearest, double farthest) {
    if (GLAD_GL_ARB_viewport_array)
        glDepthRangeIndexed(0, nearest, farthest);
    else
        glDepthRange(nearest, farthest);
}

void setScissorTest(bool on) {
    if (GLAD_GL_ARB_viewport_array)
        on ? glEnablei(GL_SCISSOR_TEST, 0) : glDisablei(GL_SCISSOR_TEST, 0);
    else
        on ? glEnable(GL_SCISSOR_TEST) : glDisable(GL_SCISSOR_TEST);
}

void setScissor(glm::ivec2 low, glm::ivec2 size) {
    if (GLAD_GL_ARB_viewport_array)
        glScissorIndexed(0, low.x, low.y, size.x, size.y);
    else
        glScissor(low.x, low.y, size.x, size.y);
}

}  // namespace rubble
