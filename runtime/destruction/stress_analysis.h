#pragma once
#include <deque>
#include <span>
#include <vector>

#include "runtime/destruction/stress_graph.h"
#include "runtime/destruction/stress_multigrid.h"
#include "runtime/destruction/stressed_sections.h"

namespace rubble {

/// A brick that fire has left less of its strength. Lists of them are in the order of cellBefore().
struct WeakBrick {
    glm::ivec3 brick{0};
    int left = 256;  ///< of 256
};

/// A shape as the load analysis sees it. What it refers to must be what it was told of last.
struct StressedShape {
    const VoxelGrid& grid;
    std::span<const CellBox> anchors;
    const StrengthTable& entries;
    glm::dvec3 gravity{0.0};     ///< m/s2, in the shape's frame
    double voxelSize = 0.1;      ///< metres
    double strengthScale = 1.0;  ///< of all strengths
    std::span<const WeakBrick> weak = {};
};

/// A section that is to break.
struct StressCrack {
    Section section;
    double utilization = 0.0;  ///< stress over strength
    FailureMode cause = FailureMode::Tension;
    friend bool operator==(const StressCrack&, const StressCrack&) = default;
};

/// A impact that a shape takes. It lasts until an analysis finds that it breaks nothing, for kMaxImpactRounds analyses
/// at most.
struct ImpactForce {
    glm::ivec3 cell{0};
    glm::dvec3 force{0.0};  ///< N, in the shape's frame
};

/// Finds what in one anchored shape stands on too little: the forces between its parts under gravity, by conjugate
/// gradients, and the sections that they overload. Works in slices; once it knows, it is idle until something changes.
class StressAnalysis {
public:
    /// These bricks changed, or are new. An analysis that has begun goes on and leaves them to the next.
    void markChanged(std::span<const glm::ivec3> bricks);
    /// Part of the next analysis to begin.
    void applyImpact(const ImpactForce& impact);
    /// Weighs all sections again, for another gravity or strength.
    void restart() { m_isRestartRequested = true; }
    bool isIdle() const { return m_phase == Phase::Idle && !m_isRestartRequested; }

    /// Goes on until it is idle or `work` (about a 6x6 product with a vector each, 20 ns) is spent. What it may not
    /// finish at once it saves up for. Fills in `cracks` when it has come to an end: the most overloaded sections,
    /// worst first.
    void run(const StressedShape& shape, int64_t& work, size_t maxCracks, std::vector<StressCrack>& cracks);

    const StressGraph& graph() const { return m_graph; }
    /// The largest stress over strength that the last analysis found, and where; none below 0.8.
    const StressCrack& worst() const { return m_worst; }
    /// All sections and what they carry, from the last analysis.
    const StressedSections& sections() const { return m_sections; }
    /// Steps of the solver in the last analysis.
    int iterations() const { return m_iterations; }
    bool hasConverged() const { return m_hasConverged; }
    /// Of all that the next results depend on.
    uint64_t hash() const;

private:
    enum class Phase : uint8_t { Idle, Graph, Rows, MultigridSetup, Start, Iterate, Bonds, Layers, Check };

    void numberRows();
    void assembleRow(uint32_t node);
    template <class F>
    void forEachImpact(const StressedShape& shape, const StressNode& node, F&& f) const;
    void assembleLoad(const StressedShape& shape, size_t row);
    void start();
    bool iterate();
    void finishSolution();
    SectionForce bondForce(const StressBond& bond) const;
    int64_t evaluateBonds(const StressedShape& shape, uint32_t node);
    void dilateSliced();
    int64_t evaluateLayers(const StressedShape& shape, uint32_t node);
    int64_t checkSection(size_t stressed);
    bool isStale(const Section& section) const;
    void finish(bool hasCracks);
    void chooseCracks(size_t maxCracks, std::vector<StressCrack>& cracks);
    int64_t stepWork() const;

    StressGraph m_graph;
    std::deque<glm::ivec3> m_changed;
    std::vector<ImpactForce> m_pendingImpacts, m_impacts;  ///< that wait, and that the analysis is about
    int m_impactRounds = 0;                                ///< analyses that the impacts have lasted for
    Phase m_phase = Phase::Idle;
    bool m_isRestartRequested = false;  ///< another analysis after this one
    size_t m_next = 0;                  ///< row, within a phase
    int64_t m_savedWork = 0;            ///< work put by for a step that takes more than one run has

    std::vector<uint32_t> m_rowOf, m_nodeOf;  ///< node -> row, row -> node
    BlockMatrix m_stiffness;
    StressMultigrid m_inverse;
    std::vector<Vector6> m_load, m_displacement, m_residual, m_direction, m_preconditioned, m_product;
    double m_rz = 0.0;
    int m_iterations = 0;
    bool m_hasConverged = false;
    StressedSections m_sections;
    std::vector<bool> m_isSliced;  ///< nodes whose layers are looked at
    std::vector<StressCrack> m_overloaded;
    StressCrack m_worst;
};

/// The cells that open along a section: one of each pair that touches, the weaker, else by chance, in clumps.
std::vector<BrickSubset> crackCells(const VoxelGrid& grid, std::span<const CellBox> anchors,
                                    const StrengthTable& entries, const Section& section);

}  // namespace rubble
