// A random host with two worlds, of which one follows the other.
#include "tests/fuzz/random_host.h"

namespace rubble {

void RandomHost::followByDeltas() {
    worldInCall = 0;  // the follower logs as well
    const rubble_world follower = makeWorld();
    uint64_t size = 0;
    const bool hasMotion = !m_decisions.oneIn(3);
    const uint32_t events = m_decisions.oneIn(2) ? RUBBLE_DELTAS_EVENTS : 0;
    if (api().keep_deltas(m_world, events | (hasMotion ? RUBBLE_DELTAS_ALL : RUBBLE_DELTAS_EDITS)) != RUBBLE_OK)
        fail("keep_deltas");
    const auto hashOf = hasMotion ? api().get_resolved_hash : api().get_voxel_hash;
    const std::vector<uint8_t> game = saved();
    if (api().load_game_data(follower, game.data(), game.size()) != RUBBLE_OK) fail("load_game_data");
    bool isFollowing = true;
    for (uint32_t i = 1 + m_decisions.below(6); i-- > 0;) {
        callEdit();
        if (api().step(m_world) != RUBBLE_OK) fail("step");
        if (api().take_deltas(m_world, nullptr, 0, &size) != RUBBLE_OK) fail("take_deltas");
        std::vector<uint8_t> data(size);
        if (api().take_deltas(m_world, data.data(), size, &size) != RUBBLE_OK) fail("take_deltas");
        if (isFollowing && m_decisions.oneIn(4)) {
            std::vector<uint8_t> bad = data;
            const uint32_t at = m_decisions.below(uint32_t(size));
            bad[at] ^= uint8_t(1 + m_decisions.below(255));
            if (api().apply_deltas(follower, bad.data(), size) == RUBBLE_OK) fail("wrong bytes of deltas are applied");
            reached("wrong bytes of deltas");
        }
        const rubble_result applied = api().apply_deltas(follower, data.data(), size);
        if (isFollowing && applied != RUBBLE_OK) fail("apply_deltas");
        if (!isFollowing && applied == RUBBLE_OK) fail("a delta that does not follow is applied");
        if (m_decisions.oneIn(8)) isFollowing = isFollowing && api().step(follower) != RUBBLE_OK;
        uint64_t here = 0, there = 0;
        hashOf(m_world, &here), hashOf(follower, &there);
        if (isFollowing && here != there) fail("another hash after apply_deltas");
        reached("steps followed by deltas");
    }
    api().keep_deltas(m_world, 0);
    api().destroy_world(follower);
    worldInCall = m_world;
}

}  // namespace rubble
