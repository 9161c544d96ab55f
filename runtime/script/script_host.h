#pragma once
#include <rubble/rubble.h>

#include <functional>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "runtime/script/profile_table.h"
#include "runtime/script/script.h"

namespace rubble::script {

/// What a host gives to the scripts of a world.
struct ScriptHostSettings {
    SandboxLimits limits;  ///< of each script
    /// The folder of which scripts may read files: Spawn(), require(), images and fonts; empty: none.
    std::string folder;
    /// The folder of the level's file, where the scripts that the level names lie and read files; empty: none. Those
    /// that are not there, as of a prefab of another script, are looked for in `folder`.
    std::string levelFolder;
    bool measuresFunctions = false;  ///< ScriptContext::costs: time and allocations of each function that scripts call
    /// Reports that the host wants beside those of the scripts: scripts set the filter of the world.
    rubble_report_filter reports = {};
    /// Functions of the host, which are globals of all scripts, and what they find in ScriptWorld::host. They outlive
    /// this.
    std::span<const ScriptFunction> functions = {};
    void* host = nullptr;
    /// Is told of all calls of functions; null: nobody.
    CallObserver* observer = nullptr;
    /// What print() writes, and what went wrong with script and line: RUBBLE_LOG_..., without a break.
    std::function<void(int level, const std::string&)> log;
};

/// The scripts of one world. All they do they do by the C interface, so that saves, recordings and undo know it as the
/// host's own edits; a replay needs no script.
///
///     ScriptHost scripts(*api, world, settings);
///     scripts.add("lift.lua", text);
///     for (;;) {
///         scripts.tick(secondsOfTheFrame);
///         while (a step is due) scripts.step();    // in place of api->step(world)
///         api->draw(renderer, &view);
///     }
class ScriptHost {
public:
    /// The world must outlive it.
    ScriptHost(const rubble_api& api, rubble_world world, ScriptHostSettings settings = {});
    /// Calls destroy() of all scripts.
    ~ScriptHost();
    ScriptHost(const ScriptHost&) = delete;
    ScriptHost& operator=(const ScriptHost&) = delete;

    /// Adds a script: runs its text, then init(). What goes wrong is logged, and Script::error() says it. `parameters`
    /// is what GetIntParam() and its like read.
    Script& add(const std::string& name, const std::string& text, std::map<std::string, std::string> parameters = {});

    /// Runs the scripts that the level names, which lie in ScriptHostSettings::levelFolder: after each load_level().
    /// Those of the level before it end, also if it is the same one; as after load(), destroy() has no world. From here
    /// on, and from the first Spawn() on, step() follows their list: what it names begins, and what it names no longer
    /// ends, after destroy(). One that cannot be read is logged.
    void addLevelScripts();
    /// Keeps the registry and the tables of saved() with the game: before save_game().
    rubble_result save();
    /// After load_game(): calls destroy() of all scripts, gives the registry and the tables of saved() back, and runs
    /// all scripts again, those of the loaded game's level among them: their text, then onLoad(), or init() where there
    /// is no such function. As after load_level(), what destroy() asks of the world has no effect: it is another one.
    void load();
    /// Calls the callbacks of events of the last step. step() does it; for a step that the host made by itself.
    void readEvents();
    /// Before a step in which the world undoes or redoes: lights of PointLight() that come back end with that step.
    void beforeUndo() { m_hasOldLights = true; }
    /// Gives a script another text, as after a change of its file: it begins again as after load(), and keeps the
    /// tables of saved(). A text that does not compile changes nothing. False: that, or it has failed, or there is none
    /// such.
    bool reload(const std::string& name, const std::string& text);

    /// Calls tick(dt) of all scripts: once a frame.
    void tick(double dt);
    /// Calls update(1/60 s), steps the world, and tells scripts what happened. The result is that of step().
    rubble_result step();

    /// What the host wants to be reported from the next step on, beside what scripts ask for: see
    /// ScriptHostSettings::reports.
    void setHostReports(const rubble_report_filter& reports);

    /// Around a step of the world, or apply_edits(), that the host takes itself: step() does both. After it nothing of
    /// what scripts have queued waits any more.
    void beforeEdits();
    /// See beforeEdits(). `steps`: how many steps of the world the host has taken.
    void afterEdits(uint64_t steps = 0);
    /// Goes on with what waits for such a step, or for a time that has come. step() does it.
    void resumeWaiting();

    /// What the camera sees, for scripts that ask before the first draw(): before add().
    void setView(const rubble_view& view);
    /// Calls draw(dt) of all scripts after tick(), for a view that is drawn next, and gives what they have drawn, the
    /// lines since tick() and the values of DebugWatch() to its renderer, of which there may be several.
    /// [render-thread, which is the main thread here] renderer 0: what is drawn only stands in shared().ui.items. Where
    /// no script draws, nothing is given.
    rubble_result draw(rubble_renderer renderer, const rubble_view& view, double dt);

    /// How many seconds of the world a second of the host shall be, as SetTimeScale() says.
    double timeScale() const { return m_shared.timeScale; }
    /// What scripts share: lines to draw, watches, the registry, which a host may fill and keep; whether frames show
    /// the profile.
    ScriptWorld& shared() { return m_shared; }
    /// All scripts, in the order in which they are called.
    const std::list<Script>& scripts() const { return m_scripts; }
    /// The same: erase one between steps to end it, without destroy().
    std::list<Script>& scripts() { return m_scripts; }

    /// How many scripts of a level run: the others of its list wait for their place.
    static constexpr size_t kMaxScripts = 1000;

private:
    /// By script and name of saved().
    using SavedTables = std::map<std::string, std::map<std::string, std::string>>;
    std::vector<LevelScriptName> namedScripts();
    void followLevel(SavedTables restored, bool isAgain);
    std::string folderOfScript(const std::string& name) const;
    void addLevelScript(const LevelScriptName& name, SavedTables& restored, bool isAgain);
    bool hasRoom(const std::string& path);
    Script& make(std::list<Script>::iterator before, const std::string& name, uint64_t number);
    uint64_t freeNumber() const;
    void endLevelScript(const LevelScriptName& name);
    std::list<Script>::iterator restart(std::list<Script>::iterator old, std::string text,
                                        std::map<std::string, std::string> restored);
    void begin(Script& script, const std::string& text, bool isAgain);
    void callFirst(Script& script);
    void forgetWorld();
    void removePlaceholders();
    void beginFrame();
    void resumeAll();
    void callAll(Callback callback, double dt);
    bool anyHas(Callback callback);
    void setReports();
    void tellSplits(const rubble_events& events);
    void tellReports();
    void tellTriggers();
    void dropPointLights();
    void removePointLights();
    void beginDrawing(const rubble_view& view);
    void addLinesAndWatches();
    void addProfile();
    rubble_result show(rubble_renderer renderer);

    ScriptHostSettings m_settings;
    ScriptWorld m_shared;
    std::list<Script> m_scripts;
    std::vector<LevelScriptName> m_named;   ///< scripts of the level that were begun
    std::set<rubble_renderer> m_overlaid;   ///< that have an overlay of the scripts
    std::optional<ProfileTable> m_profile;  ///< while it is shown
    uint32_t m_reports = 0;                 ///< kinds that the world lists for the scripts
    bool m_hasOldLights = false;            ///< of PointLight() in a world that another run has left
    bool m_isFullTold = false;              ///< that there are more scripts than may run
    bool m_hasReports = true;               ///< the world has the host's filter
};

}  // namespace rubble::script
