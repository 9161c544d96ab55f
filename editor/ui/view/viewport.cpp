#include "editor/ui/view/viewport.h"

#include <algorithm>
#include <cstdint>
#include <sstream>

namespace editor {
namespace {

constexpr int kFrames = 16;  ///< in which the renderer gathers light after a change

rubble::Renderer makeRenderer(const rubble::World& world, const std::string& preset, const std::string& cache) {
    rubble_renderer_settings settings{};
    settings.flags = RUBBLE_RENDERER_RESET_STATE | RUBBLE_RENDERER_COMPILE_LATE;
    settings.preset = preset.c_str();
    settings.program_cache = cache.empty() ? nullptr : cache.c_str();
    return rubble::Renderer(world, settings);
}

/// The renderer lists the names of its images in the error of a wrong one.
std::vector<std::string> namesOfPasses(rubble::Renderer& renderer) {
    std::vector<std::string> names;
    try {
        renderer.set_debug_view("?");
    } catch (const rubble::Error& error) {
        std::string text = error.what();
        text = text.substr(std::min(text.rfind(':'), text.size() - 1) + 1);
        std::replace(text.begin(), text.end(), ',', ' ');
        std::istringstream words(text);
        for (std::string word; words >> word;) names.push_back(word);
    }
    if (std::find(names.begin(), names.end(), "final") == names.end()) names = {"final"};
    return names;
}

}  // namespace

Viewport::Viewport(const rubble::World& world, const std::string& preset, const std::string& cache)
    : m_renderer(makeRenderer(world, preset, cache)), m_passes(namesOfPasses(m_renderer)) {}

ImTextureID Viewport::texture() const {
    return reinterpret_cast<ImTextureID>(uintptr_t(m_image.texture()));
}

void Viewport::draw(const ViewFrame& frame, uint64_t version, const std::string& pass, double share,
                    std::span<const rubble_shape> hidden) {
    const int width = std::max(16, int(double(frame.size.x) * share));
    const int height = std::max(16, int(double(frame.size.y) * share));
    const bool isResized = width != m_width || height != m_height;
    if (isResized) m_image.resize(m_width = width, m_height = height);
    if (pass != m_pass) m_renderer.set_debug_view(pass.c_str());
    if (isResized || pass != m_pass || version != m_version || frame.camera != m_camera) m_framesLeft = kFrames;
    m_pass = pass, m_version = version, m_camera = frame.camera;
    if (m_framesLeft == 0) return;
    --m_framesLeft;
    ++m_frames;
    rubble_view view = frame.view(m_image.framebuffer(), width, height);
    view.hidden_shapes = hidden.data(), view.hidden_shape_count = uint32_t(hidden.size());
    if (!std::ranges::equal(hidden, m_hidden)) view.flags |= RUBBLE_VIEW_CUT;  // no trace of what was there
    m_hidden.assign(hidden.begin(), hidden.end());
    m_renderer.draw(view);
    m_stats = m_renderer.get_draw_stats();
}

}  // namespace editor
