#include "tests/benchmark/pile.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace rubble {

using Clock = std::chrono::steady_clock;

double wallMs(const std::function<void()>& f) {
    const auto start = Clock::now();
    f();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double percentile(std::vector<double> values, size_t percent) {
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, values.size() * percent / 100)];
}
double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}
double median(const std::vector<double>& values) {
    return percentile(values, 50);
}

PhysicsSettings sleepless(PhysicsSettings settings) {
    settings.sleepTime = 1e9;
    return settings;
}

Pile::Pile(const Level& level, const PhysicsSettings& settings, size_t woken) : physics(settings) {
    world.load(level);
    world.applyEdits({});
    physics.load(world);
    FrameChanges nudge;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        handles.push_back(handle);
        if (!body.isStatic && handles.size() <= woken)
            nudge.impulses.push_back({handle, body.pose.position, glm::dvec3(0.0)});
    });
    physics.apply(nudge, world);
}

void Pile::step() {
    physics.step();
    world.setPoses(physics.poses());
}

std::vector<Pose> Pile::poses() const {
    std::vector<Pose> all;
    for (const BodyHandle handle : handles) all.push_back(world.bodies().at(handle).pose);
    return all;
}

std::vector<Pose> posesOf(const BulletCompounds& bullet, const Level& level) {
    std::vector<Pose> poses;
    for (size_t i = 0; i < level.bodies.size(); ++i) poses.push_back(bullet.pose(i));
    return poses;
}

}  // namespace rubble
