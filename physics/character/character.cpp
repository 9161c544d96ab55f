#include "physics/character/character.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/character/character_queries.h"
#include "physics/math/clamp_length.h"
#include "runtime/core/ranges.h"

// A kinematic character: a capsule that collides and slides (after Fauerby, "Improved Collision detection and
// Response", 2003, and the movement code of Quake).
//
// Sliding: sweep the capsule along the wished displacement d. At a contact with the normal n, stop a skin's width
// before it and remove the part of the rest of d that goes into it: d -= n min(0, d . n). Sweep again, a few times. If
// d then goes into an earlier wall with the normal m, it may only follow the corner: d becomes its part along m x n.
// What is steeper than the character can climb is a vertical wall: n loses its y.
//
// Stepping: when sliding along the ground was stopped, try again lifted by the step height above what it stands on,
// then sweep down. The step counts if it leads farther and onto a face that can be stood on, on which a foot finds
// place: what counts is the depth of the tread, not the space for the whole capsule, which may reach over several
// treads.
//
// The order of a step: move with the ground; push out of what came into the capsule, of dynamic bodies first and of
// static ones last; choose the velocity from the wish (ground, air or water); move; look for ground. Since every sweep
// ends a skin's width short, the capsule is never inside something static. Bodies get impulses, as from a mass that
// pushes with a limited force.
//
// On the ground its velocity is that against the ground. What it walks on gets the opposite of what that gives it and
// of what it pushes other bodies with: a raft goes back under who runs. Nothing in a step pushes a body from within, so
// who leans on the wall of a cabin moves it by no more than he moves himself. Of a body that can move, the legs only
// take so much in a step that they do not kick it away. What carries it does not feel its inertia, nor that it jumps
// off; and a body that is heavier than its push goes through it, and leaves it on top.
//
// Characters are no obstacles for each other: those that overlap go apart, each by the share of the other's mass.
//
// What it stands on bears its weight. A sleeping body came to rest under the load that it had; it wakes when that load
// comes, goes, or moves into another cell of the body's frame. So it can tip, and who stands still lets it sleep.

namespace rubble {
namespace {

constexpr double kSkin = 0.008;             ///< metres kept from what it meets
constexpr int kMaxSlides = 4;               ///< walls that it follows in one step
constexpr int kMaxDepenetrations = 12;      ///< pushes out of what came into it
constexpr double kMaxSpeed = 60.0;          ///< m/s, falling
constexpr double kAirControl = 3.0;         ///< 1/s: rate at which the velocity follows a wish without ground
constexpr double kSwimControl = 6.0;        ///< 1/s, in water
constexpr double kChest = 0.6;              ///< fraction of its height: under water there, it swims
constexpr double kMinTread = 0.19;          ///< metres that a step is deep at least: 0.2, less what rounding may take
constexpr double kJumpOutHeight = 1.2;      ///< fraction of its height: it jumps out of water whose surface is lower
constexpr double kMaxLandingRise = 0.1;     ///< m/s away from the ground, above which it does not land
constexpr double kMinFall = 0.01;           ///< m/s in a step by which ground that falls away gets faster than it falls
constexpr double kMinCarryingShare = 0.25;  ///< of the character's mass: what is lighter does not take it along
constexpr double kMaxKick = 0.25;  ///< m/s that a step on a body may give it, if that is more than the push force
constexpr double kMinWakeImpulse = 1e-3;  ///< N s: a weaker push wakes no body
constexpr double kLoadCell = 0.1;         ///< metres; a body bears another load when the feet are in another such cell
constexpr double kQueryMargin = 1.0;      ///< metres, for what ground, gravity and pushes add to its own motion

glm::dvec3 horizontal(glm::dvec3 v) {
    return {v.x, 0.0, v.z};
}

glm::dvec3 velocityOf(const CollisionObject* object, glm::dvec3 point) {
    return object ? velocityAt(*object, point) : glm::dvec3(0.0);
}

/// One character in one step.
class CharacterMover {
public:
    CharacterMover(Character& character, const CharacterSurroundings& around, std::vector<CharacterPush>& pushes)
        : m_c(character), m_around(around), m_pushes(pushes), m_queries(character, around) {}

    void run(const std::vector<BodyHandle>& handles) {
        CollisionObject* const ground = groundObject();
        const bool wasGrounded = m_c.grounded;
        const BodyHandle stoodOn = m_c.ground;
        if (wasGrounded) followGround(ground);
        const glm::dvec3 velocity = m_c.velocity;
        if (m_c.grounded && !m_c.wantsJump) moveWithGround(ground);  // who jumps gets its velocity
        depenetrate();
        makeRoom();
        crouch();
        const Water* water =
            m_around.waters ? m_around.waters->at(m_c.position + kUp * (kChest * m_c.currentHeight())) : nullptr;
        m_c.swimming = water != nullptr;
        if (m_c.swimming)
            leaveGround(), swim(*water);
        else
            accelerate();
        m_c.velocity = clampedLength(m_c.velocity, kMaxSpeed);
        const bool walks = m_c.grounded && !m_c.swimming;
        const glm::dvec3 start = m_c.position;
        if (walks) {
            walk(m_c.velocity * m_around.seconds);
            m_c.velocity = horizontal(m_c.position - start) / m_around.seconds;
            pushBack(m_c.velocity - horizontal(velocity), start);
        } else
            slide((m_c.velocity - 0.5 * m_fall) * m_around.seconds, false, true);
        probeGround(walks, wasGrounded ? stoodOn : BodyHandle{}, start, handles);
        if (ground && m_c.ground != stoodOn && !ground->dynamic->quarantined())
            m_pushes.push_back({ground->dynamic, glm::dvec3(0.0), start, false, true});
        m_c.velocity = clampedLength(m_c.velocity, ranges::kMaxCharacterSpeed);  // it may have taken on a body's
        m_c.groundVelocity = clampedLength(m_c.groundVelocity, ranges::kMaxCharacterSpeed);
    }

private:
    /// m/s, world.
    glm::dvec3 worldVelocity() const { return m_c.grounded ? m_c.velocity + m_groundVelocity : m_c.velocity; }
    void leaveGround() {
        m_c.velocity = worldVelocity();
        m_c.grounded = false;
    }

    /// Moves until something is hit, and stops a skin's width before it. Returns what it hit.
    CharacterHit advance(glm::dvec3 displacement) {
        const double length = glm::length(displacement);
        if (!(length > 1e-9)) return {};
        const CharacterHit hit = m_queries.sweep(m_c.position, displacement);
        m_c.position += displacement * (hit.hit ? std::max(0.0, hit.t - kSkin / length) : 1.0);
        return hit;
    }

    /// Moves and follows what it hits. upright: slopes that are too steep, and edges, are walls. Returns whether such a
    /// wall stopped it.
    bool slide(glm::dvec3 displacement, bool upright, bool changesVelocity) {
        std::array<glm::dvec3, kMaxSlides> walls{};
        bool stopped = false;
        const glm::dvec3 wished = displacement;
        for (int i = 0; i < kMaxSlides; ++i) {
            const glm::dvec3 from = m_c.position;
            const CharacterHit hit = advance(displacement);
            if (!hit.hit) break;
            displacement -= m_c.position - from;
            glm::dvec3 normal = hit.normal;
            if (upright && !hit.isSlope) {
                normal = wallNormal(normal, wished);
                stopped = true;
            }
            push(hit, -normal);
            walls[size_t(i)] = normal;
            if (changesVelocity)
                m_c.velocity -=
                    normal * std::min(0.0, glm::dot(m_c.velocity - velocityOf(hit.object, hit.point), normal));
            displacement -= normal * std::min(0.0, glm::dot(displacement, normal));
            for (int k = 0; k < i; ++k)
                if (glm::dot(displacement, walls[size_t(k)]) < -1e-9)
                    displacement = alongCorner(displacement, walls[size_t(k)], normal, upright);
            if (glm::dot(displacement, wished) <= 0.0) break;
        }
        return stopped;
    }
    /// The horizontal part of a normal, as a unit vector; against the wished displacement if there is none.
    static glm::dvec3 wallNormal(glm::dvec3 normal, glm::dvec3 wished) {
        normal = horizontal(normal);
        const double length = glm::length(normal);
        return length > 1e-6 ? normal / length : horizontal(-wished) / std::max(glm::length(horizontal(wished)), 1e-9);
    }
    /// The part of a displacement along the line in which two walls meet; zero for upright walls, as it is vertical.
    static glm::dvec3 alongCorner(glm::dvec3 displacement, glm::dvec3 wall, glm::dvec3 normal, bool upright) {
        const glm::dvec3 corner = glm::cross(wall, normal);
        const double length = glm::length(corner);
        return length > 1e-6 && !upright ? corner / length * (glm::dot(displacement, corner) / length)
                                         : glm::dvec3(0.0);
    }

    /// Walks along the ground, and up steps that lead somewhere: in parts no longer than its radius, each of which
    /// meets one step at most.
    void walk(glm::dvec3 displacement) {
        displacement = horizontal(displacement);
        const double parts = std::max(1.0, std::ceil(glm::length(displacement) / m_c.radius));
        for (double i = 0.0; i < parts; ++i) walkPart(displacement / parts);
    }
    void walkPart(glm::dvec3 displacement) {
        if (displacement == glm::dvec3(0.0)) return;
        const glm::dvec3 start = m_c.position;
        const size_t pushed = m_pushes.size();
        if (!slide(displacement, true, false)) return;
        const glm::dvec3 slid = m_c.position;
        const size_t pushedThere = m_pushes.size();
        m_c.position = start;
        const bool climbed = climbStep(displacement, start, glm::length(horizontal(slid - start)));
        if (climbed)
            m_pushes.resize(pushed);  // it went over the step and pushed nothing
        else
            m_pushes.resize(pushedThere), m_c.position = slid;
    }
    /// Tries the displacement again, lifted by the step height above what it stands on, then lowered onto what is
    /// there. before: metres that it got without that. False if there is no step, or if it leads no farther.
    bool climbStep(glm::dvec3 displacement, glm::dvec3 start, double before) {
        const CharacterHit under = m_queries.sweep(start, -kUp * (2.0 * kSkin));
        const double highest = (under.hit ? under.point.y : start.y) + m_c.stepHeight + kSkin;
        advance(kUp * (highest - start.y));
        const glm::dvec3 lifted = m_c.position;
        slide(displacement, true, false);
        const glm::dvec3 reached = m_c.position, way = horizontal(reached - lifted);
        if (glm::length(way) <= before + 1e-6) return false;
        const double climbed = reached.y - start.y;
        const CharacterHit step = m_queries.sweep(reached, -kUp * (climbed + kSkin));
        const double drop = step.t * (climbed + kSkin);
        if (!step.hit || !step.isFlat || step.point.y > highest || drop >= climbed) return false;
        m_c.position = reached - kUp * std::max(0.0, drop - kSkin);
        return isTread(step.point, lifted, way);
    }
    /// Whether a foot finds place behind the edge of a step, or whether the steps are together no steeper than it can
    /// climb. point: on the step. from, way: how its axis came there, horizontally.
    bool isTread(glm::dvec3 point, glm::dvec3 from, glm::dvec3 way) const {
        const glm::dvec3 forward = way / glm::length(way);
        const glm::dvec3 below(from.x, point.y - kSkin, from.z);
        const double edge = m_queries.castPoint(below, way);  // that its axis has passed, if any
        if (edge < 1.0) point = below + way * edge;
        point.y += m_c.maxSlope * kMinTread + 2.0 * kSkin;
        return m_queries.castPoint(point, forward * kMinTread) == 1.0;
    }

    /// Pushes the body that it hit, with at most its push force.
    void push(const CharacterHit& hit, glm::dvec3 direction) {
        if (!hit.object || !hit.object->dynamic) return;
        DynamicBody& body = *hit.object->dynamic;
        const double speed = glm::dot(worldVelocity() - velocityOf(hit.object, hit.point), direction);
        if (speed <= 0.0 || body.quarantined() || hit.object == m_ground) return;
        const double impulse = speed / (body.motion.inverseMass + 1.0 / m_c.mass);  // that makes both equally fast
        m_pushes.push_back({&body, direction * std::min(impulse, m_c.maxPushForce * m_around.seconds), hit.point,
                            impulse > kMinWakeImpulse});
    }

    /// What a step on the ground moves: the inverse of its mass where the foot is, along a unit vector, 1/kg; 0:
    /// nothing.
    double groundMobility(glm::dvec3 direction, glm::dvec3 feet) const {
        if (!m_ground || m_ground->dynamic->quarantined()) return 0.0;
        const SolverBody& motion = m_ground->dynamic->motion;
        const glm::dvec3 arm = glm::cross(feet - motion.position, direction);
        return motion.inverseMass + glm::dot(arm, worldInverseInertia(motion) * arm);
    }
    /// As much of a change of the velocity on the ground as its legs can do in a step.
    glm::dvec3 possibleChange(glm::dvec3 change) const {
        const double speed = glm::length(change);
        const double mobility = speed > 0.0 ? groundMobility(change / speed, m_c.position) : 0.0;
        if (mobility == 0.0) return change;
        const double impulse = speed / (mobility + 1.0 / m_c.mass),
                     most = std::max(m_c.maxPushForce * m_around.seconds, kMaxKick / mobility);
        return change * std::min(1.0, most / impulse);
    }
    /// Gives the ground the opposite of what changed the velocity on it, and of what pushed other bodies.
    void pushBack(glm::dvec3 change, glm::dvec3 feet) {
        const double speed = glm::length(change);
        const double mobility = groundMobility(speed > 0.0 ? change / speed : kUp, feet);
        if (mobility == 0.0) return;
        glm::dvec3 impulse = change / -(mobility + 1.0 / m_c.mass);
        for (const CharacterPush& push : m_pushes)
            if (push.body != m_ground->dynamic) impulse -= push.impulse;
        if (glm::length(impulse) > kMinWakeImpulse) m_pushes.push_back({m_ground->dynamic, impulse, feet, true});
    }

    /// The dynamic body that it stood on; null: none.
    CollisionObject* groundObject() const {
        if (!m_c.ground) return nullptr;
        for (CollisionObject* object : m_around.objects)
            if (object->dynamic && object->dynamic->handle() == m_c.ground) return object;
        return nullptr;
    }
    /// Whether a body takes along who stands on it. A flying crumb under the feet does not.
    bool carries(const CollisionObject& object) const {
        return !object.dynamic || object.dynamic->motion.inverseMass * kMinCarryingShare * m_c.mass <= 1.0;
    }
    /// The velocity of a ground under the feet, as far as it takes the character along.
    glm::dvec3 carryingVelocity(const CollisionObject* ground) const {
        const glm::dvec3 velocity = velocityOf(ground, m_c.position);
        return !ground || carries(*ground) ? velocity : kUp * std::min(velocity.y, 0.0);
    }
    /// Takes over the velocity of the ground, unless that is gone or falls away under it: nothing pulls a character
    /// down faster than it falls.
    void followGround(CollisionObject* ground) {
        m_ground = ground;
        m_groundVelocity = m_c.groundVelocity;
        if (!ground && m_groundVelocity != glm::dvec3(0.0)) return leaveGround();
        const double falling = m_groundVelocity.y + std::min(0.0, m_around.gravity.y) * m_around.seconds;
        m_groundVelocity = carryingVelocity(ground);
        m_groundFalls = m_groundVelocity.y < falling - kMinFall;
        if (m_groundFalls) m_groundVelocity.y = falling;
    }
    /// Moves by as much as the ground has moved under its feet in this step.
    void moveWithGround(const CollisionObject* ground) {
        if (!ground || ground->dynamic->asleep()) return;
        const glm::dvec3 there =
            ground->dynamic->bodyPose().transformPoint(ground->dynamic->state().pose.inversePoint(m_c.position));
        glm::dvec3 displacement = there - m_c.position;
        if (!carries(*ground)) displacement = kUp * std::min(displacement.y, 0.0);
        if (m_groundFalls) displacement.y = 0.5 * (m_c.groundVelocity.y + m_groundVelocity.y) * m_around.seconds;
        m_queries.setIgnoresBodies(true);
        if (displacement.y > 0.0) advance(kUp * displacement.y);
        slide(horizontal(displacement), false, false);
        if (displacement.y < 0.0) advance(kUp * displacement.y);
        m_queries.setIgnoresBodies(false);
    }

    /// Moves out of what came into the capsule. If something static cannot be left, it stays where it is.
    void depenetrate() {
        const glm::dvec3 start = m_c.position;
        for (int i = 0; i < kMaxDepenetrations; ++i) {
            double depth = 0.0;
            CharacterHit worst = m_queries.findDeepest(m_c.position, 0.5 * kSkin, depth);
            if (!worst.hit) return;
            if (worst.normal == glm::dvec3(0.0)) worst.normal = kUp;
            if (worst.object->dynamic)
                moveOutOfBody(worst, depth);
            else
                m_c.position += worst.normal * (depth + 1e-4);
        }
        if (!m_queries.isFreeOfStatic(m_c.position) && m_queries.isFreeOfStatic(start)) m_c.position = start;
    }
    /// Moves out of a body. One that comes closer passes on its velocity.
    void moveOutOfBody(CharacterHit& worst, double depth) {
        const double speed = glm::dot(velocityOf(worst.object, worst.point) - worldVelocity(), worst.normal);
        if (speed > 0.0) {
            const double gain = std::min(speed, speed / worst.object->dynamic->motion.inverseMass / m_c.mass);
            push(worst, -worst.normal);
            m_c.velocity += worst.normal * gain;
        }
        if (worst.normal.y < -0.5 && m_c.grounded) worst.normal = horizontal(worst.normal);  // never into the ground
        const double length = glm::length(worst.normal);
        m_queries.setIgnoresBodies(true);
        if (length > 1e-6) slide(worst.normal / length * (depth + 1e-4), false, false);
        m_queries.setIgnoresBodies(false);
    }

    /// Goes sideways by its share of what it overlaps other characters by; they do the rest in their turn.
    void makeRoom() {
        const CollisionFilter mine{m_c.collisionLayer, m_c.collisionMask};
        for (const Character* other : m_around.others) {
            const glm::dvec3 away = m_c.position - other->position;
            const double distance = glm::length(horizontal(away)), overlap = m_c.radius + other->radius - distance;
            const bool isBeside = away.y < other->currentHeight() && away.y > -m_c.currentHeight();
            if (overlap <= 0.0 || !isBeside || !mine.meets({other->collisionLayer, other->collisionMask})) continue;
            // Of two in one place, the one before in their array goes to the left.
            const glm::dvec3 direction =
                distance > 1e-6 ? horizontal(away) / distance : glm::dvec3(&m_c < other ? -1.0 : 1.0, 0.0, 0.0);
            slide(direction * (overlap * other->mass / (m_c.mass + other->mass)), true, false);
        }
    }

    void crouch() {
        if (m_c.wantsCrouch)
            m_c.crouched = true;
        else if (m_c.crouched && m_queries.isFree(m_c.position, m_c.height + kSkin))
            m_c.crouched = false;
    }

    /// Sets the velocity that it wishes on the ground. In the air its velocity along the wish tends to that, and
    /// nothing slows it down otherwise: who jumps on a train, or walks off its side, goes on with it.
    void accelerate() {
        if (m_c.grounded && m_around.gravity.y > 0.0) leaveGround();
        const glm::dvec3 wish = clampedLength(horizontal(m_c.wish), m_c.crouched ? m_c.crouchSpeed : m_c.walkSpeed);
        if (m_c.grounded && !m_c.wantsJump) {
            m_c.velocity = horizontal(m_c.velocity);
            m_c.velocity += possibleChange(wish - m_c.velocity);
            return;
        }
        if (m_c.grounded) {
            m_c.velocity = wish;
            leaveGround();
            m_c.velocity.y += m_c.jumpSpeed;
        } else if (const double speed = glm::length(wish); speed > 0.0) {
            const double missing = std::max(0.0, speed - glm::dot(m_c.velocity, wish) / speed);
            m_c.velocity += wish / speed * (missing * kAirControl * m_around.seconds);
        }
        m_fall = m_around.gravity * m_around.seconds;
        m_c.velocity += m_fall;
    }
    void swim(const Water& water) {
        const glm::dvec3 wish = clampedLength(m_c.wish, m_c.swimSpeed) + water.flow;
        m_c.velocity += (wish - m_c.velocity) * std::min(1.0, kSwimControl * m_around.seconds);
        const bool canJumpOut = m_c.position.y + kJumpOutHeight * m_c.currentHeight() > water.surface;
        if (m_c.wantsJump && canJumpOut) m_c.velocity.y = m_c.jumpSpeed;
    }

    /// Finds what it stands on: within a step's height below while it walks, else what it has landed on.
    /// start: where this step's motion began.
    void probeGround(bool walks, BodyHandle stoodOn, glm::dvec3 start, const std::vector<BodyHandle>& handles) {
        leaveGround();
        m_c.ground = {};
        m_c.groundVelocity = glm::dvec3(0.0);
        // Bodies have moved before it: above one that lifts it, it has risen once more by the velocity of that.
        const double risen = std::max(0.0, m_c.velocity.y) * m_around.seconds;
        const double queryDistance = walks && !m_groundFalls ? m_c.stepHeight + 2.0 * kSkin : 2.0 * kSkin + risen;
        const CharacterHit hit = m_queries.sweep(m_c.position, -kUp * queryDistance);
        const bool fallsAway = m_groundFalls && hit.object == m_ground;
        const double rising = walks ? 0.0 : m_c.velocity.y - velocityOf(hit.object, hit.point).y;
        if (!hit.hit || !hit.isFlat || m_c.swimming || rising > kMaxLandingRise) return;
        if (m_around.gravity.y > 0.0) return;  // it falls upward
        const double drop = hit.t * queryDistance;
        if (drop > kSkin && !fallsAway) m_c.position.y -= drop - kSkin;
        m_c.grounded = true;
        m_c.ground = hit.object->body < handles.size() ? handles[hit.object->body] : BodyHandle{};
        DynamicBody* body = hit.object->dynamic;
        const glm::dvec3 groundVelocity = hit.object == m_ground ? m_groundVelocity : carryingVelocity(hit.object);
        m_c.velocity = horizontal(m_c.velocity - groundVelocity);
        m_c.groundVelocity = groundVelocity;
        if (!body || body->quarantined() || fallsAway) return;
        const glm::dvec3 fall = kUp * std::min(0.0, rising) * m_c.mass / (1.0 + m_c.mass * body->motion.inverseMass);
        const bool changes = stoodOn != m_c.ground || loadCell(*body, start) != loadCell(*body, m_c.position);
        if (changes || !body->asleep())
            m_pushes.push_back(
                {body, m_around.gravity * (m_c.mass * m_around.seconds) + fall, hit.point, false, changes});
    }
    static glm::dvec3 loadCell(const DynamicBody& body, glm::dvec3 feet) {
        return glm::floor(body.bodyPose().inversePoint(feet) / kLoadCell);
    }

    Character& m_c;
    const CharacterSurroundings& m_around;
    std::vector<CharacterPush>& m_pushes;
    CharacterQueries m_queries;
    CollisionObject* m_ground = nullptr;  ///< the dynamic body on which it stood when the step began
    glm::dvec3 m_groundVelocity{0.0};     ///< there, m/s; of a ground that falls away, its own downward
    bool m_groundFalls = false;           ///< the ground falls away under it
    glm::dvec3 m_fall{0.0};               ///< m/s that gravity has given it in this step
};

}  // namespace

double characterQueryRadius(const Character& character, double seconds) {
    return character.radius + character.stepHeight + glm::length(character.velocity) * seconds +
           character.walkSpeed * seconds + kQueryMargin;
}

void moveCharacter(Character& character, const CharacterSurroundings& around, const std::vector<BodyHandle>& handles,
                   std::vector<CharacterPush>& pushes) {
    CharacterMover(character, around, pushes).run(handles);
}

}  // namespace rubble
