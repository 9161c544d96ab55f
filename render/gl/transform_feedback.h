#pragma once
#include "render/gl/gl.h"

namespace rubble {

/// A host's transform feedback that is going on. While it is, no program can be used but its own, and whatever is drawn
/// is captured. It can be paused only with GL 4.0 or ARB_transform_feedback2: elsewhere it must have ended.
struct TransformFeedback {
    bool isActive = false;  ///< and not paused by the host itself

    /// As the GL has it.
    static TransformFeedback current();
    /// Pauses it, if it is active, for draws of others.
    void pause() const;
    /// Goes on with it, if it was active. Its program must be in use, and its object bound, as they were.
    void resume() const;
};

}  // namespace rubble
