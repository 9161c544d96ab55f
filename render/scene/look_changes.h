#pragma once
#include <cstdint>
#include <vector>

#include "render/frame/shader_constants.h"
#include "runtime/core/world_box.h"
#include "runtime/frame/frame_snapshot.h"
#include "runtime/voxel/palette.h"

namespace rubble {

class Bodies;

/// What has changed of the look of shapes, of the sky and of the air, where neither voxels nor local lights have. All
/// changes are relative: 0 none, 1 nothing is as it was. [render-thread]
class LookChanges {
public:
    static constexpr size_t kMaxBoxes = shared::kMaxLookChanges;

    /// Where shapes look different.
    struct Box {
        WorldBox box;           ///< from the render origin
        float now = 0.0f;       ///< change since the moment before
        float lately = 0.0f;    ///< the larger one of that and the change in the moment before
        float newShare = 0.0f;  ///< see newShare()
    };

    /// The shape in a slot has another palette from the next moment on.
    void addPalette(uint32_t slot, const Palette& before, const Palette& after);
    /// Sun, sky and air are others from the next moment on.
    void addEnvironment(const Environment& before, const Environment& after);
    /// The world is another one: nothing is left of what was there.
    void replaceAll();
    /// A number that grows with each replaceAll().
    uint64_t replacements() const { return m_replacements; }
    /// Begins the next moment.
    void beginMoment();
    /// Finds the boxes, where the bodies are drawn now: at most kMaxBoxes.
    void findBoxes(const Bodies& bodies);

    /// Of the last findBoxes().
    const std::vector<Box>& boxes() const { return m_boxes; }
    /// Change of the light that comes from sun and sky: in the last `moments`, the largest.
    float lightChange(int moments = 1) const;
    /// Share of this frame in the mean of colours over frames, at the least, everywhere: all of it in the moment of a
    /// large change, then a half, a third and so on.
    float newShare() const;
    /// The same in the mean of the sun's visibility. A turn of the sun by its diameter is a large change.
    float newSunShare() const;

private:
    struct Moment {
        float look = 0.0f, light = 0.0f, sun = 0.0f;
    };
    struct ShapeChange {
        uint32_t slot = 0;
        float change = 0.0f;
        int age = 0;  ///< moments since it
    };
    void addBox(const Box& box);

    uint64_t m_replacements = 0;
    Moment m_next;
    std::vector<Moment> m_moments;  ///< newest first
    std::vector<ShapeChange> m_nextShapes, m_shapes;
    std::vector<Box> m_boxes;
};

}  // namespace rubble
