#pragma once
#include <utility>

#include "render/gl/gl.h"

namespace rubble {

/// Owns one GL object and deletes it in the context that is current. Kind says how to make and delete one.
template <class Kind>
class GlName {
public:
    GlName() = default;
    static GlName make() {
        GlName name;
        name.m_name = Kind::create();
        return name;
    }
    GlName(GlName&& other) noexcept : m_name(std::exchange(other.m_name, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(m_name, other.m_name);
        return *this;
    }
    ~GlName() {
        if (m_name) Kind::destroy(m_name);
    }
    GLuint get() const { return m_name; }
    explicit operator bool() const { return m_name != 0; }

private:
    GLuint m_name = 0;
};

struct TextureKind {
    static GLuint create() {
        GLuint name;
        glGenTextures(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct BufferKind {
    static GLuint create() {
        GLuint name;
        glGenBuffers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct FramebufferKind {
    static GLuint create() {
        GLuint name;
        glGenFramebuffers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct VertexArrayKind {
    static GLuint create() {
        GLuint name;
        glGenVertexArrays(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct QueryKind {
    static GLuint create() {
        GLuint name;
        glGenQueries(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteQueries(1, &name); }
};
struct ProgramKind {
    static GLuint create() { return glCreateProgram(); }
    static void destroy(GLuint name) { glDeleteProgram(name); }
};

using VertexArray = GlName<VertexArrayKind>;

}  // namespace rubble
