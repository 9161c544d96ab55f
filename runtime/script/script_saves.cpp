// What saves keep of scripts, and how scripts begin again: after a load, and with another text.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

#include "runtime/script/binding/data_text.h"
#include "runtime/script/binding/files.h"
#include "runtime/script/sandbox/script_name.h"
#include "runtime/script/script_host.h"

namespace rubble::script {
namespace {

constexpr const char* kDataName = "rubble.scripts";

void putText(std::string& bytes, const std::string& text) {
    const auto size = uint32_t(text.size());
    for (int i = 0; i < 4; ++i) bytes += char(size >> (8 * i) & 255);
    bytes += text;
}

/// The next text of those that putText() has written. False: there is none.
bool takeText(const std::string& bytes, size_t& at, std::string& out) {
    if (at + 4 > bytes.size()) return false;
    uint32_t size = 0;
    for (int i = 0; i < 4; ++i) size |= uint32_t(static_cast<unsigned char>(bytes[at + size_t(i)])) << (8 * i);
    if (size > bytes.size() - at - 4) return false;
    out = bytes.substr(at + 4, size);
    at += 4 + size;
    return true;
}

/// What writeSaved() is given, and gives.
struct Saving {
    int reference;
    std::string text = {};
    DataLosses losses = {};
};

int writeSaved(lua_State* L) {
    Saving& saving = *static_cast<Saving*>(lua_touserdata(L, 1));
    lua_rawgeti(L, LUA_REGISTRYINDEX, saving.reference);
    saving.text = dataText(L, -1, saving.losses);
    return 0;
}

std::map<std::string, std::string> parametersOf(const std::string& lines) {
    std::map<std::string, std::string> parameters;
    std::istringstream in(lines);
    for (std::string line; std::getline(in, line);)
        if (const size_t at = line.find('='); at != line.npos) parameters[line.substr(0, at)] = line.substr(at + 1);
    return parameters;
}

/// While it lives scripts find no world: theirs was replaced, and destroy() changes nothing in the one that came.
class WithoutWorld {
public:
    explicit WithoutWorld(ScriptWorld& shared) : m_shared(shared), m_world(std::exchange(shared.world, 0)) {}
    ~WithoutWorld() { m_shared.world = m_world; }
    WithoutWorld(const WithoutWorld&) = delete;
    WithoutWorld& operator=(const WithoutWorld&) = delete;

private:
    ScriptWorld& m_shared;
    rubble_world m_world;
};

int pushNothing(lua_State*) {
    return 0;
}

/// A name of a level on one line.
std::string quoted(std::string name) {
    std::replace_if(name.begin(), name.end(), isControl, '?');
    return '"' + name + '"';
}

}  // namespace

std::map<std::string, std::string> Script::savedTables() {
    std::map<std::string, std::string> out = m_context.restored;  // also what this run has not asked for yet
    for (const auto& [name, table] : m_context.saved) {
        const std::string place = table.place + ": saved \"" + name + "\"";
        Saving saving{table.reference};
        if (isStopped()) break;
        if (!m_sandbox.prepare(writeSaved, &saving))
            report(place + ": " + m_sandbox.refusal());
        else if (saving.text != "nil")  // else it stays as it was saved before
            out[name] = saving.text;
        for (const std::string& loss : saving.losses)
            if (m_context.warned.insert(place + loss).second && m_context.shared.log)
                m_context.shared.log(RUBBLE_LOG_WARNING,
                                     place +
                                         ": expected numbers, texts, booleans, vectors and tables of these, found " +
                                         name + loss + ": it is not kept");
    }
    return out;
}

rubble_result ScriptHost::save() {
    std::string bytes;
    putText(bytes, std::to_string(m_shared.step));
    for (const auto& [key, value] : m_shared.registry) {
        putText(bytes, "key " + key);
        putText(bytes, value);
    }
    for (Script& script : m_scripts)
        for (const auto& [name, text] : script.savedTables()) {
            putText(bytes, "table " + script.name() + "\n" + name);
            putText(bytes, text);
        }
    return m_shared.api->set_host_data(m_shared.world, kDataName, reinterpret_cast<const uint8_t*>(bytes.data()),
                                       bytes.size());
}

void ScriptHost::load() {
    for (Script& script : m_scripts) {
        const WithoutWorld replaced(m_shared);
        script.call(Callback::Destroy, pushNothing);
    }
    uint64_t count = 0;
    const rubble_api& api = *m_shared.api;
    api.get_host_data(m_shared.world, kDataName, nullptr, 0, &count);
    std::string bytes(count, '\0'), key, value;
    if (count) api.get_host_data(m_shared.world, kDataName, reinterpret_cast<uint8_t*>(bytes.data()), count, &count);
    SavedTables tables;
    m_shared.registry.clear();
    size_t at = 0;
    m_shared.step = takeText(bytes, at, value) ? std::strtoull(value.c_str(), nullptr, 10) : 0;
    m_shared.time = double(m_shared.step) / 60.0;
    while (takeText(bytes, at, key) && takeText(bytes, at, value)) {
        if (key.starts_with("key ")) m_shared.registry[key.substr(4)] = value;
        const size_t end = key.find('\n');
        if (key.starts_with("table ") && end != key.npos) tables[key.substr(6, end - 6)][key.substr(end + 1)] = value;
    }
    forgetWorld();
    std::erase_if(m_scripts, [](const Script& script) { return script.ofLevel().has_value(); });
    for (auto script = m_scripts.begin(); script != m_scripts.end(); ++script)
        script = restart(script, script->text(), std::move(tables[script->name()]));
    m_named.clear();
    m_shared.followsLevel = true;
    followLevel(std::move(tables), true);
}

void ScriptHost::forgetWorld() {
    afterEdits();
    m_shared.pointLights.clear();
    m_hasOldLights = true;
}

std::list<Script>::iterator ScriptHost::restart(std::list<Script>::iterator old, std::string text,
                                                std::map<std::string, std::string> restored) {
    make(old, old->name(), old->context().number);
    const auto made = std::prev(old);
    made->context().parameters = old->context().parameters;
    made->context().folder = old->context().folder;
    if (old->ofLevel()) made->setOfLevel(*old->ofLevel());
    made->context().restored = std::move(restored);
    m_scripts.erase(old);
    begin(*made, text, true);
    return made;
}

bool ScriptHost::reload(const std::string& name, const std::string& text) {
    for (auto script = m_scripts.begin(); script != m_scripts.end(); ++script) {
        if (script->name() != name) continue;
        std::string unused;
        if (!script->isStopped() && !script->compiles(text))
            return script->evaluate(text, unused);  // which says what is wrong, and runs nothing
        script->call(Callback::Destroy, pushNothing);
        const auto made = restart(script, text, script->savedTables());
        return made->error().empty();
    }
    return false;
}

std::vector<LevelScriptName> ScriptHost::namedScripts() {
    uint32_t count = 0;
    const rubble_api& api = *m_shared.api;
    if (api.get_level_scripts(m_shared.world, nullptr, 0, &count) != RUBBLE_OK || !count) return {};
    std::vector<rubble_level_script> rows(count);
    if (api.get_level_scripts(m_shared.world, rows.data(), count, &count) != RUBBLE_OK) return {};
    std::vector<LevelScriptName> names;
    if (count > kMaxScripts && !std::exchange(m_isFullTold, true) && m_shared.log)
        m_shared.log(RUBBLE_LOG_ERROR, "the level names the script \"" + std::string(rows[kMaxScripts].path) +
                                           "\" and others: expected at most " + std::to_string(kMaxScripts) +
                                           " scripts, found more, which do not run");
    rows.resize(std::min(rows.size(), kMaxScripts));
    for (const rubble_level_script& row : rows) names.emplace_back(row.path, row.parameters);
    return names;
}

void ScriptHost::addLevelScripts() {
    for (const LevelScriptName& name : std::exchange(m_named, {})) {
        const WithoutWorld replaced(m_shared);
        endLevelScript(name);
    }
    forgetWorld();
    m_shared.followsLevel = true;
    followLevel({}, false);
}

/// Several scripts may have one name, as those of two prefabs: each of the list stands for one that runs.
void ScriptHost::followLevel(SavedTables restored, bool isAgain) {
    std::vector<LevelScriptName> ended = m_named, begun;
    m_named = namedScripts();
    if (ended == m_named) return;
    for (const LevelScriptName& name : m_named) {
        const auto running = std::find(ended.begin(), ended.end(), name);
        if (running == ended.end())
            begun.push_back(name);
        else
            ended.erase(running);
    }
    for (const LevelScriptName& name : ended) endLevelScript(name);
    for (const LevelScriptName& name : begun) addLevelScript(name, restored, isAgain);
}

/// Of several the one that began last, as an undo would take it.
void ScriptHost::endLevelScript(const LevelScriptName& name) {
    const auto last = std::find_if(m_scripts.rbegin(), m_scripts.rend(),
                                   [&](const Script& script) { return script.ofLevel() == name; });
    if (last == m_scripts.rend()) return;  // it could not be read
    last->call(Callback::Destroy, pushNothing);
    m_scripts.erase(std::prev(last.base()));
}

/// Where a script of the level lies; "": nowhere.
std::string ScriptHost::folderOfScript(const std::string& name) const {
    const std::string path = withoutModFolder(name);
    if (!isScriptName(path) || !staysInside(path)) return "";
    for (const std::string& folder : {m_settings.levelFolder, m_settings.folder})
        if (!folder.empty() && !leadsOutside(folder, path) && isFile(folder + "/" + path)) return folder;
    return "";
}

/// Whether the memory of all scripts is enough for another one to begin.
bool ScriptHost::hasRoom(const std::string& path) {
    constexpr size_t kBegin = 1 << 20;
    const size_t most = SharedMemory::kScripts * m_settings.limits.memory;
    if (m_shared.memory.used + kBegin <= most || m_scripts.empty()) return true;
    if (!std::exchange(m_isFullTold, true) && m_shared.log)
        m_shared.log(RUBBLE_LOG_ERROR, "the level names the script \"" + path +
                                           "\": expected scripts that hold at most " + std::to_string(most) +
                                           " bytes together, found more: it does not run");
    return false;
}

void ScriptHost::addLevelScript(const LevelScriptName& named, SavedTables& restored, bool isAgain) {
    const auto& [path, parameters] = named;
    std::ifstream file;
    const std::string folder = folderOfScript(path);
    if (!folder.empty()) file.open(folder + "/" + withoutModFolder(path), std::ios::binary);
    if (!file.is_open()) {
        if (m_shared.log)
            m_shared.log(RUBBLE_LOG_ERROR, "the level names the script " + quoted(path) + ": expected " +
                                               (isScriptName(path) ? "a file beside the level, found none"
                                                                   : "a name of one line that ends in .lua"));
        return;
    }
    if (!hasRoom(path)) return;
    std::ostringstream text;
    text << file.rdbuf();
    std::set<std::string> taken;
    for (const Script& script : m_scripts) taken.insert(script.name());
    std::string name = path;  // several prefabs may have the same one
    for (int i = 2; taken.contains(name); ++i) name = path + "#" + std::to_string(i);
    Script& script = make(m_scripts.end(), name, freeNumber());
    script.context().parameters = parametersOf(parameters);
    script.context().folder = folder;
    script.context().restored = std::move(restored[name]);
    script.setOfLevel(named);
    begin(script, text.str(), isAgain);
}

}  // namespace rubble::script
