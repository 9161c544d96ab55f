#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/collision/cover.h"
#include "physics/collision/feature_query.h"
#include "physics/collision/voxel_contacts.h"
#include "physics/math/simd4.h"

namespace rubble {

/// Collides the features (corners and edges) of one part, `from`, with the occupancy of another, `into`. Everything is
/// computed in the cells of `into`. See voxel_contacts.cpp for the method.
class FeatureCollider {
public:
    /// The cell transforms are about one origin, the first body's frame. All must outlive the collider.
    FeatureCollider(const CoveredPart& from, const CoveredPart& into);

    /// velocity (at the first body's frame origin, m/s) and spin (rad/s) of `from` relative to `into`, world axes.
    /// maxDisplacement: the longest that a feature moves in the step, metres.
    void setMotion(glm::dvec3 velocity, glm::dvec3 spin, const NarrowphaseSettings& settings, double maxDisplacement);
    /// Skips features whose dot product with the direction (world axes, from the first body's frame origin) exceeds
    /// `limit`, metres: they touch nothing.
    void setLimit(const glm::vec3& direction, float limit, const CellTransform& fromCells);

    /// Appends the contacts. isFirst: `from` belongs to the first body, else normals are reversed. partKey: bits of
    /// ContactPoint::feature that tell parts apart. search: which bricks come first, and how many were left out.
    /// Returns false if nothing of the two is near.
    bool collide(bool isFirst, uint64_t partKey, ContactSearch& search, std::vector<ContactPoint>& out);

    /// The greatest depth, in cells, of a feature that is inside the solid and accepts no exit; 0 if there is none.
    float stuckDepth() const { return m_stuckDepth; }

private:
    bool mayTouchSolid(const CellBox& near);
    bool boxMayTouchSolid(Float4 low, Float4 high);
    bool pathMeetsBounds(Float4 center, Float4 half, Float4 displacement) const;
    bool findOverlap(CellBox& near) const;
    void setSearchExtents();
    void boundSweep();
    FeatureQuery& queryFor(uint8_t kind, const glm::vec3& point);
    bool findCoveredSides(FeatureQuery& query, Cell own);
    uint32_t mayTouchSolid(const std::array<Float4, 3>& points, const std::array<uint8_t, 4>& kinds, uint32_t lanes);
    void collideBricks(const CellBox& near, ContactSearch& search, std::vector<ContactPoint>& out);
    void collideFeatures(const FeatureList& features, Cell corner, const CellBox& near, std::vector<ContactPoint>& out);
    void collideCluster(std::span<const FeatureList::Pack> packs, Cell corner, const glm::vec3& base, float limit,
                        std::vector<ContactPoint>& out);
    void collideFeature(FeatureQuery& query, uint8_t kind, Cell own, std::vector<ContactPoint>& out);
    void addFace(const FeatureQuery& query, const Face& face, uint8_t kind, Cell own, std::vector<ContactPoint>& out);
    bool collideEdgeCrossing(const FeatureQuery& query, float from, float to, uint8_t kind, Cell own,
                             std::vector<ContactPoint>& out);
    void add(const glm::vec3& point, const glm::vec3& normal, float separation, uint8_t kind, Cell own, Cell other,
             std::vector<ContactPoint>& out);

    const ColliderPart& m_from;
    const ColliderPart& m_into;
    Cover* m_fromCover;     ///< null: nothing lies around `from`
    Occupancy m_occupancy;  ///< of `into`
    CellTransform m_intoCells;

    glm::mat3 m_axes;                   ///< of a cell of `from`, in cells of `into`
    glm::vec3 m_corner;                 ///< of cell (0, 0, 0) of `from`, in cells of `into`
    float m_scale;                      ///< length of a cell of `from`, in cells of `into`
    std::array<glm::vec3, 3> m_unit;    ///< m_axes as unit vectors
    uint32_t m_readyKinds = 0;          ///< bit i: the query of kind i is set up
    glm::vec3 m_maxSearchExtent{0.0f};  ///< componentwise maximum of the search extents
    SimdMat3 m_axes4, m_absoluteAxes4;  ///< m_axes, and its absolute values
    Float4 m_corner4, m_velocity4, m_spin4, m_about4, m_maxSearchExtent4;
    std::array<Float4, 4> m_searchExtents;  ///< around corners, and around the middles of edges along x, y, z
    std::array<FeatureQuery, kFeatureKinds> m_queries;
    std::array<glm::vec3, kFeatureKinds> m_insets;  ///< from a feature to where it is looked up
    float m_margin, m_searchDistance = 0.0f;        ///< cells
    bool m_sweeps = false, m_isFirst = true;
    float m_stuckDepth = 0.0f;
    uint64_t m_key = 0;
    glm::vec3 m_velocity{0.0f}, m_spin{0.0f};  ///< cells and radians in the step, axes of `into`
    glm::vec3 m_about{0.0f};                   ///< where the velocity is measured
    glm::vec3 m_direction{0.0f};               ///< of setLimit(), per cell of `from`
    float m_limit = 1e30f;
    glm::vec3 m_displacementLow{0.0f}, m_displacementHigh{0.0f};  ///< bounds of the features' displacements, and of 0
    glm::vec3 m_low, m_high;                                      ///< the box in which features may meet `into`
};

}  // namespace rubble
