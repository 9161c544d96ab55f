#pragma once
#include <glm/vec2.hpp>
#include <memory>
#include <string>

#include "runtime/core/result.h"
#include "samples/support/image.h"

namespace rubble {

class Window;

/// What is drawn on, with a GL context that is current from its making on: a window, or memory where there is no
/// display. There is one of them in a program at a time. [render-thread]
class Display {
public:
    /// An error without a display, or without OpenGL.
    static Result<std::unique_ptr<Display>> openWindow(glm::ivec2 size, const std::string& title);
    /// An error without OpenGL.
    static Result<std::unique_ptr<Display>> inMemory(glm::ivec2 size);
    virtual ~Display() = default;

    using Loader = void* (*)(const char* name);
    /// How GL functions are found by name, for rubble_host.gl_get_proc_address.
    virtual Loader loader() const = 0;
    /// GL name of what to draw on, for rubble_view.framebuffer.
    virtual unsigned framebuffer() const = 0;
    /// In pixels.
    virtual glm::ivec2 size() const = 0;
    /// Memory of another size, in the same context, which ends before this. An error where there is no room for it.
    Result<std::unique_ptr<Display>> memoryBeside(glm::ivec2 size) const;
    /// Its window; null: it is memory.
    virtual Window* window() = 0;
    /// Shows what was drawn.
    virtual void present() = 0;
    /// What was drawn.
    virtual Image read() const = 0;
};

}  // namespace rubble
