#pragma once
#include <algorithm>
#include <array>
#include <utility>

#include "runtime/world/edits/edit.h"

namespace rubble::scenes {

/// Collects the edits of a script that fall into one step of 1/60 s.
class ScriptClock {
public:
    /// Collects the edits of `step`, which counts from 0.
    explicit ScriptClock(int step) : m_step(step) {}

    /// Whether this is the step at a time in seconds.
    bool at(double seconds) const { return m_step == stepOf(seconds); }
    /// Index of the first edit of this step, of `count` edits that are spread evenly over [from, to) seconds.
    int first(double from, int count, double to) const { return share(m_step, from, count, to); }
    /// Index after the last one. A step without any of these edits has first() == last().
    int last(double from, int count, double to) const { return share(m_step + 1, from, count, to); }

    /// Adds an edit to this step.
    void add(Edit edit) { m_edits.push_back(std::move(edit)); }
    /// The edits of this step; the clock is empty afterwards.
    Edits take() { return std::move(m_edits); }

private:
    static int stepOf(double seconds) { return int(seconds * 60.0 + 0.5); }
    static int share(int step, double from, int count, double to) {
        const int low = stepOf(from), steps = std::max(stepOf(to) - low, 1);
        return std::clamp((step - low) * count / steps, 0, count);
    }
    int m_step;
    Edits m_edits;
};

/// A carve of a sphere; `radii` in metres for soft, medium and hard materials.
inline CarveEdit carveSphere(glm::dvec3 position, std::array<double, 3> radii) {
    CarveEdit edit;
    edit.position = position;
    edit.radii = radii;
    return edit;
}

/// A carve of a capsule between two points; `radii` as in carveSphere().
inline CarveEdit carveCapsule(glm::dvec3 from, glm::dvec3 to, std::array<double, 3> radii) {
    CarveEdit edit = carveSphere(from, radii);
    edit.kind = BrushKind::Capsule;
    edit.end = to;
    return edit;
}

}  // namespace rubble::scenes
