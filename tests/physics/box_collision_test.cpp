#include "physics/box_collision.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

TEST(BoxCollision, ReducingKeepsTheDeepestAndTheCorners) {
    std::vector<BoxContact> contacts;
    const btVector3 up(0, 1, 0);
    for (int z = 0; z <= 4; ++z)
        for (int x = 0; x <= 4; ++x) contacts.push_back({up, btVector3(btScalar(x), 0, btScalar(z)), btScalar(-0.001)});
    contacts[0].depth = -0.01f;  // the corner (0, 0, 0)
    reduceContacts(contacts);
    ASSERT_EQ(contacts.size(), 4u);
    EXPECT_EQ(contacts[0].point, btVector3(0, 0, 0));
    EXPECT_EQ(contacts[1].point, btVector3(4, 0, 4));
    EXPECT_NE(contacts[2].point, contacts[3].point);
    for (int i = 2; i < 4; ++i) EXPECT_EQ(contacts[size_t(i)].point.x() + contacts[size_t(i)].point.z(), 4);
}

TEST(BoxCollision, FourOrFewerStay) {
    std::vector<BoxContact> contacts(3, {btVector3(0, 1, 0), btVector3(1, 2, 3), btScalar(0)});
    reduceContacts(contacts);
    EXPECT_EQ(contacts.size(), 3u);
}

}  // namespace
}  // namespace rubble
