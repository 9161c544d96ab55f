#pragma once
#include <cstdint>
#include <set>

#include "runtime/destruction/free_body_fracture.h"
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Loads shapes as a whole by impacts, while stress analysis is on. A piece breaks in the same step; what stands breaks
/// when its analysis has found where. Lives for one step: a piece is tested once in it.
class ImpactLoadStage {
public:
    /// For the step of the context.
    explicit ImpactLoadStage(EditContext& context) : m_context(context) {}

    /// Loads the edit's shape with the force impulse / StressSettings::contactTime at its voxel nearest to the
    /// position.
    void apply(const ImpactLoadEdit& edit);

private:
    void fracturePiece(ShapeHandle shape, const ImpactForce& impact);

    EditContext& m_context;
    std::set<uint32_t> m_tested;  ///< slots of pieces
};

}  // namespace rubble
