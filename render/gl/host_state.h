#pragma once

namespace rubble {

/// What becomes of the host's GL state when the renderer draws.
enum class HostState {
    /// It is as before. To know it the renderer asks the GL some 170 questions a draw, all at its start, so that a
    /// driver that works on a thread of its own must catch up once.
    Restored,
    /// What the renderer changes gets the values of a new context, but for viewport and scissor. Nothing is asked, so
    /// transform feedback must be paused or have ended. For hosts that set what they need, or whose cache of GL state
    /// can be emptied.
    Reset,
};

}  // namespace rubble
