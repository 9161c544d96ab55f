#include "runtime/destruction/stress_analysis.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "runtime/core/hash.h"
#include "runtime/destruction/internal_forces.h"

// Stress analysis of an anchored shape: a model of rigid bodies and springs, solved by conjugate gradients, and beam
// theory.
//
// Nodes are rigid parts of the shape, bonds are the sections between them (stress_graph.h). Node i moves by a
// translation u_i and a rotation r_i. At the centroid s of a bond's section, with area A and second moments I, the node
// above moves against the node below by
//     d = (u_b + r_b x (s - c_b)) - (u_a + r_a x (s - c_a)),   q = r_b - r_a,
// and an elastic bar of length L between the centres c_a and c_b resists with
//     N = E A d_n / L,  V = G A d_t / L,  M = E I q_t / L,  T = G (I_u + I_v) q_n / L.
// Equilibrium of the forces of all bonds on each free node with its weight and impacts is K x = f, one 6x6 block for
// each node and pair of bonded nodes. K is symmetric positive definite, as every row's node is connected to a fixed
// one: preconditioned conjugate gradients (M. Hestenes and E. Stiefel 1952; stress_multigrid.h). E cancels out of the
// forces, so E = 1. From x follow the forces in all bonds, by the method of sections those between the layers inside a
// node (internal_forces.h), and by beam theory the stress in each section (stressed_sections.h). Sections whose stress
// exceeds their strength are cracks. The analysis advances row by row in slices of work; all of its state is in the
// class, so the size of the slices does not change the result.

namespace rubble {
namespace {

constexpr double kShearRatio = 0.4;            ///< shear modulus over Young's modulus
constexpr double kTolerance = 1e-6;            ///< energy of the error over that of the solution: forces to about 0.1 %
constexpr int kMaxIterations = 400;            ///< after more the analysis fails: nothing breaks
constexpr double kSimultaneousRatio = 0.9;     ///< of the highest utilization: sections above it break in the same step
constexpr double kMinOwnUtilization = 0.8;     ///< of a section's own cells: below, it holds, whatever its window says
constexpr double kMinSlicedUtilization = 0.2;  ///< of a bond from which the layers of the nodes around it are evaluated
constexpr int kMaxImpactRounds = 24;
constexpr int kWindowRadius = StressedSections::kWindowRadius;
constexpr int kMinCrackSpacing = 8;  ///< cells between parallel sections, one behind the other, that break together
// Work, in the units of StressAnalysis::run():
constexpr int64_t kBrickWork = 450;   ///< to rebuild a brick of the graph
constexpr int64_t kRowWork = 350;     ///< to assemble a row of K and f
constexpr int64_t kBondWork = 30;     ///< to evaluate a bond
constexpr int64_t kSlicesWork = 900;  ///< to sum up the forces on the layers of a node
constexpr int64_t kSectionWork = 40;  ///< to evaluate a section between two layers
constexpr int64_t kWindowWork = 200;  ///< to evaluate a section in its window

/// The force of a bond for a unit of d along each axis, and its moment for a unit of q (a symmetric matrix), with E
/// = 1.
struct BondStiffness {
    glm::dvec3 force;
    double moment[3][3] = {};
};

BondStiffness bondStiffness(const StressBond& bond) {
    const int a = bond.section.axis, u = kSectionU[size_t(a)], v = kSectionV[size_t(a)];
    const double perLength = 1.0 / bond.length;
    BondStiffness out{glm::dvec3(kShearRatio * bond.shape.area * perLength), {}};
    out.force[a] = bond.shape.area * perLength;
    out.moment[a][a] = kShearRatio * (bond.shape.uu + bond.shape.vv) * perLength;
    out.moment[v][v] = bond.shape.uu * perLength;  // a rotation about v has its lever along u
    out.moment[u][u] = bond.shape.vv * perLength;
    out.moment[u][v] = out.moment[v][u] = -bond.shape.uv * perLength;
    return out;
}

/// The block of K of a bond between two nodes. armA, armB: from their centres to the section's centroid.
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

/// Whether a cell is one of the node's.
bool holds(const StressNode& node, glm::ivec3 cell) {
    return brickOfCell(cell) == node.brick && hasVoxel(node.cells, voxelIndex(cellInBrick(cell)));
}

/// The translation of a node, which moves as a rigid body, at a point.
glm::dvec3 displacementAt(const StressNode& node, glm::dvec3 point) {
    return node.translation + glm::cross(node.rotation, point - node.center);
}

/// The strength a brick has left, in 1/256.
int remainingStrength(std::span<const WeakBrick> weak, glm::ivec3 brick) {
    const auto found = std::lower_bound(weak.begin(), weak.end(), brick,
                                        [](const WeakBrick& a, glm::ivec3 b) { return cellBefore(a.brick, b); });
    return found != weak.end() && found->brick == brick ? found->left : 256;
}

/// Strength in units of section forces per area. A section between two bricks has the strength of the weaker one.
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

/// Whether one of two sections is a few cells behind the other: then they are the same crack.
bool areSameCrack(const Section& a, const Section& b) {
    if (a.axis != b.axis) return false;
    glm::ivec3 away = (a.brick - b.brick) * kBrickSize;
    away[a.axis] += a.plane - b.plane;
    const int behind = std::exchange(away[a.axis], 0);
    return away == glm::ivec3(0) && behind != 0 && std::abs(behind) < kMinCrackSpacing;
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
        case Phase::Start:  // reads from memory what an iteration finds in the cache
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
    // Saved work is for the step that waits: no run does much more than its own work.
    work = std::min(work + std::exchange(m_savedWork, 0), std::max(work, stepWork()));
    while (!isIdle() && work > 0) {
        if (work < stepWork()) {  // a step of the solver is not divided: it waits until enough work is saved
            m_savedWork = work;
            work = 0;
            return;
        }
        if (advance(shape, work, maxCracks, cracks)) return;
    }
}

/// One step of the current phase. Returns whether the analysis has come to its end, with cracks or without.
bool StressAnalysis::advance(const StressedShape& shape, int64_t& work, size_t maxCracks,
                             std::vector<StressCrack>& cracks) {
    switch (m_phase) {
        case Phase::Idle:
            m_phase = Phase::Graph;
            return false;
        case Phase::Graph:
            work -= updateGraph(shape);
            return false;
        case Phase::Rows:
            assembleNextRow(shape);
            work -= kRowWork;
            return false;
        case Phase::MultigridSetup:
            if (m_inverse.setUp(work)) m_phase = Phase::Start;
            return false;
        case Phase::Start:
            work -= stepWork();
            start();
            m_phase = Phase::Iterate;
            return false;
        case Phase::Iterate:
            work -= stepWork();
            if (iterate()) finishSolution();
            return false;
        case Phase::Bonds:
            work -= evaluateBonds(shape, m_nodeOf[m_next]);
            if (++m_next < m_nodeOf.size()) return false;
            dilateSliced();
            work -= int64_t(m_nodeOf.size());
            m_next = 0;
            m_phase = Phase::Layers;
            return false;
        case Phase::Layers:
            work -= evaluateLayers(shape, m_nodeOf[m_next]);
            if (++m_next < m_nodeOf.size()) return false;
            m_next = 0;
            m_phase = Phase::Check;
            return false;
        case Phase::Check:
            work -= checkSection(m_next);
            if (++m_next < m_sections.size()) return false;
            chooseCracks(maxCracks, cracks);
            finish(!cracks.empty());
            return true;
    }
    return false;
}

/// Rebuilds one changed brick of the graph; after the last one, numbers the rows of K. Returns the work.
int64_t StressAnalysis::updateGraph(const StressedShape& shape) {
    if (!m_changed.empty()) {
        m_graph.setBrick(shape.grid, shape.anchors, shape.entries, m_changed.front());
        m_changed.pop_front();
        return kBrickWork;
    }
    numberRows();
    m_phase = Phase::Rows;
    const int64_t work = int64_t(m_nodeOf.size());
    if (!m_nodeOf.empty()) return work;
    m_hasConverged = true;  // all that there is, is fixed
    m_worst = {};
    finish(false);
    return work;
}

/// Assembles a row of K and f; after the last one, begins the setup of the preconditioner.
void StressAnalysis::assembleNextRow(const StressedShape& shape) {
    assembleRow(m_nodeOf[m_next]);
    assembleLoad(shape, m_next);
    if (++m_next < m_nodeOf.size()) return;
    std::vector<glm::dvec3> centers;
    for (const uint32_t node : m_nodeOf) centers.push_back(m_graph.nodes()[node].center);
    m_inverse.begin(std::move(m_stiffness), std::move(centers));
    m_phase = Phase::MultigridSetup;
}

/// An impact that has broken something is analysed again once the cracks are open.
void StressAnalysis::finish(bool hasCracks) {
    m_phase = Phase::Idle;
    if (m_impacts.empty()) return;
    if (hasCracks && ++m_impactRounds < kMaxImpactRounds)
        m_isRestartRequested = true;
    else
        m_impacts.clear();
}

/// Gives a row to each free node that is connected to a fixed one, in the order of the slots.
void StressAnalysis::numberRows() {
    const std::vector<StressNode>& nodes = m_graph.nodes();
    std::vector<bool> isConnected(nodes.size());
    std::vector<uint32_t>& open = m_nodeOf;  // its memory, before its content
    open.clear();
    for (uint32_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].isUsed && nodes[i].isFixed) isConnected[i] = true, open.push_back(i);
    while (!open.empty()) {
        const uint32_t node = open.back();
        open.pop_back();
        m_graph.forEachBond(node, [&](const StressBond&, uint32_t other) {
            if (!isConnected[other]) isConnected[other] = true, open.push_back(other);
        });
    }
    m_rowOf.assign(nodes.size(), kNoIndex);
    m_nodeOf.clear();
    for (uint32_t i = 0; i < nodes.size(); ++i)
        if (isConnected[i] && !nodes[i].isFixed) m_rowOf[i] = uint32_t(m_nodeOf.size()), m_nodeOf.push_back(i);
    m_isRestartRequested = false;
    if (m_impacts.empty()) m_impactRounds = 0;
    m_impacts.insert(m_impacts.end(), m_pendingImpacts.begin(), m_pendingImpacts.end());
    m_pendingImpacts.clear();
    m_stiffness.clear();
    m_load.resize(m_nodeOf.size());
    m_next = 0;
}

/// A row of K: the blocks of the node's bonds.
void StressAnalysis::assembleRow(uint32_t index) {
    const StressNode& node = m_graph.nodes()[index];
    m_stiffness.findOrAppend(m_rowOf[index]);
    m_graph.forEachBond(index, [&](const StressBond& bond, uint32_t other) {
        const BondStiffness stiffness = bondStiffness(bond);
        const glm::dvec3 arm = bond.shape.centroid - node.center;
        const Block6 own = stiffnessBlock(stiffness, arm, arm);
        Block6& diagonal = m_stiffness.findOrAppend(m_rowOf[index]);
        for (size_t i = 0; i < 36; ++i) diagonal.m[i] += own.m[i];
        if (m_rowOf[other] == kNoIndex) return;
        const Block6 across = stiffnessBlock(stiffness, arm, bond.shape.centroid - m_graph.nodes()[other].center);
        Block6& coupling = m_stiffness.findOrAppend(m_rowOf[other]);
        for (size_t i = 0; i < 36; ++i) coupling.m[i] -= across.m[i];
    });
    m_stiffness.endRow();
}

/// Calls f(cell, force) for each impact on a node. The force is in the units of assembleLoad().
template <class F>
void StressAnalysis::forEachImpact(const StressedShape& shape, const StressNode& node, F&& f) const {
    const double unit = 1.0 / (shape.voxelSize * shape.voxelSize * shape.voxelSize);
    for (const ImpactForce& impact : m_impacts)
        if (holds(node, impact.cell)) f(impact.cell, impact.force * unit);
}

/// A row of f. The unit of force is density times m/s2 times cell volume, so stresses are in Pa over the voxel size.
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

/// Begins the solver at the displacements of the last analysis.
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

/// One step of preconditioned conjugate gradients. Returns true when it has converged or failed.
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

/// Stores the displacements and begins the evaluation of the sections.
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
    m_phase = Phase::Bonds;
    if (!m_hasConverged) finish(false);
}

/// The force of a bond from the displacements of its nodes.
SectionForce StressAnalysis::bondForce(const StressBond& bond) const {
    const StressNode &below = m_graph.nodes()[bond.below], &above = m_graph.nodes()[bond.above];
    const BondStiffness stiffness = bondStiffness(bond);
    const glm::dvec3 point = bond.shape.centroid, rotation = above.rotation - below.rotation;
    const glm::dvec3 translation = displacementAt(above, point) - displacementAt(below, point);
    SectionForce out{stiffness.force * translation, glm::dvec3(0.0)};
    for (int i = 0; i < 3; ++i)
        out.moment[i] = stiffness.moment[i][0] * rotation[0] + stiffness.moment[i][1] * rotation[1] +
                        stiffness.moment[i][2] * rotation[2];
    return out;
}

/// Adds the sections of a node's bonds; each bond belongs to one node. Returns the work.
int64_t StressAnalysis::evaluateBonds(const StressedShape& shape, uint32_t index) {
    int64_t work = 0;
    m_graph.forEachBond(index, [&](const StressBond& bond, uint32_t other) {
        work += kBondWork;
        if (bond.below != index && !m_graph.nodes()[other].isFixed) return;
        const double utilization = m_sections.add(bond.section, bond.shape, bondForce(bond),
                                                  scaled(bond.strength, bond.section, shape), bond.canBreak);
        if (utilization < kMinSlicedUtilization) return;
        m_isSliced[bond.below] = m_isSliced[bond.above] = true;
    });
    return work;
}

/// Windows reach into other bricks: also slices the nodes within two windows of one under stress.
void StressAnalysis::dilateSliced() {
    std::vector<uint32_t> ring;
    for (uint32_t node = 0; node < m_isSliced.size(); ++node)
        if (m_isSliced[node]) ring.push_back(node);
    for (int step = 0; step < 2 * kWindowRadius; ++step) {
        std::vector<uint32_t> next;
        for (const uint32_t node : ring)
            m_graph.forEachBond(node, [&](const StressBond&, uint32_t other) {
                if (!m_isSliced[other]) m_isSliced[other] = true, next.push_back(other);
            });
        ring = std::move(next);
    }
}

/// Adds the sections between the layers of a node. Returns the work.
int64_t StressAnalysis::evaluateLayers(const StressedShape& shape, uint32_t index) {
    const StressNode& node = m_graph.nodes()[index];
    const Brick* content = shape.grid.brickAt(node.brick);
    if (!m_isSliced[index] || !content) return 1;
    InternalForces slices(node);
    m_graph.forEachBond(
        index, [&](const StressBond& bond, uint32_t) { slices.addBond(bond, bondForce(bond), bond.below == index); });
    slices.addWeight(*content, shape.entries, shape.gravity);
    forEachImpact(shape, node, [&](glm::ivec3 cell, glm::dvec3 force) { slices.addForce(cell, force); });
    int64_t work = kSlicesWork;
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
            work += kSectionWork;
        }
    return work;
}

/// Whether voxels beside a section have changed since the analysis began.
bool StressAnalysis::isStale(const Section& section) const {
    glm::ivec3 above = section.brick;
    above[section.axis] += section.plane == 8;
    return std::any_of(m_changed.begin(), m_changed.end(),
                       [&](glm::ivec3 brick) { return brick == section.brick || brick == above; });
}

/// Lists a section as overloaded if it is. Returns the work.
int64_t StressAnalysis::checkSection(size_t index) {
    const StressedSection& stressed = m_sections[index];
    if (!stressed.canBreak || !(stressed.ownUtilization >= kMinOwnUtilization) || isStale(stressed.section)) return 1;
    const SectionUtilization result = m_sections.windowUtilization(index);
    if (result.utilization > m_worst.utilization) m_worst = {stressed.section, result.utilization, result.cause};
    if (result.utilization > 1.0) m_overloaded.push_back({stressed.section, result.utilization, result.cause});
    return kWindowWork;
}

/// The worst overloaded sections, without those that are part of the same crack.
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

}  // namespace rubble
