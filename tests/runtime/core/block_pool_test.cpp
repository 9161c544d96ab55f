#include "runtime/core/block_pool.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>
#include <vector>

namespace rubble {
namespace {

TEST(BlockPool, GivesOutAgainWhatCameBack) {
    const auto pool = std::make_shared<BlockPool>(2);
    const auto make = [&](int value) { return std::allocate_shared<int>(PoolAllocator<int>(pool), value); };
    std::vector<std::shared_ptr<int>> all{make(1), make(2), make(3)};
    std::set<int*> before;
    for (const auto& each : all) before.insert(each.get());
    all.clear();  // two are kept
    all = {make(4), make(5)};
    for (const auto& each : all) EXPECT_TRUE(before.contains(each.get()));
    EXPECT_EQ(*all[0] + *all[1], 9);
}

TEST(BlockPool, LivesAsLongAsItsObjects) {
    auto pool = std::make_shared<BlockPool>(8);
    const std::weak_ptr<BlockPool> known = pool;
    auto last = std::allocate_shared<int>(PoolAllocator<int>(std::move(pool)), 7);
    EXPECT_FALSE(known.expired());
    std::thread([&] { last.reset(); }).join();
    EXPECT_TRUE(known.expired());
}

}  // namespace
}  // namespace rubble
