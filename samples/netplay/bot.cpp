#include "samples/netplay/bot.h"

#include "samples/netplay/player.h"
#include "samples/netplay/yard.h"

namespace netplay {

double Bot::between(double low, double high) {
    return low + (high - low) * (double(m_random()) / 4294967295.0);
}

void Bot::act(Client& client) {
    if (client.state() != Client::State::Playing) return;
    if (m_steps % 90 == 0) {  // towards another place around the yard
        const Vec3 at = client.position();
        const Vec3 to = {between(-24.0, 24.0), between(3.0, 12.0), between(-24.0, 24.0)};
        client.move({(to[0] - at[0]) / 3.0, (to[1] - at[1]) / 3.0, (to[2] - at[2]) / 3.0});
    }
    if (++m_steps % m_stepsBetweenAsks) return;
    const Vec3 at = client.position();
    const Vec3 target = {housePlace(int(m_random() % uint32_t(m_rows)), m_rows) + between(-3.5, 3.5),
                         between(0.2, kHouseHeight),
                         housePlace(int(m_random() % uint32_t(m_rows)), m_rows) + between(-3.5, 3.5)};
    const uint32_t choice = m_random() % 8;  // blasts most of the time
    const Tool tool = choice < 4 ? Tool::Blast : choice < 6 ? Tool::Hammer : choice < 7 ? Tool::Push : Tool::Paint;
    client.ask(tool, {target[0] - at[0], target[1] - at[1], target[2] - at[2]});
}

}  // namespace netplay
