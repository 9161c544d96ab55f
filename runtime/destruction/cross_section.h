#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "runtime/voxel/brick.h"

namespace rubble {

/// A cross-section: a plane set of cell faces through which one part of a shape is connected to another. Lengths in
/// cells of the grid.
struct Section {
    glm::ivec3 brick{0};  ///< the brick of the layer below the plane
    int axis = 0;         ///< normal to the plane
    int plane = 0;        ///< 1 to 8: between layers plane - 1 and plane of the brick; 8: its border to the next brick
    uint64_t cells = 0;   ///< bit u + 8 v, with (u, v) = (y, z), (x, z) or (x, y), as in BrickPart::faces

    /// The cell below the plane of one of the bits.
    glm::ivec3 cellBelow(int bit) const;
    friend bool operator==(const Section&, const Section&) = default;
};

/// The axes of u and v in the plane of a section, by the axis of its normal.
inline constexpr std::array<int, 3> kSectionU = {1, 0, 0}, kSectionV = {2, 2, 1};

/// A number for each brick of a grid and beyond its borders: 16 bits an axis.
inline uint64_t brickKey(glm::ivec3 brick) {
    return uint64_t(uint16_t(brick.x)) | uint64_t(uint16_t(brick.y)) << 16 | uint64_t(uint16_t(brick.z)) << 32;
}

/// The moments of area of a section.
struct SectionShape {
    double area = 0.0;
    glm::dvec3 centroid{0.0};
    double uu = 0.0, vv = 0.0, uv = 0.0;  ///< second moments about the centroid
};

/// Force and moment of the side above the plane on the side below; the moment is about the section's centroid.
struct SectionForce {
    glm::dvec3 force{0.0};
    glm::dvec3 moment{0.0};
};

/// The stresses that a section withstands, in units of its forces per area.
struct SectionStrength {
    double tensile = 0.0, compressive = 0.0, shear = 0.0;
};

/// The stress by which a section fails.
enum class FailureMode : uint8_t { Tension, Compression, Shear };

/// How much of its strength a section uses where that is most.
struct SectionUtilization {
    double utilization = 0.0;  ///< stress over strength; above 1 the section breaks
    FailureMode cause = FailureMode::Tension;
};

/// The cells of one layer of a brick, 0 to 7 along an axis, in the order of Section::cells.
uint64_t brickLayer(const BrickBits& bits, int axis, int layer);
/// The cells of a brick in this layer and all layers above it.
BrickBits bitsFrom(const BrickBits& bits, int axis, int layer);

/// The moments of area of a section's own cells.
SectionShape sectionShape(const Section& section);
/// Cells in the plane of a section: in its own brick, (u, v) = (0, 0), or in another brick of the plane.
struct SectionTile {
    uint64_t cells = 0;
    int u = 0, v = 0;  ///< bricks from that of the section
};
/// The moments of area of all tiles together, in the frame of `section`.
SectionShape sectionShape(const Section& section, std::span<const SectionTile> tiles);
/// The utilization of a section by beam theory (S. Timoshenko, Strength of Materials): normal stress N/A + M c/I, shear
/// stress V/A + T c/Ip, at the outermost corners of the section's cells. `shape`: of the whole cross-section, of which
/// the section may be a part. `load`: on the whole cross-section, about its centroid.
SectionUtilization sectionUtilization(const Section& section, const SectionShape& shape, const SectionForce& load,
                                      const SectionStrength& strength);
/// The force on one cell face of a cross-section that carries `load`, by the same theory.
glm::dvec3 faceForce(const Section& section, const SectionShape& shape, const SectionForce& load,
                     glm::dvec3 faceCenter);

}  // namespace rubble
