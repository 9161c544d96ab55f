#include "samples/netplay/protocol.h"

#include <algorithm>

namespace netplay {
namespace {

constexpr uint64_t kMaxGameBytes = uint64_t(32) << 20, kMaxEditBytes = uint64_t(64) << 20;
constexpr size_t kMaxNames = 1u << 20, kMaxBodies = 4096, kMaxSteps = 64;

/// step: of the message, from which theirs are counted back.
void putNames(BitWriter& out, const std::vector<BodyName>& names, uint64_t step) {
    out.putVarint(names.size());
    uint64_t last = 0;
    for (const BodyName& name : names) {
        out.putVarint(name.id - last);
        out.put(name.handle, 64);
        out.putVarint(step - name.step);
        last = name.id;
    }
}

std::vector<BodyName> getNames(BitReader& in, uint64_t step) {
    const uint64_t count = in.getVarint();
    if (count > kMaxNames) in.fail();
    std::vector<BodyName> out;
    uint64_t last = 0;
    for (uint64_t i = 0; i < count && !in.failed(); ++i) {
        const uint64_t distance = in.getVarint();
        if (distance > 0xffffffffu - last) in.fail();
        last += distance;
        const uint64_t handle = in.get(64), age = in.getVarint();
        if (age > step) in.fail();
        out.push_back({uint32_t(last), handle, step - age});
    }
    return out;
}

void put(BitWriter& out, const Join& join) {
    out.put(join.version, 32);
    for (const uint64_t value : {join.token, join.game, join.step}) out.put(value, 64);
}
void get(BitReader& in, Join& join) {
    join.version = uint32_t(in.get(32));
    for (uint64_t* value : {&join.token, &join.game, &join.step}) *value = in.get(64);
}

void put(BitWriter& out, const Input& input) {
    out.put(input.newest, 16), out.put(input.older, 32);
    for (const int8_t part : input.velocity) out.put(uint8_t(part), 8);
}
void get(BitReader& in, Input& input) {
    input.newest = uint16_t(in.get(16)), input.older = uint32_t(in.get(32));
    for (int8_t& part : input.velocity) part = int8_t(uint8_t(in.get(8)));
}

void put(BitWriter& out, const Ask& ask) {
    out.put(uint64_t(ask.tool), 8);
    for (const int16_t part : ask.direction) out.put(uint16_t(part), 16);
}
void get(BitReader& in, Ask& ask) {
    ask.tool = Tool(in.get(8));
    for (int16_t& part : ask.direction) part = int16_t(uint16_t(in.get(16)));
    if (int(ask.tool) >= kTools || ask.direction == std::array<int16_t, 3>{}) in.fail();
}

void put(BitWriter& out, const Refused& refused) {
    out.put(uint64_t(refused.why), 8);
}
void get(BitReader& in, Refused& refused) {
    refused.why = Refusal(in.get(8));
    if (refused.why > Refusal::Full) in.fail();
}

void put(BitWriter& out, const Welcome& welcome) {
    out.put(welcome.token, 64), out.put(welcome.game, 64), out.put(welcome.player, 32);
    out.put(welcome.isResumed, 8);
}
void get(BitReader& in, Welcome& welcome) {
    welcome.token = in.get(64), welcome.game = in.get(64), welcome.player = uint32_t(in.get(32));
    const uint64_t isResumed = in.get(8);
    if (isResumed > 1) in.fail();
    welcome.isResumed = isResumed;
}

void put(BitWriter& out, const Snapshot& snapshot) {
    out.put(snapshot.step, 64);
    putNames(out, snapshot.names, snapshot.step);
    out.putBytes(snapshot.game);
}
void get(BitReader& in, Snapshot& snapshot) {
    snapshot.step = in.get(64);
    snapshot.names = getNames(in, snapshot.step);
    const auto game = in.getRest();
    if (game.size() > kMaxGameBytes) in.fail();
    snapshot.game.assign(game.begin(), game.end());
}

void put(BitWriter& out, const EditSteps& steps) {
    BitWriter inner;
    putNames(inner, steps.names, steps.last);
    inner.putVarint(steps.deltas.size());
    for (const auto& delta : steps.deltas) inner.putVarint(delta.size()), inner.putBytes(delta);
    out.put(steps.last, 64);
    out.putBytes(packed(inner.take()));
}
void get(BitReader& in, EditSteps& steps) {
    steps.last = in.get(64);
    const std::vector<uint8_t> bytes = unpacked(in, kMaxEditBytes);
    BitReader inner(bytes);
    steps.names = getNames(inner, steps.last);
    const uint64_t count = inner.getVarint();
    if (count > kMaxSteps) inner.fail();
    for (uint64_t i = 0; i < count && !inner.failed(); ++i) {
        const auto delta = inner.getBytes(inner.getVarint());
        steps.deltas.emplace_back(delta.begin(), delta.end());
    }
    if (!inner.isAtEnd() || count > steps.last) in.fail();
}

void put(BitWriter& out, const Poses& poses) {
    out.put(poses.sequence, 16), out.put(poses.step, 64);
    out.put(poses.players.size(), 8);
    for (const Poses::Player& player : poses.players) {
        out.putVarint(player.player);
        putPosition(out, player.position);
    }
    putPoses(out, poses.bodies);
}
void get(BitReader& in, Poses& poses) {
    poses.sequence = uint16_t(in.get(16)), poses.step = in.get(64);
    const uint64_t count = in.get(8);
    if (count > kMaxPlayersInPoses) in.fail();
    for (uint64_t i = 0; i < count && !in.failed(); ++i) {
        const uint64_t player = in.getVarint();
        if (player > 0xffffffffu) in.fail();
        poses.players.push_back({uint32_t(player), getPosition(in)});
    }
    poses.bodies = getPoses(in, kMaxBodies);
}

template <class T>
std::optional<Message> decodeAs(BitReader& in) {
    T message;
    get(in, message);
    if (!in.isAtEnd()) return std::nullopt;
    return message;
}

}  // namespace

std::vector<uint8_t> encode(const Message& message) {
    BitWriter out;
    out.put(message.index(), 8);
    std::visit([&](const auto& kind) { put(out, kind); }, message);
    return out.take();
}

std::optional<Message> decode(std::span<const uint8_t> bytes, bool isFromClient) {
    BitReader in(bytes);
    const uint64_t kind = in.get(8);
    if (isFromClient && bytes.size() > kMaxRequestBytes) return std::nullopt;
    using Decode = std::optional<Message> (*)(BitReader&);
    static constexpr std::array<Decode, 3> kFromClients = {decodeAs<Join>, decodeAs<Input>, decodeAs<Ask>};
    static constexpr std::array<Decode, 5> kFromServer = {decodeAs<Refused>, decodeAs<Welcome>, decodeAs<Snapshot>,
                                                          decodeAs<EditSteps>, decodeAs<Poses>};
    if (in.failed() || kind >= kKinds || (kind < kFromClients.size()) != isFromClient) return std::nullopt;
    return isFromClient ? kFromClients[kind](in) : kFromServer[kind - kFromClients.size()](in);
}

}  // namespace netplay
