#include "samples/netplay/poses.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace netplay {
namespace {

constexpr double kSteps = 512.0;      // to a metre
constexpr int kPositionBits = 18;     // so many steps, around the origin
constexpr int kRotationBits = 10;     // of a component
constexpr double kLargest = 0.70711;  // of a component that is not the largest
constexpr std::array<int, 4> kIdBits = {0, 4, 10, 32};

/// Two bits say how many bits the distance of two ids less 1 takes.
void putDistance(BitWriter& out, uint32_t distance) {
    int kind = 0;
    while (kind < 3 && (distance - 1) >> kIdBits[size_t(kind)]) ++kind;
    out.put(uint64_t(kind), 2);
    out.put(distance - 1, kIdBits[size_t(kind)]);
}

void putRotation(BitWriter& out, const Quat& rotation) {
    size_t largest = 0;
    double length = 0.0;
    for (size_t i = 0; i < 4; ++i) {
        if (std::abs(rotation[i]) > std::abs(rotation[largest])) largest = i;
        length += rotation[i] * rotation[i];
    }
    const double scale = std::copysign(1.0 / std::sqrt(length), rotation[largest]);
    out.put(largest, 2);
    constexpr double kHalf = (1 << (kRotationBits - 1)) - 1;
    for (size_t i = 0; i < 4; ++i) {
        if (i == largest) continue;
        const double part = std::clamp(rotation[i] * scale / kLargest, -1.0, 1.0);
        out.put(uint64_t(std::lround(part * kHalf) + int(kHalf)), kRotationBits);
    }
}

Quat getRotation(BitReader& in) {
    const size_t largest = size_t(in.get(2));
    constexpr double kHalf = (1 << (kRotationBits - 1)) - 1;
    Quat out{};
    double rest = 1.0;
    for (size_t i = 0; i < 4; ++i) {
        if (i == largest) continue;
        out[i] = (double(in.get(kRotationBits)) - kHalf) / kHalf * kLargest;
        rest -= out[i] * out[i];
    }
    out[largest] = std::sqrt(std::max(rest, 0.0));
    double length = 0.0;
    for (const double part : out) length += part * part;
    for (double& part : out) part /= std::sqrt(length);
    return out;
}

}  // namespace

void putPosition(BitWriter& out, const Vec3& position) {
    constexpr double kFarthest = (1 << (kPositionBits - 1)) - 1;
    const bool isNear =
        std::all_of(position.begin(), position.end(), [](double part) { return std::abs(part) * kSteps < kFarthest; });
    out.put(!isNear, 1);
    for (const double part : position)
        isNear ? out.put(uint64_t(std::lround(part * kSteps) + int(kFarthest)), kPositionBits)
               : out.put(std::bit_cast<uint32_t>(float(part)), 32);
}

Vec3 getPosition(BitReader& in) {
    constexpr double kFarthest = (1 << (kPositionBits - 1)) - 1;
    const bool isNear = !in.get(1);
    Vec3 out{};
    for (double& part : out) {
        part = isNear ? (double(in.get(kPositionBits)) - kFarthest) / kSteps
                      : double(std::bit_cast<float>(uint32_t(in.get(32))));
        if (!(std::abs(part) <= 1e9)) in.fail();
    }
    return out;
}

void putPoses(BitWriter& out, const std::vector<BodyPose>& poses) {
    out.putVarint(poses.size());
    uint32_t last = ~0u;  // so that the first distance is its id and 1
    for (const BodyPose& pose : poses) {
        putDistance(out, pose.id - last);
        last = pose.id;
        putPosition(out, pose.position);
        putRotation(out, pose.rotation);
        out.put(pose.isAsleep, 1);
    }
}

std::vector<BodyPose> getPoses(BitReader& in, size_t limit) {
    const uint64_t count = in.getVarint();
    if (count > limit) in.fail();
    std::vector<BodyPose> out;
    uint64_t last = ~0u;
    for (uint64_t i = 0; i < count && !in.failed(); ++i) {
        const uint64_t distance = in.get(kIdBits[size_t(in.get(2))]) + 1;
        const uint64_t id = i ? last + distance : distance - 1;
        if (id >= ~0u) in.fail();
        last = id;
        BodyPose& pose = out.emplace_back();
        pose.id = uint32_t(id);
        pose.position = getPosition(in);
        pose.rotation = getRotation(in);
        pose.isAsleep = in.get(1);
    }
    if (in.failed()) out.clear();
    return out;
}

}  // namespace netplay
