#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// Which of MakeHole's three radii removes it: soft r0 >= medium r1 >= hard r2. The last two are never removed;
/// unphysical voxels are seen but not touched.
enum class Hardness : uint8_t { Soft, Medium, Hard, Unbreakable, Unphysical };

/// What breaks a voxel: a material says which tools it obeys. Any: all that can be broken at all.
enum class Tool : uint8_t { Any, Sledge, Torch, Gun, Explosive };

/// What a voxel is made of. SI units. Strengths are used by the load solver, heat by fire.
struct Material {
    std::string name;
    Hardness hardness = Hardness::Medium;
    uint32_t density = 1000;       ///< kg/m3; an integer, so that mass is an exact sum
    float tensileStrength = 1e6f;  ///< Pa
    float compressiveStrength = 1e7f;
    float shearStrength = 1e6f;
    float friction = 0.6f;
    float restitution = 0.1f;
    float heatCapacity = 900.0f;       ///< J/(kg K)
    float ignitionTemperature = 0.0f;  ///< K; 0 = does not burn
    float burnTime = 0.0f;             ///< s
    std::string fragments = "chunk";   ///< how it comes apart: chunk, bond, splinter, pane, tear, crumble, none
    bool sledge = true, torch = true, gun = true, explosive = true;  ///< the tools that break it

    friend bool operator==(const Material&, const Material&) = default;
};

bool breaksWith(const Material& material, Tool tool);

/// The materials of a world, by index; index 0 stands for "empty". Data: a level may bring its own.
struct MaterialTable {
    std::vector<Material> materials;

    /// Index of a name; 0 if there is none.
    uint8_t find(std::string_view name) const;
    const Material& operator[](uint8_t index) const { return materials[index < materials.size() ? index : 0]; }
    friend bool operator==(const MaterialTable&, const MaterialTable&) = default;
};

/// The table of the reference game's palette rows with handbook densities and strengths.
const MaterialTable& defaultMaterials();
/// The material of a palette index under the import preset "teardown" (rows 1-8 glass, 9-24 foliage, ...).
uint8_t teardownMaterial(uint8_t paletteIndex);

}  // namespace rubble
