#pragma once
#include <cstdint>
#include <functional>

namespace rubble {

enum class HandleType : uint8_t {
    None,
    Body,
    Shape,
    Light,
    LightGroup,
    World,
    Renderer,
    Water,
    Trigger,
    Character,
    Joint
};

/// A value that names an object of one World: type, world, generation and slot in 64 bits.
/// A handle whose generation is older than its slot's is stale: it is reported, never followed. Zero is "nothing".
template <HandleType kType>
struct Handle {
    uint64_t bits = 0;

    static constexpr Handle make(uint8_t world, uint32_t generation, uint32_t slot) {
        return {uint64_t(kType) << 56 | uint64_t(world) << 48 | uint64_t(generation & 0xffffffu) << 24 |
                (slot & 0xffffffu)};
    }
    constexpr uint32_t slot() const { return uint32_t(bits & 0xffffffu); }
    constexpr uint32_t generation() const { return uint32_t(bits >> 24 & 0xffffffu); }
    constexpr uint8_t world() const { return uint8_t(bits >> 48); }
    constexpr HandleType type() const { return HandleType(bits >> 56); }
    constexpr explicit operator bool() const { return bits != 0; }
    friend constexpr bool operator==(Handle, Handle) = default;
    friend constexpr auto operator<=>(Handle, Handle) = default;
};

using BodyHandle = Handle<HandleType::Body>;
using ShapeHandle = Handle<HandleType::Shape>;
using LightHandle = Handle<HandleType::Light>;
using LightGroupHandle = Handle<HandleType::LightGroup>;
using WaterHandle = Handle<HandleType::Water>;
using TriggerHandle = Handle<HandleType::Trigger>;
using CharacterHandle = Handle<HandleType::Character>;
using JointHandle = Handle<HandleType::Joint>;

}  // namespace rubble

template <rubble::HandleType kType>
struct std::hash<rubble::Handle<kType>> {
    size_t operator()(rubble::Handle<kType> handle) const noexcept { return std::hash<uint64_t>{}(handle.bits); }
};
