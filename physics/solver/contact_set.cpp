#include "physics/solver/contact_set.h"

namespace rubble {
namespace {

SymmetricMat3<float> symmetric(const glm::mat3& m) {
    return {m[0].x, m[0].y, m[0].z, m[1].y, m[1].z, m[2].z};
}
Mat3<float> columns(const glm::mat3& m) {
    return {toVec3(m[0]), toVec3(m[1]), toVec3(m[2])};
}

}  // namespace

VelocityPair<float> velocitiesOf(const SolverState& A, const SolverState& B) {
    return {toVec3(A.v),
            toVec3(A.w),
            toVec3(B.v),
            toVec3(B.w),
            A.inverseMass,
            B.inverseMass,
            symmetric(A.inverseInertia),
            symmetric(B.inverseInertia)};
}

void storeVelocities(const VelocityPair<float>& velocities, SolverState& A, SolverState& B) {
    if (A.inverseMass != 0.0f) A.v = toGlm(velocities.vA), A.w = toGlm(velocities.wA);
    if (B.inverseMass != 0.0f) B.v = toGlm(velocities.vB), B.w = toGlm(velocities.wB);
}

MotionPair<float> motionsOf(const SolverState& A, const SolverState& B) {
    return {toVec3(A.deltaPosition - B.deltaPosition), columns(A.deltaRotation), columns(B.deltaRotation)};
}

}  // namespace rubble
