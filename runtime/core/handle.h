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
    Joint,
    Note
};

/// Names an object of one World in 64 bits: from the top 8 bits of type, 8 of world, 24 of generation and 24 of slot.
/// A handle is stale when its slot has another generation: its object was erased. Lookups of a stale handle fail; they
/// never return the slot's new object. Zero is no object.
template <HandleType kType>
struct Handle {
    uint64_t bits = 0;

    /// A handle of its parts; the upper bits of generation and slot beyond 24 are dropped.
    static constexpr Handle make(uint8_t world, uint32_t generation, uint32_t slot) {
        return {uint64_t(kType) << 56 | uint64_t(world) << 48 | uint64_t(generation & 0xffffffu) << 24 |
                (slot & 0xffffffu)};
    }
    /// The index of the object in its SlotMap.
    constexpr uint32_t slot() const { return uint32_t(bits & 0xffffffu); }
    /// Tells objects apart that used the same slot one after the other.
    constexpr uint32_t generation() const { return uint32_t(bits >> 24 & 0xffffffu); }
    /// The number of the World that made the handle.
    constexpr uint8_t world() const { return uint8_t(bits >> 48); }
    /// The kind of object; None for the empty handle.
    constexpr HandleType type() const { return HandleType(bits >> 56); }
    constexpr explicit operator bool() const { return bits != 0; }
    friend constexpr bool operator==(Handle, Handle) = default;
    friend constexpr auto operator<=>(Handle, Handle) = default;
};

/// The bits of a handle as those of another World: what a saved game that is loaded there calls the same object.
constexpr uint64_t withWorld(uint64_t bits, uint8_t world) {
    return (bits & ~(uint64_t(0xff) << 48)) | uint64_t(world) << 48;
}

/// A handle of any type.
using AnyHandle = Handle<HandleType::None>;

using BodyHandle = Handle<HandleType::Body>;
using ShapeHandle = Handle<HandleType::Shape>;
using LightHandle = Handle<HandleType::Light>;
using LightGroupHandle = Handle<HandleType::LightGroup>;
using WaterHandle = Handle<HandleType::Water>;
using TriggerHandle = Handle<HandleType::Trigger>;
using CharacterHandle = Handle<HandleType::Character>;
using JointHandle = Handle<HandleType::Joint>;
using NoteHandle = Handle<HandleType::Note>;

}  // namespace rubble

template <rubble::HandleType kType>
struct std::hash<rubble::Handle<kType>> {
    size_t operator()(rubble::Handle<kType> handle) const noexcept { return std::hash<uint64_t>{}(handle.bits); }
};
