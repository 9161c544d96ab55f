#pragma once
#include <optional>
#include <string>

#include "render/frame/render_settings.h"

namespace rubble {

/// Tells whether views can be drawn. [render-thread]
class ViewCheck {
public:
    /// Why the GL cannot draw this view now; empty: it can. mayAsk: whether the GL may be asked at each draw; if not,
    /// only about framebuffers that are new. A lost context stays lost, even if the GL says so only once.
    std::string error(const View& view, bool mayAsk);
    /// Whether the context was lost: all GL objects are gone.
    bool isLost() const { return m_isLost; }

private:
    static constexpr int kDrawsPerQuestion = 64;  ///< whether the context is lost, if the GL may not be asked each time

    bool m_isLost = false;
    int m_draws = 0;
    std::optional<unsigned> m_checked;  ///< the last framebuffer that was complete
    bool m_hadDepth = false;            ///< and whether it was seen to have a depth buffer
};

}  // namespace rubble
