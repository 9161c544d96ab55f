// Apart from what sees rubble.hpp, whose classes have the names of some that are included here.
#include "samples/netplay/app/screen.h"

#include <stdexcept>

#include "render/gl/gl.h"
#include "render/gl/offscreen.h"
#include "samples/support/gl_context.h"
#include "samples/support/image.h"
#include "samples/support/window.h"

namespace netplay {
namespace {

constexpr int kEscape = 256, kDigitZero = '0';  // GLFW's codes of keys

/// The value of a result; throws its error, and a hint.
template <class T>
T valueOf(rubble::Result<T> result, const char* hint = "") {
    if (!result) throw std::runtime_error(result.error() + hint);
    return std::move(*result);
}

class WindowScreen final : public Screen {
public:
    WindowScreen(Size size, const std::string& title)
        : m_window(valueOf(rubble::Window::create({size.width, size.height}, title),
                           "; without a display run with --frames N")) {}
    Loader loader() const override { return m_window->loader(); }
    unsigned framebuffer() const override { return 0; }
    Size size() const override { return {m_window->size().x, m_window->size().y}; }
    std::vector<uint8_t> read() const override { return m_window->readPixels().rgb; }
    void setTitle(const std::string& title) override { m_window->setTitle(title); }
    void present() override { m_window->present(); }
    bool poll() override { return m_window->poll() && !m_window->pressed(kEscape); }
    rubble::PlayerInput input() override { return rubble::readPlayerInput(*m_window); }
    bool isClicking() const override { return m_window->mouseHeld(); }
    bool hasPressed(int number) const override { return m_window->pressed(kDigitZero + number); }

private:
    std::unique_ptr<rubble::Window> m_window;
};

class MemoryScreen final : public Screen {
public:
    explicit MemoryScreen(Size size) : m_context(valueOf(rubble::GlContext::create())) {
        valueOf(rubble::loadGl(m_context->loader()));
        m_target = std::make_unique<rubble::Offscreen>(glm::ivec2(size.width, size.height));
    }
    Loader loader() const override { return m_context->loader(); }
    unsigned framebuffer() const override { return m_target->framebuffer(); }
    Size size() const override { return {m_target->size().x, m_target->size().y}; }
    std::vector<uint8_t> read() const override { return m_target->readRgb(); }
    void setTitle(const std::string&) override {}
    void present() override {}
    bool poll() override { return true; }
    rubble::PlayerInput input() override { return {}; }
    bool isClicking() const override { return false; }
    bool hasPressed(int) const override { return false; }

private:
    std::unique_ptr<rubble::GlContext> m_context;  // destroyed after what it draws on
    std::unique_ptr<rubble::Offscreen> m_target;
};

}  // namespace

bool Screen::hasDisplay() {
    return rubble::Window::hasDisplay();
}

std::unique_ptr<Screen> Screen::openWindow(Size size, const std::string& title) {
    return std::make_unique<WindowScreen>(size, title);
}

std::unique_ptr<Screen> Screen::inMemory(Size size) {
    return std::make_unique<MemoryScreen>(size);
}

void writeImage(const std::string& path, Size size, const std::vector<uint8_t>& rgb) {
    rubble::Image image(size.width, size.height);
    image.rgb = rgb;
    valueOf(rubble::writePng(path, image));
}

}  // namespace netplay
