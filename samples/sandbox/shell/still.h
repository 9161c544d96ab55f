#pragma once
#include <rubble/rubble.h>

#include <memory>
#include <string>

#include "samples/support/display.h"

namespace sandbox {

/// An image of another size than the window's, which is drawn beside it, one draw a frame, until its light has settled.
/// What it takes of the GPU is free again after it: the renderer's part within 64 draws.
class Still {
public:
    /// An error where there is no room for it.
    static rubble::Result<std::unique_ptr<Still>> begin(rubble::Display& display, std::string path, glm::ivec2 size);
    /// Draws it once more, from where a view looks; the last time it is written. What is wrong, or "".
    std::string draw(const rubble_api& api, rubble_renderer renderer, rubble_view view);
    /// How far it is, 0 to 1; 1: it was written.
    double progress() const;

private:
    Still(std::unique_ptr<rubble::Display> target, std::string path)
        : m_target(std::move(target)), m_path(std::move(path)) {}
    std::unique_ptr<rubble::Display> m_target;
    std::string m_path;
    int m_draws = 0;
};

}  // namespace sandbox
