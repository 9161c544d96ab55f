#include <utility>
#include <vector>

#include "tests/abi/create_fixture.h"

namespace rubble {
namespace {

/// A world and one that follows it by deltas, which later go on apart from each other.
class AbiFollowerSlots : public AbiCreate {
protected:
    void SetUp() override {
        AbiCreate::SetUp();
        m_other = makeWorld();
        uint64_t size = 0;
        ASSERT_EQ(api()->save_game_data(m_world, nullptr, 0, &size), RUBBLE_OK);
        std::vector<uint8_t> game(size);
        ASSERT_EQ(api()->save_game_data(m_world, game.data(), size, &size), RUBBLE_OK);
        ASSERT_EQ(api()->load_game_data(m_other, game.data(), size), RUBBLE_OK) << api()->get_last_error();
        ASSERT_EQ(api()->keep_deltas(m_world, RUBBLE_DELTAS_ALL), RUBBLE_OK);
    }
    void TearDown() override {
        api()->destroy_world(m_other);
        AbiCreate::TearDown();
    }
    void follow() {
        step();
        uint64_t size = 0;
        ASSERT_EQ(api()->take_deltas(m_world, nullptr, 0, &size), RUBBLE_OK) << api()->get_last_error();
        std::vector<uint8_t> data(size);
        ASSERT_EQ(api()->take_deltas(m_world, data.data(), size, &size), RUBBLE_OK);
        ASSERT_EQ(api()->apply_deltas(m_other, data.data(), size), RUBBLE_OK) << api()->get_last_error();
    }
    std::vector<rubble_body> makeThree() {
        std::vector<rubble_body> made;
        for (int i = 0; i < 3; ++i) {
            made.push_back(make(bodyAt(5.0 + i, 3.0, RUBBLE_BODY_STATIC)));
            make(shapeOn(made.back(), RUBBLE_SHAPE_BOX, 2));
        }
        return made;
    }
    static uint64_t resolved(rubble_world world) {
        uint64_t out = 0;
        EXPECT_EQ(api()->get_resolved_hash(world, &out), RUBBLE_OK);
        return out;
    }

    rubble_world m_other = 0;
};

TEST_F(AbiFollowerSlots, AreThoseOfTheOtherWorldAfterObjectsCameAndWent) {
    const std::vector<rubble_body> first = makeThree();
    follow();
    ASSERT_EQ(api()->destroy_body(m_world, first[1]), RUBBLE_OK);
    follow();
    for (const rubble_body body : makeThree()) ASSERT_EQ(api()->destroy_body(m_world, body), RUBBLE_OK);
    follow();
    ASSERT_EQ(resolved(m_world), resolved(m_other));
    ASSERT_EQ(api()->keep_deltas(m_world, RUBBLE_DELTAS_NONE), RUBBLE_OK);
    for (int i = 0; i < 2; ++i) {
        makeThree();
        step();
        for (auto& b : bodies(m_world)) printf("%llx ", (unsigned long long)b.body); for (auto& b : shapes()) printf("S%llx ", (unsigned long long)b.shape); puts("");
        std::swap(m_world, m_other);
    }
    EXPECT_EQ(resolved(m_world), resolved(m_other)) << "new objects have got other slots";
}

}  // namespace
}  // namespace rubble
