#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// Which of the three radii of a carve applies to a voxel: soft r0 >= medium r1 >= hard r2. Unbreakable voxels are
/// never removed; unphysical ones are drawn but nothing collides with them or breaks them.
enum class Hardness : uint8_t { Soft, Medium, Hard, Unbreakable, Unphysical };

/// What breaks a voxel. A material lists the tools that break it; `Any` breaks whatever a tool can break.
enum class Tool : uint8_t { Any, Sledge, Torch, Gun, Explosive };

/// What a voxel is made of. SI units. Fracture uses the strengths, fire the heat, contacts friction and restitution.
struct Material {
    std::string name;
    Hardness hardness = Hardness::Medium;
    uint32_t density = 1000;           ///< kg/m3; an integer, so that mass is an exact sum
    float tensileStrength = 1e6f;      ///< Pa
    float compressiveStrength = 1e7f;  ///< Pa
    float shearStrength = 1e6f;        ///< Pa
    float friction = 0.6f;             ///< Coulomb coefficient
    float restitution = 0.1f;          ///< speed after an impact over speed before it
    float heatCapacity = 900.0f;       ///< J/(kg K)
    float ignitionTemperature = 0.0f;  ///< K; 0 = does not burn
    float burnTime = 0.0f;             ///< s until a voxel that burns is gone
    std::string fragments = "chunk";   ///< its FragmentStyle: chunk, bond, splinter, pane, tear, crumble, none
    bool sledge = true, torch = true, gun = true, explosive = true;  ///< the tools that break it

    friend bool operator==(const Material&, const Material&) = default;
};

/// Whether a tool breaks the material.
bool breaksWith(const Material& material, Tool tool);

/// The materials of a world by index; index 0 is "empty". A level may bring its own.
struct MaterialTable {
    std::vector<Material> materials;

    /// The index of a name; 0 if there is none.
    uint8_t find(std::string_view name) const;
    /// A hash of all rows.
    uint64_t hash() const;
    const Material& operator[](uint8_t index) const { return materials[index < materials.size() ? index : 0]; }
    friend bool operator==(const MaterialTable&, const MaterialTable&) = default;
};

/// The materials that Teardown's palette rows name, and wire and rubber, with strengths and heat from handbooks.
const MaterialTable& defaultMaterials();
/// The default material of a palette index by Teardown's palette rows: 1-8 glass, 9-24 foliage, ...
uint8_t teardownMaterial(uint8_t paletteIndex);

}  // namespace rubble
