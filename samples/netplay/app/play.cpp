#include "samples/netplay/app/play.h"

#include <fmt/format.h>

#include <filesystem>

#include "samples/netplay/app/player_view.h"
#include "samples/netplay/app/step_clock.h"
#include "samples/netplay/bot.h"

namespace netplay {

volatile std::sig_atomic_t isInterrupted = 0;

void say(const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

namespace {

constexpr int kStepsBetweenAsks = 60;                     // of a bot
constexpr int kStepsBetweenClicks = 15;                   // of a player who holds the button, as the server allows
constexpr int kDefaultFrames = 12, kDefaultSeconds = 12;  // without a display
constexpr const char* kToolNames[kTools] = {"blast", "hammer", "paint", "push"};

/// A client with its world.
struct Seat {
    const Options& options;
    rubble::World world;
    Client client{world};
    uint32_t seed;

    Seat(const Options& given, const rubble_world_settings& settings, uint32_t number)
        : options(given), world(settings), seed(number) {}

    /// One step, with a new connection each second while there is none. False: the server does not want it.
    bool tick(int64_t step) {
        if (client.state() == Client::State::Disconnected && step % kStepsPerSecond == 0)
            client.connect(connectTo(options, seed += 1000));
        client.tick();
        if (step % (5 * kStepsPerSecond) == 0 && client.state() == Client::State::Playing)
            say(fmt::format("player {}: step {}, {} bodies", client.player(), client.appliedStep(),
                            world.get_body_states().size()));
        if (client.state() != Client::State::Refused) return true;
        fmt::print(stderr, "netplay: the server has refused: it is full, or of another version\n");
        return false;
    }
};

/// Whether the time of the options has come, or an interruption.
bool isOver(const Options& options, const StepClock& clock) {
    return isInterrupted || (options.seconds && clock.steps() >= int64_t(options.seconds) * kStepsPerSecond);
}

}  // namespace

int playInWindow(const Options& options) {
    const auto screen = Screen::openWindow(options.size, "Rubble netplay: blast");
    Seat seat(options, drawnWorld(), 1);
    PlayerView view(seat.world, seat.client, *screen, options.preset.c_str());
    Tool tool = Tool::Blast;
    int64_t nextUse = 0;
    StepClock clock;
    while (screen->poll() && !isOver(options, clock)) {
        for (int i = 0; i < kTools; ++i)
            if (screen->hasPressed(i + 1)) {
                tool = Tool(i);
                screen->setTitle(std::string("Rubble netplay: ") + kToolNames[i]);
            }
        for (rubble::PlayerInput input = screen->input(); clock.take(); input.turnRight = input.turnUp = 0.0) {
            const bool isUsing = screen->isClicking() && clock.steps() >= nextUse;
            if (isUsing) nextUse = clock.steps() + kStepsBetweenClicks;
            view.act(input, tool, isUsing);
            if (!seat.tick(clock.steps())) return 1;
            view.follow();
        }
        view.draw(clock.part());
        screen->present();
    }
    return 0;
}

int playIntoFrames(const Options& given) {
    Options options = given;
    if (options.frames == 0) options.frames = kDefaultFrames;
    if (options.seconds == 0) options.seconds = kDefaultSeconds;
    std::filesystem::create_directories(options.out);
    const auto screen = Screen::inMemory(options.size);
    Seat seat(options, drawnWorld(), 1);
    Bot bot(std::random_device{}(), options.rows, kStepsBetweenAsks);
    PlayerView view(seat.world, seat.client, *screen, options.preset.c_str());
    StepClock clock;
    for (int frame = 0; frame < options.frames && !isInterrupted; clock.wait()) {
        while (clock.take()) {
            bot.act(seat.client);
            if (!seat.tick(clock.steps())) return 1;
            view.follow();
        }
        view.lookAt(bot.target());
        view.draw(clock.part());
        const int64_t due = int64_t(frame + 1) * options.seconds * kStepsPerSecond / options.frames;
        if (clock.steps() < due) continue;
        const std::string path = fmt::format("{}/{:04d}.png", options.out, frame++);
        writeImage(path, screen->size(), screen->read());
        say(fmt::format("{}: step {}", path, seat.client.appliedStep()));
    }
    return 0;
}

int playBots(const Options& options) {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_HOST_PHYSICS;
    std::vector<std::unique_ptr<Seat>> seats;
    std::vector<Bot> bots;
    for (int i = 0; i < options.bots; ++i) {
        seats.push_back(std::make_unique<Seat>(options, settings, uint32_t(i + 1)));
        bots.emplace_back(uint32_t(i + 1), options.rows, kStepsBetweenAsks);
    }
    for (StepClock clock; !isOver(options, clock); clock.wait()) {
        if (!clock.take()) continue;
        for (size_t i = 0; i < seats.size(); ++i) {
            bots[i].act(seats[i]->client);
            if (!seats[i]->tick(clock.steps() - 1)) return 1;
        }
    }
    return 0;
}

}  // namespace netplay
