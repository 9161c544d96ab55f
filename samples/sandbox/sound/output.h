#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "samples/sandbox/sound/mixer.h"

namespace sandbox::sound {

/// What stands around the ear.
struct Room {
    double freePath = 10.0;  ///< metres that sound goes from wall to wall, in the mean
    double openness = 1.0;   ///< share of directions in which there is no wall
};

/// The seconds in which sound in a room falls by 60 dB, by Sabine: 0.161 V / (S a), where 4 V / S is the free path and
/// openings absorb all.
double reverberationTime(const Room& room);

/// Plays the emitters of a mixer by OpenAL: direction, distance, what is between, reverberation. One at a time in a
/// process. Sounds are heard from the origin, along -z.
class Output {
public:
    /// A sound card; null, and why, where there is none.
    static std::unique_ptr<Output> openDevice(std::string& why);
    /// Memory: the same sound in two channels.
    static std::unique_ptr<Output> openMemory(std::string& why);
    ~Output();
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    /// Whether the card wants the next block.
    bool wantsBlock();
    /// Gives it a block, as it is heard by an ear with that rotation (x, y, z, w) at a place.
    void play(const std::array<Emitter, kEmitters>& emitters, glm::dvec3 ear, const std::array<double, 4>& rotation);
    /// Of memory: the block that was given last, left and right after each other.
    void read(std::vector<float>& samples);
    /// What stands around from the next block on.
    void setRoom(const Room& room);
    /// How loud everything is, 0 to 1.
    void setVolume(double volume);

private:
    struct Al;
    explicit Output(std::unique_ptr<Al> al);
    std::unique_ptr<Al> m_al;
};

}  // namespace sandbox::sound
