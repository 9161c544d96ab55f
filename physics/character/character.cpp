#include "physics/character/character.h"

#include <algorithm>
#include <cmath>

#include "runtime/voxel/grid_cast.h"

namespace rubble {
namespace {

constexpr double kSkin = 0.008;         ///< metres that it keeps from what it meets
constexpr int kMaxSlides = 4;           ///< walls that it follows in one step
constexpr int kMaxDepenetrations = 12;  ///< times that it is pushed out of what came into it
constexpr double kMaxSpeed = 60.0;      ///< m/s, falling
constexpr double kAirControl = 3.0;     ///< 1/s: how fast it comes to its wish without ground
constexpr double kSwimControl = 6.0;
constexpr double kChest = 0.6;       ///< of its height: under water there, it swims
constexpr double kLookAhead = 0.25;  ///< metres of level ground that a step must lead to
const glm::dvec3 kUp(0.0, 1.0, 0.0);

struct SweepHit {
    bool hit = false;
    double t = 1.0;  ///< of the displacement
    glm::dvec3 normal{0.0}, point{0.0};
    CollisionObject* object = nullptr;
    bool isFlat = false;   ///< a face that it can stand on is touched
    bool isSlope = false;  ///< and the normal is that face's
};

glm::dvec3 flat(glm::dvec3 v) {
    return {v.x, 0.0, v.z};
}

glm::dvec3 limited(glm::dvec3 v, double most) {
    const double length = glm::length(v);
    return length > most ? v * (most / length) : v;
}

glm::dvec3 velocityAt(const CollisionObject* object, glm::dvec3 point) {
    if (!object || !object->dynamic || object->dynamic->asleep()) return glm::dvec3(0.0);
    const SolverBody& motion = object->dynamic->motion;
    return motion.velocity + glm::cross(motion.angularVelocity, point - motion.position);
}

/// One character in one step.
class CharacterMover {
public:
    CharacterMover(Character& character, const CharacterSurroundings& around, std::vector<CharacterPush>& pushes)
        : m_c(character),
          m_around(around),
          m_pushes(pushes),
          m_steepest(1.0 / std::sqrt(1.0 + character.steepest * character.steepest)) {}

    void run(const std::vector<BodyHandle>& handles) {
        const CollisionObject* ground = findGround();
        const bool wasGrounded = m_c.grounded;
        const BodyHandle stoodOn = m_c.ground;
        if (m_c.grounded) moveWithGround(ground);
        depenetrate();
        crouch();
        const Water* water =
            m_around.waters ? m_around.waters->at(m_c.position + kUp * (kChest * m_c.currentHeight())) : nullptr;
        m_c.swimming = water != nullptr;
        if (m_c.swimming)
            swim(*water);
        else
            accelerate(ground);
        m_c.velocity = limited(m_c.velocity, kMaxSpeed);
        const bool walks = m_c.grounded && !m_c.swimming;
        const glm::dvec3 start = m_c.position;
        if (walks) {
            walk(m_c.velocity * m_around.seconds);
            m_c.velocity = flat(m_c.position - start) / m_around.seconds;
        } else
            slide(m_c.velocity * m_around.seconds, false, true);
        probeGround(walks, wasGrounded ? stoodOn : BodyHandle{}, handles);
    }

private:
    /// Its capsule in the cells of a part.
    CellShape capsule(const CollisionObject& object, size_t part, glm::dvec3 feet, double tall, double radius) const {
        const CellTransform& cells = object.cellTransforms()[part];
        const double size = object.collider.parts[part]->voxelSize();
        const glm::dvec3 corner = object.pose.position + cells.corner;
        const glm::dmat3 toCells = glm::transpose(cells.axes) / (size * size);
        CellShape shape;
        shape.a = toCells * (feet + kUp * m_c.radius - corner);
        shape.b = toCells * (feet + kUp * (tall - m_c.radius) - corner);
        shape.radius = radius / size;
        return shape;
    }
    template <class F>
    void forEachPart(F&& f) const {
        const CollisionFilter mine{m_c.collisionLayer, m_c.collisionMask};
        for (CollisionObject* object : m_around.objects)
            for (size_t i = 0; !(m_passesBodies && object->dynamic) && i < object->collider.parts.size(); ++i)
                if (object->collider.parts[i]->filter().meets(mine)) f(*object, i, *object->collider.parts[i]);
    }
    static glm::dvec3 toWorld(const CellTransform& cells, double size, glm::dvec3 normalCells) {
        return cells.axes * normalCells / size;
    }

    SweepHit sweep(glm::dvec3 from, glm::dvec3 displacement) const {
        SweepHit best;
        forEachPart([&](CollisionObject& object, size_t i, const VoxelPart& part) {
            const CellTransform& cells = object.cellTransforms()[i];
            const double size = part.voxelSize();
            const CellContact touch = castShape(part.grid(), capsule(object, i, from, m_c.currentHeight(), m_c.radius),
                                                glm::transpose(cells.axes) * displacement / (size * size), best.t);
            if (!touch.hit || (best.hit && touch.t >= best.t)) return;
            best = {true, touch.t, toWorld(cells, size, touch.normal),
                    object.pose.position + cells.corner + cells.axes * touch.point, &object};
            findFace(part, cells, touch, best);
        });
        return best;
    }
    /// Whether the point touched is on an exposed face that one can stand on: seams and edges of voxels are no slopes.
    void findFace(const VoxelPart& part, const CellTransform& cells, const CellContact& touch, SweepHit& out) const {
        for (int face = 0; face < 6; ++face) {
            const int axis = face >> 1, sign = face & 1 ? 1 : -1;
            glm::ivec3 outward(0);
            outward[axis] = sign;
            const double plane = touch.cell[axis] + (sign > 0 ? 1.0 : 0.0);
            if (std::abs(touch.point[axis] - plane) > 1e-6 || part.grid().at(touch.cell + outward)) continue;
            const glm::dvec3 normal = toWorld(cells, part.voxelSize(), glm::dvec3(outward));
            if (normal.y < m_steepest) continue;
            out.isFlat = true;
            out.isSlope = out.isSlope || glm::dot(normal, out.normal) > 0.999;
        }
    }
    bool isFree(glm::dvec3 feet, double tall) const {
        bool free = true;
        forEachPart([&](CollisionObject& object, size_t i, const VoxelPart& part) {
            free = free && !findOverlap(part.grid(), capsule(object, i, feet, tall, m_c.radius));
        });
        return free;
    }

    /// Goes as far as nothing is met, less the skin. Returns what stopped it.
    SweepHit advance(glm::dvec3 displacement) {
        const double length = glm::length(displacement);
        if (!(length > 1e-9)) return {};
        const SweepHit touch = sweep(m_c.position, displacement);
        m_c.position += displacement * (touch.hit ? std::max(0.0, touch.t - kSkin / length) : 1.0);
        return touch;
    }

    /// Follows what it meets. upright: slopes that are too steep, and edges, are walls. Returns true if something
    /// stopped it.
    bool slide(glm::dvec3 displacement, bool upright, bool changesVelocity) {
        std::array<glm::dvec3, kMaxSlides> walls{};
        bool stopped = false;
        const glm::dvec3 wished = displacement;
        for (int i = 0; i < kMaxSlides; ++i) {
            const glm::dvec3 from = m_c.position;
            const SweepHit touch = advance(displacement);
            if (!touch.hit) break;
            displacement -= m_c.position - from;
            glm::dvec3 normal = touch.normal;
            if (upright && !touch.isSlope) {
                normal = flat(normal);
                const double length = glm::length(normal);
                normal = length > 1e-6 ? normal / length : flat(-wished) / std::max(glm::length(flat(wished)), 1e-9);
                stopped = true;
            }
            push(touch, -normal);
            walls[size_t(i)] = normal;
            if (changesVelocity)
                m_c.velocity -=
                    normal * std::min(0.0, glm::dot(m_c.velocity - velocityAt(touch.object, touch.point), normal));
            displacement -= normal * std::min(0.0, glm::dot(displacement, normal));
            for (int k = 0; k < i; ++k) {  // into a corner: along it, or nowhere
                if (glm::dot(displacement, walls[size_t(k)]) >= -1e-9) continue;
                const glm::dvec3 corner = glm::cross(walls[size_t(k)], normal);
                const double length = glm::length(corner);
                displacement = length > 1e-6 && !upright ? corner / length * (glm::dot(displacement, corner) / length)
                                                         : glm::dvec3(0.0);
            }
            if (glm::dot(displacement, wished) <= 0.0) break;
        }
        return stopped;
    }

    /// Along the ground, and up a step where there is one that leads somewhere.
    void walk(glm::dvec3 displacement) {
        displacement = flat(displacement);
        if (displacement == glm::dvec3(0.0)) return;
        const glm::dvec3 start = m_c.position;
        const size_t pushed = m_pushes.size();
        if (!slide(displacement, true, false)) return;
        const glm::dvec3 slid = m_c.position;
        const double before = glm::length(flat(slid - start));
        m_c.position = start;
        const glm::dvec3 forward = displacement / glm::length(displacement);
        advance(kUp * m_c.stepHeight);
        const double climbed = m_c.position.y - start.y;
        const glm::dvec3 lifted = m_c.position;
        const SweepHit ahead = advance(displacement);
        const double after = glm::length(flat(m_c.position - lifted));
        const glm::dvec3 reached = m_c.position;
        const SweepHit step = sweep(reached, -kUp * (climbed + kSkin));
        const double rise = climbed - step.t * (climbed + kSkin);
        if (ahead.hit && ahead.object->dynamic == nullptr && after <= before + 1e-6) return stay(slid);
        if (!step.hit || !step.isFlat || step.point.y > start.y + m_c.stepHeight + kSkin || after <= before + 1e-6 ||
            rise <= 0.0)
            return stay(slid);
        m_c.position = reached - kUp * std::max(0.0, step.t * (climbed + kSkin) - kSkin);
        if (sweep(m_c.position + kUp * (m_c.steepest * kLookAhead + kSkin), forward * kLookAhead).hit)
            return stay(slid);
        if (sweep(m_c.position, kUp * (m_c.steepest * kLookAhead + kSkin)).hit) return stay(slid);
        m_pushes.resize(pushed);  // over it, not against it
    }
    void stay(glm::dvec3 at) { m_c.position = at; }

    void push(const SweepHit& touch, glm::dvec3 direction) {
        if (!touch.object || !touch.object->dynamic) return;
        DynamicBody& body = *touch.object->dynamic;
        const double speed = glm::dot(m_c.velocity - velocityAt(touch.object, touch.point), direction);
        if (speed <= 0.0 || body.quarantined()) return;
        const double most = speed / (body.motion.inverseMass + 1.0 / m_c.mass);
        m_pushes.push_back(
            {&body, direction * std::min(most, m_c.pushForce * m_around.seconds), touch.point, most > 1e-3});
    }

    CollisionObject* findGround() const {
        if (!m_c.ground) return nullptr;
        for (CollisionObject* object : m_around.objects)
            if (object->dynamic && object->dynamic->handle() == m_c.ground) return object;
        return nullptr;
    }
    void moveWithGround(const CollisionObject* ground) {
        if (!ground || ground->dynamic->asleep()) return;
        const glm::dvec3 there =
            ground->dynamic->bodyPose().transformPoint(ground->dynamic->state().pose.inversePoint(m_c.position));
        const glm::dvec3 displacement = there - m_c.position;
        m_passesBodies = true;
        if (displacement.y > 0.0) advance(kUp * displacement.y);
        slide(flat(displacement), false, false);
        if (displacement.y < 0.0) advance(kUp * displacement.y);
        m_passesBodies = false;
    }

    /// Out of what came into it: what moves first, what stands still has the last word. What cannot be left stays where
    /// it is.
    void depenetrate() {
        const glm::dvec3 start = m_c.position;
        for (int i = 0; i < kMaxDepenetrations; ++i) {
            SweepHit worst;
            double depth = 0.0;
            forEachPart([&](CollisionObject& object, size_t part, const VoxelPart& solid) {
                const CellTransform& cells = object.cellTransforms()[part];
                const double size = solid.voxelSize(), wide = m_c.radius + 0.5 * kSkin;
                const CellContact touch =
                    findDeepest(solid.grid(), capsule(object, part, m_c.position, m_c.currentHeight(), wide));
                const double here = touch.hit ? wide - touch.t * size : 0.0;
                const bool outranks = object.dynamic == nullptr && worst.object && worst.object->dynamic;
                if (here <= 1e-6 || (worst.hit && here <= depth && !outranks) ||
                    (worst.object && !worst.object->dynamic && object.dynamic))
                    return;
                depth = here;
                worst = {true, 0.0, toWorld(cells, size, touch.normal),
                         object.pose.position + cells.corner + cells.axes * touch.point, &object};
            });
            if (!worst.hit) return;
            if (worst.normal == glm::dvec3(0.0)) worst.normal = kUp;
            if (worst.object->dynamic) {
                const double speed = glm::dot(velocityAt(worst.object, worst.point) - m_c.velocity, worst.normal);
                if (speed > 0.0) {
                    const double given = std::min(speed, speed / worst.object->dynamic->motion.inverseMass / m_c.mass);
                    push(worst, -worst.normal);
                    m_c.velocity += worst.normal * given;
                }
                if (worst.normal.y < -0.5 && m_c.grounded) worst.normal = flat(worst.normal);  // never into the ground
                const double length = glm::length(worst.normal);
                m_passesBodies = true;
                if (length > 1e-6) slide(worst.normal / length * (depth + 1e-4), false, false);
                m_passesBodies = false;
            } else {
                m_c.position += worst.normal * (depth + 1e-4);
            }
        }
        if (!isFreeOfStatic(m_c.position) && isFreeOfStatic(start)) m_c.position = start;
    }
    bool isFreeOfStatic(glm::dvec3 feet) const {
        bool free = true;
        forEachPart([&](CollisionObject& object, size_t i, const VoxelPart& part) {
            free = free && (object.dynamic ||
                            !findOverlap(part.grid(), capsule(object, i, feet, m_c.currentHeight(), m_c.radius)));
        });
        return free;
    }

    void crouch() {
        if (m_c.wantsCrouch)
            m_c.crouched = true;
        else if (m_c.crouched && isFree(m_c.position, m_c.height + kSkin))
            m_c.crouched = false;
    }

    /// What it wants to do on the ground and in the air.
    void accelerate(const CollisionObject* ground) {
        const glm::dvec3 wish = limited(flat(m_c.wish), m_c.crouched ? m_c.crouchSpeed : m_c.walkSpeed);
        if (!m_c.grounded) {
            const double share = kAirControl * m_around.seconds;
            m_c.velocity += (wish - flat(m_c.velocity)) * share + m_around.gravity * m_around.seconds;
            return;
        }
        m_c.velocity = wish;
        if (!m_c.wantsJump) return;
        m_c.velocity += velocityAt(ground, m_c.position);
        m_c.velocity.y += m_c.jumpSpeed;
        m_c.grounded = false;
    }
    void swim(const Water& water) {
        const glm::dvec3 wish = limited(m_c.wish, m_c.swimSpeed) + water.flow;
        m_c.velocity += (wish - m_c.velocity) * std::min(1.0, kSwimControl * m_around.seconds);
        const bool headIsOut = m_c.position.y + 1.2 * m_c.currentHeight() > water.surface;
        if (m_c.wantsJump && headIsOut) m_c.velocity.y = m_c.jumpSpeed;
        m_c.grounded = false;
    }

    /// Finds what it stands on: a step below while it walks, else what it has come down on.
    void probeGround(bool walks, BodyHandle stoodOn, const std::vector<BodyHandle>& handles) {
        m_c.grounded = false;
        m_c.ground = {};
        const double queryDistance = walks ? m_c.stepHeight + 2.0 * kSkin : 2.0 * kSkin;
        const SweepHit touch = sweep(m_c.position, -kUp * queryDistance);
        const double rising = walks ? 0.0 : m_c.velocity.y - velocityAt(touch.object, touch.point).y;
        if (!touch.hit || m_c.swimming || rising > 0.1) return;
        if (!touch.isFlat) return;
        const double drop = touch.t * queryDistance;
        if (drop > kSkin) m_c.position.y -= drop - kSkin;
        m_c.grounded = true;
        m_c.ground = touch.object->body < handles.size() ? handles[touch.object->body] : BodyHandle{};
        m_c.velocity = flat(m_c.velocity);
        DynamicBody* body = touch.object->dynamic;
        if (!body || body->quarantined()) return;
        const glm::dvec3 fall = kUp * std::min(0.0, rising) * m_c.mass / (1.0 + m_c.mass * body->motion.inverseMass);
        const bool isNew = stoodOn != m_c.ground;
        if (isNew || !body->asleep())
            m_pushes.push_back({body, m_around.gravity * (m_c.mass * m_around.seconds) + fall, touch.point, isNew});
    }

    Character& m_c;
    const CharacterSurroundings& m_around;
    std::vector<CharacterPush>& m_pushes;
    bool m_passesBodies = false;  ///< only what stands still is in its displacement
    double m_steepest;            ///< least vertical part of the normal of a face that it can stand on
};

}  // namespace

double characterQueryRadius(const Character& character, double seconds) {
    return character.radius + character.stepHeight + glm::length(character.velocity) * seconds +
           character.walkSpeed * seconds + 1.0;
}

void moveCharacter(Character& character, const CharacterSurroundings& around, const std::vector<BodyHandle>& handles,
                   std::vector<CharacterPush>& pushes) {
    CharacterMover(character, around, pushes).run(handles);
}

}  // namespace rubble
