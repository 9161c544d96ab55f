#include "editor/ui/view/overlay_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "editor/core/places.h"
#include "editor/core/rotation.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

constexpr uint64_t kShownSteps = 30;  ///< for which a contact or a changed brick is shown
constexpr size_t kMaxMarks = 2000;    ///< of one kind: more could not be told apart
constexpr ImU32 kAwake = theme::kAccent, kAsleep = IM_COL32(150, 158, 170, 150);
constexpr ImU32 kLink = IM_COL32(120, 190, 240, 255), kGlow = IM_COL32(255, 232, 150, 255);

glm::dvec3 sizeOf(const rubble_shape_state& shape) {
    return {shape.size[0], shape.size[1], shape.size[2]};
}

void drawAnchors(Session& session, Wires& wires) {
    size_t marks = 0;
    const auto drawOf = [&](const rubble_shape_state& shape) {
        if (session.editor().view().hides(shape.shape)) return;
        for (const rubble_cell_box& box : session.world().get_anchors(shape.shape))
            if (++marks < kMaxMarks)
                wires.cells(shape, {box.low[0], box.low[1], box.low[2]}, {box.size[0], box.size[1], box.size[2]},
                            theme::kAccent, theme::kAccentFaint);
    };
    const std::vector<rubble_shape_state> selected = [&] {
        std::vector<rubble_shape_state> all;
        if (const rubble_shape shape = session.selectedShape()) all.push_back(session.world().get_shape_state(shape));
        return all.empty() ? session.world().get_shape_states(0) : all;
    }();
    for (const rubble_shape_state& shape : selected) drawOf(shape);
}

void drawSleep(Session& session, Wires& wires) {
    size_t marks = 0;
    for (const rubble_body_state& body : session.world().get_body_states()) {
        if (body.flags & RUBBLE_BODY_STATIC || ++marks > kMaxMarks) continue;
        const ImU32 color = body.flags & RUBBLE_BODY_ASLEEP ? kAsleep : kAwake;
        for (const rubble_shape_state& shape : session.world().get_shape_states(body.body))
            if (!session.editor().view().hides(shape.shape))
                wires.cells(shape, glm::dvec3(0.0), sizeOf(shape), color, 0,
                            body.flags & RUBBLE_BODY_ASLEEP ? 1.0f : 2.0f);
    }
}

void drawJoints(Session& session, Wires& wires) {
    for (const rubble_joint_state& joint : session.world().get_joint_states()) {
        const glm::dvec3 a = vectorOf(joint.first_anchor), b = vectorOf(joint.second_anchor);
        wires.line(a, b, kLink, 2.0f);
        wires.dot(a, kLink, 5.0f);
        wires.dot(b, kLink, 3.0f);
    }
}

void drawLights(Session& session, Wires& wires) {
    for (const rubble_light each : session.world().get_lights()) {
        const rubble_light_settings light = session.world().get_light_settings(each);
        const glm::dvec3 at = placeOf(session.world(), each).position;
        wires.dot(at, light.flags & RUBBLE_LIGHT_ENABLED ? kGlow : kAsleep, 5.0f);
        const double radius = std::max(light.radius, 0.15);
        wires.ring(at, {radius, 0, 0}, {0, 0, radius}, kGlow, 1.0f);
    }
}

/// From where the wire of a group begins to its lights.
void drawGroups(Session& session, Wires& wires) {
    const rubble::World& world = session.world();
    for (const rubble_light_group group : world.get_objects(RUBBLE_KIND_LIGHT_GROUP)) {
        const rubble_light_group_state state = world.get_light_group(group);
        const ImU32 color = (state.flags & (RUBBLE_GROUP_ON | RUBBLE_GROUP_OUT)) == RUBBLE_GROUP_ON ? kGlow : kAsleep;
        std::vector<glm::dvec3> ends;
        glm::dvec3 begin(0.0);
        for (const rubble_light light : world.get_lights())
            if (world.get_light_settings(light).group == group) ends.push_back(placeOf(world, light).position);
        for (const glm::dvec3& end : ends) begin += end / double(ends.size());
        if (state.supply_shape)
            begin = worldOf(world.get_shape_state(state.supply_shape),
                            glm::dvec3(state.supply_cell[0], state.supply_cell[1], state.supply_cell[2]) + 0.5);
        if (ends.empty() && !state.supply_shape) continue;
        for (const glm::dvec3& end : ends) wires.line(begin, end, color, 2.0f), wires.dot(end, color, 5.0f);
        if (state.supply_shape) wires.dot(begin, kLink, 6.0f);
        const std::string name = nameOf(world, group);
        wires.label(begin, theme::kText, (name.empty() ? handleText(group) : name).c_str());
    }
}

void drawGrid(Session& session, Wires& wires) {
    constexpr int kLines = 20;
    const glm::dvec3 middle(std::round(session.camera.pivot.x), 0.0, std::round(session.camera.pivot.z));
    for (int i = -kLines; i <= kLines; ++i) {
        const ImU32 color = i % 5 ? IM_COL32(255, 255, 255, 26) : IM_COL32(255, 255, 255, 60);
        wires.line(middle + glm::dvec3(i, 0, -kLines), middle + glm::dvec3(i, 0, kLines), color, 1.0f);
        wires.line(middle + glm::dvec3(-kLines, 0, i), middle + glm::dvec3(kLines, 0, i), color, 1.0f);
    }
}

}  // namespace

/// Those of the last steps: most touch in one step only.
void OverlayMarks::drawContacts(Session& session, Wires& wires) {
    const uint64_t now = session.editor().document().playedSteps();
    if (!session.editor().document().isPlaying()) return m_contacts.clear();
    if (session.version() != m_contactVersion) {
        const rubble_reports reports = session.world().get_reports();
        for (uint32_t i = 0; i < reports.contact_count; ++i)
            m_contacts.push_back({vectorOf(reports.contacts[i].position), vectorOf(reports.contacts[i].normal),
                                  reports.contacts[i].impulse, now});
    }
    m_contactVersion = session.version();
    std::erase_if(m_contacts, [&](const Contact& each) { return each.step + kShownSteps < now; });
    if (m_contacts.size() > kMaxMarks) m_contacts.erase(m_contacts.begin(), m_contacts.end() - kMaxMarks);
    for (const Contact& contact : m_contacts) {
        const double length = std::clamp(std::log10(1.0 + contact.impulse) * 0.3, 0.05, 1.5);
        const auto alpha = ImU32(255 - 215 * (now - contact.step) / (kShownSteps + 1));
        const ImU32 color = (theme::kAccent & 0x00ffffffu) | alpha << 24;
        wires.line(contact.at, contact.at + contact.normal * length, color, 2.0f);
        wires.dot(contact.at, color, 3.0f);
    }
}

void OverlayMarks::gatherBricks(Session& session, uint64_t now) {
    std::map<rubble_shape, uint64_t> versions;
    for (const rubble_shape_state& shape : session.world().get_shape_states(0)) {
        const auto known = m_brickVersions.find(shape.shape);
        rubble_brick_changes changes{};
        changes.shape = shape.shape;
        changes.since = known == m_brickVersions.end() ? 0 : known->second;
        uint64_t version = 0;
        try {
            for (const rubble_brick& each : session.world().get_changed_bricks(changes, &version))
                if (changes.since) m_bricks.push_back({shape.shape, {each.x, each.y, each.z}, now});
        } catch (const rubble::Error&) {  // it has another grid: from the next step on again
        }
        versions[shape.shape] = version;
    }
    m_brickVersions = std::move(versions);
}

void OverlayMarks::drawBricks(Session& session, Wires& wires) {
    const uint64_t now = session.editor().document().playedSteps();
    if (!session.editor().document().isPlaying()) return m_bricks.clear(), m_brickVersions.clear();
    if (m_brickVersions.empty() || now != m_brickStep) gatherBricks(session, now);
    m_brickStep = now;
    std::erase_if(m_bricks, [&](const ChangedBrick& each) {
        return each.step > now || each.step + kShownSteps < now || kindOf(session.world(), each.shape) < 0 ||
               session.editor().view().hides(each.shape);
    });
    if (m_bricks.size() > kMaxMarks) m_bricks.erase(m_bricks.begin(), m_bricks.end() - kMaxMarks);
    for (const ChangedBrick& each : m_bricks) {
        const auto alpha = ImU32(200 - 170 * (now - each.step) / (kShownSteps + 1));
        const ImU32 color = kLink & 0x00ffffffu;
        wires.cells(session.world().get_shape_state(each.shape), glm::dvec3(each.brick) * 8.0, glm::dvec3(8.0),
                    color | alpha << 24, color | alpha / 5 << 24);
    }
}

/// From red, where it breaks as it is, to a faint yellow, where it takes 64 times its load.
void OverlayMarks::drawLoad(Session& session, Wires& wires) {
    static constexpr ImU32 kHeat[LoadProbe::kLevels] = {IM_COL32(255, 60, 50, 210),  IM_COL32(255, 104, 46, 200),
                                                        IM_COL32(255, 142, 48, 185), IM_COL32(250, 176, 60, 165),
                                                        IM_COL32(240, 204, 90, 140), IM_COL32(228, 220, 128, 115),
                                                        IM_COL32(214, 222, 170, 90)};
    const rubble_shape shape = session.selectedShape();
    if (!shape || session.editor().document().isPlaying()) return;
    if (shape != m_load.shape || session.version() != m_loadVersion) m_load = LoadProbe::of(session.world(), shape);
    m_loadVersion = session.version();
    const rubble_shape_state state = session.world().get_shape_state(shape);
    glm::dvec3 middle(0.0);
    int count = 0;
    for (size_t i = 0; i < std::min(m_load.cells.size(), kMaxMarks); ++i) {
        const LoadProbe::Cell& each = m_load.cells[i];
        const ImU32 color = kHeat[each.level];
        wires.cells(state, glm::dvec3(each.cell) - 0.02, glm::dvec3(1.04), color,
                    (color & 0x00ffffffu) | (color >> 25 << 24), 1.0f);
        if (each.level == m_load.weakest) middle += glm::dvec3(each.cell) + 0.5, ++count;
    }
    const std::string text =
        count == 0            ? fmt::format("bears more than {} times its load", 1 << (LoadProbe::kLevels - 1))
        : m_load.weakest == 0 ? "weakest here: breaks under its load"
                              : fmt::format("weakest here: breaks at {} times its load", 1 << m_load.weakest);
    const glm::dvec3 at = count ? middle / double(count) : sizeOf(state) * 0.5;
    wires.label(worldOf(state, at), theme::kText, text.c_str());
}

void OverlayMarks::draw(Session& session, Wires& wires) {
    const Overlays& shown = session.editor().view().overlays;
    if (shown.contacts != m_asksForContacts) {
        rubble_report_filter filter{};
        constexpr uint32_t kKinds =
            RUBBLE_REPORT_CONTACT_BEGUN | RUBBLE_REPORT_CONTACT_SLID | RUBBLE_REPORT_CONTACT_HIT;
        filter.kinds = shown.contacts ? kKinds : 0;
        session.world().set_report_filter(filter);
        m_asksForContacts = shown.contacts;
    }
    if (shown.grid) drawGrid(session, wires);
    if (shown.anchors) drawAnchors(session, wires);
    if (shown.components) m_components.draw(session, wires);
    if (shown.load) drawLoad(session, wires);
    if (shown.sleep) drawSleep(session, wires);
    if (shown.contacts) drawContacts(session, wires);
    if (shown.joints) drawJoints(session, wires);
    if (shown.lights) drawLights(session, wires);
    if (shown.groups) drawGroups(session, wires);
    if (shown.bricks) drawBricks(session, wires);
}

}  // namespace editor
