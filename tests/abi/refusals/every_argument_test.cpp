#include <algorithm>
#include <thread>

#include "tests/abi/refusals/refusals_fixture.h"

namespace rubble {
namespace {

TEST_F(Refusals, EveryFunctionIsAcceptedAsAHostCallsIt) {
    expectUsualCallsAccepted(false);
    const auto& all = describedFunctions();
    const auto isThere = [&](const std::string& name) {
        return std::any_of(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    };
    for (const auto& [name, ways] : usualCalls()) EXPECT_TRUE(isThere(name)) << name;
}

TEST_F(Refusals, EveryWrongArgumentIsRefusedByNameAndChangesNothing) {
    expectWrongArgumentsRefused(false);
}

TEST_F(Refusals, AnotherThreadIsRefused) {
    for (const FunctionDescription& function : describedFunctions()) {
        if (!isOfWorld(function) || function.thread != "main") continue;
        SCOPED_TRACE(function.name);
        const auto world = makeWorld(function, RUBBLE_WORLD_ONE_THREAD);
        const auto same = makePrepared(function, waysOf(function)[0]);
        HostCall call(function, *world);
        waysOf(function)[0](call);
        std::thread([&] {
            EXPECT_EQ(call.call(), RUBBLE_ERROR_THREAD) << api()->get_last_error();
            expectNamed(function, "world");
        }).join();
        if (!world->isAlive()) return ADD_FAILURE() << "the world is gone";
        world->step(), same->step();
        EXPECT_EQ(world->hash(), same->hash());
    }
}

/// What a log callback calls, and for which world.
struct Listener {
    const FunctionDescription* function;
    FullWorld* world;
    int calls = 0;
};

TEST_F(Refusals, ACallFromACallbackIsRefused) {
    Listener listener{};
    auto host = sized<rubble_host>();
    host.user = &listener;
    host.log = [](void* user, int32_t, const char*) {
        auto& inside = *static_cast<Listener*>(user);
        if (!inside.function) return;
        HostCall call(*inside.function, *inside.world);
        EXPECT_EQ(call.call(), RUBBLE_ERROR_BUSY) << api()->get_last_error();
        expectNamed(*inside.function, "world");
        ++inside.calls;
    };
    ASSERT_EQ(api()->set_host(&host), RUBBLE_OK);
    for (const FunctionDescription& function : describedFunctions()) {
        if (!isOfWorld(function) || function.thread != "main") continue;
        SCOPED_TRACE(function.name);
        const auto world = makeWorld(function), same = makeWorld(function);
        for (const FullWorld* each : {world.get(), same.get()}) ASSERT_EQ(api()->undo(each->world()), RUBBLE_OK);
        listener = {&function, world.get()};
        world->step();  // it logs that there is nothing to undo
        EXPECT_GE(listener.calls, 1);
        listener.function = nullptr;
        same->step();
        EXPECT_EQ(world->hash(), same->hash());
    }
}

}  // namespace
}  // namespace rubble
