#include "editor/ui/gl/gui_painter.h"

#include <imgui.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "render/gl/gl.h"

namespace editor {
namespace {

constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 color;
uniform vec2 uSize;
out vec2 vTexel;
out vec4 vColor;
void main() {
    vTexel = texel;
    vColor = color;
    gl_Position = vec4(position / uSize * vec2(2.0, -2.0) + vec2(-1.0, 1.0), 0.0, 1.0);
})";
constexpr const char* kFragmentShader = R"(#version 330 core
in vec2 vTexel;
in vec4 vColor;
uniform sampler2D uTexture;
out vec4 color;
void main() { color = vColor * texture(uTexture, vTexel); })";

GLuint compile(GLenum kind, const char* text) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint isGood = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &isGood);
    if (isGood) return shader;
    char log[1024] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw std::runtime_error(std::string("the editor's shader does not compile: ") + log);
}

}  // namespace

GuiPainter::GuiPainter() {
    buildProgram();
    buildFonts();
    glGenVertexArrays(1, &m_vertexArray);
    glGenBuffers(1, &m_vertices);
    glGenBuffers(1, &m_indices);
    glBindVertexArray(m_vertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, m_vertices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices);
    for (GLuint i = 0; i < 3; ++i) glEnableVertexAttribArray(i);
    const auto at = [](size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, pos)));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, uv)));
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, col)));
    glBindVertexArray(0);
}

GuiPainter::~GuiPainter() {
    glDeleteBuffers(1, &m_vertices);
    glDeleteBuffers(1, &m_indices);
    glDeleteVertexArrays(1, &m_vertexArray);
    glDeleteTextures(1, &m_fonts);
    glDeleteProgram(m_program);
}

void GuiPainter::buildProgram() {
    const GLuint vertex = compile(GL_VERTEX_SHADER, kVertexShader);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, kFragmentShader);
    m_program = glCreateProgram();
    glAttachShader(m_program, vertex);
    glAttachShader(m_program, fragment);
    glLinkProgram(m_program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    m_size = glGetUniformLocation(m_program, "uSize");
    m_texture = glGetUniformLocation(m_program, "uTexture");
}

void GuiPainter::buildFonts() {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.GetTexDataAsRGBA32(&pixels, &width, &height);
    glGenTextures(1, &m_fonts);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, m_fonts);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    fonts.SetTexID(reinterpret_cast<ImTextureID>(uintptr_t(m_fonts)));
}

void GuiPainter::setState(const ImDrawData& data, int width, int height) const {
    glViewport(0, 0, width, height);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_SCISSOR_TEST);
    glUseProgram(m_program);
    glUniform2f(m_size, data.DisplaySize.x, data.DisplaySize.y);
    glUniform1i(m_texture, 0);
    glActiveTexture(GL_TEXTURE0);
    glBindSampler(0, 0);
    glBindVertexArray(m_vertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, m_vertices);
}

void GuiPainter::draw(const ImDrawData& data, uint32_t framebuffer) {
    const ImVec2 scale = data.FramebufferScale;
    const int width = int(data.DisplaySize.x * scale.x), height = int(data.DisplaySize.y * scale.y);
    if (width <= 0 || height <= 0) return;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    setState(data, width, height);
    const GLenum kind = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        glBufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const ImVec4 clip = command.ClipRect;
            const int left = int(clip.x * scale.x), bottom = int(float(height) - clip.w * scale.y);
            const int across = int((clip.z - clip.x) * scale.x), down = int((clip.w - clip.y) * scale.y);
            if (across <= 0 || down <= 0 || command.UserCallback) continue;
            glScissor(left, bottom, across, down);
            glBindTexture(GL_TEXTURE_2D, GLuint(reinterpret_cast<uintptr_t>(command.GetTexID())));
            glDrawElementsBaseVertex(GL_TRIANGLES, GLsizei(command.ElemCount), kind,
                                     reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)),
                                     GLint(command.VtxOffset));
        }
    }
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glBindVertexArray(0);
    glUseProgram(0);
}

}  // namespace editor
