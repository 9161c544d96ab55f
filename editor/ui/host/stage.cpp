#include "editor/ui/host/stage.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <stdexcept>

#include "editor/ui/state/theme.h"

namespace editor {

struct Stage::Context {
    Context() : context(ImGui::CreateContext()) {}
    ~Context() { ImGui::DestroyContext(context); }
    ImGuiContext* context;
};

Stage::Stage(const StageSettings& settings, GlLoader loader) {
    if (const std::string error = loadGlFunctions(loader); !error.empty()) throw std::runtime_error(error);
    rubble_host host{};
    host.gl_get_proc_address = loader;
    rubble::set_host(host);
    const auto watcher = [this](const std::vector<uint8_t>& deltas) {
        if (m_session) m_session->replay.add(deltas);
    };
    const auto writer = [this](const std::string& path) { return m_ui->writeView(path); };
    const auto tracer = [this](const std::string& path) { return m_ui->writeTrace(path); };
    m_editor.emplace(EditorSettings{RUBBLE_WORLD_WAIT_FOR_SHADOW, settings.vdbTool, settings.journals, watcher, writer,
                                    tracer, settings.isForced});
    m_context = std::make_unique<Context>();
    applyTheme(settings.scale);
    m_painter.emplace();
    m_viewport.emplace(m_editor->world(), settings.preset, settings.programCache);
    m_session.emplace(*m_editor);
    m_ui.emplace(*m_session, *m_viewport);
    m_ui->makeViewport = [settings](const rubble::World& world) {
        return std::make_unique<Viewport>(world, settings.preset, settings.programCache);
    };
}

Stage::~Stage() = default;

void Stage::draw(double share, uint32_t framebuffer) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const uint64_t frames = m_viewport->frames();
    m_ui->frame(share);
    ImGui::Render();
    if (share > 0.0) m_painter->draw(*ImGui::GetDrawData(), framebuffer);
    m_uiMs = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    const rubble_draw_stats after = m_viewport->stats();
    if (m_viewport->frames() == frames) return;
    m_uiMs = std::max(m_uiMs - after.apply_ms - after.draw_ms, 0.0);
    m_ui->sample(m_uiMs);
}

}  // namespace editor
