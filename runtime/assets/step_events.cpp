#include "runtime/assets/step_events.h"

#include "runtime/assets/binary_archive.h"
#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"

namespace rubble {

template <>
inline constexpr auto kFields<RemovedVoxels> = std::tuple{
    Field{"shape", &RemovedVoxels::shape},       Field{"entry", &RemovedVoxels::entry},
    Field{"material", &RemovedVoxels::material}, Field{"color", &RemovedVoxels::color},
    Field{"count", &RemovedVoxels::count},
};
template <>
inline constexpr auto kFields<DustCloud> = std::tuple{
    Field{"position", &DustCloud::position}, Field{"radius", &DustCloud::radius},
    Field{"velocity", &DustCloud::velocity}, Field{"color", &DustCloud::color},
    Field{"material", &DustCloud::material}, Field{"count", &DustCloud::count},
};
template <>
inline constexpr auto kFields<ShapeSplit> = std::tuple{
    Field{"parent", &ShapeSplit::parent},
    Field{"children", &ShapeSplit::children},
    Field{"parent_offset", &ShapeSplit::parentOffset},
};
template <>
inline constexpr auto kFields<Blast> = std::tuple{
    Field{"position", &Blast::position},
    Field{"size", &Blast::size},
};
template <>
inline constexpr auto kFields<StepEvents> = std::tuple{
    Field{"step", &StepEvents::step},
    Field{"removed", &StepEvents::removed},
    Field{"dust", &StepEvents::dust},
    Field{"splits", &StepEvents::splits},
    Field{"blasts", &StepEvents::blasts},
    Field{"broken", &StepEvents::broken},
    Field{"settled", &StepEvents::settled},
    Field{"unsettled", &StepEvents::unsettled},
    Field{"painted_voxels", &StepEvents::paintedVoxels},
    Field{"is_restored", &StepEvents::isRestored},
};

namespace {

/// Wider than ranges::kPlace: a part of a shape lies beside its origin.
constexpr NumberRange kEventPlace{-1e10, 1e10};  // m
constexpr NumberRange kEventSize{0.0, 1e10};     // m
/// Those of the largest grid: what is drawn of a cloud grows with them.
constexpr NumberRange kCloudVoxels{0.0, double(kMaxGridSize) * kMaxGridSize* kMaxGridSize};

/// Calls f(a, b) with each list of both.
template <class A, class B, class F>
void forEachList(A& a, B& b, F&& f) {
    f(a.removed, b.removed), f(a.dust, b.dust), f(a.splits, b.splits), f(a.blasts, b.blasts);
    f(a.broken, b.broken), f(a.settled, b.settled), f(a.unsettled, b.unsettled);
    f(a.paintedVoxels, b.paintedVoxels), f(a.isRestored, b.isRestored);
}

/// What is wrong with events from outside; empty: nothing.
std::string eventsError(const StepEvents& events) {
    RangeCheck check;
    for (const DustCloud& cloud : events.dust)
        check.vector("dust", cloud.position, kEventPlace)
            .number("radius", cloud.radius, kEventSize)
            .vector("velocity", cloud.velocity, ranges::kVelocity)
            .number("count", double(cloud.count), kCloudVoxels);
    for (const Blast& blast : events.blasts)
        check.vector("blast", blast.position, kEventPlace).number("size", blast.size, ranges::kExplosionSize);
    for (const ShapeSplit& split : events.splits) {
        check.require(split.children.size() == split.parentOffset.size(), "an offset for each piece");
        for (const glm::ivec3 offset : split.parentOffset)
            check.vector("parent_offset", offset, {-double(kMaxGridSize), double(kMaxGridSize)});
    }
    return check.error();
}

}  // namespace

bool StepEvents::empty() const {
    return removed.empty() && dust.empty() && splits.empty() && blasts.empty() && broken.empty() && settled.empty() &&
           unsettled.empty() && paintedVoxels == 0 && !isRestored;
}

StepEvents eventsOf(const FrameChanges& changes) {
    StepEvents out{.step = changes.step};
    forEachList(out, changes, [](auto& to, const auto& from) { to = from; });
    return out;
}

void addEvents(const StepEvents& events, FrameChanges& changes) {
    forEachList(changes, events, [](auto& to, const auto& from) { to = from; });
}

std::vector<uint8_t> stepEventsToBytes(const StepEvents& events, uint64_t* memory) {
    std::vector<uint8_t> bytes;
    PaletteList unused;
    BinaryOutputArchive archive(bytes, unused);
    archive.put(events);
    *memory = archive.memory() + listMemory(1, sizeof(StepEvents));
    return bytes;
}

StepEvents readStepEvents(ByteReader& in, uint8_t world) {
    StepEvents events;
    if (!in.takeMemory(listMemory(1, sizeof(StepEvents)))) return events;
    BinaryInputArchive(in, {}, world).get(events);
    in.expectEnd("events");
    if (in.failed()) return events;
    if (const std::string error = eventsError(events); !error.empty()) in.fail("events within their ranges", error);
    return events;
}

}  // namespace rubble
