#include "physics/joints/rope.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "physics/bodies/dynamic_body.h"
#include "physics/joints/rope_contact.h"

// Ropes by position-based dynamics (Mueller et al., "Position Based Dynamics", 2007).
//
// A rope is a chain of points of equal mass. A substep of h seconds moves each point x by h (v + h g), then projects
// the positions onto the constraints, and sets v to the change of position divided by h. A segment may not be longer
// than its rest length l: with d = x_j - x_i and the inverse masses w, its projection is
//     x_i += w_i (|d| - l) / (w_i + w_j) d / |d|,   x_j -= w_j (...) d / |d|
// and nothing if it is shorter, since a rope does not push. Points at the ends that something holds have w = 0. The
// last passes give the whole correction to the farther point ("follow the leader"), which makes a taut rope straight.
// Then places along the segments, half a voxel apart, are pushed out of voxels (rope_contact.h), with Coulomb friction
// along the displacement by which they slid: an exit of depth d takes back up to friction * d of it. The voxels have
// the last word: a chain that is pulled harder than it is long stretches, and does not pass.
//
// An end may be held inside a body. As many metres of the rope as that end is deep, and its radius more, touch nothing,
// as if it went through a hole to the nearest face. From a held end to the next point the radius grows from 0 to the
// rope's: to push a place out near the end would swing that point by many times as much.

namespace rubble {
namespace {

constexpr int kSubsteps = 4, kPasses = 6;
constexpr double kDrag = 0.4;  ///< fraction of a free point's speed that air takes in a second
constexpr double kFriction = 0.6;
constexpr double kSampling = 0.5;                          ///< voxels between the places that are kept out of them
constexpr double kMaxSamples = 64.0, kMaxSampling = 0.12;  ///< places on a segment; metres between them
constexpr int kContactPasses = 3;                          ///< over all places, until none is inside anything
constexpr double kTouchDistance = 0.02;                    ///< metres from a rope at which something bends it
constexpr double kAslant = 1.8;                            ///< times its depth that a hole is long at most
constexpr double kMaxSpeed = 200.0;                        ///< m/s, above which a point is stopped

class RopeSolver {
public:
    RopeSolver(std::span<RopePoint> points, const RopeStep& step, std::vector<RopeBend>& bends)
        : m_points(points),
          m_step(step),
          m_bends(bends),
          m_last(points.size() - 1),
          m_spacing(step.length / double(m_last)) {
        for (const RopePoint& point : points) m_before.push_back(point.position);
        m_pulled = m_before;
        m_carrying.resize(points.size());
        double sampling = kMaxSampling;
        for (const CollisionObject* object : step.nearby) {
            for (const auto& part : object->collider.parts)
                sampling = std::min(sampling, kSampling * double(part->voxelSize()));
            for (size_t end = 0; end < 2; ++end)
                if (const double depth = step.ends[end] ? depthInside(*object, *step.ends[end]) : 0.0;
                    depth > m_depth[end])
                    m_depth[end] = depth, m_holder[end] = object;
        }
        m_samples = size_t(std::clamp(std::ceil(m_spacing / sampling), 1.0, kMaxSamples));
    }

    void run() {
        const double h = m_step.seconds / kSubsteps;
        const std::array<glm::dvec3, 2> from = {m_points.front().position, m_points.back().position};
        for (int substep = 1; substep <= kSubsteps; ++substep) {
            predict(h);
            const double share = double(substep) / kSubsteps;
            for (size_t end = 0; end < 2; ++end)
                if (m_step.ends[end])
                    m_points[end ? m_last : 0].position = from[end] + (*m_step.ends[end] - from[end]) * share;
            for (int pass = 0; pass < kPasses; ++pass) limitLengths(pass % 2 == 0, pass + 2 >= kPasses);
            for (size_t i = 0; i <= m_last; ++i) m_pulled[i] = m_points[i].position;
            m_ahead = {m_step.seconds - (substep - 1) * h, m_step.seconds - substep * h};
            collide();
            updateVelocities(h);
        }
        findBends();
    }

    /// Pushes the points out of what is nearby, and notes where.
    void collide() {
        m_touched.clear();
        bool isInside = !m_step.nearby.empty();
        for (int pass = 0; pass < kContactPasses && isInside; ++pass) {
            isInside = false;
            m_touched.clear();
            for (size_t i = 0; i < m_last; ++i) {
                findNear(i);
                for (size_t k = i == 0 ? 0 : 1; k <= m_samples && !m_near.empty(); ++k)
                    isInside = collideAt(i, i * m_samples + k) || isInside;
            }
        }
    }

    /// Replaces the bends by the places that touched something.
    void findBends() {
        m_bends.clear();
        for (const auto& [sample, object] : m_touched) m_bends.push_back(bendOn(*object, placeOf(sample)));
    }

private:
    /// Inverse mass, in units of a point's.
    double weight(size_t i) const { return (i == 0 && m_step.ends[0]) || (i == m_last && m_step.ends[1]) ? 0.0 : 1.0; }

    void predict(double h) {
        for (size_t i = 0; i <= m_last; ++i) {
            RopePoint& point = m_points[i];
            m_before[i] = point.position;
            point.velocity = (point.velocity + m_step.gravity * h) * (1.0 - kDrag * h);
            point.position += point.velocity * h;
        }
    }

    /// What pushes a point out stops it, and gives it no speed: that would be as large as the depth is by chance.
    glm::dvec3 velocityOf(size_t i, double h) const {
        const glm::dvec3 velocity = (m_pulled[i] - m_before[i]) / h, push = m_points[i].position - m_pulled[i];
        const double depth = glm::length(push);
        if (depth == 0.0) return velocity;
        const glm::dvec3 out = push / depth;
        const double inward = glm::dot(m_carrying[i] - velocity, out);
        return velocity + out * std::clamp(inward, 0.0, depth / h);
    }

    void updateVelocities(double h) {
        for (size_t i = 0; i <= m_last; ++i) {
            glm::dvec3 velocity = velocityOf(i, h);
            const double speed = glm::length(velocity);
            if (!(speed < kMaxSpeed)) velocity = glm::dvec3(0.0);
            m_points[i].velocity = velocity;
        }
    }

    /// One pass over the segments. follow: the farther point of each takes the whole correction.
    void limitLengths(bool forward, bool follow) {
        for (size_t k = 0; k < m_last; ++k) {
            const size_t i = forward ? k : m_last - k, j = forward ? k + 1 : m_last - k - 1;
            const glm::dvec3 segment = m_points[j].position - m_points[i].position;
            const double length = glm::length(segment);
            if (length <= m_spacing) continue;
            double wi = weight(i), wj = weight(j);
            if (follow && wj > 0.0) wi = 0.0;
            if (wi + wj == 0.0) continue;
            const glm::dvec3 change = segment * ((length - m_spacing) / (length * (wi + wj)));
            m_points[i].position += change * wi;
            m_points[j].position -= change * wj;
        }
    }

    /// Finds the objects that segment i may touch on its way in the substep.
    void findNear(size_t i) {
        const double margin = m_step.radius + 2.0 * kTouchDistance;
        glm::dvec3 low(1e300), high(-1e300);
        for (const glm::dvec3& place : {m_before[i], m_before[i + 1], m_points[i].position, m_points[i + 1].position})
            low = glm::min(low, place - margin), high = glm::max(high, place + margin);
        m_near.clear();
        for (const CollisionObject* object : m_step.nearby) {
            const glm::dvec3 ahead = velocityAt(*object, m_before[i]) * m_ahead[0];
            if (!glm::any(glm::lessThan(glm::max(high, high + ahead), object->low)) &&
                !glm::any(glm::greaterThan(glm::min(low, low + ahead), object->high)))
                m_near.push_back(object);
        }
    }

    /// Places of the chain are numbered from end 0 to end 1.
    glm::dvec3 placeOf(size_t sample) const {
        const size_t i = std::min(sample / m_samples, m_last - 1);
        const double fraction = double(sample - i * m_samples) / double(m_samples);
        return m_points[i].position + (m_points[i + 1].position - m_points[i].position) * fraction;
    }
    /// Whether a place is as near to a held end as the end is deep, `times` as deep, and the rope's radius.
    bool isNearEnd(size_t sample, size_t end, double times) const {
        const double along = double(sample) * m_spacing / double(m_samples), way = end ? m_step.length - along : along;
        return m_step.ends[end] && way <= times * m_depth[end] + m_step.radius + kTouchDistance;
    }
    /// Whether a place of the rope is in a hole of an object that holds an end: the hole may leave it aslant.
    bool isInHole(size_t sample, const CollisionObject* object) const {
        return (object == m_holder[0] && isNearEnd(sample, 0, kAslant)) ||
               (object == m_holder[1] && isNearEnd(sample, 1, kAslant));
    }

    /// Pushes a place of segment i out of what is near, by moving the segment's two points. Returns whether it was
    /// inside anything.
    bool collideAt(size_t i, size_t sample) {
        if (isNearEnd(sample, 0, 1.0) || isNearEnd(sample, 1, 1.0)) return false;
        const double fraction = double(sample - i * m_samples) / double(m_samples);
        RopePoint &a = m_points[i], &b = m_points[i + 1];
        const glm::dvec3 place = a.position + (b.position - a.position) * fraction;
        const glm::dvec3 before = m_before[i] + (m_before[i + 1] - m_before[i]) * fraction;
        const double share = std::min(i == 0 && m_step.ends[0] ? fraction : 1.0,
                                      i + 1 == m_last && m_step.ends[1] ? 1.0 - fraction : 1.0);
        const double touch = share * kTouchDistance;
        glm::dvec3 out(0.0);
        const CollisionObject* touched = nullptr;
        for (const CollisionObject* object : m_near) {
            if (isInHole(sample, object)) continue;
            const glm::dvec3 velocity = velocityAt(*object, before);
            const glm::dvec3 exit =
                exitDisplacement(*object, before + velocity * m_ahead[0], place + out + velocity * m_ahead[1],
                                 share * (m_step.radius + kTouchDistance));
            if (exit != glm::dvec3(0.0)) out += exit, touched = object;
        }
        if (!touched) return false;
        m_touched.emplace_back(sample, touched);
        const double depth = glm::length(out) - touch;
        const double wa = weight(i) * (1.0 - fraction), wb = weight(i + 1) * fraction,
                     sum = wa * (1.0 - fraction) + wb * fraction;
        if (!(depth > 0.0) || sum < 1e-6) return false;
        out *= depth / (depth + touch);
        const glm::dvec3 normal = glm::normalize(out);
        const glm::dvec3 slid = place - before - normal * glm::dot(place - before, normal);
        const double slide = glm::length(slid);
        if (slide > 0.0) out -= slid * std::min(1.0, kFriction * depth / slide);
        a.position += out * (wa / sum);
        b.position += out * (wb / sum);
        m_carrying[i] = m_carrying[i + 1] = velocityAt(*touched, before);
        return depth > kTouchDistance;
    }

    static RopeBend bendOn(const CollisionObject& object, glm::dvec3 place) {
        if (!object.dynamic) return {place, {}, {}};
        return {place, object.dynamic->handle(), object.dynamic->pose().inversePoint(place)};
    }

    std::span<RopePoint> m_points;
    const RopeStep& m_step;
    std::vector<RopeBend>& m_bends;
    /// Seconds by which what is nearby is ahead of the points at the beginning and at the end of the substep: it is
    /// where it will be after the step. Places are carried on with it by so much before they are tested.
    std::array<double, 2> m_ahead{};
    size_t m_last;                                     ///< index of the last point
    double m_spacing;                                  ///< rest length of a segment, metres
    size_t m_samples = 1;                              ///< places on a segment that are kept out of voxels
    std::array<double, 2> m_depth{};                   ///< metres that an end is deep in what holds it
    std::array<const CollisionObject*, 2> m_holder{};  ///< that; null: the end is in nothing
    std::vector<glm::dvec3> m_before;                  ///< positions before the substep
    std::vector<glm::dvec3> m_pulled;                  ///< those before anything was pushed out, in this substep
    std::vector<glm::dvec3> m_carrying;                ///< velocities of what last pushed each point, m/s
    std::vector<const CollisionObject*> m_near;
    std::vector<std::pair<size_t, const CollisionObject*>> m_touched;  ///< places and what they touch, ascending
};

}  // namespace

void moveRope(std::span<RopePoint> points, const RopeStep& step, std::vector<RopeBend>& bends) {
    RopeSolver(points, step, bends).run();
}

void findBends(std::span<const RopePoint> points, const RopeStep& step, std::vector<RopeBend>& bends) {
    std::vector<RopePoint> copy(points.begin(), points.end());
    RopeSolver solver(copy, step, bends);
    solver.collide();
    solver.findBends();
}

}  // namespace rubble
