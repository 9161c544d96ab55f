#pragma once
#include <optional>
#include <string>

#include "render/frame/render_settings.h"
#include "render/gl/context_mark.h"

namespace rubble {

/// Tells whether views can be drawn. Made in the GL context of the renderer. [render-thread]
class ViewCheck {
public:
    /// Why the GL cannot draw this view now; empty: it can. mayAsk: whether the GL may be asked at each draw; if not,
    /// only about framebuffers that are new. A lost context stays lost, even if the GL says so only once.
    std::string error(const View& view, bool mayAsk);
    /// Whether the context was lost: all GL objects are gone.
    bool isLost() const { return m_isLost; }

    /// Whether the context that it was made in is current.
    bool isItsContext() const { return m_mark.isCurrent(); }

private:
    static constexpr int kDrawsPerQuestion = 64;  ///< whether the context is lost, if the GL may not be asked each time

    ContextMark m_mark;
    bool m_isLost = false;
    int m_draws = 0;
    std::optional<unsigned> m_checked;  ///< the last framebuffer that was complete
    bool m_hadDepth = false;            ///< and whether it was seen to have a depth buffer
};

}  // namespace rubble
