// ./rubble netplay: a server, or clients that join one. Both run in real time until they are interrupted.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "samples/netplay/bot.h"
#include "samples/netplay/enet_transport.h"
#include "samples/netplay/link_conditioner.h"
#include "samples/netplay/server.h"
#include "samples/netplay/yard.h"

namespace netplay {
namespace {

struct Options {
    bool isServer = false;
    std::string host, level;
    uint16_t port = kPort;
    int rows = 2, bots = 1, seconds = 0, latency = 0;
    double loss = 0.0;
};

volatile std::sig_atomic_t isInterrupted = 0;

/// Calls step() sixty times a second; late steps are made up for, but not more than a second of them.
template <class F>
void runInRealTime(int seconds, F&& step) {
    using Clock = std::chrono::steady_clock;
    constexpr auto kStep = std::chrono::nanoseconds(1'000'000'000 / kStepsPerSecond);
    auto next = Clock::now();
    for (int64_t i = 0; !isInterrupted && (seconds == 0 || i < int64_t(seconds) * kStepsPerSecond); ++i) {
        step(i);
        next = std::max(next + kStep, Clock::now() - std::chrono::seconds(1));
        std::this_thread::sleep_until(next);
    }
}

void say(const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

std::unique_ptr<Transport> overLink(std::unique_ptr<Transport> transport, const Options& options, uint32_t seed) {
    if (options.latency == 0 && options.loss == 0.0) return transport;
    const int delay = options.latency * kStepsPerSecond / 1000;
    return std::make_unique<LinkConditioner>(std::move(transport), LinkSettings{delay, options.loss / 100.0, seed});
}

int serve(const Options& options) {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    rubble::World world(settings);
    if (options.level.empty())
        buildYard(world, options.rows);
    else
        world.load_level(options.level.c_str()), world.step();
    ServerSettings rules;
    rules.seed = uint64_t(std::random_device{}()) << 32 | std::random_device{}();
    rules.log = say;
    Server server(world, overLink(listenWithEnet(options.port, rules.players + 8), options, 1), rules);
    say(fmt::format("listening on UDP port {}; ./rubble netplay --join HOST", options.port));
    runInRealTime(options.seconds, [&](int64_t) { server.tick(); });
    return 0;
}

/// A client with its world and the bot that plays.
struct Seat {
    rubble::World world;
    Client client{world};
    Bot bot;
    explicit Seat(const rubble_world_settings& settings, uint32_t seed, int rows)
        : world(settings), bot(seed, rows, 60) {}
};

int join(const Options& options) {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_HOST_PHYSICS;
    std::vector<std::unique_ptr<Seat>> seats;
    for (int i = 0; i < options.bots; ++i) {
        seats.push_back(std::make_unique<Seat>(settings, uint32_t(i + 1), options.rows));
        seats.back()->client.connect(overLink(connectWithEnet(options.host, options.port), options, uint32_t(i + 2)));
    }
    runInRealTime(options.seconds, [&](int64_t step) {
        for (const auto& seat : seats) {
            if (seat->client.state() == Client::State::Disconnected && step % kStepsPerSecond == 0)
                seat->client.connect(overLink(connectWithEnet(options.host, options.port), options, uint32_t(step)));
            seat->bot.act(seat->client);
            seat->client.tick();
        }
        const Client& first = seats.front()->client;
        if (first.state() == Client::State::Refused) isInterrupted = 1;
        if (step % (5 * kStepsPerSecond) == 0 && first.state() == Client::State::Playing)
            say(fmt::format("player {}: step {}, {} bodies", first.player(), first.appliedStep(),
                            seats.front()->world.get_body_states().size()));
    });
    if (seats.front()->client.state() != Client::State::Refused) return 0;
    fmt::print(stderr, "netplay: the server has refused: it is full, or of another version\n");
    return 1;
}

int run(int argc, char** argv) {
    CLI::App app{"Several machines break one yard: a server that runs the world, and clients that follow and ask."};
    Options options;
    auto* server = app.add_flag("--server", options.isServer, "run the world");
    auto* host = app.add_option("--join", options.host, "join the server on this host");
    server->excludes(host);
    app.add_option("--port", options.port, "UDP port of the server")->capture_default_str();
    app.add_option("--rows", options.rows, "rows of houses in the yard")
        ->check(CLI::Range(1, 4))
        ->capture_default_str();
    app.add_option("--level", options.level, "server: a level in place of the yard, .rubble or .vox");
    app.add_option("--bots", options.bots, "players that join from here")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.add_option("--seconds", options.seconds, "how long; 0: until it is interrupted")->capture_default_str();
    app.add_option("--latency", options.latency, "ms that each message from here takes longer")
        ->check(CLI::Range(0, 5000));
    app.add_option("--loss", options.loss, "percent of the datagrams from here that are lost")
        ->check(CLI::Range(0, 90));
    CLI11_PARSE(app, argc, argv);
    std::signal(SIGINT, [](int) { isInterrupted = 1; });
    std::signal(SIGTERM, [](int) { isInterrupted = 1; });
    if (options.isServer) return serve(options);
    if (!options.host.empty()) return join(options);
    fmt::print(stderr, "netplay: expected --server or --join HOST; --help says more\n");
    return 1;
}

}  // namespace
}  // namespace netplay

int main(int argc, char** argv) try { return netplay::run(argc, argv); } catch (const std::exception& error) {
    fmt::print(stderr, "netplay: {}\n", error.what());
    return 1;
}
