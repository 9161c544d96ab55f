#include "tests/support/gl_host.h"

#include <cstdio>
#include <cstdlib>

#include "render/gl/gl.h"
#include "samples/support/gl_context.h"

void* (*make_gl_context())(const char*) {
    static auto context = rubble::GlContext::create(rubble::GlContext::Kind::OsMesa);
    if (!context || !rubble::loadGl(context.value()->loader())) {
        std::fprintf(stderr, "no OpenGL: %s\n", context ? "too old" : context.error().c_str());
        std::exit(1);
    }
    return context.value()->loader();
}

unsigned make_framebuffer(int width, int height) {
    GLuint framebuffer = 0, buffers[2] = {};
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(2, buffers);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const GLenum formats[2] = {GL_RGBA8, GL_DEPTH_COMPONENT32F},
                 places[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, formats[i], width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, buffers[i]);
    }
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return framebuffer;
}
