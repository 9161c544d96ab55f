#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "samples/support/player_input.h"

namespace rubble {
class Display;
}

namespace netplay {

/// In pixels.
struct Size {
    int width = 640, height = 360;
};

/// A rubble::Display for files that see rubble.hpp, whose classes have the names of some that a display includes: a
/// window, or memory where there is no display. [render-thread]
class Screen {
public:
    /// Whether a window can be opened.
    static bool hasDisplay();
    /// Throws std::runtime_error if there is no display, or no OpenGL.
    static std::unique_ptr<Screen> openWindow(Size size, const std::string& title);
    /// Throws std::runtime_error if there is no OpenGL.
    static std::unique_ptr<Screen> inMemory(Size size);
    /// Takes a display over.
    explicit Screen(std::unique_ptr<rubble::Display> display);
    ~Screen();

    using Loader = void* (*)(const char* name);
    /// How GL functions are found by name.
    Loader loader() const;
    /// GL name of what to draw on, for rubble_view.framebuffer.
    unsigned framebuffer() const;
    /// Of the image.
    Size size() const;
    /// Its image: three bytes a pixel, rows from the top.
    std::vector<uint8_t> read() const;
    /// Sets the text of a window's title bar.
    void setTitle(const std::string& title);
    /// Shows what was drawn.
    void present();
    /// Reads what the player does; false: he leaves. In memory there is none.
    bool poll();
    /// How he wants to fly and look since the last poll().
    rubble::PlayerInput input();
    /// Whether he holds the button that uses a tool.
    bool isClicking() const;
    /// Whether he has pressed the key of a number, 1 to 9, since the last poll().
    bool hasPressed(int number) const;

private:
    std::unique_ptr<rubble::Display> m_display;
};

/// Writes an image of Screen::read() as PNG. Throws std::runtime_error if it cannot.
void writeImage(const std::string& path, Size size, const std::vector<uint8_t>& rgb);

}  // namespace netplay
