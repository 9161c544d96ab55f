// Saved games, and options that outlive the game.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "samples/sandbox/shell/functions.h"
#include "samples/sandbox/shell/game.h"

namespace sandbox {
namespace {

namespace fs = std::filesystem;
constexpr const char* kOptions = "options.";  ///< keys of the registry that outlive the game

}  // namespace

std::string Game::savePath(const std::string& name) const {
    return m_settings.saves + "/" + name + ".save";
}

bool Game::hasSave(const std::string& name) const {
    std::error_code ignored;
    return fs::is_regular_file(savePath(name), ignored);
}

/// Loads it into a world of its own, as only that finds all damage.
bool Game::canLoad(const std::string& name) const {
    if (!hasSave(name)) return false;
    rubble_world_settings settings = {};
    settings.struct_size = sizeof settings;
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    rubble_world scratch = 0;
    if (m_api.create_world(&settings, &scratch) != RUBBLE_OK) return false;
    const bool isGood = m_api.load_game(scratch, savePath(name).c_str()) == RUBBLE_OK;
    if (!isGood) fmt::print(stderr, "sandbox: {}\n", m_api.get_last_error());
    m_api.destroy_world(scratch);
    return isGood;
}

/// In a world and a script of its own, which alone ends where the text never does.
std::string Game::testPrefab(const std::string& name, const std::string& text) {
    static constexpr const char* kTest =
        "local environment = require('environment')()\n"
        "local chunk, what = load(GetString('drop.text'), '=' .. GetString('drop.name'), 't', environment)\n"
        "if not chunk then error(what, 0) end\n"
        "local prefab = chunk()\n"
        "if type(prefab) == 'table' and prefab.pieces then prefab.pieces(require('things').model) end\n";
    rubble_world_settings settings = {};
    settings.struct_size = sizeof settings;
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    rubble_world scratch = 0;
    if (m_api.create_world(&settings, &scratch) != RUBBLE_OK) return m_api.get_last_error();
    std::string what;
    {
        rubble::script::ScriptHostSettings host;
        host.folder = m_settings.folder;
        host.limits = scriptLimits();
        host.functions = gameFunctions();
        host.host = this;
        rubble::script::ScriptHost scripts(m_api, scratch, host);
        scripts.shared().registry["drop.text"] = text;
        scripts.shared().registry["drop.name"] = name;
        what = scripts.add(name, kTest).error();
    }
    m_api.destroy_world(scratch);
    return what;
}

std::string Game::save(const std::string& name) {
    std::error_code ignored;
    fs::create_directories(m_settings.saves, ignored);
    if (m_scripts->save() != RUBBLE_OK) return m_api.get_last_error();
    return m_api.save_game(m_world, savePath(name).c_str()) == RUBBLE_OK ? "" : m_api.get_last_error();
}

std::string Game::load(const std::string& name) {
    writeOptions();
    if (m_api.load_game(m_world, savePath(name).c_str()) != RUBBLE_OK) return m_api.get_last_error();
    m_api.set_undo_limit(m_world, kUndoMarks);
    m_marks = 0;
    m_replay.forget();
    m_player->adopt(false);
    m_sound.enter(m_world);
    m_scripts->load();
    readOptions();
    m_isCut = true;
    return "";
}

std::string Game::optionsPath() const {
    return m_settings.saves + "/options.txt";
}

void Game::readOptions() {
    std::error_code ignored;
    const bool isThere = fs::exists(optionsPath(), ignored);
    std::ifstream file;
    if (fs::is_regular_file(optionsPath(), ignored)) file.open(optionsPath());
    if (isThere && !file.is_open())
        fmt::print(stderr, "sandbox: {}: expected a file that can be read, found another thing: nothing is chosen\n",
                   optionsPath());
    for (std::string line; std::getline(file, line);)
        if (const size_t at = line.find('='); line.starts_with(kOptions) && at != line.npos)
            m_scripts->shared().registry[line.substr(0, at)] = line.substr(at + 1);
}

void Game::writeOptions() {
    if (m_settings.saves.empty()) return;
    std::error_code ignored;
    fs::create_directories(m_settings.saves, ignored);
    std::ofstream file(optionsPath());
    for (const auto& [key, value] : m_scripts->shared().registry)
        if (key.starts_with(kOptions) && value.find('\n') == value.npos) file << key << '=' << value << '\n';
    if (!file.flush())
        fmt::print(stderr, "sandbox: {}: expected a file that can be written: options are not kept\n", optionsPath());
}

}  // namespace sandbox
