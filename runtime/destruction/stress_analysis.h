#pragma once
#include <deque>
#include <span>
#include <vector>

#include "runtime/destruction/stress_graph.h"
#include "runtime/destruction/stress_multigrid.h"
#include "runtime/destruction/stressed_sections.h"

namespace rubble {

/// A brick that fire has weakened. Lists of them are in the order of cellBefore().
struct WeakBrick {
    glm::ivec3 brick{0};
    int left = 256;  ///< the strength it has left, in 1/256
};

/// The input of a stress analysis. The grid may differ from that of the last run() only in bricks given to
/// markChanged().
struct StressedShape {
    const VoxelGrid& grid;
    std::span<const CellBox> anchors;
    const StrengthTable& entries;
    glm::dvec3 gravity{0.0};     ///< m/s2, in the shape's frame
    double voxelSize = 0.1;      ///< metres
    double strengthScale = 1.0;  ///< multiplies all strengths
    std::span<const WeakBrick> weak = {};
};

/// A section that breaks.
struct StressCrack {
    Section section;
    double utilization = 0.0;  ///< stress over strength
    FailureMode cause = FailureMode::Tension;
    friend bool operator==(const StressCrack&, const StressCrack&) = default;
};

/// An impact on a shape. It is part of every analysis until one finds that it breaks nothing, at most kMaxImpactRounds
/// times.
struct ImpactForce {
    glm::ivec3 cell{0};
    glm::dvec3 force{0.0};  ///< N, in the shape's frame
};

/// Finds where an anchored shape breaks under its weight and under impacts; the algorithm is at the top of
/// stress_analysis.cpp. Works in slices; once the result is known, it is idle until something changes. One thread.
class StressAnalysis {
public:
    /// Bricks that have changed or are new. A running analysis goes on without them; another one follows.
    void markChanged(std::span<const glm::ivec3> bricks);
    /// An impact for the next analysis.
    void applyImpact(const ImpactForce& impact);
    /// Requests another analysis, for another gravity or other strengths.
    void restart() { m_isRestartRequested = true; }
    /// Whether there is nothing to do.
    bool isIdle() const { return m_phase == Phase::Idle && !m_isRestartRequested; }

    /// Goes on until it is idle, an analysis has ended, or `work` is spent, and subtracts the work done (one unit is a
    /// product of a 6x6 block with a vector, about 20 ns). Work that is too little for the next step is saved for the
    /// next call. `cracks`: empty, or at the end of an analysis the most overloaded sections, worst first.
    void run(const StressedShape& shape, int64_t& work, size_t maxCracks, std::vector<StressCrack>& cracks);

    /// The section of the highest utilization in the last analysis. Utilizations below 0.8 are not found.
    const StressCrack& worst() const { return m_worst; }
    /// Whether the solver of the last analysis has converged; if not, nothing breaks.
    bool hasConverged() const { return m_hasConverged; }
    /// A hash of the state that later results depend on.
    uint64_t hash() const;

private:
    enum class Phase : uint8_t { Idle, Graph, Rows, MultigridSetup, Start, Iterate, Bonds, Layers, Check };

    bool advance(const StressedShape& shape, int64_t& work, size_t maxCracks, std::vector<StressCrack>& cracks);
    int64_t updateGraph(const StressedShape& shape);
    void numberRows();
    void assembleNextRow(const StressedShape& shape);
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
    int64_t checkSection(size_t index);
    bool isStale(const Section& section) const;
    void finish(bool hasCracks);
    void chooseCracks(size_t maxCracks, std::vector<StressCrack>& cracks);
    int64_t stepWork() const;

    StressGraph m_graph;
    std::deque<glm::ivec3> m_changed;           ///< bricks that the graph does not know yet
    std::vector<ImpactForce> m_pendingImpacts;  ///< for the next analysis
    std::vector<ImpactForce> m_impacts;         ///< of this analysis
    int m_impactRounds = 0;                     ///< analyses so far with these impacts
    Phase m_phase = Phase::Idle;
    bool m_isRestartRequested = false;  ///< another analysis follows this one
    size_t m_next = 0;                  ///< the next row or section of the phase
    int64_t m_savedWork = 0;            ///< for a step of the solver that needs more than one run

    std::vector<uint32_t> m_rowOf, m_nodeOf;                                    ///< row by node, node by row
    BlockMatrix m_stiffness;                                                    ///< K, during its assembly
    StressMultigrid m_inverse;                                                  ///< the preconditioner; it holds K
    std::vector<Vector6> m_load;                                                ///< f, by row
    std::vector<Vector6> m_displacement;                                        ///< x, by row
    std::vector<Vector6> m_residual, m_direction, m_preconditioned, m_product;  ///< of conjugate gradients
    double m_rz = 0.0;  ///< scalar product of the residual and the preconditioned residual
    int m_iterations = 0;
    bool m_hasConverged = true;
    StressedSections m_sections;
    std::vector<bool> m_isSliced;  ///< by node: whether the sections between its layers are evaluated
    std::vector<StressCrack> m_overloaded;
    StressCrack m_worst;
};

}  // namespace rubble
