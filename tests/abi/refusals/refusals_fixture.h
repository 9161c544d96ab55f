#pragma once
#include <algorithm>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/abi/abi_fixture.h"
#include "tests/abi/refusals/accepted_values.h"
#include "tests/abi/refusals/argument_changes.h"
#include "tests/abi/refusals/usual_calls.h"
#include "tests/support/temp_folder.h"

namespace rubble {

/// Every function of the table with every wrong value of each argument. What is called follows from rubble.h: a new
/// function is in here by itself.
class Refusals : public testing::Test {
protected:
    static void SetUpTestSuite() {
        if (s_folder) return;  // of another suite: the files are made once
        s_folder = std::make_unique<TempFolder>();
        callFiles(s_folder->path());
    }
    void TearDown() override { api()->set_host(nullptr); }

    static bool isOfRenderer(const FunctionDescription& function) { return function.thread == "render"; }
    /// All functions, those of renderers or the others.
    static std::vector<FunctionDescription> functions(bool ofRenderers) {
        std::vector<FunctionDescription> out;
        for (const FunctionDescription& each : describedFunctions())
            if (isOfRenderer(each) == ofRenderers) out.push_back(each);
        return out;
    }
    static std::unique_ptr<FullWorld> makeWorld(const FunctionDescription& function, uint32_t flags = 0) {
        if (function.name == "set_body_states" || function.name == "report_impacts") flags |= RUBBLE_WORLD_HOST_PHYSICS;
        if (!isOfRenderer(function)) flags |= RUBBLE_WORLD_NO_RENDERER;
        auto world = std::make_unique<FullWorld>(callFiles().level, flags);
        if (isOfRenderer(function) && !isOfWorld(function)) world->addRenderer();
        return world;
    }
    /// A world after what prepares a call.
    static std::unique_ptr<FullWorld> makePrepared(const FunctionDescription& function, Prepare prepare) {
        auto world = makeWorld(function);
        HostCall call(function, *world);
        prepare(call);
        return world;
    }
    static std::vector<Prepare> waysOf(const FunctionDescription& function) {
        const auto found = usualCalls().find(function.name);
        return found == usualCalls().end() ? std::vector<Prepare>{[](HostCall&) {}} : found->second;
    }
    static bool isOfWorld(const FunctionDescription& function) {
        return !function.arguments.empty() && function.arguments[0].type == "rubble_world";
    }
    static rubble_result run(HostCall& call, const FunctionDescription& function) {
        const rubble_result result = call.call();
        if (result != RUBBLE_OK) return result;
        if (function.name == "create_world") api()->destroy_world(call.at<uint64_t>("out"));
        if (function.name == "create_renderer") api()->destroy_renderer(call.at<uint64_t>("out"));
        return result;
    }
    /// The last refused call named the function and then, as a word, the argument.
    static void expectNamed(const FunctionDescription& function, const std::string& word) {
        const std::string text = api()->get_last_error();
        EXPECT_TRUE(text.starts_with(function.name + ": ")) << text;
        const std::string rest = text.substr(std::min(text.size(), function.name.size() + 2));
        EXPECT_TRUE(std::regex_search(rest, std::regex("\\b" + word + "\\b"))) << "'" << word << "' in: " << text;
    }

    void checkFunction(const FunctionDescription& function) {
        const FullWorld other(callFiles().level);
        rubble_world gone = FullWorld(callFiles().level).world();
        std::map<std::string, bool> refused;
        for (const Prepare prepare : waysOf(function)) {
            std::vector<ArgumentChange> kept;
            auto world = makePrepared(function, prepare);
            const uint64_t before = world->hash();
            for (const ArgumentChange& change : changesOf(function, {other, gone, s_goneRenderer})) {
                SCOPED_TRACE(change.place + " is " + change.what);
                HostCall call(function, *world);
                prepare(call);
                change.make(call);
                const rubble_result result = run(call, function);
                bool& isRefused = refused[change.place + ": " + change.what];
                if (result == RUBBLE_OK) {
                    world = makePrepared(function, prepare);
                    continue;
                }
                isRefused = true;
                kept.push_back(change);
                EXPECT_EQ(world->hash(), before);
                if (acceptedValues().contains(function.name + " " + change.place + ": " + change.what)) continue;
                EXPECT_EQ(result, change.expected) << api()->get_last_error();
                expectNamed(function, change.word());
            }
            expectNoEdit(function, prepare, kept);
        }
        for (const auto& [change, isRefused] : refused)
            EXPECT_TRUE(isRefused || acceptedValues().contains(function.name + " " + change))
                << function.name << " " << change << " is accepted: refuse it, or list it in accepted_values.cpp";
        for (const auto& [change, isRefused] : refused) s_seen.insert(function.name + " " + change);
    }
    /// Calls that were refused have queued nothing: a step is as one without them.
    static void expectNoEdit(const FunctionDescription& function, Prepare prepare,
                             const std::vector<ArgumentChange>& changes) {
        const auto world = makePrepared(function, prepare), same = makePrepared(function, prepare);
        for (const ArgumentChange& change : changes) {
            HostCall call(function, *world);
            prepare(call);
            change.make(call);
            run(call, function);
        }
        if (!world->isAlive()) return ADD_FAILURE() << "the world is gone";
        world->step(), same->step();
        EXPECT_EQ(world->hash(), same->hash()) << "a refused call has changed the next step";
    }

    static void expectUsualCallsAccepted(bool ofRenderers) {
        for (const FunctionDescription& function : functions(ofRenderers)) {
            for (const Prepare prepare : waysOf(function)) {
                const auto world = makeWorld(function);
                HostCall call(function, *world);
                prepare(call);
                EXPECT_EQ(run(call, function), RUBBLE_OK)
                    << api()->get_last_error() << "\nsay in usual_calls.cpp how it is called";
            }
        }
    }
    void expectWrongArgumentsRefused(bool ofRenderers) {
        const auto all = functions(ofRenderers);
        for (const FunctionDescription& function : all) {
            SCOPED_TRACE(function.name);
            checkFunction(function);
        }
        for (const auto& [change, reason] : acceptedValues()) {
            const bool isOfThese = std::any_of(
                all.begin(), all.end(),
                [name = change.substr(0, change.find(' '))](const auto& each) { return each.name == name; });
            EXPECT_TRUE(!isOfThese || s_seen.contains(change)) << change << " is listed, but no such call is made";
        }
    }

    static inline std::unique_ptr<TempFolder> s_folder;
    static inline std::set<std::string> s_seen;
    static inline rubble_renderer s_goneRenderer = 0;
};

}  // namespace rubble
