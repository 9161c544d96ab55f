#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/solver/contact_solver.h"
#include "tests/physics/baseline/bullet_spin.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/tradeoff/physics.h"

namespace rubble::tradeoff {
namespace {

using namespace known;

constexpr double kMaxError = 10.0;  ///< larger errors are reported as this

/// A method to integrate rotation; `make` takes the principal moments of inertia and the substeps per 1/60 s.
struct Method {
    const char* name;
    SpinStep (*make)(glm::dvec3 inertia, int substeps);
};

SpinStep ours(glm::dvec3 inertia, int substeps, bool conservesMomentum) {
    SolverBody body;
    body.inertia = inertia;
    body.conservesMomentum = conservesMomentum;
    return [body, substeps](glm::dquat& rotation, glm::dvec3& w) mutable {
        body.rotation = rotation;
        body.angularVelocity = rotation * w;
        for (int i = 0; i < substeps; ++i) rotateBody(body, 1.0 / 60.0 / substeps);
        rotation = body.rotation;
        w = glm::conjugate(rotation) * body.angularVelocity;
    };
}

constexpr Method kMethods[] = {
    {"velocity kept", [](glm::dvec3 inertia, int substeps) { return ours(inertia, substeps, false); }},
    {"momentum kept", [](glm::dvec3 inertia, int substeps) { return ours(inertia, substeps, true); }},
    {"Runge-Kutta", rungeKutta},
    {"Bullet's default",
     [](glm::dvec3 inertia, int substeps) { return bulletSpin(BulletGyroscopy::ImplicitInBody, inertia, substeps); }},
    {"Bullet, explicit",
     [](glm::dvec3 inertia, int substeps) { return bulletSpin(BulletGyroscopy::Explicit, inertia, substeps); }},
};

struct Spinner {
    std::string name;
    glm::dvec3 inertia;
    glm::dvec3 axis;  ///< direction of the angular velocity, in principal axes
    bool flips = false;
};

Spinner spinnerOf(const std::string& name, VoxelGrid grid, bool flips) {
    PhysicsScene scene;
    scene.add(std::move(grid), {0, 0, 0}, false);
    scene.load();
    const glm::dvec3 inertia = bodyMass(scene.world, scene.handle(0)).principalInertia;
    if (!flips) return {name, inertia, glm::normalize(glm::dvec3(1, 0.9, 0.3))};
    glm::dvec3 axis(0.01 / 6.0);
    for (int i = 0; i < 3; ++i)
        if ((inertia[i] > inertia[(i + 1) % 3]) != (inertia[i] > inertia[(i + 2) % 3])) axis[i] = 1.0;
    return {name, inertia, glm::normalize(axis), true};
}

/// Nanoseconds of processor time of 1/60 s of rotation.
double costOf(const SpinStep& step, glm::dvec3 w) {
    constexpr int kTurns = 20'000;
    glm::dquat rotation(1, 0, 0, 0);
    return cpuMs([&] {
               for (int i = 0; i < kTurns; ++i) step(rotation, w);
           }) *
           1e6 / kTurns;
}

/// Error of the time of the last flip that both have, in flips.
double flipPhase(const FreeSpin& spin, const FreeSpin& reference) {
    const size_t most = std::min(spin.flips.size(), reference.flips.size()),
                 apart = std::max(spin.flips.size(), reference.flips.size()) - most;
    if (reference.flips.size() < 2) return 0.0;
    const double period = (reference.flips.back() - reference.flips.front()) / double(reference.flips.size() - 1);
    return (most ? std::abs(spin.flips[most - 1] - reference.flips[most - 1]) / period : 0.0) +
           (apart > 1 ? double(apart) : 0.0);
}

double bounded(double error) {
    return error < kMaxError ? std::max(error, 1e-12) : kMaxError;
}

/// Largest errors over all bodies and spins.
struct Worst {
    double momentum = 0.0, energy = 0.0, phase = 0.0;
};

std::vector<Spinner> spinnersOf(const Options& options) {
    std::vector<Spinner> spinners{spinnerOf("rod 1:16", solidGrid({16, 1, 1}, 7), false),
                                  spinnerOf("T-handle", tHandle(), true)};
    if (!options.full) return spinners;
    for (const int length : {4, 64, 256})
        spinners.push_back(spinnerOf(fmt::format("rod 1:{}", length), solidGrid({length, 1, 1}, 7), false));
    spinners.push_back(spinnerOf("plank 24x5x2", solidGrid({24, 5, 2}, 7), false));
    return spinners;
}

/// Measures one method with one number of substeps: a row for each spin, its cost in `costs`. Returns the worst errors.
Worst measureMethod(const Options& options, const Method& method, int substeps, const Spinner& spinner, double speed,
                    double seconds, Table& table, std::vector<double>& costs) {
    const glm::dvec3 w = spinner.axis * speed;
    const SpinStep step = method.make(spinner.inertia, substeps);
    const FreeSpin spin = spinBy(step, spinner.inertia, w, seconds);
    const Measured ns = measure(options.repeats, [&] { return costOf(method.make(spinner.inertia, substeps), w); });
    const double off = spinner.flips ? flipPhase(spin, spinReference(spinner.inertia, w, seconds, 64)) : 0.0;
    costs.push_back(ns.median);
    table.add({method.name, std::to_string(substeps), spinner.name, fmt::format("{:.0f}", speed), ns.text(),
               fmt::format("{:.1e}", bounded(spin.energy)), fmt::format("{:.1e}", bounded(spin.momentum)),
               fmt::format("{:.1e}", bounded(spin.direction)), spinner.flips ? fmt::format("{:.2g}", off) : "-"});
    return {bounded(spin.momentum), bounded(spin.energy), bounded(off)};
}

std::string noteText() {
    return fmt::format(
        "Energy, momentum and direction: the largest departure from the start, as a share; {:.0f} stands for anything "
        "larger. Flips off: error of the time of the T-handle's last flip, in flips, from Runge-Kutta in doubles with "
        "64 substeps.",
        kMaxError);
}

}  // namespace

Table rotationTradeoff(const Options& options) {
    const double seconds = options.full ? 60.0 : 20.0;
    Table table{
        "T2",
        fmt::format(
            "integration of rotation: processor time per body and 1/60 s against what a free body loses in {:.0f} s",
            seconds),
        {"step", "substeps", "body", "spin rad/s", "ns per body", "energy", "momentum", "its direction rad",
         "flips off"},
        {}};
    table.note = noteText();
    const std::vector<Spinner> spinners = spinnersOf(options);
    const std::vector<double> spins =
        options.full ? std::vector<double>{1.0, 10.0, 30.0, 100.0} : std::vector<double>{6.0, 30.0};
    std::vector<Series> energy, momentum, phase;
    Worst kept, bullet;
    for (const Method& method : kMethods) {
        for (auto* plot : {&energy, &momentum, &phase}) plot->push_back({method.name, {}});
        for (const int substeps : {1, 2, 4, 8, 16}) {
            if (!options.full && substeps != 1 && substeps != 4 && substeps != 16) continue;
            Worst worst;
            std::vector<double> costs;
            for (const Spinner& spinner : spinners)
                for (const double speed : spins) {
                    const Worst one = measureMethod(options, method, substeps, spinner, speed, seconds, table, costs);
                    worst.energy = std::max(worst.energy, one.energy);
                    worst.momentum = std::max(worst.momentum, one.momentum);
                    worst.phase = std::max(worst.phase, one.phase);
                }
            const double ns = quantile(costs, 0.5);
            energy.back().points.emplace_back(ns, worst.energy);
            momentum.back().points.emplace_back(ns, worst.momentum);
            phase.back().points.emplace_back(ns, std::max(worst.phase, 1e-6));
            if (substeps == 4 && &method == &kMethods[1]) kept = worst;
            if (substeps == 4 && &method == &kMethods[3]) bullet = worst;
        }
    }
    table.failed = kept.energy > 1e-3 || kept.momentum > 1e-5;
    table.conclusion = fmt::format(
        "Balanced (momentum conserved, 4 substeps) loses at most {:.0e} of the energy and {:.0e} of the momentum, and "
        "its T-handle is {:.2g} flips off; Bullet's default loses {:.0f} % and {:.0f} %.",
        kept.energy, kept.momentum, kept.phase, std::min(100.0, bullet.energy * 100.0),
        std::min(100.0, bullet.momentum * 100.0));
    const std::string cost = "ns per body and 1/60 s";
    writePlot(options, "T2-energy", "Free rotation: cost against worst change of energy", cost, "share of the energy",
              energy);
    writePlot(options, "T2-momentum", "Free rotation: cost against worst change of momentum", cost,
              "share of the momentum", momentum);
    writePlot(options, "T2-flips", "Free rotation: cost against worst error of flips", cost, "flips off", phase);
    return table;
}

}  // namespace rubble::tradeoff
