#pragma once
#include <rubble/rubble.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "runtime/script/binding/ui_state.h"
#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {

/// A line of DrawLine(), DebugLine() or DebugCross().
struct WorldLine {
    std::array<double, 3> from, to;  ///< world, metres
    std::array<double, 4> color;     ///< 0 to 1, with opacity
    bool isOccluded = false;         ///< voxels hide it
};

/// The voxels of a shape with what calls that draw have written since the last step: what several of them draw in one
/// step adds up. Holes, TrimShape() and MergeShape() of that step are not in it.
struct GridCopy {
    std::array<int32_t, 3> size{};
    std::vector<uint8_t> voxels;  ///< as read_voxels() gives them
    /// A cell that holds a voxel which is not in `voxels`: the world removes a shape that has none when it is resized.
    std::optional<std::array<int32_t, 3>> placeholder = {};

    /// Where a cell is in `voxels`.
    size_t at(int32_t x, int32_t y, int32_t z) const {
        return (size_t(z) * size_t(size[1]) + size_t(y)) * size_t(size[0]) + size_t(x);
    }
};

/// What calls since the last step have set and reads of the interface do not know yet.
struct PendingReads {
    std::map<uint64_t, uint32_t> created;                  ///< objects, with their kinds: RUBBLE_KIND_...
    std::map<rubble_body, std::array<double, 6>> motions;  ///< velocity and angular velocity
    std::map<rubble_body, bool> kinds;                     ///< whether it is static
    std::map<rubble_light, rubble_light_settings> lights;
    /// By object and tag its value; nothing: the tag was taken away.
    std::map<std::pair<uint64_t, std::string>, std::optional<std::string>> tags;
};

/// The tag of lights of PointLight(), by which they are found in saves.
inline constexpr const char* kPointLightTag = "rubble.point_light";

struct ScriptFunction;

/// Is told of the calls of functions with effects and without, as of a host that writes down what scripts do.
class CallObserver {
public:
    virtual ~CallObserver() = default;
    /// Before a call: its arguments are what lies on the stack, which it leaves as it is.
    virtual void begin(lua_State* L, const ScriptFunction& function) = 0;
    /// It waits: other calls begin and end before its end.
    virtual void wait(lua_State* L, const ScriptFunction& function) = 0;
    /// After it, unless it has failed: its results are the topmost values of the stack.
    virtual void end(lua_State* L, const ScriptFunction& function, int results) = 0;
};

/// What the scripts of a world share: all functions of scripts work on it by the C interface.
struct ScriptWorld {
    const rubble_api* api = nullptr;
    rubble_world world = 0;        ///< 0: destroy() is called after it was replaced
    double time = 0.0;             ///< seconds of steps
    double timeScale = 1.0;        ///< as SetTimeScale() has set it; the host decides how many steps a frame has
    double timeStep = 1.0 / 60.0;  ///< of the callback that runs
    uint64_t step = 0;
    SharedMemory memory;   ///< of all scripts
    int64_t stepWork = 0;  ///< what all scripts have queued since the last step, by chargeStep()
    bool hasTime = true;   ///< false: nothing may wait for a time, because the host takes no steps
    PendingReads pending;
    std::map<rubble_shape, GridCopy> grids;        ///< of shapes whose voxels calls since the last step have written
    std::set<rubble_shape> reframed;               ///< whose cells the next step gives other coordinates
    std::map<uint64_t, rubble_light> pointLights;  ///< of PointLight() in this step and in the last, by its number
    std::map<std::string, std::string> registry;   ///< "a.b.c": its value as a text
    bool followsLevel = false;                     ///< the scripts that the world names run, or a prefab was placed
    std::vector<WorldLine> lines;                  ///< for frames until the next tick()
    UiFrame ui;
    std::map<std::string, std::string> watches;              ///< of DebugWatch(), by name
    bool showsProfile = false;                               ///< DebugProfile(): frames show what scripts cost
    std::function<void(int level, const std::string&)> log;  ///< RUBBLE_LOG_..., a line without a break
    std::span<const ScriptFunction> hostFunctions;           ///< globals beside those of the vocabulary
    void* host = nullptr;                                    ///< what those work on
    CallObserver* observer = nullptr;
};

/// What QueryRequire() and its like have set, for the next query.
struct QuerySettings {
    uint32_t flags = 0;  ///< RUBBLE_FILTER_...
    uint32_t layers = 0;
    std::vector<rubble_body> bodies;
    std::vector<rubble_shape> shapes;
};

/// What SetBrush() has set.
struct Brush {
    bool isCube = false, isNoise = false;
    double size = 1.0;  ///< cells
    uint8_t entry = 1;  ///< of the palette; 0: none
};

/// What calls of a function have cost.
struct FunctionCost {
    double seconds = 0.0;
    uint64_t allocations = 0;
};

/// A table of saved().
struct SavedTable {
    int reference;      ///< to it
    std::string place;  ///< "SCRIPT:LINE" of the call
};

/// One script, as its functions see it.
struct ScriptContext {
    ScriptWorld& shared;
    std::string name;
    std::string folder;             ///< that files are read from; empty: none
    uint64_t number = 0;            ///< among the scripts of the world, from 0 on
    lua_State* callback = nullptr;  ///< the thread of the callback that runs: only there may functions wait
    QuerySettings query;
    Brush brush;
    rubble_particle_burst particle = {};
    std::vector<UiState> ui;   ///< of UiPush(), the last one in use
    std::vector<int> started;  ///< of start(): references to lists of a function and its arguments
    std::map<std::string, std::string> parameters;
    std::map<std::string, SavedTable> saved;      ///< of saved()
    std::map<std::string, std::string> restored;  ///< what saved() gives: dataText() of each table
    std::vector<FunctionCost> costs;  ///< of each function of the vocabulary, where the host asks for them; else empty
    std::set<std::string> required;   ///< files that require() has read
    std::set<std::string> spawned;    ///< files that Spawn() has read
    std::set<std::string> warned;     ///< places that have been told of once
    int64_t stepWork = 0;             ///< what it has queued since the last step, by chargeStep()
    std::vector<uint64_t> calls;      ///< of each function of the vocabulary
    std::vector<uint64_t> rows;       ///< for lists, so that calls do not allocate

    /// That of the script that runs.
    static ScriptContext& of(lua_State* L) { return *static_cast<ScriptContext*>(Sandbox::of(L).owner()); }
};

/// A struct of the interface with its struct_size and zeros.
template <class T>
T sized() {
    T value = {};
    value.struct_size = sizeof(T);
    return value;
}

/// Checks what a call of the interface came to. False: something that it names is gone, which is told once for each
/// line of a script, or its world is, and the function has no effect. Everything else that is wrong is an error of the
/// script.
bool isDone(lua_State* L, rubble_result result);
/// Logs a warning of the running function, once for each line of a script.
void warnOnce(lua_State* L, const std::string& text);

/// A function that scripts call.
struct ScriptFunction {
    const char* signature;  ///< "MakeHole(pos, r0, r1, r2, silent)"
    const char* meaning;    ///< one sentence
    lua_CFunction function;
    int64_t stepWork = 0;  ///< of each call, for chargeStep(); what depends on the arguments it charges itself
    /// Where options of tables become fields of the interface, for messages: what they are called there, as
    /// "spring_hertz hertz, ...". All others as "sunColor". nullptr: there are none.
    const char* fields = nullptr;

    /// The name in its signature.
    std::string name() const {
        const std::string text = signature;
        return text.substr(0, text.find('('));
    }
    /// The names of its parameters, in order.
    std::vector<std::string> parameters() const;
};

/// An error where what the running function would queue is more than the script, or all of the world, may still queue
/// for the next step: as much work as a call, or a frame, may have. A unit is some 0.15 us of the step.
void requireStep(lua_State* L, int64_t work);
/// The same, and counts it, before it is queued.
void chargeStep(lua_State* L, int64_t work);

/// Ends the call of the running function, which gives its topmost values.
int endCall(lua_State* L, int results);

/// The function that runs, for messages.
const ScriptFunction& runningFunction(lua_State* L);

}  // namespace rubble::script
