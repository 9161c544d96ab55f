#include "samples/netplay/player.h"

#include <algorithm>
#include <cmath>

namespace netplay {
namespace {

constexpr uint64_t kStepsBetweenUses = 15;
constexpr double kFarthest = 100.0, kLowest = 1.0, kHighest = 50.0;  // metres that players fly

void setAll(double (&out)[3], const Vec3& value) {
    std::copy(value.begin(), value.end(), out);
}

}  // namespace

Player::Player(uint32_t number) {
    const double angle = 2.4 * number;  // no two of them are near each other
    m_position = {26.0 * std::cos(angle), 6.0 + number % 4, 26.0 * std::sin(angle)};
}

void Player::want(const Input& input) {
    double length = 0.0;
    for (size_t i = 0; i < 3; ++i) {
        m_velocity[i] = kPlayerSpeed * input.velocity[i] / 127.0;
        length += m_velocity[i] * m_velocity[i];
    }
    const double tooFast = std::sqrt(length) / kPlayerSpeed;
    if (tooFast > 1.0)
        for (double& part : m_velocity) part /= tooFast;
}

void Player::step() {
    for (size_t i = 0; i < 3; ++i) m_position[i] += m_velocity[i] / kStepsPerSecond;
    m_position[0] = std::clamp(m_position[0], -kFarthest, kFarthest);
    m_position[1] = std::clamp(m_position[1], kLowest, kHighest);
    m_position[2] = std::clamp(m_position[2], -kFarthest, kFarthest);
}

bool Player::mayUse(uint64_t step) {
    if (step < m_nextUse) return false;
    m_nextUse = step + kStepsBetweenUses;
    return true;
}

void useTool(rubble::World& world, const Vec3& from, const Ask& ask) {
    double origin[3], direction[3];
    setAll(origin, from);
    std::copy(ask.direction.begin(), ask.direction.end(), direction);
    const rubble_hit hit = world.cast_ray(origin, direction, kReach);
    if (!hit.shape) return;
    const Vec3 place = {hit.position[0], hit.position[1], hit.position[2]};
    if (ask.tool == Tool::Blast) {
        rubble_explosion blast{};
        setAll(blast.position, place);
        world.explode(blast);
    } else if (ask.tool == Tool::Hammer) {
        rubble_break blow{};
        setAll(blow.position, place);
        setAll(blow.radii, {0.6, 0.5, 0.3});
        blow.tool = RUBBLE_TOOL_SLEDGE;
        world.break_voxels(blow);
    } else if (ask.tool == Tool::Paint) {
        rubble_paint paint{};
        setAll(paint.position, place);
        paint.color[0] = 230, paint.color[1] = 40, paint.color[2] = 40;
        world.paint(paint);
    } else {
        rubble_impulse push{};
        push.body = hit.body;
        setAll(push.position, place);
        for (size_t i = 0; i < 3; ++i) push.impulse[i] = direction[i] / 32767.0 * 2000.0;
        world.apply_impulse(push);
    }
}

}  // namespace netplay
