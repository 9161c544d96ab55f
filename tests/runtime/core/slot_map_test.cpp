#include "runtime/core/slot_map.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "runtime/core/handle.h"
#include "runtime/core/random.h"

namespace rubble {
namespace {

TEST(SlotMap, StaleHandlesAreReportedNeverFollowed) {
    SlotMap<BodyHandle, std::string> map(3);
    const BodyHandle first = map.insert("first");
    EXPECT_EQ(first.type(), HandleType::Body);
    EXPECT_EQ(first.world(), 3);
    EXPECT_TRUE(map.erase(first));
    EXPECT_FALSE(map.erase(first));
    const BodyHandle second = map.insert("second");
    EXPECT_EQ(second.slot(), first.slot());
    EXPECT_NE(second, first);
    EXPECT_EQ(map.find(first), nullptr);
    EXPECT_EQ(*map.find(second), "second");
    EXPECT_EQ(map.find(BodyHandle{}), nullptr);
    EXPECT_EQ(map.find(BodyHandle::make(4, second.generation(), second.slot())), nullptr) << "another world's handle";
}

TEST(SlotMap, AfterClearSlotsStartOverAndOldHandlesAreStale) {
    SlotMap<BodyHandle, int> used(1), fresh(1);
    const BodyHandle first = used.insert(1), second = used.insert(2), third = used.insert(3);
    used.erase(second);
    used.clear();
    EXPECT_EQ(used.size(), 0u);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(used.insert(i).slot(), fresh.insert(i).slot());
    for (const BodyHandle handle : {first, second, third}) EXPECT_EQ(used.find(handle), nullptr);
}

TEST(SlotMap, AReservedHandleNamesNothingUntilItIsFilled) {
    SlotMap<BodyHandle, int> map(1);
    map.erase(map.insert(1));
    const BodyHandle reserved = map.reserve(), next = map.reserve();
    EXPECT_EQ(map.find(reserved), nullptr);
    EXPECT_TRUE(map.isReserved(reserved));
    EXPECT_EQ(map.size(), 0u);
    const BodyHandle other = map.insert(5);
    EXPECT_NE(other.slot(), reserved.slot());
    map.setFreeSlots({reserved.slot()});
    EXPECT_NE(map.insert(6).slot(), reserved.slot()) << "it stays reserved";
    map.fill(reserved, 7);
    EXPECT_EQ(*map.find(reserved), 7);
    EXPECT_FALSE(map.isReserved(reserved));
    map.release(next);
    EXPECT_FALSE(map.isReserved(next));
    const BodyHandle later = map.insert(8);
    EXPECT_EQ(later.slot(), next.slot());
    EXPECT_EQ(map.find(next), nullptr) << "released is stale for ever";
}

TEST(SlotMap, AClaimIsWhatReserveGaveElsewhere) {
    SlotMap<BodyHandle, int> map(1);
    map.erase(map.insert(1));
    SlotMap<BodyHandle, int> copy = map;
    const BodyHandle first = map.reserve(), second = map.reserve(), third = map.reserve();
    EXPECT_TRUE(copy.claim(first));
    EXPECT_TRUE(copy.claim(first));
    EXPECT_FALSE(copy.claim(third)) << "not in the order of the calls";
    EXPECT_TRUE(copy.claim(second));
    EXPECT_TRUE(copy.claim(third));
    EXPECT_EQ(copy.insert(3), map.insert(3));
    EXPECT_FALSE(copy.claim(BodyHandle::make(2, 1, 9)));
    EXPECT_FALSE(copy.claim(BodyHandle::make(1, 1, 900)));
    EXPECT_FALSE(copy.claim({}));
}

TEST(SlotMap, AReservedSlotCanBeRestoredOverAndCleared) {
    SlotMap<BodyHandle, int> map(1);
    const BodyHandle old = map.insert(1);
    map.erase(old);
    const BodyHandle reserved = map.reserve();
    ASSERT_EQ(reserved.slot(), old.slot());
    map.restore(old, 4);
    EXPECT_EQ(*map.find(old), 4);
    EXPECT_FALSE(map.isReserved(reserved));
    map.erase(old);
    EXPECT_NE(map.insert(5), reserved);
    const BodyHandle waiting = map.reserve();
    map.clear();
    for (int i = 0; i < 3; ++i) map.insert(i);
    EXPECT_EQ(map.find(waiting), nullptr);
    EXPECT_FALSE(map.isReserved(waiting));
}

TEST(SlotMap, BehavesLikeAMapUnderRandomUse) {
    SlotMap<ShapeHandle, int> map(1);
    std::map<uint64_t, int> expected;
    std::vector<ShapeHandle> all;
    Random random(5);
    for (int i = 0; i < 20000; ++i) {
        if (random.below(3) || expected.empty()) {
            const ShapeHandle handle = map.insert(i);
            ASSERT_TRUE(expected.emplace(handle.bits, i).second) << "a handle was given twice";
            all.push_back(handle);
        } else {
            const ShapeHandle handle = all[random.below(uint32_t(all.size()))];
            ASSERT_EQ(map.erase(handle), expected.erase(handle.bits) == 1);
        }
    }
    EXPECT_EQ(map.size(), expected.size());
    for (const ShapeHandle handle : all) {
        const auto found = expected.find(handle.bits);
        const int* value = map.find(handle);
        ASSERT_EQ(value != nullptr, found != expected.end());
        if (value) {
            ASSERT_EQ(*value, found->second);
        }
    }
    size_t visited = 0;
    uint32_t lastSlot = 0;
    map.forEach([&](ShapeHandle handle, int) {
        EXPECT_TRUE(visited == 0 || handle.slot() > lastSlot);
        lastSlot = handle.slot();
        ++visited;
    });
    EXPECT_EQ(visited, map.size());
}

TEST(SlotMap, RestoredObjectsKeepTheirHandlesAndNewOnesGetFreshOnes) {
    SlotMap<BodyHandle, int> map;
    const BodyHandle first = map.insert(1), second = map.insert(2);
    map.erase(second);
    map.erase(first);
    const BodyHandle third = map.insert(3);
    EXPECT_EQ(third.slot(), first.slot());
    map.erase(third);
    map.restore(first, 1);
    EXPECT_EQ(*map.find(first), 1);
    EXPECT_FALSE(map.find(third));
    map.erase(first);
    const BodyHandle fourth = map.insert(4);
    EXPECT_NE(fourth, third) << "an old handle must not name a new object";
    EXPECT_NE(fourth, first);

    SlotMap<BodyHandle, int> other;  // as replay does: into slots that were never used
    other.restore(BodyHandle::make(0, 7, 2), 5);
    EXPECT_EQ(other.slotCount(), 3u);
    EXPECT_EQ(other.insert(6).slot(), 0u);
    EXPECT_EQ(other.insert(7).slot(), 1u);
}

TEST(SlotMap, RestoringAHighSlotKeepsTheOrderOfTheFreeOnes) {
    SlotMap<BodyHandle, int> map;
    const BodyHandle first = map.insert(1), second = map.insert(2);
    map.erase(first);
    map.restore(BodyHandle::make(0, 3, 1000000), 5);  // a cost that grows with the square of the slot never ends
    EXPECT_EQ(map.slotCount(), 1000001u);
    EXPECT_EQ(map.insert(6).slot(), 0u) << "freed last, used first";
    for (uint32_t slot = 2; slot < 10; ++slot) EXPECT_EQ(map.insert(7).slot(), slot);
    EXPECT_TRUE(map.find(second));
}

}  // namespace
}  // namespace rubble
