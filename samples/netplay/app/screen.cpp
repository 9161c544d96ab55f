#include "samples/netplay/app/screen.h"

#include <stdexcept>
#include <utility>

#include "samples/support/display.h"
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

}  // namespace

bool Screen::hasDisplay() {
    return rubble::Window::hasDisplay();
}

std::unique_ptr<Screen> Screen::openWindow(Size size, const std::string& title) {
    return std::make_unique<Screen>(valueOf(rubble::Display::openWindow({size.width, size.height}, title),
                                            "; without a display run with --frames N"));
}

std::unique_ptr<Screen> Screen::inMemory(Size size) {
    return std::make_unique<Screen>(valueOf(rubble::Display::inMemory({size.width, size.height})));
}

Screen::Screen(std::unique_ptr<rubble::Display> display) : m_display(std::move(display)) {}
Screen::~Screen() = default;

Screen::Loader Screen::loader() const {
    return m_display->loader();
}

unsigned Screen::framebuffer() const {
    return m_display->framebuffer();
}

Size Screen::size() const {
    return {m_display->size().x, m_display->size().y};
}

std::vector<uint8_t> Screen::read() const {
    return m_display->read().rgb;
}

void Screen::setTitle(const std::string& title) {
    if (rubble::Window* window = m_display->window()) window->setTitle(title);
}

void Screen::present() {
    m_display->present();
}

bool Screen::poll() {
    rubble::Window* const window = m_display->window();
    return !window || (window->poll() && !window->pressed(kEscape));
}

rubble::PlayerInput Screen::input() {
    rubble::Window* const window = m_display->window();
    return window ? rubble::readPlayerInput(*window) : rubble::PlayerInput{};
}

bool Screen::isClicking() const {
    const rubble::Window* const window = m_display->window();
    return window && window->mouseHeld();
}

bool Screen::hasPressed(int number) const {
    const rubble::Window* const window = m_display->window();
    return window && window->pressed(kDigitZero + number);
}

void writeImage(const std::string& path, Size size, const std::vector<uint8_t>& rgb) {
    rubble::Image image(size.width, size.height);
    image.rgb = rgb;
    valueOf(rubble::writePng(path, image));
}

}  // namespace netplay
