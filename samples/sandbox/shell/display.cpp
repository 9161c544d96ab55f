#include "samples/sandbox/shell/display.h"

#define GLFW_INCLUDE_NONE  // render/gl/gl.h has GL
#include <GLFW/glfw3.h>

#include <optional>

#include "render/gl/gl.h"
#include "render/gl/offscreen.h"
#include "samples/support/gl_context.h"
#include "samples/support/image.h"
#include "samples/support/window.h"

namespace sandbox {
namespace {

constexpr double kCanvasHeight = 1080.0;

struct KeyName {
    int key;
    const char* name;
};
constexpr KeyName kKeys[] = {
    {GLFW_KEY_SPACE, "space"},       {GLFW_KEY_ESCAPE, "esc"},          {GLFW_KEY_TAB, "tab"},
    {GLFW_KEY_ENTER, "return"},      {GLFW_KEY_BACKSPACE, "backspace"}, {GLFW_KEY_LEFT_SHIFT, "shift"},
    {GLFW_KEY_LEFT_CONTROL, "ctrl"}, {GLFW_KEY_LEFT_ALT, "alt"},        {GLFW_KEY_UP, "uparrow"},
    {GLFW_KEY_DOWN, "downarrow"},    {GLFW_KEY_LEFT, "leftarrow"},      {GLFW_KEY_RIGHT, "rightarrow"},
};

void readKeys(const rubble::Window& window, Input& input) {
    for (const KeyName& row : kKeys) input.set(row.name, window.held(row.key));
    for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key)
        input.set(std::string(1, char('a' + key - GLFW_KEY_A)), window.held(key));
    for (int key = GLFW_KEY_0; key <= GLFW_KEY_9; ++key)
        input.set(std::string(1, char('0' + key - GLFW_KEY_0)), window.held(key));
    for (int i = 1; i <= 12; ++i) input.set("f" + std::to_string(i), window.held(GLFW_KEY_F1 + i - 1));
}

class WindowDisplay final : public Display {
public:
    explicit WindowDisplay(std::unique_ptr<rubble::Window> window) : m_window(std::move(window)) {}
    Loader loader() const override { return m_window->loader(); }
    unsigned framebuffer() const override { return 0; }
    glm::ivec2 size() const override { return m_window->size(); }
    bool poll(Input& input) override {
        const bool isOpen = m_window->poll();
        readKeys(*m_window, input);
        static constexpr const char* kButtons[] = {"lmb", "rmb", "mmb"};
        for (int i = 0; i < 3; ++i) input.set(kButtons[i], m_window->buttonHeld(i));
        const glm::dvec2 motion = m_window->takeMouseMotion();
        input.add("mousedx", motion.x);
        input.add("mousedy", motion.y);
        input.add("mousewheel", m_window->takeWheel());
        const glm::dvec2 at = m_window->cursor() * (kCanvasHeight / std::max(1, size().y));
        input.place(at.x, at.y);
        return isOpen;
    }
    void captureCursor(bool isCaptured) override { m_window->captureCursor(isCaptured); }
    void present() override { m_window->present(); }
    rubble::Image read() const override { return m_window->readPixels(); }

private:
    std::unique_ptr<rubble::Window> m_window;
};

class MemoryDisplay final : public Display {
public:
    MemoryDisplay(std::unique_ptr<rubble::GlContext> context, glm::ivec2 size) : m_context(std::move(context)) {
        m_target.emplace(size);
    }
    Loader loader() const override { return m_context->loader(); }
    unsigned framebuffer() const override { return m_target->framebuffer(); }
    glm::ivec2 size() const override { return m_target->size(); }
    bool poll(Input&) override { return true; }
    void captureCursor(bool) override {}
    void present() override {}
    rubble::Image read() const override {
        rubble::Image image(m_target->size().x, m_target->size().y);
        image.rgb = m_target->readRgb();
        return image;
    }

private:
    std::unique_ptr<rubble::GlContext> m_context;  // destroyed after what it draws on
    std::optional<rubble::Offscreen> m_target;
};

}  // namespace

std::unique_ptr<Display> Display::openWindow(glm::ivec2 size, std::string& error) {
    auto window = rubble::Window::create(size, "Rubble");
    if (window) return std::make_unique<WindowDisplay>(std::move(*window));
    error = window.error();
    return nullptr;
}

std::unique_ptr<Display> Display::inMemory(glm::ivec2 size, std::string& error) {
    auto context = rubble::GlContext::create();
    if (!context) error = context.error();
    if (!context) return nullptr;
    if (const auto loaded = rubble::loadGl((*context)->loader()); !loaded) {
        error = loaded.error();
        return nullptr;
    }
    return std::make_unique<MemoryDisplay>(std::move(*context), size);
}

}  // namespace sandbox
