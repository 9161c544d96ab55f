// Reads of a random host that answer with more than rows.
#include "tests/fuzz/random_host.h"

namespace rubble {

void RandomHost::callReports() {
    auto filter = sized<rubble_report_filter>();
    filter.kinds = whole(256), filter.min_impulse = number(10.0), filter.min_hit_speed = number(1.0);
    filter.min_slip_speed = number(1.0), filter.stride = number(2.0);
    if (m_decisions.oneIn(2)) api().set_report_filter(m_world, &filter);
    auto reports = sized<rubble_reports>();
    if (api().get_reports(m_world, &reports) != RUBBLE_OK) return;
    if (reports.struct_size < sizeof(rubble_reports)) return;
    for (uint32_t i = 0; i < reports.contact_count; ++i)
        if (!(reports.contacts[i].impulse > 0.0) || !reports.contacts[i].kinds) fail("a contact without an impulse");
    if (reports.contact_count) reached("reports of contacts");
    if (reports.break_count) reached("reports of breaks");
    if (reports.joint_count) reached("reports of joints");
}

void RandomHost::callBricks() {
    auto changes = sized<rubble_brick_changes>();
    changes.what = whole(2), changes.shape = any(shapes());
    changes.since = m_decisions.oneIn(2) ? 0 : m_decisions.oneIn(8) ? m_decisions.bits() : m_brickVersion;
    rubble_brick bricks[8] = {};
    uint32_t count = 0;
    api().get_changed_bricks(m_world, &changes, &m_brickVersion, bricks, 8, &count);
    if (changes.since && count) reached("lists of changed bricks");
    static std::vector<rubble_mesh_vertex> vertices(RUBBLE_MAX_BRICK_VERTICES);
    int32_t brick[3] = {bricks[0].x, bricks[0].y, bricks[0].z};
    if (m_decisions.oneIn(4)) brick[m_decisions.below(3)] = int32_t(whole(4)) - 1;
    const rubble_result meshed =
        api().mesh_brick(m_world, changes.shape, brick, vertices.data(), uint32_t(vertices.size()), &count);
    if (meshed == RUBBLE_ERROR_CAPACITY || (meshed == RUBBLE_OK && count % 4)) fail("mesh_brick");
    if (count) reached("meshes");
    static std::vector<uint8_t> bytes(8 * RUBBLE_BRICK_BYTES);
    uint64_t size = 0;
    api().read_bricks(m_world, changes.shape, bricks, m_decisions.below(9), bytes.data(), bytes.size(), &size);
    static std::vector<rubble_shadow_brick> shadow(64);
    const uint64_t since = m_decisions.oneIn(2) ? 0 : m_decisions.oneIn(8) ? m_decisions.bits() : m_shadowVersion;
    if (api().get_shadow_bricks(m_world, since, &m_shadowVersion, shadow.data(), 64, &count) == RUBBLE_OK && count)
        reached("bricks of the shadow volume");
}

void RandomHost::callParticles() {
    auto burst = sized<rubble_particle_burst>();
    burst.kind = whole(7), burst.count = whole(64), place(burst.position), burst.radius = number(2.0);
    fill(burst.velocity, 5.0), burst.spread = number(3.0), fill(burst.color, 1.0), burst.size = number(0.2);
    burst.growth = number(1.0), burst.opacity = number(1.0), burst.life = number(3.0), burst.glow = number(1.0);
    api().spawn_particles(m_world, &burst);
    rubble_particle rows[8];
    uint32_t count = 0;
    const rubble_result listed = api().get_particles(m_world, rows, 8, &count);
    if (listed != RUBBLE_ERROR_ARGUMENT && count > 4096) fail("too many particles");
    if (count) reached("particles");
}

}  // namespace rubble
