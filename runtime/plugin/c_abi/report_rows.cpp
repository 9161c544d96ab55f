#include "runtime/plugin/c_abi/report_rows.h"

#include "runtime/plugin/c_abi/checks.h"

namespace rubble::abi {
namespace {

constexpr uint32_t kContactKinds = RUBBLE_REPORT_CONTACT_BEGUN | RUBBLE_REPORT_CONTACT_SLID | RUBBLE_REPORT_CONTACT_HIT;
constexpr uint32_t kCharacterKinds = RUBBLE_REPORT_FOOTSTEP | RUBBLE_REPORT_WATER;

rubble_contact contactRow(const World& world, const ReportedContact& contact) {
    rubble_contact row = {};
    if (contact.begun) row.kinds |= RUBBLE_REPORT_CONTACT_BEGUN;
    if (contact.slid) row.kinds |= RUBBLE_REPORT_CONTACT_SLID;
    if (contact.hit) row.kinds |= RUBBLE_REPORT_CONTACT_HIT;
    for (size_t i = 0; i < 2; ++i) {
        const ContactSide& side = contact.sides[i];
        row.bodies[i] = side.body.bits;
        const ShapeHandle handle = world.shapes().handleAt(side.shapeSlot);
        if (!handle) continue;
        const Shape& shape = world.shapes().at(handle);
        row.shapes[i] = handle.bits;
        row.materials[i] = (*shape.palette)[shape.grid.at(side.cell)].material;
    }
    writeVector(row.position, contact.position);
    writeVector(row.normal, contact.normal);
    row.impulse = contact.impulse;
    row.hit_speed = contact.hitSpeed;
    row.slip_speed = contact.slipSpeed;
    row.size = contact.size;
    return row;
}

uint32_t whatHappened(JointBreak reason) {
    switch (reason) {
        case JointBreak::VoxelGone:
            return RUBBLE_REPORT_JOINT_VOXEL_GONE;
        case JointBreak::Force:
            return RUBBLE_REPORT_JOINT_OVERLOADED;
        case JointBreak::Removed:
            return RUBBLE_REPORT_JOINT_REMOVED;
        default:
            return RUBBLE_REPORT_JOINT_CUT;
    }
}

rubble_fire_report fireRow(const Fire& fire, bool lit) {
    rubble_fire_report row = {fire.shape.bits, lit, 0, {}};
    writeVector(row.position, fire.position);
    return row;
}

rubble_water_report waterRow(WaterHandle water, uint64_t object, glm::dvec3 position, double speed, double mass) {
    rubble_water_report row = {water.bits, object, {}, speed, mass};
    writeVector(row.position, position);
    return row;
}

}  // namespace

void ReportRows::setFilter(FrameLoop& loop, uint32_t kinds, ReportFilter filter, double stride) {
    filter.begun = kinds & RUBBLE_REPORT_CONTACT_BEGUN;
    filter.slid = kinds & RUBBLE_REPORT_CONTACT_SLID;
    filter.hit = kinds & RUBBLE_REPORT_CONTACT_HIT;
    filter.water = kinds & RUBBLE_REPORT_WATER;
    if (loop.physics()) loop.physics()->report(filter);
    if (kinds & ~m_kinds & RUBBLE_REPORT_FIRE) m_fireReports.restart(loop.world().data());
    m_kinds = kinds;
    m_stride = stride;
    if (!(kinds & kCharacterKinds)) m_characters.forget();
}

void ReportRows::fill(FrameLoop& loop) {
    if (m_listed) clear();
    m_listed = m_kinds;
    if (!m_kinds) return;
    const World& world = loop.world();
    if (loop.changes().levelReplaced) m_characters.forget();
    if (m_kinds & kContactKinds) fillContacts(world, loop.physics()->contacts());
    if (m_kinds & RUBBLE_REPORT_BREAK) fillBreaks(loop.changes());
    if (m_kinds & RUBBLE_REPORT_JOINT) fillJoints(loop.changes());
    if (m_kinds & RUBBLE_REPORT_FIRE) fillFires(world);
    if (m_kinds & kCharacterKinds) m_characters.step(loop.physics()->characters(), world, m_stride);
    if (m_kinds & RUBBLE_REPORT_WATER) fillWaters(world, loop.physics()->waterEntries());
    if (m_kinds & RUBBLE_REPORT_FOOTSTEP) fillFootsteps();
}

void ReportRows::restart(const FrameLoop& loop) {
    clear();
    if (m_kinds & RUBBLE_REPORT_FIRE) m_fireReports.restart(loop.world().data());
}

void ReportRows::follow(const FrameLoop& loop) {
    restart(loop);
    if (!(m_kinds & RUBBLE_REPORT_BREAK) || loop.changes().dust.empty()) return;
    m_listed = RUBBLE_REPORT_BREAK;
    fillBreaks(loop.changes());
}

void ReportRows::clear() {
    m_contacts.clear(), m_breaks.clear(), m_joints.clear();
    m_fires.clear(), m_waters.clear(), m_footsteps.clear();
    m_listed = 0;
}

void ReportRows::fillBreaks(const FrameChanges& changes) {
    reportBreaks(changes.dust, m_found);
    for (const BreakReport& each : m_found) {
        m_breaks.push_back({each.material, 0, each.voxels, {}, each.radius});
        writeVector(m_breaks.back().position, each.position);
    }
}

void ReportRows::fillContacts(const World& world, std::span<const ReportedContact> contacts) {
    for (const ReportedContact& contact : contacts) m_contacts.push_back(contactRow(world, contact));
}

void ReportRows::fillJoints(const FrameChanges& changes) {
    for (const JointBroken& broken : changes.jointsBroken) {
        m_joints.push_back({broken.joint.bits, whatHappened(broken.reason), 0, {}, 0, 0});
        writeVector(m_joints.back().position, broken.position);
    }
    for (const JointMoved& moved : changes.jointsMoved) {
        const uint32_t what = moved.to ? RUBBLE_REPORT_JOINT_MOVED : RUBBLE_REPORT_JOINT_LOOSE;
        m_joints.push_back({moved.joint.bits, what, 0, {}, moved.from.bits, moved.to.bits});
        writeVector(m_joints.back().position, moved.position);
    }
}

void ReportRows::fillFires(const World& world) {
    m_fireReports.step(world.data());
    for (const Fire& fire : m_fireReports.lit()) m_fires.push_back(fireRow(fire, true));
    for (const Fire& fire : m_fireReports.out()) m_fires.push_back(fireRow(fire, false));
}

void ReportRows::fillWaters(const World& world, std::span<const WaterEntry> entries) {
    for (const WaterEntry& each : entries)
        m_waters.push_back(
            waterRow(world.waters().handleAt(each.waterSlot), each.body.bits, each.position, each.speed, each.mass));
    for (const CharacterInWater& each : m_characters.inWater())
        m_waters.push_back(waterRow(each.water, each.character.bits, each.position, each.speed,
                                    world.characters().at(each.character).mass));
}

void ReportRows::fillFootsteps() {
    for (const Footstep& each : m_characters.footsteps()) {
        m_footsteps.push_back({each.character.bits,
                               each.landed ? uint32_t(RUBBLE_FOOTSTEP_LANDED) : 0u,
                               each.material,
                               each.shape.bits,
                               {},
                               each.speed});
        writeVector(m_footsteps.back().position, each.position);
    }
}

rubble_reports ReportRows::view() const {
    rubble_reports out = {};
    out.kinds = m_listed;
    const auto point = [](const auto& rows, auto& at, uint32_t& count) {
        at = rows.data();
        count = uint32_t(rows.size());
    };
    point(m_contacts, out.contacts, out.contact_count);
    point(m_breaks, out.breaks, out.break_count);
    point(m_joints, out.joints, out.joint_count);
    point(m_fires, out.fires, out.fire_count);
    point(m_waters, out.waters, out.water_count);
    point(m_footsteps, out.footsteps, out.footstep_count);
    return out;
}

}  // namespace rubble::abi
