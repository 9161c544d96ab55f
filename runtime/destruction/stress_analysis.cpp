#include "runtime/destruction/stress_analysis.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "runtime/core/hash.h"
#include "runtime/core/random.h"
#include "runtime/destruction/internal_forces.h"

namespace rubble {
namespace {

constexpr uint32_t kNone = ~0u;
constexpr double kShearRatio = 0.4;  ///< shear modulus over Young's modulus
constexpr double kTolerance = 1e-6;  ///< of the energy of the error: forces to about a thousandth
constexpr int kMaxIterations = 400;  ///< beyond which it is given up: nothing breaks
constexpr double kSimultaneousRatio =
    0.9;  ///< utilization of the worst overload from which others break in the same step
constexpr double kMinOwnUtilization =
    0.8;  ///< stress over strength that a section must have ownUtilization too: a window may see tension beside a press
constexpr double kMinSlicedUtilization =
    0.2;  ///< of a bond, from which the layers of its nodes and those around are looked at
constexpr int kMaxImpactRounds = 24;
constexpr int kWindowRadius = StressedSections::kWindowRadius;
constexpr int kMinCrackSpacing = 8;  ///< cells between two sections, one behind the other, that break in the same step
constexpr int64_t kBrickWork = 450, kRowWork = 350;

/// What a unit of motion across a bond does to it, with E = 1: forces, and moments as rows of a symmetric matrix.
struct BondStiffness {
    glm::dvec3 force;
    double moment[3][3] = {};
};

BondStiffness bondStiffness(const StressBond& bond) {
    const int a = bond.section.axis, u = a == 0 ? 1 : 0, v = a == 2 ? 1 : 2;
    const double perLength = 1.0 / bond.length;
    BondStiffness out{glm::dvec3(kShearRatio * bond.shape.area * perLength), {}};
    out.force[a] = bond.shape.area * perLength;
    out.moment[a][a] = kShearRatio * (bond.shape.uu + bond.shape.vv) * perLength;
    out.moment[v][v] = bond.shape.uu * perLength;  // about v, the lever is along u
    out.moment[u][u] = bond.shape.vv * perLength;
    out.moment[u][v] = out.moment[v][u] = -bond.shape.uv * perLength;
    return out;
}

/// Stiffness between the motions of two bodies whose section is at `armA` and `armB` from them.
Block6 stiffnessBlock(const BondStiffness& bond, glm::dvec3 armA, glm::dvec3 armB) {
    Block6 middle;
    for (size_t i = 0; i < 3; ++i) {
        middle.at(i, i) = bond.force[int(i)];
        for (size_t j = 0; j < 3; ++j) middle.at(3 + i, 3 + j) = bond.moment[i][j];
    }
    Block6 right, out;
    addProduct(right, middle, rigidBlock(armB));
    addProduct(out, transposed(rigidBlock(armA)), right);
    return out;
}

bool holds(const StressNode& node, glm::ivec3 cell) {
    return cell >> 3 == node.brick && (node.cells[size_t(cell.z & 7)] >> ((cell.x & 7) + 8 * (cell.y & 7)) & 1);
}

glm::dvec3 displacementAt(const StressNode& node, glm::dvec3 point) {
    return node.translation + glm::cross(node.rotation, point - node.center);
}

}  // namespace

void StressAnalysis::markChanged(std::span<const glm::ivec3> bricks) {
    if (bricks.empty()) return;
    m_changed.insert(m_changed.end(), bricks.begin(), bricks.end());
    m_isRestartRequested = true;
}

void StressAnalysis::applyImpact(const ImpactForce& impact) {
    m_pendingImpacts.push_back(impact);
    m_isRestartRequested = true;
}

int64_t StressAnalysis::stepWork() const {
    const auto solverWork = [&] {
        return (m_inverse.applyWork() + int64_t(m_inverse.stiffness().block.size() + 2 * m_nodeOf.size())) * 3 / 4;
    };
    switch (m_phase) {
        case Phase::Start:  // it has to fetch what an iteration finds in the cache
            return 2 * solverWork();
        case Phase::Iterate:
            return solverWork();
        default:
            return 1;
    }
}

void StressAnalysis::run(const StressedShape& shape, int64_t& work, size_t maxCracks,
                         std::vector<StressCrack>& cracks) {
    cracks.clear();
    // What was put by is for the step that waits, no more: no run does much more than it has.
    work = std::min(work + std::exchange(m_savedWork, 0), std::max(work, stepWork()));
    while (!isIdle() && work > 0) {
        const int64_t cost = stepWork();
        if (work < cost) {  // a step of the solver is not stressed in two: it waits until it is paid for
            m_savedWork = work;
            work = 0;
            return;
        }
        switch (m_phase) {
            case Phase::Idle:
                m_phase = Phase::Graph;
                break;
            case Phase::Graph:
                if (!m_changed.empty()) {
                    m_graph.setBrick(shape.grid, shape.anchors, shape.entries, m_changed.front());
                    m_changed.pop_front();
                    work -= kBrickWork;
                    break;
                }
                numberRows();
                work -= int64_t(m_nodeOf.size());
                m_phase = Phase::Rows;
                if (m_nodeOf.empty()) finish(false);
                break;
            case Phase::Rows:
                assembleRow(m_nodeOf[m_next]);
                assembleLoad(shape, m_next);
                work -= kRowWork;
                if (++m_next < m_nodeOf.size()) break;
                {
                    std::vector<glm::dvec3> centers;
                    for (const uint32_t node : m_nodeOf) centers.push_back(m_graph.nodes()[node].center);
                    m_inverse.begin(std::move(m_stiffness), std::move(centers));
                }
                m_phase = Phase::MultigridSetup;
                break;
            case Phase::MultigridSetup:
                if (m_inverse.setUp(work)) m_phase = Phase::Start;
                break;
            case Phase::Start:
                start();
                work -= cost;
                m_phase = Phase::Iterate;
                break;
            case Phase::Iterate:
                work -= cost;
                if (!iterate()) break;
                finishSolution();
                m_phase = Phase::Bonds;
                if (!m_hasConverged) finish(false);
                break;
            case Phase::Bonds:
                work -= evaluateBonds(shape, m_nodeOf[m_next]);
                if (++m_next < m_nodeOf.size()) break;
                dilateSliced();
                work -= int64_t(m_nodeOf.size());
                m_next = 0;
                m_phase = Phase::Layers;
                break;
            case Phase::Layers:
                work -= evaluateLayers(shape, m_nodeOf[m_next]);
                if (++m_next < m_nodeOf.size()) break;
                m_next = 0;
                m_phase = Phase::Check;
                break;
            case Phase::Check:
                work -= checkSection(m_next);
                if (++m_next < m_sections.size()) break;
                chooseCracks(maxCracks, cracks);
                finish(!cracks.empty());
                return;
        }
    }
}

/// What a impact breaks does not end it: it is looked at again once the cracks are open.
void StressAnalysis::finish(bool hasCracks) {
    m_phase = Phase::Idle;
    if (m_impacts.empty()) return;
    if (hasCracks && ++m_impactRounds < kMaxImpactRounds)
        m_isRestartRequested = true;
    else
        m_impacts.clear();
}

/// Rows for all free nodes that something fixed holds, in the order of their slots.
void StressAnalysis::numberRows() {
    const std::vector<StressNode>& nodes = m_graph.nodes();
    std::vector<bool> isHeld(nodes.size());
    std::vector<uint32_t> open;
    for (uint32_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].isUsed && nodes[i].isFixed) isHeld[i] = true, open.push_back(i);
    while (!open.empty()) {
        const uint32_t node = open.back();
        open.pop_back();
        for (const uint32_t bond : nodes[node].bonds) {
            const StressBond& each = m_graph.bonds()[bond];
            const uint32_t other = each.below == node ? each.above : each.below;
            if (!isHeld[other]) isHeld[other] = true, open.push_back(other);
        }
    }
    m_rowOf.assign(nodes.size(), kNone);
    m_nodeOf.clear();
    for (uint32_t i = 0; i < nodes.size(); ++i)
        if (isHeld[i] && !nodes[i].isFixed) m_rowOf[i] = uint32_t(m_nodeOf.size()), m_nodeOf.push_back(i);
    m_isRestartRequested = false;
    if (m_impacts.empty()) m_impactRounds = 0;
    m_impacts.insert(m_impacts.end(), m_pendingImpacts.begin(), m_pendingImpacts.end());
    m_pendingImpacts.clear();
    m_stiffness.clear();
    m_load.resize(m_nodeOf.size());
    m_next = 0;
}

void StressAnalysis::assembleRow(uint32_t index) {
    const StressNode& node = m_graph.nodes()[index];
    m_stiffness.open(m_rowOf[index]);
    for (const uint32_t bondIndex : node.bonds) {
        const StressBond& bond = m_graph.bonds()[bondIndex];
        const uint32_t other = bond.below == index ? bond.above : bond.below;
        const BondStiffness stiffness = bondStiffness(bond);
        const glm::dvec3 arm = bond.shape.centroid - node.center;
        const Block6 own = stiffnessBlock(stiffness, arm, arm);
        Block6& diagonal = m_stiffness.open(m_rowOf[index]);
        for (size_t i = 0; i < 36; ++i) diagonal.m[i] += own.m[i];
        if (m_rowOf[other] == kNone) continue;
        const Block6 across = stiffnessBlock(stiffness, arm, bond.shape.centroid - m_graph.nodes()[other].center);
        Block6& coupling = m_stiffness.open(m_rowOf[other]);
        for (size_t i = 0; i < 36; ++i) coupling.m[i] -= across.m[i];
    }
    m_stiffness.endRow();
}

/// f(cell, force) for each impact on a node, in the unit of its weight.
template <class F>
void StressAnalysis::forEachImpact(const StressedShape& shape, const StressNode& node, F&& f) const {
    const double unit = 1.0 / (shape.voxelSize * shape.voxelSize * shape.voxelSize);
    for (const ImpactForce& impact : m_impacts)
        if (holds(node, impact.cell)) f(impact.cell, impact.force * unit);
}

/// Forces in densities times m/s2 a cell: stresses come out in Pa over the size of a voxel.
void StressAnalysis::assembleLoad(const StressedShape& shape, size_t row) {
    const StressNode& node = m_graph.nodes()[m_nodeOf[row]];
    glm::dvec3 force = node.weight * shape.gravity;
    glm::dvec3 moment = glm::cross(node.massCenter - node.center, force);
    forEachImpact(shape, node, [&](glm::ivec3 cell, glm::dvec3 impact) {
        force += impact;
        moment += glm::cross(glm::dvec3(cell) + 0.5 - node.center, impact);
    });
    m_load[row] = {force.x, force.y, force.z, moment.x, moment.y, moment.z};
}

void StressAnalysis::start() {
    const size_t n = m_nodeOf.size();
    m_displacement.resize(n), m_residual.resize(n), m_direction.resize(n), m_preconditioned.resize(n),
        m_product.resize(n);
    for (size_t row = 0; row < n; ++row) {
        const StressNode& node = m_graph.nodes()[m_nodeOf[row]];
        m_displacement[row] = {node.translation.x, node.translation.y, node.translation.z,
                               node.rotation.x,    node.rotation.y,    node.rotation.z};
    }
    multiply(m_inverse.stiffness(), m_displacement, m_product);
    for (size_t row = 0; row < n; ++row)
        for (size_t k = 0; k < 6; ++k) m_residual[row][k] = m_load[row][k] - m_product[row][k];
    m_inverse.apply(m_residual, m_preconditioned);
    m_direction = m_preconditioned;
    m_rz = dot(m_residual, m_preconditioned);
    m_iterations = 0;
}

/// One step of preconditioned conjugate gradients (Hestenes & Stiefel 1952); true at the end.
bool StressAnalysis::iterate() {
    const size_t n = m_nodeOf.size();
    m_hasConverged = m_rz <= kTolerance * std::fabs(dot(m_load, m_displacement));
    if (m_hasConverged || m_iterations >= kMaxIterations) return true;
    ++m_iterations;
    multiply(m_inverse.stiffness(), m_direction, m_product);
    const double along = dot(m_direction, m_product);
    if (!(along > 0.0)) return m_iterations = kMaxIterations, false;
    const double length = m_rz / along;
    for (size_t row = 0; row < n; ++row)
        for (size_t k = 0; k < 6; ++k) {
            m_displacement[row][k] += length * m_direction[row][k];
            m_residual[row][k] -= length * m_product[row][k];
        }
    m_inverse.apply(m_residual, m_preconditioned);
    const double rz = dot(m_residual, m_preconditioned), beta = rz / m_rz;
    for (size_t row = 0; row < n; ++row)
        for (size_t k = 0; k < 6; ++k) m_direction[row][k] = m_preconditioned[row][k] + beta * m_direction[row][k];
    m_rz = rz;
    return false;
}

void StressAnalysis::finishSolution() {
    for (size_t row = 0; row < m_nodeOf.size(); ++row) {
        const Vector6& m = m_displacement[row];
        m_graph.setDisplacement(m_nodeOf[row], {m[0], m[1], m[2]}, {m[3], m[4], m[5]});
    }
    m_overloaded.clear();
    m_sections.clear();
    m_isSliced.assign(m_graph.nodes().size(), false);
    m_worst = {};
    m_next = 0;
}

SectionForce StressAnalysis::bondForce(const StressBond& bond) const {
    const StressNode &below = m_graph.nodes()[bond.below], &above = m_graph.nodes()[bond.above];
    const BondStiffness stiffness = bondStiffness(bond);
    const glm::dvec3 translation =
                         displacementAt(above, bond.shape.centroid) - displacementAt(below, bond.shape.centroid),
                     rotation = above.rotation - below.rotation;
    SectionForce out{stiffness.force * translation, glm::dvec3(0.0)};
    for (int i = 0; i < 3; ++i)
        out.moment[i] = stiffness.moment[i][0] * rotation[0] + stiffness.moment[i][1] * rotation[1] +
                        stiffness.moment[i][2] * rotation[2];
    return out;
}

namespace {

int remainingStrength(std::span<const WeakBrick> weak, glm::ivec3 brick) {
    const auto found = std::lower_bound(weak.begin(), weak.end(), brick,
                                        [](const WeakBrick& a, glm::ivec3 b) { return cellBefore(a.brick, b); });
    return found != weak.end() && found->brick == brick ? found->left : 256;
}

/// In the unit of forces an area; a section between two bricks is as strong as the weaker.
SectionStrength scaled(const SectionStrength& s, const Section& section, const StressedShape& shape) {
    double scale = shape.strengthScale / shape.voxelSize;
    if (!shape.weak.empty()) {
        glm::ivec3 above = section.brick;
        above[section.axis] += section.plane == 8;
        scale *= double(std::min(remainingStrength(shape.weak, section.brick), remainingStrength(shape.weak, above))) /
                 256.0;
    }
    return {s.tensile * scale, s.compressive * scale, s.shear * scale};
}

/// Whether one of two sections lies just behind the other: what breaks there is one crack.
bool areSameCrack(const Section& a, const Section& b) {
    if (a.axis != b.axis) return false;
    glm::ivec3 away = (a.brick - b.brick) * kBrickSize;
    away[a.axis] += a.plane - b.plane;
    const int behind = std::exchange(away[a.axis], 0);
    return away == glm::ivec3(0) && behind != 0 && std::abs(behind) < kMinCrackSpacing;
}

}  // namespace

/// Lists the bonds of a node, each once.
int64_t StressAnalysis::evaluateBonds(const StressedShape& shape, uint32_t index) {
    const StressNode& node = m_graph.nodes()[index];
    for (const uint32_t bondIndex : node.bonds) {
        const StressBond& bond = m_graph.bonds()[bondIndex];
        if (bond.below != index && !m_graph.nodes()[bond.below].isFixed) continue;
        const double utilization = m_sections.add(bond.section, bond.shape, bondForce(bond),
                                                  scaled(bond.strength, bond.section, shape), bond.canBreak);
        if (utilization < kMinSlicedUtilization) continue;
        m_isSliced[bond.below] = m_isSliced[bond.above] = true;
    }
    return 30 * int64_t(node.bonds.size());
}

/// Nodes that utilization a window with one under stress are sliced too.
void StressAnalysis::dilateSliced() {
    std::vector<uint32_t> ring;
    for (uint32_t node = 0; node < m_isSliced.size(); ++node)
        if (m_isSliced[node]) ring.push_back(node);
    for (int step = 0; step < 2 * kWindowRadius; ++step) {
        std::vector<uint32_t> next;
        for (const uint32_t node : ring)
            for (const uint32_t bondIndex : m_graph.nodes()[node].bonds) {
                const StressBond& bond = m_graph.bonds()[bondIndex];
                const uint32_t other = bond.below == node ? bond.above : bond.below;
                if (!m_isSliced[other]) m_isSliced[other] = true, next.push_back(other);
            }
        ring = std::move(next);
    }
}

/// Lists the sections between the layers of a node. Returns the work.
int64_t StressAnalysis::evaluateLayers(const StressedShape& shape, uint32_t index) {
    const StressNode& node = m_graph.nodes()[index];
    const Brick* content = shape.grid.brickAt(node.brick);
    if (!m_isSliced[index] || !content) return 1;
    InternalForces slices(node);
    for (const uint32_t bondIndex : node.bonds) {
        const StressBond& bond = m_graph.bonds()[bondIndex];
        slices.addBond(bond, bondForce(bond), bond.below == index);
    }
    slices.addWeight(*content, shape.entries, shape.gravity);
    forEachImpact(shape, node, [&](glm::ivec3 cell, glm::dvec3 force) { slices.addForce(cell, force); });
    int64_t work = 900;
    for (int axis = 0; axis < 3; ++axis)
        for (int plane = 1; plane < 8; ++plane) {
            const Section section{node.brick, axis, plane,
                                  brickLayer(node.cells, axis, plane - 1) & brickLayer(node.cells, axis, plane)};
            if (!section.cells) continue;
            bool canBreak = false;
            const SectionStrength strength =
                scaled(sectionStrength(shape.grid, shape.entries, section, canBreak), section, shape);
            const SectionShape form = sectionShape(section);
            m_sections.add(section, form, slices.forceAt(axis, plane, form.centroid), strength, canBreak);
            work += 40;
        }
    return work;
}

/// Whether its voxels changed since the analysis began.
bool StressAnalysis::isStale(const Section& section) const {
    glm::ivec3 above = section.brick;
    above[section.axis] += section.plane == 8;
    return std::any_of(m_changed.begin(), m_changed.end(),
                       [&](glm::ivec3 brick) { return brick == section.brick || brick == above; });
}

int64_t StressAnalysis::checkSection(size_t index) {
    const StressedSection& stressed = m_sections[index];
    if (!stressed.canBreak || !(stressed.ownUtilization >= kMinOwnUtilization) || isStale(stressed.section)) return 1;
    const SectionUtilization result = m_sections.windowUtilization(index);
    if (result.utilization > m_worst.utilization) m_worst = {stressed.section, result.utilization, result.cause};
    if (result.utilization > 1.0) m_overloaded.push_back({stressed.section, result.utilization, result.cause});
    return 200;
}

void StressAnalysis::chooseCracks(size_t maxCracks, std::vector<StressCrack>& cracks) {
    std::stable_sort(m_overloaded.begin(), m_overloaded.end(),
                     [](const StressCrack& a, const StressCrack& b) { return a.utilization > b.utilization; });
    for (const StressCrack& crack : m_overloaded) {
        if (cracks.size() >= maxCracks || crack.utilization < kSimultaneousRatio * m_worst.utilization) return;
        const auto isSame = [&](const StressCrack& other) { return areSameCrack(other.section, crack.section); };
        if (std::none_of(cracks.begin(), cracks.end(), isSame)) cracks.push_back(crack);
    }
}

uint64_t StressAnalysis::hash() const {
    uint64_t out = hashValue(uint64_t(m_phase) << 32 | uint64_t(m_next));
    out = hashValue(m_savedWork, out);
    out = hashValue(uint64_t(m_iterations), out);
    out = hashValue(m_rz, out);
    out = hashValue(uint64_t(m_isRestartRequested) << 32 | uint64_t(m_impactRounds), out);
    for (const std::vector<ImpactForce>* impacts : {&m_impacts, &m_pendingImpacts})
        for (const ImpactForce& impact : *impacts)
            out = hashBytes(&impact.force, sizeof impact.force, hashBytes(&impact.cell, sizeof impact.cell, out));
    return hashValue(uint64_t(m_changed.size()), out);
}

std::vector<BrickSubset> crackCells(const VoxelGrid& grid, std::span<const CellBox> anchors,
                                    const StrengthTable& entries, const Section& section) {
    std::vector<BrickSubset> out;
    glm::ivec3 step(0);
    step[section.axis] = 1;
    const auto isAnchored = [&](glm::ivec3 cell) {
        return std::any_of(anchors.begin(), anchors.end(), [&](const CellBox& box) {
            return cell.x >= box.low.x && cell.y >= box.low.y && cell.z >= box.low.z && cell.x < box.high.x &&
                   cell.y < box.high.y && cell.z < box.high.z;
        });
    };
    for (uint64_t left = section.cells; left; left &= left - 1) {
        const glm::ivec3 below = section.cellBelow(std::countr_zero(left)), above = below + step;
        const EntryStrength &lower = entries[grid.at(below)], &upper = entries[grid.at(above)];
        const bool canLower = lower.canBreak && !isAnchored(below), canUpper = upper.canBreak && !isAnchored(above);
        if (!lower.isSolid || !upper.isSolid || (!canLower && !canUpper)) continue;
        const glm::ivec3 clump = below >> 1;
        const bool takesLower = canLower != canUpper             ? canLower
                                : lower.tensile != upper.tensile ? lower.tensile < upper.tensile
                                                                 : (hashCell(clump.x, clump.y, clump.z) & 1) != 0;
        const glm::ivec3 cell = takesLower ? below : above;
        if (out.empty() || out.back().brick != cell >> 3) {
            const auto same = std::find_if(out.begin(), out.end(),
                                           [&](const BrickSubset& subset) { return subset.brick == cell >> 3; });
            if (same != out.end())
                std::swap(*same, out.back());
            else
                out.push_back({cell >> 3, {}});
        }
        out.back().voxels[size_t(cell.z & 7)] |= uint64_t(1) << ((cell.x & 7) + 8 * (cell.y & 7));
    }
    return out;
}

}  // namespace rubble
