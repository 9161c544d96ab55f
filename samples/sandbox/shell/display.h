#pragma once
#include <glm/vec2.hpp>
#include <memory>
#include <string>

#include "samples/sandbox/shell/input.h"
#include "samples/support/image.h"

namespace sandbox {

/// What is drawn on, with a GL context that is current from its making on: a window, or memory where there is no
/// display.
class Display {
public:
    /// Null, and what is wrong, if there is no display or no OpenGL.
    static std::unique_ptr<Display> openWindow(glm::ivec2 size, std::string& error);
    /// The same in memory.
    static std::unique_ptr<Display> inMemory(glm::ivec2 size, std::string& error);
    virtual ~Display() = default;

    using Loader = void* (*)(const char* name);
    /// How GL functions are found by name.
    virtual Loader loader() const = 0;
    /// GL name of what to draw on.
    virtual unsigned framebuffer() const = 0;
    /// In pixels.
    virtual glm::ivec2 size() const = 0;
    /// Reads what the player does; false: the window was closed.
    virtual bool poll(Input& input) = 0;
    /// A captured cursor turns the view; a free one points at menus.
    virtual void captureCursor(bool isCaptured) = 0;
    /// Shows what was drawn.
    virtual void present() = 0;
    /// What was drawn.
    virtual rubble::Image read() const = 0;
};

}  // namespace sandbox
