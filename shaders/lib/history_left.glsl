// How much history is left to the places that the previous frame shows, as passes/history_left.frag has found: shares
// of uMaxHistory frames, 1 where nothing is known to have changed. (Set by render/passes/history_left_pass.cpp.)
#include "lib/change_rays.glsl"

uniform sampler2D uHistoryLeft;
uniform bool uHasHistoryLeft;  // false: nothing has changed
uniform float uMaxHistory;     // frames

struct HistoryLeft {
    float now;     // after the changes since the previous frame
    float lately;  // after those and after lights that changed in the frame before
    float counts;  // share by which the previous frame's light counts as light of this one
    int rays;      // to send in this frame
    bool sunChanged;
};

/// pixel: of the previous frame.
HistoryLeft historyLeftOf(ivec2 pixel) {
    vec4 left = uHasHistoryLeft ? texelFetch(uHistoryLeft, pixel, 0) : vec4(1.0, 1.0, 1.0, 0.0);
    int flags = int(left.w * 3.0 + 0.5);
    return HistoryLeft(left.x, left.y, left.z, (flags & 2) != 0 ? kRaysAfterChange : 1, (flags & 1) != 0);
}
