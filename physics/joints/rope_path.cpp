#include "physics/joints/rope_path.h"

#include <algorithm>
#include <glm/geometric.hpp>

// The path of a rope, and how much of it is slack.
//
// The bodies at the ends of a rope are held by the length of its path. Between two steps the path changes for three
// reasons: its ends move, what it lies on moves, and other places of the rope touch. The first two are motion. The last
// is not: the path cuts the corners of voxels at other places, and is a few centimetres longer or shorter, while
// nothing has moved. A rope that took this for a change of length would pull by it. That does work: on a body that
// circles with the speed v at the radius r, m v^2 / r per metre, a winch that nobody pays for. And where the path got
// shorter the rope would go slack, and lose the speed along itself when it becomes taut again.
//
// So the slack goes over from the old bends to the new ones. What both disagree about is made good slowly, and at once
// where the rope has come off something.

namespace rubble {
namespace {

constexpr double kCorrectionSpeed = 0.2;  ///< m/s at which the slack follows what was measured
constexpr double kRelease = 0.1;          ///< metres of slack that do not come from corners: the rope came off

}  // namespace

double pathLength(const std::array<glm::dvec3, 2>& ends, const std::vector<RopeBend>& bends) {
    double length = 0.0;
    glm::dvec3 last = ends[0];
    for (const RopeBend& bend : bends) {
        length += glm::length(bend.position - last);
        last = bend.position;
    }
    return length + glm::length(ends[1] - last);
}

double slackAfter(double slack, double measured, double seconds) {
    const double step = kCorrectionSpeed * seconds;
    if (measured > slack + kRelease) return measured;
    if (measured >= slack) return std::min(slack + step, measured);
    const double taut = std::min(slack, 0.0);  // a longer path makes a rope taut, and no more
    return std::max(measured, measured < taut ? taut - step : measured);
}

}  // namespace rubble
