// What a step of a netplay server takes with many players who break the yard. The clients are simulated: they join,
// send what clients send, and read no more of the answers than where they are.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <random>

#include "samples/netplay/memory_transport.h"
#include "samples/netplay/server.h"
#include "samples/netplay/yard.h"

namespace netplay {
namespace {

constexpr int kRows = 3, kSeconds = 60, kStepsBetweenAsks = 4 * kStepsPerSecond;

/// Milliseconds of processor time of this thread.
double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

class SimulatedClient {
public:
    SimulatedClient(MemoryNetwork& network, uint32_t seed) : m_transport(network.connect()), m_random(seed) {
        send(Join{});
    }
    void tick(int step) {
        Event event;
        while (m_transport->receive(event))
            if (event.kind == Event::Kind::Received) read(event.bytes);
        if (!m_player) return;
        if (step % kStepsPerPoses == 0) send(m_input);
        if ((step + int(7 * m_player)) % kStepsBetweenAsks == 0) shoot();
    }
    uint32_t player() const { return m_player; }

private:
    void send(const Message& message) { m_transport->send(0, Delivery::Reliable, encode(message)); }
    void read(const std::vector<uint8_t>& bytes) {
        const auto message = decode(bytes, false);
        if (const auto* welcome = std::get_if<Welcome>(&*message)) m_player = welcome->player;
        if (const auto* poses = std::get_if<Poses>(&*message)) {
            m_position = poses->players.front().position;
            m_input.newest = poses->sequence;
            m_input.older = ~0u;  // nothing is lost here
        }
    }
    double between(double low, double high) { return low + (high - low) * (double(m_random()) / 4294967295.0); }
    void shoot() {
        const Vec3 target = {housePlace(int(m_random() % kRows), kRows) + between(-3.5, 3.5),
                             between(0.2, kHouseHeight),
                             housePlace(int(m_random() % kRows), kRows) + between(-3.5, 3.5)};
        Ask ask{Tool::Blast, {}};
        for (size_t i = 0; i < 3; ++i) ask.direction[i] = int16_t(300.0 * (target[i] - m_position[i]));
        send(ask);
        for (int8_t& part : m_input.velocity) part = int8_t(between(-60.0, 60.0));
    }

    std::unique_ptr<Transport> m_transport;
    std::mt19937 m_random;
    Input m_input;
    Vec3 m_position{};
    uint32_t m_player = 0;
};

double percentile(std::vector<double> values, double part) {
    std::sort(values.begin(), values.end());
    return values[std::min(size_t(part * double(values.size())), values.size() - 1)];
}

/// Runs a server with so many players; prints a row of the table.
void measure(int players) {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    rubble::World world(settings);
    buildYard(world, kRows);
    MemoryNetwork network;
    ServerSettings rules;
    rules.players = size_t(players);
    Server server(world, network.listen(), rules);
    std::vector<std::unique_ptr<SimulatedClient>> clients;
    for (int i = 0; i < players; ++i) clients.push_back(std::make_unique<SimulatedClient>(network, uint32_t(i + 1)));
    std::vector<double> steps;
    uint64_t awake = 0;
    for (int i = 0; i < kSeconds * kStepsPerSecond; ++i) {
        for (auto& client : clients) client->tick(i);
        const double before = processorTime();
        server.tick();
        steps.push_back(processorTime() - before);
        awake += world.get_step_stats().bodies_awake;
    }
    std::vector<double> bytes;
    for (auto& client : clients) bytes.push_back(double(server.trafficTo(client->player()).medianSecond()));
    fmt::print("{:>7}{:>9}{:>9}{:>9.2f}{:>9.2f}{:>9.2f}{:>12.1f}\n", players, world.get_body_states().size(),
               awake / steps.size(), percentile(steps, 0.5), percentile(steps, 0.99), percentile(steps, 1.0),
               percentile(bytes, 0.5) / 1e3);
}

}  // namespace
}  // namespace netplay

int main(int argc, char** argv) {
    fmt::print("A step of the server, ms of processor time, in {} s; each player asks every {} s\n", netplay::kSeconds,
               netplay::kStepsBetweenAsks / netplay::kStepsPerSecond);
    fmt::print("{:>7}{:>9}{:>9}{:>9}{:>9}{:>9}{:>12}\n", "players", "bodies", "awake", "p50", "p99", "max",
               "kB/s each");
    if (argc > 1) return netplay::measure(std::clamp(std::atoi(argv[1]), 1, 64)), 0;
    for (const int players : {1, 4, 16, 64}) netplay::measure(players);
    return 0;
}
