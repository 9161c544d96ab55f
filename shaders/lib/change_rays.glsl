// Rays where something is known to have changed. History is dropped there (lib/known_changes.glsl), and one ray a pixel
// would be too noisy. So such a pixel gets kRaysAfterChange rays in the frame of the change and in the next one. A
// frame of n rays counts as n frames of history. That also tells how far a pixel is:
//   long history, now dropped and not in the last frame   the first such frame
//   kRaysAfterChange frames or more, dropped last frame   the second one
// What changes in each frame has neither, so that an explosion does not pay for rays which the next frame drops. A
// history that was made that of the lights of now (passes/changed_lights.frag) stays long, but counts as dropped here.
// passes/history_left.frag decides it, for all passes alike. Needs lib/constants.glsl.
uniform sampler2D uLastConfidence;  // the previous frame's history confidence
uniform bool uLastConfidenceValid;

const int kRaysAfterChange = 3;
const float kDropped = 0.09;       // share of the longest history below which history counts as dropped
const float kSettledFrames = 8.0;  // from which on history counts as long

/// Whether history was dropped by knowledge in the previous frame. lastUv: the place in that frame.
bool wasDropped(vec2 lastUv) { return uLastConfidenceValid && texture(uLastConfidence, lastUv).y < kDropped; }

/// Share by which the previous frame's light of a place counts as light of this one, if so many frames of history
/// are left. It brings its whole error with it, which no later frame averages out: ten must be left for it to count in
/// full.
float countsOfPreviousFrame(float framesLeft) { return min(framesLeft * 0.1, 1.0); }

/// Rays of a pixel in this frame. lastFrames: of history in the previous frame; left, leftLately: the share of the
/// longest history that is left after the changes since the previous frame, and after those and the ones before, as if
/// no history were made that of the lights of now.
int raysAt(float lastFrames, float left, float leftLately, vec2 lastUv) {
    bool isLong = lastFrames >= kSettledFrames, isRepeated = wasDropped(lastUv);
    bool isFirst = isLong && left < kDropped && !isRepeated;
    bool hasBegun = isLong ? left >= kDropped && leftLately < kDropped : lastFrames >= float(kRaysAfterChange);
    bool isSecond = isRepeated && hasBegun;
    return isFirst || isSecond ? kRaysAfterChange : 1;
}
