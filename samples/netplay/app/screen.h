#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "samples/support/player_input.h"

namespace netplay {

/// In pixels.
struct Size {
    int width = 640, height = 360;
};

/// What is drawn on: a window, or memory where there is no display. It has a GL context, current from its making on;
/// there is one of them in a program at a time. [render-thread]
class Screen {
public:
    /// Whether a window can be opened.
    static bool hasDisplay();
    /// Throws std::runtime_error if there is no display, or no OpenGL.
    static std::unique_ptr<Screen> openWindow(Size size, const std::string& title);
    /// Throws std::runtime_error if there is no OpenGL.
    static std::unique_ptr<Screen> inMemory(Size size);
    virtual ~Screen() = default;

    using Loader = void* (*)(const char* name);
    /// How GL functions are found by name.
    virtual Loader loader() const = 0;
    /// GL name of what to draw on, for rubble_view.framebuffer.
    virtual unsigned framebuffer() const = 0;
    /// Of the image.
    virtual Size size() const = 0;
    /// Its image: three bytes a pixel, rows from the top.
    virtual std::vector<uint8_t> read() const = 0;
    /// Sets the text of a window's title bar.
    virtual void setTitle(const std::string& title) = 0;
    /// Shows what was drawn.
    virtual void present() = 0;
    /// Reads what the player does; false: he leaves.
    virtual bool poll() = 0;
    /// How he wants to fly and look since the last poll().
    virtual rubble::PlayerInput input() = 0;
    /// Whether he holds the button that uses a tool.
    virtual bool isClicking() const = 0;
    /// Whether he has pressed the key of a number, 1 to 9, since the last poll().
    virtual bool hasPressed(int number) const = 0;
};

/// Writes an image of Screen::read() as PNG. Throws std::runtime_error if it cannot.
void writeImage(const std::string& path, Size size, const std::vector<uint8_t>& rgb);

}  // namespace netplay
