#pragma once
#include <imgui.h>

#include <rubble/rubble.hpp>
#include <span>
#include <string>
#include <vector>

#include "editor/ui/gl/gl_surface.h"
#include "editor/ui/state/camera.h"

namespace editor {

/// The image of the level: drawn by the renderer into a texture, and only while something has changed or the renderer
/// still gathers light.
class Viewport {
public:
    /// preset: as rubble_renderer_settings has it; cache: a folder for compiled programs, or empty. Throws
    /// rubble::Error.
    Viewport(const rubble::World& world, const std::string& preset, const std::string& cache);

    /// Draws a frame, if one is due. version: another one than before means that the level has changed. share: pixels
    /// of the image by those of the rectangle, along each side. hidden: shapes that it leaves out, of the same version.
    void draw(const ViewFrame& frame, uint64_t version, const std::string& pass, double share,
              std::span<const rubble_shape> hidden);
    /// Whether nothing would become of another draw().
    bool isSettled() const { return m_framesLeft == 0; }
    /// The image, its first row at the bottom.
    ImTextureID texture() const;
    /// Writes the image as PNG. An error names the file; empty: it is written.
    std::string write(const std::string& path) const { return m_image.write(path); }
    /// Of the last frame that was drawn.
    const rubble_draw_stats& stats() const { return m_stats; }
    /// How many frames were drawn.
    uint64_t frames() const { return m_frames; }
    /// The images of the renderer that may be shown, "final" among them.
    const std::vector<std::string>& passes() const { return m_passes; }

private:
    rubble::Renderer m_renderer;
    std::vector<std::string> m_passes;
    rubble_draw_stats m_stats{};
    Camera m_camera;
    std::string m_pass = "final";
    std::vector<rubble_shape> m_hidden;
    uint64_t m_version = 0, m_frames = 0;
    int m_width = 0, m_height = 0, m_framesLeft = 0;
    GlImage m_image;
};

}  // namespace editor
