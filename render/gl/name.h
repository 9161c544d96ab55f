#pragma once
#include <utility>

#include "render/gl/gl.h"

namespace rubble {

/// While it lives, objects of this thread that are destroyed leave the GL alone: their context is gone, and their names
/// may mean objects of another one.
class WithoutGlContext {
public:
    /// isGone: whether there is no context; false changes nothing.
    explicit WithoutGlContext(bool isGone) : m_before(std::exchange(s_isGone, isGone)) {}
    ~WithoutGlContext() { s_isGone = m_before; }
    WithoutGlContext(const WithoutGlContext&) = delete;
    WithoutGlContext& operator=(const WithoutGlContext&) = delete;
    /// Whether there is one on this thread that says so.
    static bool isGone() { return s_isGone; }

private:
    static inline thread_local bool s_isGone = false;
    bool m_before;
};

/// Owns one GL object. The destructor deletes it in the context that is current then. `Kind` makes and deletes one.
template <class Kind>
class GlName {
public:
    GlName() = default;
    /// Takes over an object that the GL has made.
    explicit GlName(GLuint name) : m_name(name) {}
    /// A new object of the current context.
    static GlName make() {
        GlName name;
        name.m_name = Kind::create();
        return name;
    }
    /// Takes the object over.
    GlName(GlName&& other) noexcept : m_name(std::exchange(other.m_name, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(m_name, other.m_name);
        return *this;
    }
    ~GlName() {
        if (m_name && !WithoutGlContext::isGone()) Kind::destroy(m_name);
    }
    /// The GL's name of it; 0: none.
    GLuint get() const { return m_name; }
    explicit operator bool() const { return m_name != 0; }

private:
    GLuint m_name = 0;
};

/// How the GL makes and deletes each kind of object, for GlName.
struct TextureKind {
    static GLuint create() {  ///< a new name
        GLuint name;
        glGenTextures(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }  ///< frees the object
};
struct BufferKind {
    static GLuint create() {  ///< a new name
        GLuint name;
        glGenBuffers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }  ///< frees the object
};
struct FramebufferKind {
    static GLuint create() {  ///< a new name
        GLuint name;
        glGenFramebuffers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }  ///< frees the object
};
struct VertexArrayKind {
    static GLuint create() {  ///< a new name
        GLuint name;
        glGenVertexArrays(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }  ///< frees the object
};
struct QueryKind {
    static GLuint create() {  ///< a new name
        GLuint name;
        glGenQueries(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteQueries(1, &name); }  ///< frees the object
};
struct ShaderKind {
    static void destroy(GLuint name) { glDeleteShader(name); }  ///< frees the object
};
struct ProgramKind {
    static GLuint create() { return glCreateProgram(); }         ///< a new name
    static void destroy(GLuint name) { glDeleteProgram(name); }  ///< frees the object
};

using VertexArray = GlName<VertexArrayKind>;

}  // namespace rubble
