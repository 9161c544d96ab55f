#pragma once
#include <initializer_list>
#include <vector>

#include "render/gl/texture.h"

namespace rubble {

/// Textures to draw into: colour attachments in order, all of one size, and a depth buffer or none.
class Framebuffer {
public:
    Framebuffer() = default;
    /// The textures must outlive it.
    Framebuffer(std::initializer_list<const Texture*> colors, const Texture* depth = nullptr)
        : Framebuffer(std::vector<const Texture*>(colors), depth) {}
    /// depth: null for none.
    Framebuffer(const std::vector<const Texture*>& colors, const Texture* depth);

    /// The GL's name of it.
    GLuint name() const { return m_name.get(); }
    /// Of its attachments, in pixels.
    glm::ivec2 size() const { return m_size; }
    /// False if the GL cannot draw into these together, or had no memory for them.
    bool isComplete() const { return m_isComplete; }
    /// Binds it for drawing, with a viewport of its whole size.
    void begin() const;

private:
    GlName<FramebufferKind> m_name;
    glm::ivec2 m_size{0};
    bool m_isComplete = false;
};

}  // namespace rubble
