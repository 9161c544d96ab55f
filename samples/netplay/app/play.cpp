#include "samples/netplay/app/play.h"

#include <fmt/format.h>

#include "samples/netplay/app/participant.h"
#include "samples/netplay/app/player_view.h"
#include "samples/netplay/app/step_clock.h"
#include "samples/netplay/bot.h"
#include "samples/support/out_folder.h"

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

void report(const Participant& seat, int64_t step) {
    if (step % (5 * kStepsPerSecond) == 0 && seat.link() == Participant::Link::Playing)
        say(fmt::format("player {}: step {}, {} bodies", seat.client.player(), seat.client.appliedStep(),
                        seat.world.get_body_states().size()));
}

/// Whether a bot need not go on.
bool isHopeless(Participant::Link link) {
    return link == Participant::Link::NoAnswer || link == Participant::Link::Refused;
}

/// What a bot's play came to when its time is over: it should be in the game then, unless somebody ended it early.
int exitCode(const Participant& seat) {
    if (seat.link() == Participant::Link::Playing || isInterrupted) return 0;
    if (seat.link() == Participant::Link::Connecting) fmt::print(stderr, "netplay: {}\n", seat.words());
    return 1;
}

/// Whether the time of the options has come, or an interruption.
bool isOver(const Options& options, const StepClock& clock) {
    return isInterrupted || (options.seconds && clock.steps() >= int64_t(options.seconds) * kStepsPerSecond);
}

}  // namespace

int playInWindow(const Options& options) {
    const auto screen = Screen::openWindow(options.size, "Rubble netplay: blast");
    Participant seat(options, drawnWorld(), 1);
    PlayerView view(seat.world, seat.client, *screen, options.preset.c_str());
    Tool tool = Tool::Blast;
    std::string title;
    int64_t nextUse = 0;
    StepClock clock;
    while (screen->poll() && !isOver(options, clock)) {
        for (int i = 0; i < kTools; ++i)
            if (screen->hasPressed(i + 1)) tool = Tool(i);
        const std::string words = seat.link() == Participant::Link::Playing ? kToolNames[int(tool)] : seat.words();
        if (std::exchange(title, "Rubble netplay: " + words) != title) screen->setTitle(title);
        for (rubble::PlayerInput input = screen->input(); clock.take(); input.turnRight = input.turnUp = 0.0) {
            const bool isUsing = screen->isClicking() && clock.steps() >= nextUse;
            if (isUsing) nextUse = clock.steps() + kStepsBetweenClicks;
            view.act(input, tool, isUsing);
            if (seat.tick(clock.steps()) == Participant::Link::Refused) return 1;
            report(seat, clock.steps());
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
    if (const std::string error = rubble::makeOutFolder(options.out); !error.empty())
        throw std::runtime_error("--out: " + error);
    const auto screen = Screen::inMemory(options.size);
    Participant seat(options, drawnWorld(), 1);
    Bot bot(std::random_device{}(), options.rows, kStepsBetweenAsks);
    PlayerView view(seat.world, seat.client, *screen, options.preset.c_str());
    StepClock clock;
    std::optional<int64_t> joined;  // the time of the images begins then
    for (int frame = 0; frame < options.frames && !isInterrupted; clock.wait()) {
        while (clock.take()) {
            bot.act(seat.client);
            if (isHopeless(seat.tick(clock.steps()))) return 1;
            report(seat, clock.steps());
            if (!joined && seat.link() == Participant::Link::Playing) joined = clock.steps();
            view.follow();
        }
        if (!joined) continue;
        view.lookAt(bot.target());
        view.draw(clock.part());
        const int64_t due = int64_t(frame + 1) * options.seconds * kStepsPerSecond / options.frames;
        if (clock.steps() - *joined < due) continue;
        const std::string path = fmt::format("{}/{:04d}.png", options.out, frame++);
        writeImage(path, screen->size(), screen->read());
        say(fmt::format("{}: step {}", path, seat.client.appliedStep()));
    }
    return exitCode(seat);
}

int playBots(const Options& options) {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_HOST_PHYSICS;
    std::vector<std::unique_ptr<Participant>> seats;
    std::vector<Bot> bots;
    for (int i = 0; i < options.bots; ++i) {
        seats.push_back(std::make_unique<Participant>(options, settings, uint32_t(i + 1)));
        bots.emplace_back(uint32_t(i + 1), options.rows, kStepsBetweenAsks);
    }
    for (StepClock clock; !isOver(options, clock); clock.wait()) {
        if (!clock.take()) continue;
        for (size_t i = 0; i < seats.size(); ++i) {
            bots[i].act(seats[i]->client);
            if (isHopeless(seats[i]->tick(clock.steps() - 1))) return 1;
            report(*seats[i], clock.steps() - 1);
        }
    }
    for (const auto& seat : seats)
        if (const int code = exitCode(*seat)) return code;
    return 0;
}

}  // namespace netplay
