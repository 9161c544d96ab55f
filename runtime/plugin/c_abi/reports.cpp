#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

constexpr NumberRange kReportSpeed{0.0, 1e6};  ///< m/s
constexpr NumberRange kStride{0.01, 1e3};      ///< m
/// What the world's own physics finds.
constexpr uint32_t kPhysicsKinds = RUBBLE_REPORT_CONTACT_BEGUN | RUBBLE_REPORT_CONTACT_SLID |
                                   RUBBLE_REPORT_CONTACT_HIT | RUBBLE_REPORT_WATER | RUBBLE_REPORT_FOOTSTEP;
constexpr uint32_t kAllKinds = 2 * RUBBLE_REPORT_FOOTSTEP - 1;

rubble_result setReportFilter(rubble_world world, const rubble_report_filter* filter) {
    return inWorld("set_report_filter", world, [&](HostedWorld& hosted) {
        const rubble_report_filter given = readStruct(filter, "filter");
        const uint32_t kinds = readFlags(given.kinds, kAllKinds, "filter->kinds");
        if (!hosted.loop.physics() && kinds & kPhysicsKinds)
            refuse(RUBBLE_ERROR_UNSUPPORTED,
                   "filter->kinds: the host's physics moves this world: it knows of contacts, water and footsteps");
        ReportFilter read;
        read.minImpulse = readInRange(given.min_impulse, ranges::kImpactThreshold, "filter->min_impulse");
        read.minHitSpeed = readOrDefault(given.min_hit_speed, kReportSpeed, read.minHitSpeed, "filter->min_hit_speed");
        read.minSlipSpeed =
            readOrDefault(given.min_slip_speed, kReportSpeed, read.minSlipSpeed, "filter->min_slip_speed");
        const double stride = readOrDefault(given.stride, kStride, 0.8, "filter->stride");
        if (!isRefused()) hosted.reports.setFilter(hosted.loop, kinds, read, stride);
    });
}

rubble_result getReports(rubble_world world, rubble_reports* out) {
    return inWorld("get_reports", world, [&](const HostedWorld& hosted) { writeStruct(out, hosted.reports.view()); });
}

}  // namespace

void setReportFunctions(rubble_api& api) {
    api.set_report_filter = setReportFilter;
    api.get_reports = getReports;
}

}  // namespace rubble::abi
