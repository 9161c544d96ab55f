#include "runtime/core/change_log.h"

#include <gtest/gtest.h>

#include <map>

#include "runtime/core/random.h"

namespace rubble {
namespace {

TEST(ChangeLog, KnowsWhatChangedSinceAndGrowsWithTheKeysOnly) {
    ChangeLog<int> log;
    std::map<int, uint64_t> last;
    Random random(2);
    for (uint64_t version = 1; version <= 2000; ++version) {
        for (uint32_t i = random.below(4); i-- > 0;) {
            const int key = int(random.below(50));
            log.add(key, version);
            last[key] = version;
        }
        const uint64_t since = random.below(uint32_t(version) + 1);
        std::vector<int> expected, found{-1};
        for (const auto& [key, changed] : last)
            if (changed > since) expected.push_back(key);
        log.since(since, found);
        ASSERT_EQ(found, expected) << version << " since " << since;
        ASSERT_LE(log.size(), 2u * 50 + 65);
    }
}

}  // namespace
}  // namespace rubble
