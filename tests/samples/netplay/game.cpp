#include "tests/samples/netplay/game.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

#include "samples/netplay/enet_transport.h"
#include "samples/netplay/yard.h"

namespace netplay {
namespace {

constexpr int kMaxStepsToSettle = 36'000;

rubble_world_settings serverSettings() {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    return settings;
}

double distance(const double* a, const double* b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

std::vector<uint8_t> cells(const rubble::World& world, const rubble_shape_state& shape, uint32_t what) {
    rubble_voxel_box box{};
    box.shape = shape.shape, box.what = what;
    std::copy_n(shape.size, 3, box.size);
    return world.read_voxels(box);
}

}  // namespace

Seat::Seat(const rubble_world_settings& settings, uint32_t seedOfBot, int rows, int stepsBetweenAsks)
    : world(settings), bot(seedOfBot, rows, stepsBetweenAsks), seed(seedOfBot) {}

Game::Game(const GameSettings& settings) : m_settings(settings), m_world(serverSettings()) {
    buildYard(m_world, settings.rows);
    auto listening = listenWithEnet(0, settings.players + 8, true);
    m_port = portOf(*listening);
    ServerSettings rules;
    rules.players = settings.players;
    m_server = std::make_unique<Server>(m_world, std::make_unique<LinkConditioner>(std::move(listening), settings.link),
                                        rules);
}

Seat& Game::add() {
    const auto seed = uint32_t(m_seats.size() + 1);
    m_seats.push_back(std::make_unique<Seat>(m_settings.world, seed, m_settings.rows, m_settings.stepsBetweenAsks));
    connect(*m_seats.back());
    return *m_seats.back();
}

void Game::connect(Seat& seat) {
    LinkSettings link = m_settings.link;
    link.seed = 1000 * ++seat.seed;
    seat.client.connect(std::make_unique<LinkConditioner>(connectWithEnet("127.0.0.1", m_port, true), link));
}

void Game::remember() {
    PastStep past{m_world.get_events().step, {}};
    rubble_row_list list{};
    list.kind = RUBBLE_ROWS_MOVED_BODIES;
    for (const rubble_body_state& state : m_world.read_rows<rubble_body_state>(list))
        past.positions[state.body] = {state.position[0], state.position[1], state.position[2]};
    m_past.push_back(std::move(past));
    if (m_past.size() > 120) m_past.pop_front();
}

void Game::compare(Seat& seat) {
    const uint64_t step = seat.client.appliedStep();
    if (seat.client.state() != Client::State::Playing || m_past.empty() || step < m_past.front().step) return;
    for (const auto& [body, expected] : m_past[size_t(step - m_past.front().step)].positions) {
        rubble_body there = 0;
        if (rubble::api().translate_handle(seat.world.handle(), body, &there) != RUBBLE_OK) continue;
        const double error = distance(expected.data(), seat.world.get_body_state(there).position);
        ++m_errors[std::min(size_t(error * 1000.0), m_errors.size() - 1)];
    }
}

void Game::tick() {
    m_server->tick();
    remember();
    for (const auto& seat : m_seats) {
        if (seat->isPlaying) seat->bot.act(seat->client);
        seat->client.tick();
        compare(*seat);
    }
}

void Game::run(int steps) {
    while (steps-- > 0) tick();
}

bool Game::settle() {
    for (const auto& seat : m_seats) seat->isPlaying = false;
    int waited = 0;
    for (int resting = 0; resting < 120; ++waited) {
        if (waited == kMaxStepsToSettle) return false;
        tick();
        rubble_row_list list{};
        list.kind = RUBBLE_ROWS_MOVED_BODIES;
        resting = m_world.read_rows<rubble_body_state>(list).empty() ? resting + 1 : 0;
    }
    const uint64_t last = m_server->step();
    const auto hasAll = [&](const auto& seat) {
        return seat->client.state() != Client::State::Playing ||
               (seat->client.appliedStep() >= last && seat->client.moving() == 0);
    };
    for (; !std::all_of(m_seats.begin(), m_seats.end(), hasAll); ++waited) {
        if (waited == kMaxStepsToSettle) return false;
        // ENet sends again by a clock of its own what the system has lost: steps must not run out before it does.
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        tick();
    }
    run(2 * kStepsPerSecond);
    return true;
}

int percentile(const std::vector<uint64_t>& histogram, double part) {
    const double all = double(std::accumulate(histogram.begin(), histogram.end(), uint64_t(0)));
    double sum = 0.0;
    for (size_t i = 0; i < histogram.size(); ++i) {
        sum += double(histogram[i]);
        if (sum >= part * all) return int(i + 1);
    }
    return 0;
}

std::string difference(const rubble::World& server, const rubble::World& client) {
    const auto here = server.get_shape_states(0), there = client.get_shape_states(0);
    if (here.size() != there.size()) return fmt::format("{} shapes, {} at the client", here.size(), there.size());
    for (size_t i = 0; i < here.size(); ++i) {
        const rubble_shape_state &a = here[i], &b = there[i];
        if (client.translate_handle(a.shape) != b.shape || client.translate_handle(a.body) != b.body)
            return fmt::format("shape {}: another one", i);
        if (!std::equal(a.size, a.size + 3, b.size) || a.voxel_count != b.voxel_count)
            return fmt::format("shape {}: {} voxels, {} at the client", i, a.voxel_count, b.voxel_count);
        for (const uint32_t what : {RUBBLE_VOXEL_INDEX, RUBBLE_VOXEL_PAINT})
            if (cells(server, a, what) != cells(client, b, what)) return fmt::format("shape {}: other voxels", i);
    }
    uint64_t hashes[2] = {};
    rubble::check(rubble::api().get_voxel_hash(server.handle(), &hashes[0]));
    rubble::check(rubble::api().get_voxel_hash(client.handle(), &hashes[1]));
    return hashes[0] == hashes[1] ? "" : "other palettes or light groups";
}

double farthestApart(const rubble::World& server, const rubble::World& client) {
    double farthest = 0.0;
    for (const rubble_body_state& here : server.get_body_states()) {
        const rubble_body_state there = client.get_body_state(client.translate_handle(here.body));
        farthest = std::max(farthest, distance(here.position, there.position));
    }
    return farthest;
}

}  // namespace netplay
