// Processor time of the game's sound a step, without and with OpenAL: ./rubble bench sound.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "samples/sandbox/sound/mixer.h"
#include "samples/sandbox/sound/output.h"

namespace sandbox::sound {
namespace {

double processorMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

struct Times {
    std::vector<double> join, mix, play;
    static double at(std::vector<double> times, double share) {
        std::sort(times.begin(), times.end());
        return times[size_t(share * double(times.size() - 1))];
    }
};

/// Hits of four materials in sizes from 0.1 to 1 m, all over a place of 20 m.
std::vector<Strike> hits(int count, Random& random) {
    const char* materials[] = {"brick", "concrete", "wood", "glass"};
    std::vector<Strike> strikes;
    for (int i = 0; i < count; ++i) {
        const size_t row = findAcousticMaterial(materials[random.bits() % 4]);
        const double size = 0.1 + 0.9 * random.unit();
        const auto sides = bodySize(acousticMaterials()[row], {size, 0.8 * size, 0.1}, 0.1);
        const glm::dvec3 at(10.0 * random.sign(), random.unit(), -12.0 + 10.0 * random.sign());
        strikes.push_back({at, row, sides, 5.0 * random.exponential(), 1e-4});
    }
    return strikes;
}

void measure(double perSecond) {
    std::string why;
    const auto output = Output::openMemory(why);
    if (!output) return fmt::print(stderr, "sound: {}\n", why);
    Mixer mixer;
    Random random(9);
    Times times;
    std::vector<float> samples;
    double due = 0.0;
    size_t bodies = 0;
    output->setRoom({8.0, 0.5});
    for (int step = 0; step < 600; ++step) {
        due += perSecond / 60.0;
        const std::vector<Strike> strikes = hits(int(due), random);
        due -= std::floor(due);
        const double begin = processorMs();
        for (const Strike& strike : joinStrikes(strikes, {}, 12)) mixer.add(strike);
        const double joined = processorMs();
        mixer.render();
        const double mixed = processorMs();
        output->play(mixer.emitters(), {}, {0, 0, 0, 1});
        output->read(samples);
        times.join.push_back(joined - begin), times.mix.push_back(mixed - joined);
        times.play.push_back(processorMs() - mixed);
        bodies += mixer.bodies();
    }
    const auto row = [&](const std::vector<double>& t) {
        return fmt::format("{:6.3f} {:6.3f}", Times::at(t, 0.5), Times::at(t, 0.99));
    };
    fmt::print("{:>8.0f}   {}   {}   {}   {:5.1f}\n", perSecond, row(times.join), row(times.mix), row(times.play),
               double(bodies) / 600.0);
}

}  // namespace
}  // namespace sandbox::sound

int main() {
    fmt::print("processor time a step in ms, median and p99 of 600 steps\n");
    fmt::print(" hits/s   join            synthesis       OpenAL          bodies\n");
    for (const double perSecond : {0.0, 60.0, 1000.0, 10000.0, 60000.0}) sandbox::sound::measure(perSecond);
    return 0;
}
