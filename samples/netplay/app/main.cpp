// ./rubble netplay: a server, or players that join one. All run in real time until they are interrupted.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <random>

#include "samples/netplay/app/play.h"
#include "samples/netplay/app/step_clock.h"
#include "samples/netplay/enet_transport.h"
#include "samples/netplay/server.h"
#include "samples/netplay/yard.h"
#include "samples/support/image_size.h"
#include "samples/support/number_option.h"

namespace netplay {
namespace {

constexpr const char* kHelp =
    "Several machines break one yard: a server that runs the world, and players that follow and ask.\n"
    "In a window: WASD and mouse fly, Space/Shift up and down, Control fast, 1 blast, 2 hammer, 3 paint, 4 push, left "
    "click uses it, Esc leaves.";

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
    auto listening = listenWithEnet(options.port, rules.players + 8);
    const uint16_t port = portOf(*listening);
    Server server(world, overLink(std::move(listening), options, 1), rules);
    say(fmt::format("listening on UDP port {}; ./rubble netplay --join HOST{}", port,
                    port == kPort ? "" : fmt::format(" --port {}", port)));
    for (StepClock clock; !isInterrupted && (!options.seconds || clock.steps() < options.seconds * kStepsPerSecond);
         clock.wait())
        if (clock.take()) server.tick();
    return 0;
}

int join(const Options& options) {
    if (options.port == 0) throw std::runtime_error("--port 0: expected that of the server");
    if (options.bots) return playBots(options);
    return options.frames || !Screen::hasDisplay() ? playIntoFrames(options) : playInWindow(options);
}

void addImageOptions(CLI::App& app, Options& options) {
    app.add_option("--frames", options.frames,
                   "no window: a bot plays, as so many images evenly over --seconds, or 12 s, from when it has joined")
        ->excludes("--server")
        ->check(CLI::Range(1, 1000));
    app.add_option("--out", options.out, "folder of the images")->capture_default_str();
    app.add_option_function<std::string>(
        "--size",
        [&](const std::string& text) {
            if (const std::string error = rubble::readImageSize(text, options.size.width, options.size.height);
                !error.empty())
                throw CLI::ValidationError("--size", error);
        },
        "of the image, WIDTHxHEIGHT [640x360]");
    app.add_option("--preset", options.preset, "draft, fast, balanced or accurate")
        ->capture_default_str()
        ->check(CLI::IsMember({"draft", "fast", "balanced", "accurate"}));
}

int run(int argc, char** argv) {
    CLI::App app{kHelp, "netplay"};
    Options options;
    auto* server = app.add_flag("--server", options.isServer, "run the world");
    auto* host = app.add_option("--join", options.host, "join the server on this host");
    server->excludes(host);
    app.add_option("--port", options.port, "UDP port of the server; --server: 0 is any that is free")
        ->capture_default_str()
        ->check(rubble::wholeFrom(0, 65535));
    app.add_option("--rows", options.rows, "rows of houses in the yard")
        ->check(CLI::Range(1, 4))
        ->capture_default_str();
    app.add_option("--level", options.level, "server: a level in place of the yard, .rubble or .vox")->excludes(host);
    app.add_option("--bots", options.bots, "so many bots join, and nothing is drawn")
        ->excludes(server)
        ->check(CLI::Range(1, 64));
    app.add_option("--seconds", options.seconds, "how long; 0: until it is interrupted")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    app.add_option("--latency", options.latency, "ms that each message from here takes longer")
        ->check(CLI::Range(0, 5000));
    app.add_option("--loss", options.loss, "percent of the datagrams from here that are lost")
        ->check(rubble::numberFrom(0.0, 90.0));
    addImageOptions(app, options);
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
