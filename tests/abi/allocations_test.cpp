#include "tests/abi/abi_fixture.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

class AbiAllocations : public Abi {
protected:
    /// How often 100 calls take memory, after those that warm up.
    template <class Call>
    static size_t countAllocations(Call&& call) {
        for (int i = 0; i < 100; ++i) call();
        const size_t before = allocationCount();
        for (int i = 0; i < 100; ++i) call();
        return allocationCount() - before;
    }
};

TEST_F(AbiAllocations, CallsTakeNoMemory) {
    const rubble_body body = bodies(m_world)[0].body;
    rubble_body_state state = {};
    EXPECT_EQ(countAllocations([&] { api()->get_body_state(m_world, body, &state); }), 0u);
}

TEST_F(AbiAllocations, RefusedCallsTakeNoMemory) {
    rubble_body_state state = {};
    uint32_t count = 0;
    auto explosion = tableExplosion();
    explosion.size = 1e9;
    auto impulse = sized<rubble_impulse>();
    impulse.body = bodies(m_world)[0].body;
    impulse.position[2] = 1e300;
    const double zero[3] = {};
    rubble_hit hit = {};
    EXPECT_EQ(countAllocations([&] { api()->get_body_state(m_world, 0, &state); }), 0u) << "a stale handle";
    EXPECT_EQ(countAllocations([&] { api()->get_body_state(0, 0, &state); }), 0u) << "a stale world";
    EXPECT_EQ(countAllocations([&] { api()->explode(m_world, &explosion); }), 0u) << "a number out of its range";
    EXPECT_EQ(countAllocations([&] { api()->explode(m_world, nullptr); }), 0u) << "a null pointer";
    EXPECT_EQ(countAllocations([&] { api()->apply_impulse(m_world, &impulse); }), 0u) << "a vector out of its range";
    EXPECT_EQ(countAllocations([&] { api()->cast_ray(m_world, zero, zero, 1.0, &hit); }), 0u) << "no direction";
    EXPECT_EQ(countAllocations([&] { api()->get_body_states(m_world, nullptr, 1, &count); }), 0u) << "no array";
    explosion.struct_size = 3;
    EXPECT_EQ(countAllocations([&] { api()->explode(m_world, &explosion); }), 0u) << "a wrong struct_size";
}

TEST_F(AbiAllocations, EditsTakeNoMemoryOnceAStepHasHadAsMany) {
    auto impulse = sized<rubble_impulse>();
    impulse.body = bodies(m_world)[0].body;
    const auto pushAll = [&] {
        for (int i = 0; i < 1000; ++i) ASSERT_EQ(api()->apply_impulse(m_world, &impulse), RUBBLE_OK);
    };
    pushAll();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    const size_t before = allocationCount();
    pushAll();
    EXPECT_EQ(allocationCount() - before, 0u);
}

TEST_F(AbiAllocations, OneStepOfManyEditsDoesNotKeepItsMemory) {
    const rubble_explosion explosion = tableExplosion();
    ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    const size_t before = allocatedBytes();
    auto impulse = sized<rubble_impulse>();
    impulse.body = bodies(m_world)[0].body;
    for (int i = 0; i < 10'000; ++i) ASSERT_EQ(api()->apply_impulse(m_world, &impulse), RUBBLE_OK);
    for (int i = 0; i < 2; ++i) ASSERT_EQ(api()->step(m_world), RUBBLE_OK);
    EXPECT_LT(allocatedBytes(), before + 500'000);
    EXPECT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
}

}  // namespace
}  // namespace rubble
