#pragma once
#include <rubble/rubble.h>

#include <memory>
#include <string>
#include <vector>

#include "runtime/script/binding/script_context.h"
#include "samples/stress/checks/scene_requests.h"

namespace stress {

/// A body after a step.
struct BodyRow {
    rubble_body_state state;
    rubble_body_properties properties;  ///< of a dynamic one

    /// Whether it moves freely.
    bool isDynamic() const { return !(state.flags & RUBBLE_BODY_STATIC); }
};

/// What a step has left behind, as a host sees it.
struct StepView {
    const rubble_api& api;
    rubble_world world;
    rubble_events events;
    std::vector<BodyRow> bodies, before;  ///< after this step and after the one before it, by handle
    const SceneRequests& requests;
    uint64_t step = 0;          ///< steps of the scenario that are done
    std::vector<uint8_t> game;  ///< at a border: the saved game

    /// Steps of the world that are done, with those of which the scenario knows nothing.
    uint64_t worldSteps() const { return step + requests.extraSteps; }

    /// The row of a body in one of the two lists; null: it is not there.
    static const BodyRow* find(const std::vector<BodyRow>& rows, rubble_body body);
};

/// Something that shall hold in every world.
class Check {
public:
    virtual ~Check() = default;
    /// What a report calls it.
    virtual const char* name() const = 0;
    /// After each step: what is wrong, or "".
    virtual std::string afterStep(const StepView&) { return {}; }
    /// Every few seconds, for what takes long.
    virtual std::string atBorder(const StepView&) { return {}; }
    /// After each of the next steps, without edits. A copy had loaded the game before them, and has done them as well.
    virtual std::string besideCopy(const StepView&, rubble_world) { return {}; }
    /// A level or a game was loaded: nothing of before counts.
    virtual void restart() {}
};

/// No voxel appears or vanishes unaccounted for.
std::unique_ptr<Check> makeAccountingCheck();
/// Objects that events made or destroyed are there or gone, no other ones are, and each body has a shape.
std::unique_ptr<Check> makeObjectCheck();
/// Positions and velocities are finite; pieces in free flight move as their bodies did.
std::unique_ptr<Check> makeMotionCheck();
/// Mass and centre of a body are those of its voxels.
std::unique_ptr<Check> makeMassCheck();
/// Bodies gain no energy in a closed system.
std::unique_ptr<Check> makeEnergyCheck();
/// The shadow volume of changes is that of a world which loads the game.
std::unique_ptr<Check> makeShadowCheck();
/// Pieces stay within the budgets of the settings.
std::unique_ptr<Check> makeBudgetCheck();
/// Lights are on shapes that are there.
std::unique_ptr<Check> makeLightCheck();
/// The hash of the state tells worlds apart that differ in one value.
std::unique_ptr<Check> makeHashCheck();
/// Brushes remove the voxels whose centres are inside.
std::unique_ptr<Check> makeBrushCheck();

/// All of them.
std::vector<std::unique_ptr<Check>> makeChecks();

/// rubble_world_settings.log of worlds that do again what another one does, and has logged.
inline void saysNothing(void*, int32_t, const char*) {}

/// A world that has loaded a game: it is destroyed with the object.
class LoadedCopy {
public:
    /// flags: RUBBLE_WORLD_... An error of loading is in error().
    LoadedCopy(const rubble_api& api, const std::vector<uint8_t>& game, uint32_t flags);
    ~LoadedCopy();
    LoadedCopy(const LoadedCopy&) = delete;
    LoadedCopy& operator=(const LoadedCopy&) = delete;

    /// Its world; 0 if there is an error.
    rubble_world world() const { return m_world; }
    /// What went wrong, or "".
    const std::string& error() const { return m_error; }

private:
    const rubble_api& m_api;
    rubble_world m_world = 0;
    std::string m_error;
};

/// The game of a world, as save_game_data() gives it; empty: the error is in get_last_error().
std::vector<uint8_t> savedGame(const rubble_api& api, rubble_world world);

/// All rows of a list of the interface: read(out, capacity, count).
template <class Row, class Read>
std::vector<Row> readRows(Read&& read) {
    std::vector<Row> rows(256);
    uint32_t count = 0;
    rubble_result result = read(rows.data(), uint32_t(rows.size()), &count);
    if (result == RUBBLE_ERROR_CAPACITY) {
        rows.resize(count);
        result = read(rows.data(), count, &count);
    }
    rows.resize(result == RUBBLE_OK ? count : 0);
    return rows;
}

/// The shapes of a body.
std::vector<rubble_shape_state> shapesOf(const rubble_api& api, rubble_world world, rubble_body body);
/// The voxels of a shape, as read_voxels() gives them.
std::vector<uint8_t> voxelsOf(const rubble_api& api, rubble_world world, const rubble_shape_state& shape);

}  // namespace stress
