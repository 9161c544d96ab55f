#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "physics/physics_world.h"
#include "tests/tradeoff/report.h"

/// The physics tables of the trade-off report. Each function returns its table and writes its plots to options.out.
namespace rubble::tradeoff {

struct Preset {
    const char* name;
    PhysicsSettings settings;
};
/// The presets fast, balanced and accurate.
const std::vector<Preset>& presets();

/// Step length, substeps, iterations and stiffness: us per body against overlap, towers, mass ratio and incline.
Table contactTradeoff(const Options& options);
/// Substeps of ours and of Bullet's: ms per step of pieces in a pit against their penetration depth.
Table penetrationTradeoff(const Options& options);
/// Integration of rotation: ns per body against energy, angular momentum and the flips of a T-handle.
Table rotationTradeoff(const Options& options);
/// Collision by a box, merged boxes or every voxel: us per pair, build time and bytes against overlap and rest pose.
Table collisionTradeoff(const Options& options);

/// Positions in doubles and floats: error of the end position, by distance from the origin.
Table coordinateTradeoff(const Options& options);
/// Each feature of physics always on, by rule and off: instructions against accuracy.
Table physicsFeatureTradeoff(const Options& options);
/// Cost of features that a scene does not use, as a share of a step.
Table unusedFeatureTradeoff(const Options& options);
/// Runs the scene of unusedFeatureTradeoff(), for valgrind to count.
void runWithoutFeatures();
/// Runs a scene of these tables with one of its settings, for valgrind to count; false if there is no such setting.
bool runFeatureScene(const std::string& setting);
/// The maps by name: two parameters are increased until physics fails.
std::vector<std::pair<std::string, std::function<Table(const Options&)>>> physicsMaps();
/// The physics part of OPERATING_ENVELOPE.md, as Markdown: results of the maps, and limits that are clamped. `before`:
/// the part as it was, whose other maps are kept, each with the machine on which it was measured.
std::string operatingEnvelope(const std::vector<Table>& maps, const std::string& before);

}  // namespace rubble::tradeoff
