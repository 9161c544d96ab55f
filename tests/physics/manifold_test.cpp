#include "physics/collision/manifold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// A point of contact on the ground, x and z in metres.
ContactPoint pointAt(float x, float z, float separation, uint64_t feature) {
    ContactPoint point;
    point.position = {x, 0.0f, z};
    point.normal = {0.0f, 1.0f, 0.0f};
    point.separation = separation;
    point.feature = feature;
    return point;
}

/// A lump that stands on three feet, with corners farther out that are a little above the ground.
TEST(Manifold, WhatBearsGoesBeforeWhatIsFartherOut) {
    const std::array<glm::vec2, 3> feet{glm::vec2{0.1f, 0.0f}, {-0.08f, 0.06f}, {-0.02f, -0.09f}};
    for (size_t deepest = 0; deepest < feet.size(); ++deepest) {
        std::vector<ContactPoint> contacts;
        for (size_t i = 0; i < feet.size(); ++i)
            contacts.push_back(pointAt(feet[i].x, feet[i].y, i == deepest ? -2e-4f : 1e-4f, i));
        for (int i = 0; i < 6; ++i)
            contacts.push_back(pointAt(0.3f * std::cos(float(i)), 0.3f * std::sin(float(i)), 0.007f, uint64_t(10 + i)));
        LoneManifold manifold;
        reduceContacts(contacts, nullptr, kRestingLimits, manifold);
        for (uint64_t foot = 0; foot < feet.size(); ++foot)
            EXPECT_TRUE(std::ranges::any_of(manifold.all(), [&](const ManifoldPoint& p) { return p.feature == foot; }))
                << "foot " << foot << ", the deepest is " << deepest;
        EXPECT_GT(manifold.count, 3) << "and one that will bear if it tips";
    }
}

/// A rod that falls a little aslant: where it touches first lies at one end of a line, whose other end follows.
TEST(Manifold, ALineThatHitsKeepsBothOfItsEnds) {
    std::vector<ContactPoint> contacts;
    for (int i = 0; i < 6; ++i)
        contacts.push_back(pointAt(0.05f * float(i), 0.03f * float(i), 0.011f + 0.0018f * float(i), uint64_t(i)));
    LoneManifold manifold;
    reduceContacts(contacts, nullptr, kHitLimits, manifold);
    for (const uint64_t end : {0, 5})
        EXPECT_TRUE(std::ranges::any_of(manifold.all(), [&](const ManifoldPoint& p) { return p.feature == end; }))
            << "end " << end << " of " << manifold.count << " points";
}

}  // namespace
}  // namespace rubble
