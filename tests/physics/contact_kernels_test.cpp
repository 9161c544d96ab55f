#include "physics/solver/contact_kernels.h"

#include <gtest/gtest.h>

#include <cstring>
#include <deque>
#include <numeric>

#include "physics/collision/round_contacts.h"
#include "physics/solver/contact_setup.h"
#include "physics/solver/lane_packing.h"
#include "runtime/core/random.h"

namespace rubble {
namespace {

glm::dvec3 randomVector(Random& random, double size) {
    const double x = random.unit() - 0.5, y = random.unit() - 0.5, z = random.unit() - 0.5;
    return glm::dvec3(x, y, z) * (2.0 * size);
}

/// Bodies at random, of which many touch: fast and slow ones, with 1 to 12 points, some of them round.
struct Heap {
    explicit Heap(int count) {
        Random random(3);
        bodies.resize(size_t(count) + 1);
        for (size_t i = 1; i < bodies.size(); ++i) {
            SolverBody& body = bodies[i];
            body.position = randomVector(random, 5.0);
            body.velocity = randomVector(random, i % 3 ? 0.1 : 3.0);
            body.angularVelocity = randomVector(random, i % 5 ? 0.1 : 4.0);
            body.rotation = glm::normalize(glm::dquat(1.0, randomVector(random, 1.0)));
            body.inverseMass = 0.1 + random.unit();
            body.inertia = glm::dvec3(0.5) + randomVector(random, 0.3);
            body.conservesMomentum = i % 7 == 0;
        }
        prepareStates(set, bodies);
        for (int i = 0; i < 4 * count; ++i) touch(random, count);
        for (PairConstraints& pair : set.pairs) classifyPair(set, pair, bodies);
    }

    void touch(Random& random, int count) {
        const int a = 1 + int(random.next() % uint64_t(count)), b = int(random.next() % uint64_t(count + 1));
        if (a == b) return;
        Manifold& manifold = manifolds.emplace_back();
        manifold.origin = bodies[size_t(a)].position;
        manifold.count = int(random.next() % (kMaxManifoldPoints + 1));
        for (ManifoldPoint& point : manifold.all()) {
            point.position = glm::vec3(randomVector(random, 0.4));
            point.normal = glm::normalize(glm::vec3(randomVector(random, 1.0)));
            point.separation = float(random.unit() - 0.5) * 0.02f;
            point.friction = 0.6f;
            point.normalImpulse = float(random.unit());
            point.frictionImpulse = glm::vec3(randomVector(random, 0.2));
            point.feature = random.next() & 1;
        }
        set.pairs.push_back({a, b, &manifold});
    }

    /// Packs all pairs, and fills in their groups.
    void fill() {
        LanePacking packing;
        std::vector<uint32_t> order(set.pairs.size());
        std::iota(order.begin(), order.end(), 0u);
        packing.begin(set);
        packing.pack(set, order);
        set.contacts.resize(set.contactCount);
        set.starts.resize(set.contactCount);
        for (PairGroup& group : set.groups)
            fillGroup(set, group, bodies, {0, 1, 0}, {{20.0f, 0.9f, 0.1f}, {40.0f, 0.8f, 0.2f}, {}}, 0.002f);
        for (size_t i = 0; i < set.groups.size(); i += 3) makeRound(set.groups[i]);
    }

    /// As if the touched points of A lay on cylinders.
    void makeRound(PairGroup& group) {
        group.anyRound = true;
        for (uint32_t i = group.from; i < group.from + group.count; ++i)
            for (int lane = 0; lane < kLanes; lane += 2) {
                set.starts[i].a.axis.x.at[lane] = 1.0f;
                set.starts[i].a.radius.at[lane] = 0.3f;
                set.starts[i].a.side.at[lane] = -1.0f;
            }
    }

    /// Two substeps, in which the bodies turn.
    void solve(const ContactKernels& kernels) {
        const ContactArrays arrays{set.states.data(), set.groups.data(), set.contacts.data(), set.starts.data()};
        const size_t end = set.groups.size();
        kernels.prepare(arrays, 0, end);
        for (int substep = 0; substep < 2; ++substep) {
            kernels.warmStart(arrays, 0, end, substep == 0);
            kernels.solve(arrays, 0, end, {360.0f, 1.5f, 2e-4f, true, substep > 0});
            for (size_t i = 1; i < set.states.size(); ++i) {
                SolverState& state = set.states[i];
                state.deltaPosition += state.v * (1.0f / 360.0f);
                state.deltaRotation +=
                    glm::mat3(0, state.w.z, -state.w.y, -state.w.z, 0, state.w.x, state.w.y, -state.w.x, 0) *
                    (1.0f / 360.0f);
            }
            kernels.solve(arrays, 0, end, {360.0f, 1.5f, 2e-4f, false, false, true});
        }
    }

    std::vector<SolverBody> bodies;
    std::deque<LoneManifold> manifolds;
    ContactSet set;
};

TEST(ContactKernels, BothBuildsGiveTheSameBits) {
    const ContactKernels* avx2 = avx2ContactKernels();
    if (!avx2) GTEST_SKIP() << "this processor has no AVX2";
    Heap narrow(200), wide(200);
    narrow.fill(), wide.fill();
    narrow.solve(baselineContactKernels());
    wide.solve(*avx2);
    float moved = 0.0f;
    for (size_t i = 0; i < narrow.set.states.size(); ++i) {
        const SolverState &a = narrow.set.states[i], &b = wide.set.states[i];
        ASSERT_EQ(std::memcmp(&a.v, &b.v, sizeof a.v), 0) << i;
        ASSERT_EQ(std::memcmp(&a.w, &b.w, sizeof a.w), 0) << i;
        moved += glm::length(a.v - glm::vec3(narrow.bodies[i].velocity));
    }
    EXPECT_GT(moved, 10.0f);
    EXPECT_EQ(std::memcmp(narrow.set.contacts.data(), wide.set.contacts.data(),
                          narrow.set.contactCount * sizeof(Contact<Lanes>)),
              0);
}

/// Momentum of the bodies; what touches the world is left out.
glm::dvec3 momentumOf(const ContactSet& set) {
    glm::dvec3 sum(0.0);
    for (size_t i = 1; i < set.states.size(); ++i)
        sum += glm::dvec3(set.states[i].v) / double(set.states[i].inverseMass);
    return sum;
}

TEST(ContactKernels, TheBodiesKeepTheirMomentum) {
    Heap heap(200);
    std::erase_if(heap.set.pairs, [](const PairConstraints& pair) { return pair.b == 0; });
    const glm::dvec3 before = momentumOf(heap.set);
    heap.fill();
    heap.solve(contactKernels());
    EXPECT_LT(glm::length(momentumOf(heap.set) - before), 1e-3);
}

TEST(LanePacking, EveryPairWithPointsIsInOneLaneAndNoGroupHasABodyTwice) {
    Heap heap(300);
    heap.fill();
    std::vector<int> seen(heap.set.pairs.size());
    size_t lanes = 0;
    for (size_t g = 0; g < heap.set.groups.size(); ++g) {
        const PairGroup& group = heap.set.groups[g];
        std::vector<int> bodies;
        for (uint32_t lane = 0; lane < kLanes; ++lane) {
            if (group.pair[lane] == PairGroup::kNone) continue;
            const PairConstraints& pair = heap.set.pairs[group.pair[lane]];
            EXPECT_EQ(pair.group, g);
            EXPECT_EQ(pair.lane, lane);
            EXPECT_LE(uint32_t(pair.manifold->count), group.count);
            for (const int body : {pair.a, pair.b})
                if (body) bodies.push_back(body);
            ++seen[group.pair[lane]], ++lanes;
        }
        std::sort(bodies.begin(), bodies.end());
        EXPECT_EQ(std::adjacent_find(bodies.begin(), bodies.end()), bodies.end()) << "group " << g;
    }
    for (size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], heap.set.pairs[i].points().empty() ? 0 : 1);
    EXPECT_GT(double(lanes), 0.85 * double(kLanes * heap.set.groups.size())) << "lanes are filled";
}

}  // namespace
}  // namespace rubble
