#pragma once
#include <cstdint>
#include <memory>
#include <string>

namespace editor {

/// Finds GL functions by name in the context that is current.
using GlLoader = void* (*)(const char* name);

/// Loads the functions that the interface draws with. An error says what is missing; empty: nothing.
std::string loadGlFunctions(GlLoader loader);

/// A texture that is drawn into.
class GlImage {
public:
    /// Without pixels yet.
    GlImage();
    ~GlImage();
    GlImage(const GlImage&) = delete;
    GlImage& operator=(const GlImage&) = delete;

    /// In pixels; what was drawn is lost. Throws std::runtime_error.
    void resize(int width, int height);
    /// Writes what was drawn as PNG. An error names the file; empty: it is written.
    std::string write(const std::string& path) const;
    /// GL name of the texture.
    uint32_t texture() const { return m_texture; }
    /// GL name of its framebuffer.
    uint32_t framebuffer() const { return m_framebuffer; }

private:
    uint32_t m_texture = 0, m_framebuffer = 0;
    int m_width = 0, m_height = 0;
};

/// A GL without a window, and an image to draw into.
class OffscreenGl {
public:
    /// In pixels. Its context stays current. Throws std::runtime_error.
    OffscreenGl(int width, int height);
    ~OffscreenGl();
    OffscreenGl(const OffscreenGl&) = delete;
    OffscreenGl& operator=(const OffscreenGl&) = delete;

    /// Of its context.
    GlLoader loader() const;
    /// GL name of the image's framebuffer.
    uint32_t framebuffer() const;
    /// Writes the image as PNG. An error names the file; empty: it is written.
    std::string write(const std::string& path) const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace editor
