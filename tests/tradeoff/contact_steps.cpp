#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/physics/baseline/overlap.h"
#include "tests/physics/baseline/voronoi_pit.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/tradeoff/physics.h"

namespace rubble::tradeoff {
namespace {

using namespace known;

constexpr double kFriction = 0.6, kPitSeconds = 2.0, kTowerSeconds = 10.0;
constexpr double kTolerance = 0.05;  ///< relative difference of cost and error that does not count

struct Setting {
    std::string name;  ///< of a preset; "": a point of the grid
    PhysicsSettings settings;
};

/// Errors of a setting; smaller is better, except for towers and mass ratios.
struct Errors {
    double overlap = 0.0, worst = 0.0;  ///< mm, of the pieces in the pit
    int tower = 0;                      ///< cubes of the highest tower that stands awake
    double ratio = 0.0;                 ///< largest ratio of a body's mass to the mass that supports it
    double incline = 0.0;               ///< relative error of the acceleration
};

struct Point {
    Setting setting;
    std::vector<double> us;  ///< per body and 1/60 s, of each run
    Errors errors;
    double cost() const { return quantile(us, 0.5); }
};

/// Processor time of pieces that fall into a pit, in us per body and 1/60 s; fills in their overlap if `errors`.
double fallIntoPit(const Level& level, const PhysicsSettings& settings, Errors* errors) {
    PhysicsScene scene(sleepless(settings));
    scene.level = level;
    scene.load();
    double ms = 0.0;
    for (int i = scene.stepsIn(kPitSeconds); i > 0; --i) {
        ms += cpuMs([&] { scene.physics.step(); });
        scene.world.setPoses(scene.physics.poses());
    }
    if (errors) {
        std::vector<Pose> poses;
        scene.world.bodies().forEach([&](BodyHandle, const Body& body) { poses.push_back(body.pose); });
        const Overlaps overlaps = measureOverlaps(scene.level, poses);
        errors->overlap = overlaps.mean * 1e3, errors->worst = overlaps.worst * 1e3;
    }
    return ms * 1e3 / double(level.bodies.size() - 1) / (kPitSeconds * 60.0);
}

/// The last of the ascending `values` before the first one for which `holds` is false.
template <class T, class Holds>
T lastThatHolds(std::initializer_list<T> values, Holds&& holds) {
    T most{};
    for (const T value : values) {
        if (!holds(value)) break;
        most = value;
    }
    return most;
}

void measureErrors(const PhysicsSettings& settings, Errors& errors) {
    errors.tower = lastThatHolds({3, 5, 8, 12, 16, 20, 25},
                                 [&](int cubes) { return stack(sleepless(settings), cubes, kTowerSeconds).stands(); });
    errors.ratio = lastThatHolds({3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0},
                                 [&](double ratio) { return sink(settings, ratio) < 0.01; });
    const double angle = std::atan(kFriction) + glm::radians(5.0),
                 expected = 9.81 * (std::sin(angle) - kFriction * std::cos(angle));
    errors.incline =
        std::abs(slideDown(settings, glm::degrees(angle), 0.57, kFriction, 2.0).acceleration / expected - 1.0);
}

Setting gridPoint(double hertz, int substeps, int iterations, double stiffness) {
    PhysicsSettings settings;
    settings.stepSeconds = 1.0 / hertz;
    settings.substeps = substeps;
    settings.iterations = iterations;
    settings.contactHertz = stiffness;
    return {"", settings};
}

/// All combinations, or lines through balanced along each axis.
std::vector<Setting> settingsOf(bool full) {
    std::vector<Setting> all;
    for (const Preset& preset : presets()) all.push_back({preset.name, preset.settings});
    for (const double hertz : {30.0, 60.0, 120.0})
        for (const int substeps : {1, 2, 4, 8, 16})
            for (const int iterations : {1, 2, 4})
                for (const double stiffness : {60.0, 240.0}) {
                    if (stiffness > 0.25 * hertz * substeps && stiffness > 60.0)
                        continue;  // stiffness above a quarter of the substep rate has no effect
                    const int turned =
                        int(hertz != 60.0) + int(substeps != 4) + int(iterations != 1) + int(stiffness != 60.0);
                    if (full || turned <= 1) all.push_back(gridPoint(hertz, substeps, iterations, stiffness));
                }
    return all;
}

/// Whether `by` costs less and is at least as good in every error (Pareto dominance). Only a setting with as many steps
/// per second can dominate: a game sees every step.
bool isDominated(const Point& point, const Point& by) {
    const Errors &a = point.errors, &b = by.errors;
    return by.setting.settings.stepSeconds <= 1.001 * point.setting.settings.stepSeconds &&
           by.cost() * (1.0 + kTolerance) < point.cost() && b.overlap <= a.overlap * (1.0 + kTolerance) &&
           b.tower >= a.tower && b.ratio >= a.ratio && b.incline <= std::max(a.incline * (1.0 + kTolerance), 1e-3);
}

std::string describe(const PhysicsSettings& s) {
    return fmt::format("{:.0f} Hz, {} substeps, {} iterations, {:.0f} Hz stiff", 1.0 / s.stepSeconds, s.substeps,
                       s.iterations, s.contactHertz);
}

void plot(const Options& options, const std::vector<Point>& points, const std::string& name, const std::string& title,
          const std::string& yLabel, double (*error)(const Errors&), bool isBetterHigh) {
    Series cloud{"settings", {}, true};
    std::vector<std::pair<double, double>> all;
    std::vector<Series> marks;
    for (const Point& point : points) {
        const std::pair<double, double> at(point.cost(), error(point.errors));
        all.emplace_back(at.first, isBetterHigh ? -at.second : at.second);
        if (point.setting.name.empty())
            cloud.points.push_back(at);
        else
            marks.push_back({point.setting.name, {at}, true, true});
    }
    Series front = paretoFront("the front", all);
    if (isBetterHigh)
        for (auto& [x, y] : front.points) y = -y;
    std::vector<Series> series{cloud, front};
    series.insert(series.end(), marks.begin(), marks.end());
    writePlot(options, name, title, "us per body and 1/60 s", yLabel, series);
}

}  // namespace

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all{
        {"fast", fastPhysics()}, {"balanced", balancedPhysics()}, {"accurate", accuratePhysics()}};
    return all;
}

Table contactTradeoff(const Options& options) {
    const int pieces = options.full ? 216 : 72;
    Table table{"T1",
                fmt::format("contact solver settings: processor time per body and 1/60 s ({} pieces that fall into a "
                            "pit, none asleep) against errors",
                            pieces),
                {"preset", "steps per second", "substeps", "iterations", "contacts Hz", "us per body",
                 "mean overlap mm", "max overlap mm", "cubes that stand", "mass ratio", "incline error %"},
                {}};
    table.note = fmt::format(
        "Overlap: of each overlapping pair, measured from the voxels after {:.0f} s; 0 is right. Cubes: the highest "
        "tower that stands awake after {:.0f} s, of 3, 5, 8, 12, 16, 20, 25. Mass ratio: the heaviest cube that sinks "
        "into a light one by less than 1 cm in 10 s, up to 3000. Incline: acceleration 5 degrees above the angle of "
        "friction, compared with Coulomb's law.",
        kPitSeconds, kTowerSeconds);
    const Level pit = voronoiPit(pieces, options.seed);
    std::vector<Point> points;
    for (const Setting& setting : settingsOf(options.full)) points.push_back({setting, {}, {}});
    for (int i = 0; i < options.repeats; ++i)  // in alternation: other load on the machine affects all alike
        for (Point& point : points)
            point.us.push_back(fallIntoPit(pit, point.setting.settings, i ? nullptr : &point.errors));
    for (Point& point : points) {
        measureErrors(point.setting.settings, point.errors);
        const PhysicsSettings& s = point.setting.settings;
        const Errors& e = point.errors;
        table.add({point.setting.name, fmt::format("{:.0f}", 1.0 / s.stepSeconds), std::to_string(s.substeps),
                   std::to_string(s.iterations), fmt::format("{:.0f}", s.contactHertz), summary(point.us).text(),
                   fmt::format("{:.2f}", e.overlap), fmt::format("{:.1f}", e.worst), std::to_string(e.tower),
                   fmt::format("{:.0f}", e.ratio), fmt::format("{:.3f}", e.incline * 100.0)});
    }
    for (const Point& point : points) {
        if (point.setting.name.empty()) continue;
        const auto better =
            std::find_if(points.begin(), points.end(), [&](const Point& by) { return isDominated(point, by); });
        table.failed |= better != points.end();
        table.conclusion += better == points.end() ? fmt::format("{}: on the front. ", point.setting.name)
                                                   : fmt::format("{}: {} is {:.0f} % cheaper and nowhere worse. ",
                                                                 point.setting.name, describe(better->setting.settings),
                                                                 100.0 * (1.0 - better->cost() / point.cost()));
    }
    plot(
        options, points, "T1-overlap", "Contacts: cost against overlap", "mean overlap, mm",
        [](const Errors& e) { return e.overlap; }, false);
    plot(
        options, points, "T1-tower", "Contacts: cost against the tower that stands awake", "cubes",
        [](const Errors& e) { return double(e.tower); }, true);
    plot(
        options, points, "T1-ratio", "Contacts: cost against heavy on light", "times as heavy",
        [](const Errors& e) { return std::max(e.ratio, 1.0); }, true);
    plot(
        options, points, "T1-incline", "Contacts: cost against Coulomb's incline", "error, %",
        [](const Errors& e) { return std::max(e.incline * 100.0, 1e-4); }, false);
    return table;
}

}  // namespace rubble::tradeoff
