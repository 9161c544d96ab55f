#include "runtime/script/script_host.h"

#include <algorithm>
#include <utility>

#include "runtime/script/binding/arguments.h"

namespace rubble::script {
namespace {

constexpr double kStep = 1.0 / 60.0;

constexpr const char* kJointReports[] = {"voxel gone", "overloaded", "removed", "cut", "moved", "loose"};

int pushAll(lua_State* L, std::initializer_list<uint64_t> handles) {
    for (const uint64_t handle : handles) pushHandle(L, handle);
    return int(handles.size());
}

}  // namespace

ScriptHost::ScriptHost(const rubble_api& api, rubble_world world, ScriptHostSettings settings)
    : m_settings(std::move(settings)) {
    m_shared.api = &api;
    m_shared.world = world;
    m_shared.log = m_settings.log;
    m_shared.hostFunctions = m_settings.functions;
    m_shared.host = m_settings.host;
    m_shared.observer = m_settings.observer;
    m_hasReports = m_settings.reports.kinds == 0;
}

ScriptHost::~ScriptHost() {
    callAll(Callback::Destroy, 0.0);
}

Script& ScriptHost::add(const std::string& name, const std::string& text,
                        std::map<std::string, std::string> parameters) {
    Script& script = make(m_scripts.end(), name, freeNumber());
    script.context().parameters = std::move(parameters);
    script.context().folder = m_settings.folder;
    begin(script, text, false);
    return script;
}

/// Each has random numbers of its own, by its number among those that run.
Script& ScriptHost::make(std::list<Script>::iterator before, const std::string& name, uint64_t number) {
    SandboxLimits limits = m_settings.limits;
    limits.seed += number * 0x9e3779b97f4a7c15u;
    Script& script = *m_scripts.emplace(before, m_shared, name, limits);
    script.context().number = number;
    return script;
}

/// The least one that no script has.
uint64_t ScriptHost::freeNumber() const {
    std::vector<bool> isTaken(m_scripts.size() + 1);
    for (const Script& script : m_scripts)
        if (script.context().number < isTaken.size()) isTaken[script.context().number] = true;
    return uint64_t(std::find(isTaken.begin(), isTaken.end(), false) - isTaken.begin());
}

void ScriptHost::begin(Script& script, const std::string& text, bool isAgain) {
    if (m_settings.measuresFunctions || m_profile) script.context().costs.resize(script.context().calls.size());
    script.load(text, isAgain);
    callFirst(script);
}

/// Calls init() or onLoad() if the text of the script is done.
void ScriptHost::callFirst(Script& script) {
    if (script.takeReadiness()) script.call(script.first(), [](lua_State*) { return 0; });
}

bool ScriptHost::anyHas(Callback callback) {
    return std::any_of(m_scripts.begin(), m_scripts.end(), [&](Script& script) { return script.has(callback); });
}

void ScriptHost::setReports() {
    const uint32_t kinds = (anyHas(Callback::Contact) ? RUBBLE_REPORT_CONTACT_HIT : 0) |
                           (anyHas(Callback::Fire) ? RUBBLE_REPORT_FIRE : 0) |
                           (anyHas(Callback::Joint) ? RUBBLE_REPORT_JOINT : 0);
    if (kinds == m_reports && m_hasReports) return;
    rubble_report_filter filter = m_settings.reports;
    filter.struct_size = sizeof filter;
    filter.kinds |= kinds;
    if (m_shared.api->set_report_filter(m_shared.world, &filter) == RUBBLE_OK) m_reports = kinds, m_hasReports = true;
}

void ScriptHost::setHostReports(const rubble_report_filter& reports) {
    m_settings.reports = reports;
    m_hasReports = false;
}

void ScriptHost::callAll(Callback callback, double dt) {
    const bool givesTime = callback == Callback::Tick || callback == Callback::Update || callback == Callback::Draw;
    m_shared.timeStep = dt;
    for (Script& script : m_scripts)
        script.call(callback, [&](lua_State* L) {
            if (givesTime) lua_pushnumber(L, dt);
            return int(givesTime);
        });
}

void ScriptHost::beginFrame() {
    for (Script& script : m_scripts) script.beginFrame();
}

void ScriptHost::tick(double dt) {
    beginFrame();
    m_shared.lines.clear();
    callAll(Callback::Tick, dt);
}

/// Shapes that a script has resized and not drawn in are as empty as it left them.
void ScriptHost::removePlaceholders() {
    for (const auto& [shape, grid] : m_shared.grids) {
        if (!grid.placeholder) continue;
        auto box = sized<rubble_voxel_box>();
        const uint8_t none = 0;
        box.shape = shape;
        std::copy_n(grid.placeholder->data(), 3, box.low);
        std::fill_n(box.size, 3, 1);
        m_shared.api->write_voxels(m_shared.world, &box, &none, 1);
    }
}

void ScriptHost::beforeEdits() {
    setReports();
    if (!m_shared.grids.empty()) removePlaceholders();
}

void ScriptHost::afterEdits(uint64_t steps) {
    m_shared.step += steps;
    m_shared.time = double(m_shared.step) * kStep;
    m_shared.pending = {};
    m_shared.stepWork = 0;
    for (Script& script : m_scripts) script.context().stepWork = 0;
    m_shared.grids.clear();
    m_shared.reframed.clear();
}

rubble_result ScriptHost::step() {
    beginFrame();
    callAll(Callback::Update, kStep);
    beforeEdits();
    const rubble_result result = m_shared.api->step(m_shared.world);
    if (result != RUBBLE_OK) return result;
    afterEdits(1);
    if (std::exchange(m_hasOldLights, false))
        removePointLights();
    else if (!m_shared.pointLights.empty())
        dropPointLights();
    readEvents();
    resumeAll();
    if (m_shared.followsLevel) followLevel({}, false);
    return result;
}

void ScriptHost::resumeWaiting() {
    beginFrame();
    resumeAll();
}

void ScriptHost::resumeAll() {
    for (Script& script : m_scripts) {
        if (script.isWaiting()) script.resumeWaiting();
        callFirst(script);
    }
}

void ScriptHost::dropPointLights() {
    std::erase_if(m_shared.pointLights, [&](const auto& row) {
        if (row.second + 1 > m_shared.step) return false;
        m_shared.api->remove_light(m_shared.world, row.first);
        return true;
    });
}

/// All that there are after a step: also those of a save, or of a mark that was returned to.
void ScriptHost::removePointLights() {
    m_shared.pointLights.clear();
    uint32_t count = 0;
    const rubble_api& api = *m_shared.api;
    const auto find = [&](uint64_t* out, uint32_t capacity) {
        return api.find_by_tag(m_shared.world, RUBBLE_KIND_LIGHT, kPointLightTag, nullptr, out, capacity, &count);
    };
    if (find(nullptr, 0) != RUBBLE_OK || !count) return;
    std::vector<uint64_t> lights(count);
    if (find(lights.data(), count) != RUBBLE_OK) return;
    for (const uint64_t light : lights) api.remove_light(m_shared.world, light);
}

void ScriptHost::readEvents() {
    auto events = sized<rubble_events>();
    if (m_scripts.empty() || m_shared.api->get_events(m_shared.world, &events) != RUBBLE_OK) return;
    for (Script& script : m_scripts) {
        for (uint32_t i = 0; i < events.removed_count && script.has(Callback::Break); ++i)
            script.call(Callback::Break, [&](lua_State* L) {
                const rubble_removed_voxels& row = events.removed[i];
                return pushAll(L, {row.shape, row.count, row.palette_index});
            });
        for (uint32_t i = 0; i < events.bodies_broken_count && script.has(Callback::BodyBreak); ++i)
            script.call(Callback::BodyBreak, [&](lua_State* L) { return pushAll(L, {events.bodies_broken[i]}); });
        for (uint32_t i = 0; i < events.light_groups_out_count && script.has(Callback::LightOut); ++i)
            script.call(Callback::LightOut, [&](lua_State* L) { return pushAll(L, {events.light_groups_out[i]}); });
    }
    if (events.split_count && anyHas(Callback::Split)) tellSplits(events);
    if (m_reports) tellReports();
    tellTriggers();
}

void ScriptHost::tellSplits(const rubble_events& events) {
    for (uint32_t first = 0; first < events.split_count;) {
        const rubble_shape parent = events.splits[first].parent;
        std::vector<uint64_t> pieces;
        for (; first < events.split_count && events.splits[first].parent == parent; ++first)
            pieces.push_back(events.splits[first].piece);
        for (Script& script : m_scripts)
            script.call(Callback::Split, [&](lua_State* L) {
                pushHandle(L, parent);
                return 1 + pushHandles(L, pieces.data(), pieces.size());
            });
    }
}

void ScriptHost::tellReports() {
    auto reports = sized<rubble_reports>();
    if (m_shared.api->get_reports(m_shared.world, &reports) != RUBBLE_OK) return;
    for (Script& script : m_scripts) {
        for (uint32_t i = 0; i < reports.contact_count && script.has(Callback::Contact); ++i)
            script.call(Callback::Contact, [&](lua_State* L) {
                const rubble_contact& contact = reports.contacts[i];
                pushAll(L, {contact.bodies[0], contact.bodies[1]});
                pushVector(L, contact.position);
                pushVector(L, contact.normal);
                lua_pushnumber(L, contact.impulse);
                return 5;
            });
        for (uint32_t i = 0; i < reports.fire_count && script.has(Callback::Fire); ++i)
            script.call(Callback::Fire, [&](lua_State* L) {
                pushHandle(L, reports.fires[i].shape);
                pushVector(L, reports.fires[i].position);
                lua_pushboolean(L, reports.fires[i].lit);
                return 3;
            });
        for (uint32_t i = 0; i < reports.joint_count && script.has(Callback::Joint); ++i)
            script.call(Callback::Joint, [&](lua_State* L) {
                const rubble_joint_report& row = reports.joints[i];
                pushHandle(L, row.joint);
                lua_pushstring(L, kJointReports[std::min<size_t>(row.what, std::size(kJointReports) - 1)]);
                return 2 + pushAll(L, {row.from, row.to});
            });
    }
}

void ScriptHost::tellTriggers() {
    uint32_t count = 0;
    m_shared.api->get_trigger_events(m_shared.world, nullptr, 0, &count);
    if (!count || !anyHas(Callback::Trigger)) return;
    std::vector<rubble_trigger_event> rows(count);
    if (m_shared.api->get_trigger_events(m_shared.world, rows.data(), count, &count) != RUBBLE_OK) return;
    for (Script& script : m_scripts)
        for (const rubble_trigger_event& row : rows)
            script.call(Callback::Trigger, [&](lua_State* L) {
                pushAll(L, {row.trigger, row.body});
                lua_pushboolean(L, row.entered);
                return 3;
            });
}

}  // namespace rubble::script
