#include "runtime/plugin/break_reports.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace rubble {
namespace {

constexpr double kGap = 0.5;  ///< metres between clouds that are heard as one break

void add(const DustCloud& cloud, BreakReport& report) {
    const glm::dvec3 before = report.position;
    report.voxels += cloud.count;
    report.position += (cloud.position - before) * (double(cloud.count) / double(report.voxels));
    report.radius = std::max(report.radius + glm::length(report.position - before),
                             cloud.radius + glm::length(report.position - cloud.position));
}

}  // namespace

void reportBreaks(std::span<const DustCloud> dust, std::vector<BreakReport>& out) {
    out.clear();
    for (const DustCloud& cloud : dust) {
        if (!cloud.count) continue;
        const auto near = std::find_if(out.begin(), out.end(), [&](const BreakReport& report) {
            return report.material == cloud.material &&
                   glm::length(report.position - cloud.position) <= report.radius + cloud.radius + kGap;
        });
        if (near == out.end())
            out.push_back({cloud.material, cloud.count, cloud.position, cloud.radius});
        else
            add(cloud, *near);
    }
}

}  // namespace rubble
