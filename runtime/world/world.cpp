#include "runtime/world/world.h"

#include <algorithm>
#include <new>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/world/edits/edit_error.h"
#include "runtime/world/history/net_changes.h"
#include "runtime/world/history/undo_history.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {

namespace {

/// Keeps a history if there are to be marks; a new one begins with the World as it is now.
void limitUndo(std::vector<UndoHistory>& undo, const WorldData& world, size_t marks) {
    if (marks == 0)
        undo.clear();
    else if (undo.empty())
        undo.emplace_back(world);
}

bool hasOtherEdits(const Edits& edits) {
    return std::any_of(edits.begin(), edits.end(),
                       [](const Edit& edit) { return !std::holds_alternative<HistoryEdit>(edit); });
}

}  // namespace

World::World(uint8_t id, uint32_t firstGeneration) : m_data(id, firstGeneration) {
    m_data.setEnvironment({});  // with a unit vector to the sun, as after loading
}
World::~World() = default;
World::World(const World&) = default;
World::World(World&&) noexcept = default;
World& World::operator=(const World&) = default;
World& World::operator=(World&&) noexcept = default;

void World::load(const Level& level) {
    m_undo.clear();
    loadLevel(m_data, level);
}

void setHostData(World& world, const std::string& name, std::string bytes) {
    std::vector<HostData>& all = world.m_data.hostData;
    std::erase_if(all, [&](const HostData& each) { return each.name == name; });
    if (!bytes.empty()) all.push_back({name, std::move(bytes)});
}

void World::setState(WorldState state) {
    m_undo.clear();
    m_data.clear();
    static_cast<WorldState&>(m_data) = std::move(state);
    m_data.shapes.forEach([](ShapeHandle, Shape& shape) {
        shape.anchors = translatedBoxes(shape.anchors, glm::ivec3(0), shape.grid.size());
    });
    m_data.rebuildIndexes();
}

FrameChanges World::beginStep() {
    FrameChanges changes;
    changes.step = ++m_data.step;
    changes.levelReplaced = std::exchange(m_data.levelReplaced, false);
    return changes;
}

void claimHandles(World& world, const Edits& edits) {
    for (const Edit& edit : edits)
        if (edit.made) withMapOf(objectsToReserve(world), edit.made, [](auto& map, auto handle) { map.claim(handle); });
}

FrameChanges World::applyEdits(const Edits& edits, const Edits& damage, Follows follows) {
    claimHandles(*this, damage);  // before undo, as where the handles were given out
    claimHandles(*this, edits);
    FrameChanges changes = beginStep();
    changes.isStill = follows == Follows::Nothing;
    limitUndo(m_undo, m_data, m_data.settings.undoMarks);
    // The first step after a load has edits that waited in the save among the damage.
    const bool wasUndoOrRedo = runHistory(edits, changes, runHistory(damage, changes, false));
    const bool hasLostStress = m_data.settings.stress.on && !m_data.stress;  // in applyDelta()
    if (changes.isStill)
        m_data.stress.reset();  // it has not seen these edits: the next step begins it again
    else if (wasUndoOrRedo || hasLostStress)
        m_data.restartStress();
    Edits all = damage;
    if (wasUndoOrRedo) std::erase_if(all, [](const Edit& edit) { return !edit.made; });
    all.insert(all.end(), edits.begin(), edits.end());
    const size_t restored = changes.entries();
    if (changes.isStill)
        EditStep(m_data, changes).runAlone(all);
    else if (!all.empty() || m_data.isBusy())
        EditStep(m_data, changes).run(all);
    const bool isOnlyHistory = wasUndoOrRedo && (changes.entries() == restored || !hasOtherEdits(all));
    for (UndoHistory& undo : m_undo) undo.recordStep(m_data, changes, isOnlyHistory);
    changes.keepsSleep = isOnlyHistory;
    keepNetChanges(changes, m_data);
    return changes;
}

/// Drops repeats once the list is longer than all bodies twice: no stage of a world that follows takes it.
static void dropRepeats(std::vector<BodyHandle>& bodies, size_t all) {
    if (bodies.size() <= 2 * all + 64) return;
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
}

FrameChanges World::applyDelta(std::optional<WorldDelta> delta) {
    FrameChanges changes = beginStep();
    for (auto* list : {&m_data.movedBodies, &m_data.leftBounds}) dropRepeats(*list, m_data.bodies.size());
    changes.unsettled = std::exchange(m_data.unsettled, {});
    if (!delta) return changes;
    m_undo.clear();
    m_data.stress.reset();
    swapObjects(m_data, std::move(*delta), changes);
    std::sort(changes.relocated.begin(), changes.relocated.end());
    restartPendingSplits(m_data);
    return changes;
}

/// Marks, undo, redo and how many marks are kept, before all other edits of the step. True if there was an undo or a
/// redo; wasUndoOrRedo: there was one before.
bool World::runHistory(const Edits& edits, FrameChanges& changes, bool wasUndoOrRedo) {
    size_t marks = m_data.settings.undoMarks;
    for (const Edit& edit : edits) {
        if (const auto* to = std::get_if<SettingsEdit>(&edit); to && editError(edit).empty())
            limitUndo(m_undo, m_data, marks = to->settings.undoMarks);
        const auto* history = std::get_if<HistoryEdit>(&edit);
        if (!history) continue;
        if (m_undo.empty())
            logWarning("undo: no marks are kept; call set_undo_limit() with more than 0 first");
        else if (wasUndoOrRedo)
            logWarning("undo: expected one undo or redo in a step, found more; this one is left out");
        else if (history->action == HistoryAction::Mark)
            m_undo[0].mark(marks);
        else
            wasUndoOrRedo = history->action == HistoryAction::Undo ? m_undo[0].undo(m_data, changes)
                                                                   : m_undo[0].redo(m_data, changes);
        if (wasUndoOrRedo && m_data.settings.split.partsPerStep) resetSearches(changes);
    }
    return wasUndoOrRedo;
}

/// Connectivity tests that wait have seen other voxels than there are now, and an undo may bring back a shape that was
/// waiting for its split.
void World::resetSearches(const FrameChanges& changes) {
    for (PendingSplit& pending : m_data.pendingSplits) pending.search.reset();
    for (const auto* list : {&changes.carved, &changes.shapesCreated})
        for (const ShapeHandle handle : *list)
            if (Shape* shape = m_data.shapes.find(handle)) shape->knownConnected = false;
}

std::optional<bool> differsFromMark(const World& world) {
    if (world.m_undo.empty()) return std::nullopt;
    return world.m_undo[0].differs(world.m_data);
}

void World::resetCaches(bool dropMarks) {
    try {
        m_data.restartStress();
    } catch (const std::bad_alloc&) {
        m_data.stress.reset();  // applyEdits() begins it
    }
    restartPendingSplits(m_data);
    if (dropMarks) m_undo.clear();
}

void World::setSettings(const WorldSettings& settings) {
    m_data.setSettings(settings);
}

void World::setPoses(std::span<const BodyPose> poses, std::optional<uint64_t> step) {
    for (const BodyPose& pose : poses)
        if (Body* body = m_data.bodies.find(pose.body)) {
            const bool changesSleep = body->asleep != pose.asleep;
            body->pose = pose.pose;
            body->velocity = pose.velocity;
            body->angularVelocity = pose.angularVelocity;
            body->asleep = pose.asleep;
            body->waitsToWake = pose.waitsToWake;
            for (const ShapeHandle shape : body->shapes) m_data.updateShapeBounds(shape);
            m_data.checkBounds(pose.body);
            if (!changesSleep) continue;
            body->restingSince = pose.asleep ? step.value_or(m_data.step) : 0;
            if (body->settled) m_data.unsettled.push_back(pose.body);
            body->settled = false;
            m_data.updateDebris(pose.body);
        }
    if (m_data.triggers.size())
        for (const BodyPose& pose : poses) m_data.movedBodies.push_back(pose.body);
    for (UndoHistory& undo : m_undo) undo.recordMoves(m_data, poses);
}

void World::setCharacters(std::span<const CharacterMove> moves) {
    for (const CharacterMove& move : moves)
        if (Character* character = m_data.characters.find(move.character)) {
            character->position = move.position;
            character->velocity = move.velocity;
            character->groundVelocity = move.groundVelocity;
            character->grounded = move.grounded;
            character->crouched = move.crouched;
            character->swimming = move.swimming;
            character->ground = move.ground;
            character->wantsJump = false;
        }
    for (UndoHistory& undo : m_undo) undo.recordMoves(m_data, moves);
}

void World::setRopes(std::span<const RopeMotion> ropes) {
    for (const RopeMotion& motion : ropes)
        if (Joint* joint = m_data.joints.find(motion.rope); joint && joint->points.size() == motion.points.size())
            joint->points.assign(motion.points.begin(), motion.points.end());
    if (!ropes.empty())
        for (UndoHistory& undo : m_undo) undo.recordMoves(m_data, ropes);
}

}  // namespace rubble
