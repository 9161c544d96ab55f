#include "samples/support/display.h"

#include <utility>

#include "render/gl/gl.h"
#include "render/gl/offscreen.h"
#include "samples/support/gl_context.h"
#include "samples/support/window.h"

namespace rubble {
namespace {

class WindowDisplay final : public Display {
public:
    explicit WindowDisplay(std::unique_ptr<Window> window) : m_window(std::move(window)) {}
    Loader loader() const override { return m_window->loader(); }
    unsigned framebuffer() const override { return 0; }
    glm::ivec2 size() const override { return m_window->size(); }
    Window* window() override { return m_window.get(); }
    void present() override { m_window->present(); }
    Image read() const override { return m_window->readPixels(); }

private:
    std::unique_ptr<Window> m_window;
};

class MemoryDisplay final : public Display {
public:
    MemoryDisplay(std::unique_ptr<GlContext> context, Loader find, glm::ivec2 size)
        : m_context(std::move(context)), m_loader(find), m_target(size) {}
    Loader loader() const override { return m_loader; }
    unsigned framebuffer() const override { return m_target.framebuffer(); }
    glm::ivec2 size() const override { return m_target.size(); }
    Window* window() override { return nullptr; }
    void present() override {}
    Image read() const override {
        Image image(m_target.size().x, m_target.size().y);
        image.rgb = m_target.readRgb();
        return image;
    }

private:
    std::unique_ptr<GlContext> m_context;  // destroyed after what it draws on; null: it is another's
    Loader m_loader;
    Offscreen m_target;
};

}  // namespace

Result<std::unique_ptr<Display>> Display::openWindow(glm::ivec2 size, const std::string& title) {
    auto window = Window::create(size, title);
    if (!window) return Error{window.error()};
    return std::unique_ptr<Display>(std::make_unique<WindowDisplay>(std::move(*window)));
}

Result<std::unique_ptr<Display>> Display::inMemory(glm::ivec2 size) {
    auto context = GlContext::create();
    if (!context) return Error{context.error()};
    const Loader loader = (*context)->loader();
    if (const auto loaded = loadGl(loader); !loaded) return Error{loaded.error()};
    return std::unique_ptr<Display>(std::make_unique<MemoryDisplay>(std::move(*context), loader, size));
}

Result<std::unique_ptr<Display>> Display::memoryBeside(glm::ivec2 size) const {
    if (const auto loaded = loadGl(loader()); !loaded) return Error{loaded.error()};
    return std::unique_ptr<Display>(std::make_unique<MemoryDisplay>(nullptr, loader(), size));
}

}  // namespace rubble
