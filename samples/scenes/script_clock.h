#pragma once
#include <algorithm>
#include <utility>

#include "runtime/world/edits/edit.h"

namespace rubble::scenes {

/// Which edits of a script fall into one step of 1/60 s.
class ScriptClock {
public:
    explicit ScriptClock(int step) : m_step(step) {}

    /// Is this the step of that second?
    bool at(double seconds) const { return m_step == stepOf(seconds); }
    /// Of `count` things spread evenly over [from, to): those of this step are first .. last - 1.
    int first(double from, int count, double to) const { return share(m_step, from, count, to); }
    int last(double from, int count, double to) const { return share(m_step + 1, from, count, to); }

    void add(Edit edit) { m_edits.push_back(std::move(edit)); }
    void spread(double from, double to, const Edits& edits) {
        for (int i = first(from, int(edits.size()), to); i < last(from, int(edits.size()), to); ++i)
            add(edits[size_t(i)]);
    }
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

inline CarveEdit carveSphere(glm::dvec3 position, std::array<double, 3> radii) {
    CarveEdit edit;
    edit.position = position;
    edit.radii = radii;
    return edit;
}

inline CarveEdit carveCapsule(glm::dvec3 from, glm::dvec3 to, std::array<double, 3> radii) {
    CarveEdit edit = carveSphere(from, radii);
    edit.kind = BrushKind::Capsule;
    edit.end = to;
    return edit;
}

}  // namespace rubble::scenes
