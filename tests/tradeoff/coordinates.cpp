#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/physics/baseline/bullet_compounds.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/tradeoff/physics.h"

namespace rubble::tradeoff {
namespace {

constexpr double kKilometres[] = {0.0, 1.0, 10.0, 65.0, 100.0, 1000.0};
constexpr double kMaxErrorMm = 1.0;  ///< at 10 km

glm::dvec3 at(double kilometres) {
    return {kilometres * 1e3, 0.0, kilometres * 1e3 * 0.625};
}

/// The same with stock Bullet, whose positions are floats.
std::vector<glm::dvec3> tumbleInBullet(glm::dvec3 middle) {
    const Level level = known::tumblingLevel(middle);
    BulletCompounds bullet(level, {});
    for (int i = 0; i < 240; ++i) bullet.step();
    std::vector<glm::dvec3> places;
    for (size_t i = 1; i < level.bodies.size(); ++i) {
        const LevelShape& shape = level.bodies[i].shapes[0];
        const glm::dvec3 center =
            massProperties(gridMoments(shape.grid, *shape.palette, level.materials), shape.voxelSize).center;
        places.push_back(bullet.pose(i).transformPoint(center) - middle);
    }
    return places;
}

double farthest(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
    double most = 0.0;
    for (size_t i = 0; i < a.size(); ++i) most = std::max(most, glm::length(a[i] - b[i]));
    return std::isfinite(most) ? most * 1e3 : 1e9;
}

}  // namespace

Table coordinateTradeoff(const Options& options) {
    Table table{
        "T10-coordinates",
        "positions in doubles and in floats: end positions of six pieces after 4 s, compared with the same at the "
        "origin",
        {"km from the origin", "a float's step mm", "bytes per position", "Rubble (doubles) mm", "Bullet (floats) mm"},
        {}};
    table.note =
        "Bytes per position: 24 in doubles, 12 in floats. Chaos turns a rounding error into metres: the columns say "
        "whether the outcome is the same, not how large the rounding error was.";
    const std::vector<glm::dvec3> ours = known::tumble({}, at(0.0)), bullet = tumbleInBullet(at(0.0));
    Series inDoubles{"Rubble, doubles", {}}, inFloats{"Bullet, floats", {}}, step{"a float's step", {}};
    double atTen = 0.0, worst = 0.0;
    for (const double km : kKilometres) {
        const double spacing = double(std::nextafter(float(km * 1e3), 1e30f) - float(km * 1e3)) * 1e3;
        const double oursOff = farthest(known::tumble({}, at(km)), ours),
                     bulletOff = farthest(tumbleInBullet(at(km)), bullet);
        table.add({fmt::format("{:.0f}", km), fmt::format("{:.2g}", spacing), "24 or 12",
                   fmt::format("{:.2g}", oursOff), fmt::format("{:.2g}", bulletOff)});
        if (km == 10.0) atTen = oursOff;
        worst = std::max(worst, oursOff);
        if (km == 0.0) continue;
        inDoubles.points.emplace_back(km, std::max(oursOff, 1e-6));
        inFloats.points.emplace_back(km, std::max(bulletOff, 1e-6));
        step.points.emplace_back(km, spacing);
    }
    table.failed = atTen > kMaxErrorMm;
    table.conclusion = fmt::format(
        "At 10 km pieces end within {:.2g} mm of where they end at the origin; up to 1000 km, within {:.2g} mm.", atTen,
        worst);
    writePlot(options, "T10-coordinates", "Positions: error of the end position, by distance from the origin", "km",
              "mm", {inDoubles, inFloats, step});
    return table;
}

}  // namespace rubble::tradeoff
