#pragma once
#include <deque>
#include <span>
#include <vector>

#include "runtime/destruction/load_cuts.h"
#include "runtime/destruction/load_graph.h"
#include "runtime/destruction/load_multigrid.h"

namespace rubble {

/// A brick that fire has left less of its strength. Lists of them are in the order of cellBefore().
struct WeakBrick {
    glm::ivec3 brick{0};
    int left = 256;  ///< of 256
};

/// A shape as the load analysis sees it. What it refers to must be what it was told of last.
struct LoadedShape {
    const VoxelGrid& grid;
    std::span<const CellBox> anchors;
    const LoadEntries& entries;
    glm::dvec3 gravity{0.0};     ///< m/s2, in the shape's frame
    double voxelSize = 0.1;      ///< metres
    double strengthScale = 1.0;  ///< of all strengths
    std::span<const WeakBrick> weak = {};
};

/// A section that is to break.
struct LoadCrack {
    Section section;
    double share = 0.0;  ///< stress over strength
    LoadFailure cause = LoadFailure::Tension;
    friend bool operator==(const LoadCrack&, const LoadCrack&) = default;
};

/// A blow that a shape takes. It lasts until an analysis finds that it breaks nothing, for kBlowRounds analyses at most.
struct LoadBlow {
    glm::ivec3 cell{0};
    glm::dvec3 force{0.0};  ///< N, in the shape's frame
};

/// Finds what in one anchored shape stands on too little: the forces between its parts under gravity, by conjugate
/// gradients, and the sections that they overload. Works in slices; once it knows, it is idle until something changes.
class LoadAnalysis {
public:
    /// These bricks changed, or are new. An analysis that has begun goes on and leaves them to the next.
    void touch(std::span<const glm::ivec3> bricks);
    /// Part of the next analysis to begin.
    void strike(const LoadBlow& blow);
    /// Weighs all sections again, for another gravity or strength.
    void restart() { m_isAskedFor = true; }
    bool isIdle() const { return m_phase == Phase::Idle && !m_isAskedFor; }

    /// Goes on until it is idle or `work` (about a 6x6 product with a vector each, 20 ns) is spent. What it may not finish
    /// at once it saves up for. Fills in `cracks` when it has come to an end: the most overloaded sections, worst first.
    void run(const LoadedShape& shape, int64_t& work, size_t maxCracks, std::vector<LoadCrack>& cracks);

    const LoadGraph& graph() const { return m_graph; }
    /// The largest stress over strength that the last analysis found, and where; none below 0.8.
    const LoadCrack& worst() const { return m_worst; }
    /// All sections and what they carry, from the last analysis.
    const LoadCuts& cuts() const { return m_cuts; }
    /// Steps of the solver in the last analysis.
    int iterations() const { return m_iterations; }
    bool hasConverged() const { return m_hasConverged; }
    /// Of all that the next results depend on.
    uint64_t hash() const;

private:
    enum class Phase : uint8_t { Idle, Graph, Rows, SetUp, Start, Iterate, CutBonds, CutLayers, Check };

    void numberRows();
    void appendRow(uint32_t node);
    template <class F>
    void forEachBlow(const LoadedShape& shape, const LoadNode& node, F&& f) const;
    void loadRow(const LoadedShape& shape, size_t row);
    void start();
    bool iterate();
    void finishSolution();
    SectionForce bondForce(const LoadBond& bond) const;
    int64_t cutBonds(const LoadedShape& shape, uint32_t node);
    void spreadBusy();
    int64_t cutLayers(const LoadedShape& shape, uint32_t node);
    int64_t checkCut(size_t cut);
    bool isOutdated(const Section& section) const;
    void finish(bool hasCracks);
    void chooseCracks(size_t maxCracks, std::vector<LoadCrack>& cracks);
    int64_t stepWork() const;

    LoadGraph m_graph;
    std::deque<glm::ivec3> m_changed;
    std::vector<LoadBlow> m_newBlows, m_blows;  ///< that wait, and that the analysis is about
    int m_blowRounds = 0;                       ///< analyses that the blows have lasted for
    Phase m_phase = Phase::Idle;
    bool m_isAskedFor = false;  ///< another analysis after this one
    size_t m_next = 0;          ///< row, within a phase
    int64_t m_saved = 0;        ///< work put by for a step that takes more than one run has

    std::vector<uint32_t> m_rowOf, m_nodeOf;  ///< node -> row, row -> node
    BlockMatrix m_stiffness;
    LoadMultigrid m_inverse;
    std::vector<Vector6> m_load, m_motion, m_residual, m_direction, m_preconditioned, m_product;
    double m_rz = 0.0;
    int m_iterations = 0;
    bool m_hasConverged = false;
    LoadCuts m_cuts;
    std::vector<bool> m_isBusy;  ///< nodes whose layers are looked at
    std::vector<LoadCrack> m_overloaded;
    LoadCrack m_worst;
};

/// The cells that open along a section: one of each pair that touches, the weaker, else by chance, in clumps.
std::vector<BrickShare> crackCells(const VoxelGrid& grid, std::span<const CellBox> anchors, const LoadEntries& entries, const Section& section);

}  // namespace rubble
