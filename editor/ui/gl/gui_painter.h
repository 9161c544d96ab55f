#pragma once
#include <cstdint>

struct ImDrawData;

namespace editor {

/// Draws the triangles of ImGui by the GL that is current, whichever window system or memory it belongs to.
class GuiPainter {
public:
    /// Builds program and the texture of the current ImGui context's fonts. Throws std::runtime_error.
    GuiPainter();
    ~GuiPainter();
    GuiPainter(const GuiPainter&) = delete;
    GuiPainter& operator=(const GuiPainter&) = delete;

    /// Draws a frame into a framebuffer; 0: the window's.
    void draw(const ImDrawData& data, uint32_t framebuffer);

private:
    void buildProgram();
    void buildFonts();
    void setState(const ImDrawData& data, int width, int height) const;

    uint32_t m_program = 0, m_vertexArray = 0, m_vertices = 0, m_indices = 0, m_fonts = 0;
    int32_t m_size = -1, m_texture = -1;
};

}  // namespace editor
