#include "physics/collision/box_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "physics/bodies/collision_object.h"
#include "physics/collision/friction_patch.h"
#include "physics/collision/manifold.h"
#include "runtime/core/random.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

constexpr double kVoxel = 0.1;
/// Metres by which another axis may be preferred to that of the least overlap.
constexpr double kPreference = 0.003;

glm::dvec3 anyVector(Random& random, double size) {
    glm::dvec3 v;
    for (int k = 0; k < 3; ++k) v[k] = (2.0 * random.unit() - 1.0) * size;
    return v;
}
glm::dquat anyRotation(Random& random) {
    return glm::normalize(glm::dquat(2.0 * random.unit() - 1.0, anyVector(random, 1.0)));
}

/// An object of one box of voxels, about its middle.
struct BoxObject {
    CollisionObject object;
    glm::dvec3 half;
    BoxObject(glm::ivec3 size, const Pose& pose) : half(glm::dvec3(size) * (0.5 * kVoxel)) {
        Shape shape;
        shape.grid = solidGrid(size, 7);
        shape.palette = materialPalette();
        shape.voxelSize = kVoxel;
        object.collider.parts.push_back(
            std::make_unique<ColliderPart>(shape, Pose{-half, glm::dquat(1, 0, 0, 0)}, defaultMaterials()));
        object.radius = object.collider.radius();
        object.setPose(pose);
    }
    /// moves: as a box; if not, its voxels are touched.
    Motion motion(glm::dvec3 velocity = {}, bool moves = true) const {
        return {object.pose, object.cellTransforms(), velocity, {}, moves ? object.radius : 0.0};
    }
    double reach(const glm::dvec3& n) const {
        const glm::dvec3 local = glm::abs(glm::conjugate(object.pose.rotation) * n);
        return glm::dot(local, half);
    }
};

glm::ivec3 anySize(Random& random) {
    return {1 + int(random.below(12)), 1 + int(random.below(12)), 1 + int(random.below(12))};
}

/// The overlap of two boxes along a unit vector from the second to the first; negative: a gap.
double overlapAlong(const BoxObject& a, const BoxObject& b, const glm::dvec3& n, const glm::dvec3& moved = {}) {
    return a.reach(n) + b.reach(n) - glm::dot(n, a.object.pose.position + moved - b.object.pose.position);
}

/// The least overlap over all directions: from the best of many, a pattern search with ever smaller steps.
double leastOverlap(const BoxObject& a, const BoxObject& b, glm::dvec3& normal, const glm::dvec3& moved = {}) {
    Random random(1);
    std::vector<std::pair<double, glm::dvec3>> starts;
    const auto tryFrom = [&](glm::dvec3 n) {
        n = glm::normalize(n);
        starts.emplace_back(overlapAlong(a, b, n, moved), n);
    };
    for (int i = 0; i < 400; ++i) tryFrom(anyVector(random, 1.0));
    for (int i = 0; i < 3; ++i)
        for (const double sign : {-1.0, 1.0})
            for (const BoxObject* box : {&a, &b}) tryFrom(glm::mat3_cast(box->object.pose.rotation)[i] * sign);
    std::sort(starts.begin(), starts.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    double least = 1e9;
    for (size_t i = 0; i < 12; ++i) {
        auto [value, n] = starts[i];
        for (double step = 0.3; step > 1e-6;) {
            bool improved = false;
            for (int k = 0; k < 6; ++k) {
                glm::dvec3 d(0.0);
                d[k / 2] = k % 2 ? step : -step;
                const glm::dvec3 next = glm::normalize(n + d);
                if (const double there = overlapAlong(a, b, next, moved); there < value)
                    value = there, n = next, improved = true;
            }
            if (!improved) step *= 0.5;
        }
        if (value < least) least = value, normal = n;
    }
    return least;
}

std::vector<ContactPoint> contactsOf(const BoxObject& a, const BoxObject& b, glm::dvec3 velocity = {},
                                     bool asBoxes = true) {
    std::vector<ContactPoint> found;
    ContactSearch search;
    findContacts(a.object.collider, a.motion(velocity, asBoxes), b.object.collider, b.motion({}, asBoxes), {}, search,
                 found);
    return found;
}

const ContactPoint& deepestOf(const std::vector<ContactPoint>& contacts) {
    return *std::min_element(contacts.begin(), contacts.end(),
                             [](const ContactPoint& x, const ContactPoint& y) { return x.separation < y.separation; });
}

/// Random boxes at random poses against a search over all directions.
TEST(BoxContacts, DepthAndNormalAreThoseOfTheLeastOverlap) {
    Random random(11);
    int touching = 0, apart = 0;
    for (int round = 0; round < 1500; ++round) {
        const BoxObject a(anySize(random), {anyVector(random, 0.6), anyRotation(random)}),
            b(anySize(random), {{}, anyRotation(random)});
        glm::dvec3 normal;
        const double least = leastOverlap(a, b, normal);
        const std::vector<ContactPoint> found = contactsOf(a, b);
        if (least < -0.021) {
            EXPECT_TRUE(found.empty()) << round;
            ++apart;
        }
        if (least < 1e-4) continue;
        ++touching;
        ASSERT_FALSE(found.empty()) << round << " " << least;
        const ContactPoint& deepest = deepestOf(found);
        const double along = overlapAlong(a, b, glm::dvec3(deepest.normal));
        EXPECT_NEAR(-deepest.separation, along, 0.02 * along + kPreference) << round;
        EXPECT_LT(along, least + kPreference) << round;
        for (const ContactPoint& contact : found) {
            EXPECT_LT(std::abs(glm::length(contact.normal) - 1.0f), 1e-5f);
            // Halfway between the two surfaces, so inside each by half the depth, or as far away.
            for (const BoxObject* box : {&a, &b}) {
                const glm::dvec3 local =
                    glm::abs(box->object.pose.inversePoint(a.object.pose.position + glm::dvec3(contact.position)));
                const double beyond = std::max(std::abs(double(contact.separation)), 0.0) * 0.5 + 1e-4;
                EXPECT_TRUE(glm::all(glm::lessThanEqual(local, box->half + beyond))) << round;
            }
        }
    }
    EXPECT_GT(touching, 500);
    EXPECT_GT(apart, 150);
}

/// The order of the two changes nothing but signs.
TEST(BoxContacts, MirrorWhenTheBoxesAreExchanged) {
    Random random(5);
    for (int round = 0; round < 1000; ++round) {
        const BoxObject a(anySize(random), {anyVector(random, 0.5), anyRotation(random)}),
            b(anySize(random), {{}, anyRotation(random)});
        const auto ab = contactsOf(a, b), ba = contactsOf(b, a);
        ASSERT_EQ(ab.empty(), ba.empty()) << round;
        if (ab.empty()) continue;
        EXPECT_NEAR(deepestOf(ab).separation, deepestOf(ba).separation, kPreference) << round;
    }
}

/// The mean distance from its middle, as friction has it, of the area of contacts of one direction.
float patchRadius(std::vector<ContactPoint> contacts, const BoxObject& a, const BoxObject& b) {
    Manifold manifold;
    manifold.objects = {const_cast<CollisionObject*>(&a.object), const_cast<CollisionObject*>(&b.object)};
    std::swap(contacts.front(), const_cast<ContactPoint&>(deepestOf(contacts)));
    return meanPatchRadius(contacts, manifold);
}

/// A box that lies on another in any place and direction, in and out of its edges.
TEST(BoxContacts, AFaceOnAFaceIsTouchedWhereItsVoxelsAre) {
    Random random(3);
    int compared = 0;
    for (int round = 0; round < 500; ++round) {
        const glm::ivec3 size(6, 4, 6);
        const double turn = round % 3 ? 6.28 * random.unit() : 0.0;
        const double height = 0.4 + 0.004 * (random.unit() - 0.5);
        glm::dvec3 at = anyVector(random, 0.5);
        at.y = height;
        const BoxObject a(size, {at, glm::angleAxis(turn, glm::dvec3(0, 1, 0))}), b(size, {{}, {1, 0, 0, 0}});
        const auto boxes = contactsOf(a, b), voxels = contactsOf(a, b, {}, false);
        const double overlap = 0.4 - height;
        glm::vec3 low(1e9f), high(-1e9f), voxelLow(1e9f), voxelHigh(-1e9f);
        int onTop = 0;
        for (const ContactPoint& contact : voxels) {
            if (contact.normal.y < 0.99f) continue;
            ++onTop;
            voxelLow = glm::min(voxelLow, contact.position), voxelHigh = glm::max(voxelHigh, contact.position);
        }
        if (onTop < 4) continue;
        ++compared;
        ASSERT_GE(boxes.size(), 3u) << round;
        for (const ContactPoint& contact : boxes) {
            EXPECT_GT(contact.normal.y, 0.9999f) << round;
            EXPECT_NEAR(contact.separation, -overlap, 1e-5) << round;
            EXPECT_EQ(contact.friction, voxels[0].friction);
            low = glm::min(low, contact.position), high = glm::max(high, contact.position);
        }
        for (const int k : {0, 2}) {  // voxels have points at corners and in the middles of their edges
            EXPECT_NEAR(low[k], voxelLow[k], 0.072) << round;
            EXPECT_NEAR(high[k], voxelHigh[k], 0.072) << round;
        }
        if (round % 3 == 0) {
            const float radius = patchRadius(boxes, a, b), expected = patchRadius(voxels, a, b);
            EXPECT_NEAR(radius, expected, 0.1f * expected + 0.02f) << round;
        }
    }
    EXPECT_GT(compared, 200);
}

/// The patch of a whole face: the mean distance of a square of side s from its middle is 0.3826 s.
TEST(BoxContacts, TheFrictionOfASquareIsThatOfItsArea) {
    const BoxObject a({6, 6, 6}, {{0, 0.599, 0}, {1, 0, 0, 0}}), b({12, 6, 12}, {{}, {1, 0, 0, 0}});
    EXPECT_NEAR(patchRadius(contactsOf(a, b), a, b), 0.3826 * 0.6, 0.003);
}

/// Two sticks across each other touch in one point, where they cross.
TEST(BoxContacts, AnEdgeOnAnEdgeIsOnePoint) {
    const glm::dvec3 x(1, 0, 0), y(0, 1, 0);
    const double diagonal = std::sqrt(2.0) * 0.1;
    const BoxObject a({12, 2, 2}, {{0.2, 2.0 * diagonal - 0.003, 0.1}, glm::angleAxis(0.785398, x)}),
        b({12, 2, 2}, {{}, glm::angleAxis(1.570796, y) * glm::angleAxis(0.785398, x)});
    const auto found = contactsOf(a, b);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_GT(found[0].normal.y, 0.9999f);
    EXPECT_NEAR(found[0].separation, -0.003, 1e-4);
    const glm::dvec3 at = a.object.pose.position + glm::dvec3(found[0].position);
    EXPECT_NEAR(at.x, 0.0, 1e-4);
    EXPECT_NEAR(at.z, 0.1, 1e-4);
}

/// A corner that stands on a face is one point, with that face's normal.
TEST(BoxContacts, ACornerOnAFaceIsOnePoint) {
    // From the diagonal to upwards.
    const glm::dquat onCorner = glm::angleAxis(std::acos(1.0 / std::sqrt(3.0)), glm::normalize(glm::dvec3(-1, 0, 1)));
    const double reach = std::sqrt(3.0) * 0.25;
    const BoxObject a({5, 5, 5}, {{0.1, 0.5 + reach - 0.002, 0.05}, onCorner}), b({10, 10, 10}, {{}, {1, 0, 0, 0}});
    const auto found = contactsOf(a, b);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_GT(found[0].normal.y, 0.9999f);
    EXPECT_NEAR(found[0].separation, -0.002, 1e-4);
}

/// What passes into another box within the step has a contact that stops it before; what passes by has none.
TEST(BoxContacts, AFastBoxIsStoppedWhereItMeetsTheOther) {
    Random random(9);
    int hits = 0, misses = 0;
    for (int round = 0; round < 600; ++round) {
        const BoxObject a(anySize(random), {anyVector(random, 1.2), anyRotation(random)}),
            b(anySize(random), {{}, anyRotation(random)});
        glm::dvec3 normal;
        if (leastOverlap(a, b, normal) > -0.03) continue;
        const glm::dvec3 velocity = anyVector(random, 60.0);
        double deepest = -1e9;
        for (int i = 1; i <= 20; ++i)
            deepest = std::max(deepest, leastOverlap(a, b, normal, velocity * (i / 20.0 / 60.0)));
        const auto found = contactsOf(a, b, velocity);
        bool stops = false;
        for (const ContactPoint& contact : found)
            stops = stops || -glm::dot(velocity, glm::dvec3(contact.normal)) / 60.0 > double(contact.separation);
        if (deepest > 0.002) {
            EXPECT_TRUE(stops) << round << " " << deepest;
            ++hits;
        }
        if (deepest < -0.1) {
            EXPECT_FALSE(stops) << round;
            ++misses;
        }
    }
    EXPECT_GT(hits, 40);
    EXPECT_GT(misses, 40);
}

/// The corners of the area keep their names while the boxes move a little.
TEST(BoxContacts, PointsKeepTheirFeatures) {
    Random random(2);
    int compared = 0;
    for (int round = 0; round < 300; ++round) {
        glm::dvec3 at = anyVector(random, 0.3);
        at.y = 0.499;
        const glm::dquat turn = glm::angleAxis(6.28 * random.unit(), glm::dvec3(0, 1, 0));
        const BoxObject a({5, 5, 5}, {at, turn}), b({5, 5, 5}, {{}, {1, 0, 0, 0}}),
            moved({5, 5, 5}, {at + glm::dvec3(1e-5, -1e-5, 1e-5), turn});
        auto before = contactsOf(a, b), after = contactsOf(moved, b);
        if (before.size() != after.size()) continue;
        ++compared;
        for (size_t i = 0; i < before.size(); ++i) {
            EXPECT_EQ(before[i].feature, after[i].feature) << round;
            for (size_t k = 0; k < i; ++k) EXPECT_NE(before[i].feature, before[k].feature) << round;
        }
    }
    EXPECT_GT(compared, 250);
}

/// A cut leaves a box or not: half a box is one, a box without a corner is none.
TEST(BoxContacts, OnlyWhatFillsItsBoundsIsABox) {
    Shape shape;
    shape.palette = materialPalette();
    shape.grid = VoxelGrid({9, 9, 9});
    const auto set = [&](glm::ivec3 cell, uint8_t entry) { GridWriter(shape.grid).set(cell, entry); };
    for (int i = 0; i < 8 * 3 * 5; ++i) set({1 + i % 8, 2 + i / 8 % 3, 3 + i / 24}, 7);
    const ColliderPart box(shape, Pose{}, defaultMaterials());
    ASSERT_TRUE(box.box());
    EXPECT_EQ(box.box()->center, glm::vec3(5.0f, 3.5f, 5.5f));
    EXPECT_EQ(box.box()->half, glm::vec3(4.0f, 1.5f, 2.5f));
    EXPECT_EQ(box.whole()->entry, 7);
    set({4, 3, 5}, 0);
    EXPECT_FALSE(ColliderPart(shape, Pose{}, defaultMaterials()).box());
}

}  // namespace
}  // namespace rubble
