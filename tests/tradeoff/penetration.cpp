#include <fmt/format.h>

#include <algorithm>

#include "tests/physics/scenes/penetration_sweep.h"
#include "tests/tradeoff/physics.h"

namespace rubble::tradeoff {

Table penetrationTradeoff(const Options& options) {
    const int pieces = options.full ? 1000 : 150, steps = options.full ? 480 : 300;
    Table table{"T1-penetration",
                fmt::format("speed against penetration depth: {} Voronoi pieces in a pit after {} steps, none asleep",
                            pieces, steps),
                {"engine", "substeps", "iterations", "ms per step", "pairs that overlap", "mean mm", "median mm",
                 "max voxels", "height m"},
                {}};
    table.note =
        "Ms: processor time of one thread, mean of the last quarter of the steps. Overlap is measured from the voxels "
        "of each pair, in the same way for both engines. Bullet: compounds of merged boxes, two friction directions.";
    Series rubble{"Rubble", {}}, bullet{"Bullet", {}};
    for (const known::PenetrationPoint& point : known::sweepPenetration(pieces, steps)) {
        const Overlaps& o = point.overlaps;
        table.add({point.engine, std::to_string(point.substeps), std::to_string(point.iterations),
                   fmt::format("{:.2f}", point.stepMs), std::to_string(o.pairs), fmt::format("{:.2f}", o.mean * 1e3),
                   fmt::format("{:.2f}", o.median * 1e3), fmt::format("{:.3f}", o.worst * 10.0),
                   fmt::format("{:.3f}", o.middle)});
        (point.engine == "bullet" ? bullet : rubble).points.emplace_back(point.stepMs, o.mean * 1e3);
    }
    std::sort(bullet.points.begin(), bullet.points.end());
    writePlot(options, table.name, "Speed against penetration depth", "ms per step", "mean overlap, mm",
              {rubble, bullet});
    return table;
}

}  // namespace rubble::tradeoff
