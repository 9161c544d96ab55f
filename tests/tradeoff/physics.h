#pragma once
#include "physics/physics_world.h"
#include "tests/tradeoff/report.h"

/// The physics rows of the trade-off report. Each makes its tables, and writes its plots on the way.
namespace rubble::tradeoff {

struct Preset {
    const char* name;
    PhysicsSettings settings;
};
const std::vector<Preset>& presets();

/// Length of a step, substeps, iterations, stiffness: us a body against penetration, towers, mass ratio and incline.
Table contactTradeoff(const Options& options);
/// Substeps of ours and of Bullet's: ms a step of pieces in a pit against how deep they overlap.
Table penetrationTradeoff(const Options& options);
/// How rotation is stepped: ns a body against energy, angular momentum and when a T-handle flips.
Table rotationTradeoff(const Options& options);
/// A box, merged boxes, every voxel: us a pair, build, bytes against overlap and where things come to rest.
Table collisionTradeoff(const Options& options);

/// Doubles and floats: how far off pieces end, by how far from the origin they fell.
Table coordinateTradeoff(const Options& options);
/// Each feature of physics always on, by rule, and off: instructions, and the accuracy that they buy.
Table physicsFeatureTradeoff(const Options& options);
/// What the stages of features cost that nothing uses, as a share of a step; and a run of that scene.
Table unusedFeatureTradeoff(const Options& options);
void runWithoutFeatures();
/// Runs a scene of these tables with one of its settings, for valgrind to count; false: there is no such.
bool runFeatureScene(const std::string& setting);
/// Pushed until they fail, in two dimensions; by name.
std::vector<std::pair<std::string, std::function<Table(const Options&)>>> physicsMaps();
/// The operating envelope as Markdown: what the maps found, and what is clamped.
std::string operatingEnvelope(const Options& options, const std::vector<Table>& maps);

}  // namespace rubble::tradeoff
