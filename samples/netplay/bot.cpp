#include "samples/netplay/bot.h"

#include <cmath>

#include "samples/netplay/player.h"
#include "samples/netplay/yard.h"

namespace netplay {

double Bot::between(double low, double high) {
    return low + (high - low) * (double(m_random()) / 4294967295.0);
}

void Bot::act(Client& client) {
    if (client.state() != Client::State::Playing) return;
    const Vec3 at = client.position();
    if (m_steps % 90 == 0) {  // towards another place, a part of the way around the yard
        const double angle = std::atan2(at[2], at[0]) + between(-0.8, 0.8), far = between(0.75, 0.95) * kYardHalf;
        const Vec3 to = {far * std::cos(angle), between(3.0, 12.0), far * std::sin(angle)};
        client.move({(to[0] - at[0]) / 3.0, (to[1] - at[1]) / 3.0, (to[2] - at[2]) / 3.0});
    }
    if (++m_steps % m_stepsBetweenAsks) return;
    m_target = {housePlace(int(m_random() % uint32_t(m_rows)), m_rows) + between(-3.5, 3.5), between(0.2, kHouseHeight),
                housePlace(int(m_random() % uint32_t(m_rows)), m_rows) + between(-3.5, 3.5)};
    const uint32_t choice = m_random() % 8;  // blasts most of the time
    const Tool tool = choice < 4 ? Tool::Blast : choice < 6 ? Tool::Hammer : choice < 7 ? Tool::Push : Tool::Paint;
    client.ask(tool, {m_target[0] - at[0], m_target[1] - at[1], m_target[2] - at[2]});
}

}  // namespace netplay
