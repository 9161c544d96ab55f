#include "runtime/voxel/material.h"

#include <array>

#include "runtime/core/hash.h"

namespace rubble {
namespace {

using enum Hardness;

// Densities, strengths and heat: Engineering Toolbox "Solids - densities / specific heats"; EN 338 C24 and the USDA
// Wood Handbook (wood); EN 1992-1-1 C25/30 (concrete); EN 1996-1-1 (brick and mortar); EN 572 (float glass); EN 10025
// S235 (steel); Ashby & Jones, Engineering Materials 1 (plastic, rock, ice, plaster).
std::vector<Material> makeDefaults() {
    constexpr bool Y = true, n = false;  // whether it breaks under: sledge, torch, gun, explosive
    // clang-format off
    return {
    //name           hardness     kg/m3 tensile  compr.   shear    mu     e     J/kgK ign  burn fragments   tools
    {"empty",        Unphysical,  0,    0,       0,       0,       0,     0,    0,    0,   0,   "none",     n, n, n, n},
    {"glass",        Soft,        2500, 40e6f,   800e6f,  35e6f,   .40f,  .10f, 840,  0,   0,   "pane",     Y, Y, Y, Y},
    {"foliage",      Soft,        300,  1e6f,    1e6f,    0.5e6f,  .60f,  .05f, 2000, 520, 4,   "crumble",  Y, Y, Y, Y},
    {"dirt",         Soft,        1500, 0.02e6f, 0.3e6f,  0.05e6f, .80f,  .02f, 1000, 0,   0,   "crumble",  Y, n, Y, Y},
    {"rock",         Unbreakable, 2700, 10e6f,   150e6f,  20e6f,   .65f,  .15f, 800,  0,   0,   "none",     n, n, n, n},
    {"wood",         Soft,        500,  14e6f,   21e6f,   4e6f,    .50f,  .20f, 1700, 570, 20,  "splinter", Y, Y, Y, Y},
    {"concrete",     Medium,      2400, 2.6e6f,  25e6f,   4e6f,    .65f,  .10f, 880,  0,   0,   "chunk",    n, n, Y, Y},
    {"brick",        Medium,      1900, 0.4e6f,  8e6f,    0.6e6f,  .65f,  .10f, 840,  0,   0,   "bond",     n, n, Y, Y},
    {"plaster",      Soft,        900,  0.8e6f,  4e6f,    0.8e6f,  .60f,  .05f, 1090, 0,   0,   "crumble",  Y, n, Y, Y},
    {"metal",        Medium,      7850, 235e6f,  235e6f,  135e6f,  .45f,  .20f, 490,  0,   0,   "tear",     n, Y, Y, Y},
    {"heavy metal",  Unbreakable, 7850, 355e6f,  355e6f,  205e6f,  .45f,  .20f, 490,  0,   0,   "none",     n, n, n, n},
    {"plastic",      Soft,        1050, 40e6f,   60e6f,   30e6f,   .35f,  .30f, 1400, 650, 12,  "chunk",    Y, Y, Y, Y},
    {"hard metal",   Hard,        7850, 355e6f,  355e6f,  205e6f,  .45f,  .20f, 490,  0,   0,   "tear",     n, n, n, Y},
    {"hard masonry", Hard,        2500, 4e6f,    50e6f,   7e6f,    .65f,  .10f, 880,  0,   0,   "chunk",    n, n, n, Y},
    {"ice",          Soft,        917,  1e6f,    10e6f,   1e6f,    .05f,  .10f, 2050, 0,   0,   "chunk",    Y, Y, Y, Y},
    {"generic",      Medium,      1000, 2e6f,    10e6f,   2e6f,    .60f,  .10f, 1000, 0,   0,   "chunk",    n, n, Y, Y},
    {"unphysical",   Unphysical,  0,    0,       0,       0,       0,     0,    0,    0,   0,   "none",     n, n, n, n},
    {"snow",         Soft,        200,  0.01e6f, 0.05e6f, 0.01e6f, .30f,  .00f, 2090, 0,   0,   "crumble",  Y, Y, Y, Y},
    {"wire",         Soft,        8900, 220e6f,  220e6f,  125e6f,  .45f,  .10f, 385,  0,   0,   "tear",     Y, Y, Y, Y},
    {"rubber",       Soft,        1100, 15e6f,   30e6f,   10e6f,   1.00f, .30f, 1900, 620, 25,  "chunk",    Y, Y, Y, Y},
    };
    // clang-format on
}

}  // namespace

uint8_t MaterialTable::find(std::string_view name) const {
    for (size_t i = 1; i < materials.size(); ++i)
        if (materials[i].name == name) return uint8_t(i);
    return 0;
}

uint64_t MaterialTable::hash() const {
    uint64_t hash = materials.size();
    for (const Material& m : materials) {
        const std::array<float, 8> numbers = {
            m.tensileStrength, m.compressiveStrength, m.shearStrength,       m.friction,
            m.restitution,     m.heatCapacity,        m.ignitionTemperature, m.burnTime};
        hash = hashBytes(m.name.data(), m.name.size(), hash);
        hash = hashBytes(m.fragments.data(), m.fragments.size(), hash);
        hash = hashBytes(numbers.data(), sizeof numbers, hash);
        hash = hashValue(uint64_t(m.density) << 16 | uint64_t(m.hardness) << 8 | uint64_t(m.sledge) << 3 |
                             uint64_t(m.torch) << 2 | uint64_t(m.gun) << 1 | uint64_t(m.explosive),
                         hash);
    }
    return hash;
}

bool breaksWith(const Material& material, Tool tool) {
    switch (tool) {
        case Tool::Any:
            return true;
        case Tool::Sledge:
            return material.sledge;
        case Tool::Torch:
            return material.torch;
        case Tool::Gun:
            return material.gun;
        case Tool::Explosive:
            return material.explosive;
    }
    return false;
}

const MaterialTable& defaultMaterials() {
    static const MaterialTable table{makeDefaults()};
    return table;
}

uint8_t teardownMaterial(uint8_t paletteIndex) {
    struct Row {
        uint8_t last;
        const char* name;
    };
    static constexpr Row kRows[] = {
        {0, "empty"},         {8, "glass"},        {24, "foliage"},     {40, "dirt"},          {56, "rock"},
        {72, "wood"},         {88, "concrete"},    {104, "brick"},      {120, "plaster"},      {136, "metal"},
        {152, "heavy metal"}, {168, "plastic"},    {176, "hard metal"}, {184, "hard masonry"}, {192, "ice"},
        {224, "generic"},     {240, "unphysical"}, {253, "generic"},    {254, "snow"},         {255, "unphysical"},
    };
    for (const Row& row : kRows)
        if (paletteIndex <= row.last) return defaultMaterials().find(row.name);
    return 0;
}

}  // namespace rubble
