#include "samples/sandbox/figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace rubble {
namespace {

struct Quantiles {
    double p50 = 0, p95 = 0, p99 = 0, max = 0;
};

Quantiles quantilesOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto at = [&](double q) { return values[std::min(values.size() - 1, size_t(q * double(values.size())))]; };
    return {at(0.50), at(0.95), at(0.99), values.back()};
}

}  // namespace

std::vector<double>& Figures::series(const std::string& name) {
    for (Series& s : m_series)
        if (s.name == name) return s.values;
    return m_series.emplace_back(Series{name, {}}).values;
}

void Figures::addStep(FrameLoop& loop, uint64_t allocations) {
    const FrameChanges& changes = loop.changes();
    for (const Stage stage :
         {Stage::ApplyEdits, Stage::Physics, Stage::Poses, Stage::Impacts, Stage::Shadow, Stage::Publish})
        series(fmt::format("step: {} ms", kStageNames[size_t(stage)])).push_back(loop.times()[stage]);
    const PhysicsStats physics = loop.physics()->stats();
    series("bodies").push_back(double(loop.world().bodies().size()));
    series("bodies awake").push_back(physics.awake);
    if (loop.shadow()) series("shadow age, steps").push_back(double(loop.shadow()->lag()));
    series("allocations per step").push_back(double(allocations));
    for (const RemovedVoxels& removed : changes.removed) m_removed += removed.count;
    for (const ShapeSplit& split : changes.splits) m_pieces += split.children.size();
    m_splits += changes.splits.size();
    m_painted += changes.paintedVoxels;
    m_groupsOut += changes.groupsOut.size();
    m_hashes.push_back(loop.world().hash());
    m_accounting = voxelAccounting(loop.world());
}

void Figures::addFrame(const FrameLoop& loop, const Renderer& renderer) {
    const RenderStats& stats = renderer.stats();
    series("frame: apply ms").push_back(loop.times()[Stage::Apply]);
    series("frame: draw ms").push_back(loop.times()[Stage::Draw]);
    for (const auto& [name, ms] : stats.passMs) series(fmt::format("pass: {} ms", name)).push_back(ms);
    series("draw calls").push_back(stats.drawCalls);
    series("draw calls for bodies").push_back(stats.bodyDraws);
    series("bytes uploaded").push_back(double(stats.uploadBytes));
    series("texture bytes").push_back(double(stats.textureBytes));
    series("shapes drawn").push_back(stats.shapes);
    series("compute programs").push_back(stats.computePrograms);
    m_computePasses.assign(stats.computePasses.begin(), stats.computePasses.end());
}

std::string Figures::table() const {
    std::string out = fmt::format("{:<28}{:>14}{:>14}{:>14}{:>14}\n", "figure", "p50", "p95", "p99", "max");
    for (const Series& s : m_series) {
        const Quantiles q = quantilesOf(s.values);
        const auto line = s.name.ends_with("ms") ? "{:<28}{:>14.3f}{:>14.3f}{:>14.3f}{:>14.3f}\n"
                                                 : "{:<28}{:>14.0f}{:>14.0f}{:>14.0f}{:>14.0f}\n";
        out += fmt::format(fmt::runtime(line), s.name, q.p50, q.p95, q.p99, q.max);
    }
    out += fmt::format("passes drawn by compute: {}\n",
                       m_computePasses.empty() ? "none" : fmt::format("{}", fmt::join(m_computePasses, ", ")));
    out += fmt::format("voxels removed {}, painted {}; splits {}, pieces {}; light groups out {}\n", m_removed,
                       m_painted, m_splits, m_pieces, m_groupsOut);
    out += fmt::format("voxels: imported {} = standing {} + in pieces {} + removed {}: {}\n", m_accounting.imported,
                       m_accounting.standing, m_accounting.inPieces, m_accounting.removed,
                       m_accounting.balances() ? "balances" : "DOES NOT BALANCE");
    if (!m_hashes.empty()) out += fmt::format("state hash after {} steps: {:016x}\n", m_hashes.size(), m_hashes.back());
    return out;
}

bool Figures::writeJson(const std::string& path) const {
    nlohmann::ordered_json json;
    for (const Series& s : m_series) {
        const Quantiles q = quantilesOf(s.values);
        json["series"][s.name] = {{"p50", q.p50}, {"p95", q.p95}, {"p99", q.p99}, {"max", q.max}, {"values", s.values}};
    }
    json["compute_passes"] = m_computePasses;
    json["voxels_removed"] = m_removed;
    json["voxels_painted"] = m_painted;
    json["splits"] = m_splits;
    json["pieces"] = m_pieces;
    json["groups_out"] = m_groupsOut;
    json["voxels"] = {{"imported", m_accounting.imported},
                      {"standing", m_accounting.standing},
                      {"in_pieces", m_accounting.inPieces},
                      {"removed", m_accounting.removed}};
    for (const uint64_t hash : m_hashes) json["state_hash"].push_back(fmt::format("{:016x}", hash));
    std::ofstream file(path);
    file << json.dump(1) << "\n";
    return bool(file.flush());
}

}  // namespace rubble
