// Saved games, and options that outlive the game.
#include <algorithm>
#include <filesystem>
#include <fstream>

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
    return fs::exists(savePath(name), ignored);
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
    m_player->adopt(false);
    m_sound.enter(m_world);
    m_scripts->load();
    readOptions();
    m_isCut = true;
    return "";
}

void Game::readOptions() {
    std::ifstream file(m_settings.saves + "/options.txt");
    for (std::string line; std::getline(file, line);)
        if (const size_t at = line.find('='); line.starts_with(kOptions) && at != line.npos)
            m_scripts->shared().registry[line.substr(0, at)] = line.substr(at + 1);
}

void Game::writeOptions() {
    if (m_settings.saves.empty()) return;
    std::error_code ignored;
    fs::create_directories(m_settings.saves, ignored);
    std::ofstream file(m_settings.saves + "/options.txt");
    for (const auto& [key, value] : m_scripts->shared().registry)
        if (key.starts_with(kOptions) && value.find('\n') == value.npos) file << key << '=' << value << '\n';
}

}  // namespace sandbox
