#pragma once
#include <gtest/gtest.h>
#include <rubble/rubble.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "generated/paths.h"
#include "runtime/script/script_host.h"
#include "samples/lua/yard.h"
#include "tests/support/temp_folder.h"

namespace rubble::script {

/// A view from the origin.
inline rubble_view viewOf(uint32_t width, uint32_t height) {
    auto view = sized<rubble_view>();
    view.width = width, view.height = height;
    view.rotation[3] = 1.0;
    return view;
}

/// A yard with scripts.
class Yard {
public:
    /// Builds it, with limits for each script.
    explicit Yard(const SandboxLimits& limits = {}) {
        EXPECT_EQ(rubble_get_api(RUBBLE_VERSION, &m_api), RUBBLE_OK);
        auto settings = sized<rubble_world_settings>();
        settings.flags = RUBBLE_WORLD_NO_RENDERER;
        EXPECT_EQ(m_api->create_world(&settings, &m_world), RUBBLE_OK);
        EXPECT_EQ(lua_sample::buildYard(*m_api, m_world), "");
        std::filesystem::copy(RUBBLE_SOURCE_DIR "/samples/lua/files", m_folder.path());
        ScriptHostSettings given;
        given.limits = limits;
        given.folder = m_folder.path().string();
        given.log = [this](int level, const std::string& line) {
            if (m_log.size() < 1000) m_log.push_back({level, line.substr(0, 1000)});
        };
        m_host = std::make_unique<ScriptHost>(*m_api, m_world, given);
    }
    ~Yard() {
        m_host.reset();
        m_api->destroy_world(m_world);
    }
    Yard(const Yard&) = delete;
    Yard& operator=(const Yard&) = delete;

    /// Adds a script whose init() is this text, and steps until it waits no more. What went wrong, or "".
    std::string run(const std::string& text) {
        Script& script = m_host->add("test", "function init()\n" + text + "\nend");
        for (int i = 0; i < 300 && script.isWaiting(); ++i) EXPECT_EQ(m_host->step(), RUBBLE_OK);
        return script.error();
    }
    /// Adds a script whose draw(dt) is this text, and draws a view of 960 x 540 pixels. What went wrong, or "".
    std::string draw(const std::string& text) {
        Script& script = m_host->add("test", "function draw(dt)\n" + text + "\nend");
        EXPECT_EQ(m_host->draw(0, viewOf(960, 540), 1.0 / 60.0), RUBBLE_OK);
        return script.error();
    }
    /// The folder of its scripts.
    std::filesystem::path folder() const { return m_folder.path(); }
    /// What its host logs with.
    std::function<void(int, const std::string&)> log() {
        return [this](int level, const std::string& line) { m_log.push_back({level, line}); };
    }
    /// Its scripts.
    ScriptHost& host() { return *m_host; }
    /// The table of functions.
    const rubble_api& api() const { return *m_api; }
    /// Its world.
    rubble_world world() const { return m_world; }
    /// All lines of the log at a level or above.
    std::string logged(int level) const {
        std::string text;
        for (const auto& [each, line] : m_log)
            if (each >= level) text += line + "\n";
        return text;
    }
    /// The hash of its state.
    uint64_t hash() const {
        uint64_t out = 0;
        EXPECT_EQ(m_api->get_state_hash(m_world, &out), RUBBLE_OK);
        return out;
    }

private:
    const rubble_api* m_api = nullptr;
    rubble_world m_world = 0;
    TempFolder m_folder;
    std::vector<std::pair<int, std::string>> m_log;
    std::unique_ptr<ScriptHost> m_host;
};

}  // namespace rubble::script
