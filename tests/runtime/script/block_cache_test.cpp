#include "runtime/script/sandbox/block_cache.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {
namespace {

TEST(BlockCache, GivesABlockAgainToTheNextOfItsSize) {
    BlockCache cache;
    void* const block = cache.take(50);
    cache.give(block, 50);
    EXPECT_EQ(cache.kept(), 64u);
    EXPECT_EQ(cache.take(60), block) << "both take four units";
    EXPECT_EQ(cache.kept(), 0u);
    EXPECT_EQ(cache.resize(block, 60, 49), block);
    cache.give(block, 49);
}

TEST(BlockCache, ResizedBlocksKeepWhatTheyHold) {
    BlockCache cache;
    size_t size = 1;
    char* block = static_cast<char*>(cache.take(size));
    block[0] = 'x';
    for (const size_t next : {40, 512, 513, 9000, 700, 512, 30, 1}) {
        block = static_cast<char*>(cache.resize(block, size, next));
        EXPECT_EQ(block[0], 'x') << next;
        std::memset(block, 'x', size = next);
    }
    cache.give(block, size);
}

TEST(BlockCache, WhatItKeepsIsBounded) {
    BlockCache cache;
    std::vector<void*> blocks;
    for (size_t i = 0; i < 2 * BlockCache::kMaxKept / 512; ++i) blocks.push_back(cache.take(512));
    for (void* const block : blocks) cache.give(block, 512);
    EXPECT_EQ(cache.kept(), BlockCache::kMaxKept);
    cache.give(cache.take(1 << 20), 1 << 20);
    EXPECT_EQ(cache.kept(), BlockCache::kMaxKept) << "large blocks are not kept";
}

TEST(BlockCache, ManyScriptsKeepNoMoreThanOne) {
    SharedMemory shared;
    std::vector<std::unique_ptr<Sandbox>> boxes;
    for (int i = 0; i < 8; ++i) {
        Sandbox& box = *boxes.emplace_back(std::make_unique<Sandbox>(SandboxLimits{}, nullptr, &shared));
        lua_State* const thread = lua_newthread(box.state());
        ASSERT_EQ(luaL_loadstring(thread, "local t = {} for i = 1, 20000 do t[i] = {i} end"), LUA_OK);
        ASSERT_EQ(box.run(thread, 0).state, RunResult::Done);
    }
    boxes.clear();
    EXPECT_EQ(shared.used, 0u);
    EXPECT_EQ(shared.blocks.kept(), BlockCache::kMaxKept);
}

}  // namespace
}  // namespace rubble::script
