#pragma once
#include <span>
#include <vector>

#include "runtime/plugin/break_reports.h"
#include "runtime/plugin/character_reports.h"
#include "runtime/plugin/fire_reports.h"
#include "runtime/plugin/frame_loop.h"
#include "runtime/plugin/include/rubble/rubble.h"

namespace rubble::abi {

/// The arrays that rubble_reports points at, from one step to the next. They keep their memory; while nothing is asked
/// for, nothing is done.
class ReportRows {
public:
    /// What is listed from the next step on. kinds: RUBBLE_REPORT_...; stride: see CharacterReports.
    void setFilter(FrameLoop& loop, uint32_t kinds, ReportFilter filter, double stride);
    /// Replaces all rows by those of the last step.
    void fill(FrameLoop& loop);
    /// Removes all rows: the steps that they were of are not those that led to this world.
    void restart(const FrameLoop& loop);
    /// The same in a world that has followed another one: of its last step it knows the breaks, if it was told.
    void follow(const FrameLoop& loop);
    /// Pointers to the rows and their counts, valid until the next fill(); struct_size is left to the caller.
    rubble_reports view() const;

private:
    void clear();
    void fillBreaks(const FrameChanges& changes);
    void fillContacts(const World& world, std::span<const ReportedContact> contacts);
    void fillJoints(const FrameChanges& changes);
    void fillFires(const World& world);
    void fillWaters(const World& world, std::span<const WaterEntry> entries);
    void fillFootsteps();

    uint32_t m_kinds = 0;   ///< RUBBLE_REPORT_... of the next step
    uint32_t m_listed = 0;  ///< of the last
    double m_stride = 0.8;  ///< metres
    CharacterReports m_characters;
    FireReports m_fireReports;
    std::vector<BreakReport> m_found;
    std::vector<rubble_contact> m_contacts;
    std::vector<rubble_break_report> m_breaks;
    std::vector<rubble_joint_report> m_joints;
    std::vector<rubble_fire_report> m_fires;
    std::vector<rubble_water_report> m_waters;
    std::vector<rubble_footstep> m_footsteps;
};

}  // namespace rubble::abi
