// The sound of the game: what is measured in its samples is what theory says of materials and sizes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "samples/sandbox/sound/mixer.h"
#include "samples/sandbox/sound/modes.h"
#include "samples/sandbox/sound/named_sounds.h"
#include "samples/sandbox/sound/output.h"

namespace sandbox::sound {
namespace {

constexpr const char* kMaterials[] = {"glass",      "ice",  "wood",    "plastic",  "rubber", "metal",
                                      "hard metal", "rock", "plaster", "concrete", "brick",  "dirt"};
constexpr double kSizes[] = {0.2, 0.35, 0.5};

Strike hitOn(const char* material, double size) {
    const size_t row = findAcousticMaterial(material);
    return {{0, 0, -2}, row, bodySize(acousticMaterials()[row], {size, 0.8 * size, 0.1}, 0.1), 20.0, 2e-5};
}

/// What all places of a mixer give together, for so many blocks.
std::vector<float> render(Mixer& mixer, int blocks) {
    std::vector<float> samples;
    for (int i = 0; i < blocks; ++i) {
        mixer.render();
        const size_t first = samples.size();
        samples.resize(first + kBlock);
        for (const Emitter& emitter : mixer.emitters())
            for (size_t k = 0; k < kBlock && emitter.isActive; ++k) samples[first + k] += emitter.block[k];
    }
    return samples;
}

/// The amplitude of a frequency in samples, with a window.
double amplitudeAt(const std::vector<float>& samples, double frequency) {
    const std::complex<double> turn =
        std::polar(std::exp(-3.0 / double(samples.size())), 2.0 * std::numbers::pi * frequency / kSampleRate);
    std::complex<double> sum = 0.0, phase = 1.0;
    for (const float sample : samples) sum += phase * double(sample), phase *= turn;
    return std::abs(sum);
}

/// Sounds of several hits on a body, each of which excites other modes, without noise.
std::vector<std::vector<float>> ring(const Strike& strike) {
    AcousticMaterial pure = acousticMaterials()[strike.material];
    pure.noise = 0.0;
    std::vector<std::vector<float>> sounds(4, std::vector<float>(6 * kBlock));
    for (uint32_t seed = 0; seed < 4; ++seed) {
        Resonators resonators;
        Random random(seed + 1);
        resonators.set(pure, strike.size);
        resonators.strike(1.0f, strike.contact, random);
        resonators.render(sounds[seed].data(), 6 * kBlock, random);
    }
    return sounds;
}

/// The loudest of the frequencies between two at which the spectrum has a peak; 0: it has none.
double peakBetween(const std::vector<std::vector<float>>& sounds, double low, double high) {
    constexpr double kRatio = 1.006;
    double best = 0.0, found = 0.0, last = 0.0, before = 0.0;
    for (double frequency = low; frequency <= high; frequency *= kRatio) {
        double power = 0.0;
        for (const std::vector<float>& sound : sounds) power += std::pow(amplitudeAt(sound, frequency), 2.0);
        if (last > before && last > power && last > best) best = last, found = frequency / kRatio;
        before = last, last = power;
    }
    return found;
}

/// The lowest peak of the spectrum is where theory has it, and lower for a larger body. Of rubber and dirt the peaks
/// are as wide as the distance from one to the next.
TEST(Sound, FundamentalsAreThoseOfModalTheory) {
    for (const char* material : kMaterials) {
        double above = 1e9;
        for (const double size : kSizes) {
            const Strike strike = hitOn(material, size);
            const AcousticMaterial& acoustic = acousticMaterials()[strike.material];
            const Modes modes = modesOf(acoustic, strike.size);
            const double first = modes[0].frequency, next = modes[1].frequency;
            const bool isLossy = acoustic.loss > 0.1;
            const double found = peakBetween(ring(strike), 0.7 * first, isLossy ? 2 * first : 0.5 * (first + next));
            EXPECT_NEAR(found, first, isLossy ? 0.5 * first : 0.03 * first + 4.0) << material << " " << size;
            EXPECT_LT(found, 0.75 * above) << material << ": larger is lower, " << size;
            above = found;
        }
    }
}

/// The formulas, by hand: f = 1.028 h / L^2 sqrt(E / rho) of a bar, Lame's mode of a cube, a plate's twist.
TEST(Sound, FrequenciesByHand) {
    const auto& metal = acousticMaterials()[findAcousticMaterial("metal")];
    const double speed = std::sqrt(210e9 / 7850.0);
    EXPECT_NEAR(modesOf(metal, {0.8, 0.05, 0.02})[0].frequency, 1.028 * 0.02 * speed / 0.64, 0.3);
    const auto& brick = acousticMaterials()[findAcousticMaterial("brick")];
    const double shear = std::sqrt(15e9 / 2.6 / 1900.0);
    EXPECT_NEAR(modesOf(brick, {0.4, 0.4, 0.4})[0].frequency, shear / (std::sqrt(2.0) * 0.4), 1.0);
    EXPECT_NEAR(modesOf(metal, {0.5, 0.5, 0.01})[0].frequency,
                13.47 / (2.0 * std::numbers::pi * 0.25) * 0.01 * speed / std::sqrt(12.0 * 0.91), 1.0);
    EXPECT_NEAR(modesOf(metal, {1.0, 0.05, 0.02})[1].frequency / modesOf(metal, {1.0, 0.05, 0.02})[0].frequency, 2.5,
                0.27)
        << "of the other side, or the second of this one";
}

TEST(Sound, SoftAndSlowHitsAreDull) {
    const auto& wood = acousticMaterials()[findAcousticMaterial("wood")];
    const auto& rubber = acousticMaterials()[findAcousticMaterial("rubber")];
    EXPECT_LT(contactTime(wood, wood, 1.0, 3.0), 0.5 * contactTime(wood, rubber, 1.0, 3.0));
    EXPECT_LT(contactTime(wood, wood, 1.0, 3.0), contactTime(wood, wood, 10.0, 3.0));
    const auto ratio = [&](double contact) {
        Resonators resonators;
        Random random(3);
        AcousticMaterial pure = wood;
        pure.noise = 0.0;
        resonators.set(pure, {0.5, 0.4, 0.025});
        resonators.strike(1.0f, contact, random);
        std::vector<float> out(8 * kBlock);
        resonators.render(out.data(), int(out.size()), random);
        const Modes modes = modesOf(pure, {0.5, 0.4, 0.025});
        return amplitudeAt(out, modes[12].frequency) / amplitudeAt(out, modes[0].frequency);
    };
    EXPECT_LT(ratio(2e-3), 0.2 * ratio(3e-5));
}

/// Energies add up: a hundred hits in a place are as loud as one of a hundred times the energy, within what chance
/// does, and not a hundred times as loud as one.
TEST(Sound, ManyHitsAddTheirEnergies) {
    Strike one = hitOn("brick", 0.3);
    one.joules = 0.2;
    const auto energyOf = [&](std::vector<Strike> strikes) {
        Mixer mixer;
        for (const Strike& strike : joinStrikes(strikes, {}, 12)) mixer.add(strike);
        double energy = 0.0;
        for (const float sample : render(mixer, 30)) energy += double(sample) * double(sample);
        return energy;
    };
    Strike large = one;
    large.joules *= 100.0;
    const double ratio = energyOf(std::vector<Strike>(100, one)) / energyOf({large});
    EXPECT_GT(ratio, 0.4);
    EXPECT_LT(ratio, 2.5);
    EXPECT_NEAR(energyOf({large}) / energyOf({one}), std::pow(100.0, 2.0 * kLoudnessPower), 0.02 * 25.0);
}

TEST(Sound, JoiningKeepsEnergyAndTheNumberOfVoices) {
    Random random(5);
    std::vector<Strike> strikes;
    double joules = 0.0, count = 0.0;
    for (int i = 0; i < 1000; ++i) {
        Strike strike = hitOn(kMaterials[random.bits() % 12], 0.1 + random.unit());
        strike.position = {20.0 * random.sign(), random.unit(), 20.0 * random.sign()};
        joules += strike.joules = random.exponential();
        strikes.push_back(strike);
    }
    const std::vector<Strike> joined = joinStrikes(strikes, {}, 12);
    EXPECT_EQ(joined.size(), 12u);
    for (const Strike& strike : joined) joules -= strike.joules, count += strike.count;
    EXPECT_NEAR(joules, 0.0, 1e-9);
    EXPECT_NEAR(count, 1000.0, 1e-9);
}

/// Low tones that ring for long, as many as there may be, of which one fades for a strike that is heard a second later:
/// the samples stay on a smooth curve.
TEST(Sound, NothingIsCutOff) {
    Mixer mixer;
    const char* metals[] = {"metal", "hard metal", "heavy metal", "wire"};
    for (size_t i = 0; i < kBodies; ++i) {
        const double size = 12.0 * std::exp2(double(i / 4 % 3));
        const double x = 4.0 * double(i / 12);
        mixer.add({{x, 0, 0}, findAcousticMaterial(metals[i % 4]), {size, size, size}, 5.0, 0.02});
    }
    render(mixer, 20);
    ASSERT_EQ(mixer.bodies(), kBodies);
    const auto bend = [](const std::vector<float>& s) {
        float most = 0.0f;
        for (size_t i = 2; i < s.size(); ++i) most = std::max(most, std::abs(s[i] - 2.0f * s[i - 1] + s[i - 2]));
        return most;
    };
    const float before = bend(render(mixer, 5));
    mixer.add({{-2000.0, 0, 0}, findAcousticMaterial("glass"), {0.5, 0.4, 0.006}, 5.0, 1e-4});
    EXPECT_LT(bend(render(mixer, 5)), 2.0f * before);
    EXPECT_GT(bend(render(mixer, 65)), 10.0f * before) << "the strike has come";
}

TEST(Sound, LoopsBeginAndEndSoftly) {
    for (const std::string_view name : loopNames()) {
        Mixer mixer;
        Loop loop;
        loop.kind = findLoopKind(name);
        ASSERT_TRUE(loop.kind) << name;
        mixer.setLoops({loop});
        const std::vector<float> begin = render(mixer, 6);
        EXPECT_EQ(begin[0], 0.0f) << name;
        render(mixer, 20);
        mixer.setLoops({});
        const std::vector<float> end = render(mixer, 7);
        EXPECT_LT(std::abs(end[5 * kBlock - 1]), 0.01f) << name;
        EXPECT_EQ(end.back(), 0.0f) << name;
        EXPECT_FALSE(mixer.emitters()[kPlaces].isActive) << name;
    }
    for (const std::string_view name : soundNames()) EXPECT_FALSE(soundStrikes(name, {}, 1.0).empty()) << name;
}

/// By OpenAL into memory: the whole path, with the loudest that there is.
TEST(Sound, OpenAlRendersToMemory) {
    const auto play = [] {
        std::string why;
        const auto output = Output::openMemory(why);
        EXPECT_TRUE(output) << why;
        std::vector<float> all, block;
        Mixer mixer;
        if (output) output->setRoom({6.0, 0.2});
        for (int i = 0; output && i < 60; ++i) {
            if (i % 10 == 0)
                for (const Strike& strike : soundStrikes("explosion", {-3, 0, -1}, 3.0)) mixer.add(strike);
            mixer.render();
            output->play(mixer.emitters(), {}, {0, 0, 0, 1});
            output->read(block);
            all.insert(all.end(), block.begin(), block.end());
        }
        return all;
    };
    const std::vector<float> samples = play();
    double left = 0.0, right = 0.0;
    float peak = 0.0f;
    for (size_t i = 0; i + 1 < samples.size(); i += 2) {
        left += std::abs(samples[i]), right += std::abs(samples[i + 1]);
        peak = std::max({peak, std::abs(samples[i]), std::abs(samples[i + 1])});
    }
    EXPECT_GT(peak, 0.3f);
    EXPECT_LT(peak, 0.951f) << "the limiter keeps it from clipping";
    EXPECT_GT(left, 1.2 * right) << "it is to the left";
    EXPECT_EQ(samples, play()) << "the same again";
}

TEST(Sound, ReverberationGrowsWithTheRoom) {
    EXPECT_LT(reverberationTime({3.0, 0.0}), reverberationTime({20.0, 0.0}));
    EXPECT_LT(reverberationTime({20.0, 0.9}), 0.5 * reverberationTime({20.0, 0.0}));
    EXPECT_NEAR(reverberationTime({10.0, 1.0}), 0.4, 0.01);
}

}  // namespace
}  // namespace sandbox::sound
