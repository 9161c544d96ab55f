#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "samples/netplay/poses.h"

namespace netplay {

// What server and clients send each other. Each message is a byte that says its kind, then its fields. decode() takes
// any bytes: what is not exactly a message in its ranges is refused.

inline constexpr uint32_t kVersion = 1;           ///< of the protocol
inline constexpr uint16_t kPort = 24847;          ///< of a server
inline constexpr int kStepsPerSecond = 60;        ///< of the server's world, as step() has it
inline constexpr int kStepsPerEdits = 3;          ///< between two messages with edits
inline constexpr int kStepsPerPoses = 2;          ///< between two messages with poses
inline constexpr size_t kPosePacketBytes = 1200;  ///< so that a message is one datagram
inline constexpr size_t kMaxRequestBytes = 64;    ///< of a message from a client
inline constexpr size_t kMaxPlayersInPoses = 8;

/// What a player can ask for, at what lies ahead.
enum class Tool : uint8_t { Blast, Hammer, Paint, Push };
inline constexpr int kTools = 4;

// -- from clients --

/// Asks to take part. token: that of an earlier welcome; 0: a new player. game, step: what the client has of which
/// game; game 0: nothing. version: what follows it may be different in another one.
struct Join {
    uint32_t version = kVersion;
    uint64_t token = 0, game = 0, step = 0;
};
/// How a player wants to move, and which messages with poses have arrived: the newest, and in `older` bit i the one i +
/// 1 before it.
struct Input {
    uint16_t newest = 0;
    uint32_t older = 0;
    std::array<int8_t, 3> velocity{};  ///< in 127ths of the fastest
};
/// Uses a tool in a direction, in 32767ths; not all 0.
struct Ask {
    Tool tool = Tool::Blast;
    std::array<int16_t, 3> direction{};
};

// -- from the server --

/// Why a client may not take part.
enum class Refusal : uint8_t { Version, Full };
struct Refused {
    Refusal why = Refusal::Version;
};
/// The answer to Join. isResumed: the edits after the client's step follow; else a snapshot comes first.
struct Welcome {
    uint64_t token = 0, game = 0;
    uint32_t player = 0;
    bool isResumed = false;
};
/// From now on a number stands for a body of the server's world, which moved for the first time in a step.
struct BodyName {
    uint32_t id = 0;
    uint64_t handle = 0;
    uint64_t step = 0;
};
/// The whole game after a step.
struct Snapshot {
    uint64_t step = 0;
    std::vector<BodyName> names;  ///< of all bodies that have moved
    std::vector<uint8_t> game;    ///< for load_game_data()
};
/// What edits came to in the steps behind those of the message before.
struct EditSteps {
    uint64_t last = 0;                         ///< the last of the steps
    std::vector<BodyName> names;               ///< new ones
    std::vector<std::vector<uint8_t>> deltas;  ///< one for each step, for apply_deltas()
};
/// Where some bodies were after a step, and the players: first the one that it is sent to, then those near it.
struct Poses {
    struct Player {
        uint32_t player = 0;
        Vec3 position{};
    };
    uint16_t sequence = 0;
    uint64_t step = 0;
    std::vector<Player> players;
    std::vector<BodyPose> bodies;
};

using Message = std::variant<Join, Input, Ask, Refused, Welcome, Snapshot, EditSteps, Poses>;
inline constexpr size_t kKinds = std::variant_size_v<Message>;
/// The names of the kinds, in the order of Message.
inline constexpr std::array<const char*, kKinds> kKindNames = {"join",    "input",    "ask",   "refused",
                                                               "welcome", "snapshot", "edits", "poses"};

/// A message as bytes.
std::vector<uint8_t> encode(const Message& message);
/// The message of bytes; none if they are not exactly one. isFromClient: only those of clients are taken, or only those
/// of the server.
std::optional<Message> decode(std::span<const uint8_t> bytes, bool isFromClient);

}  // namespace netplay
