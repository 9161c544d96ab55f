#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "runtime/voxel/brick.h"

namespace rubble {

/// A plane set of cell faces through which one part of a shape holds to another. All lengths in cells of the grid.
struct Section {
    glm::ivec3 brick{0};  ///< that holds the layer below the plane
    int axis = 0;         ///< normal to it
    int plane = 0;       ///< 1 to 8: between the layers plane - 1 and plane of the brick; 8: and the next brick's first
    uint64_t cells = 0;  ///< bit u + 8 v, with (u, v) = (y, z), (x, z) or (x, y): as BrickPart::faces

    /// The cell below the plane at one of its bits.
    glm::ivec3 cellBelow(int bit) const;
    friend bool operator==(const Section&, const Section&) = default;
};

/// What a section resists with: the moments of its cells.
struct SectionShape {
    double area = 0.0;
    glm::dvec3 centroid{0.0};
    double uu = 0.0, vv = 0.0, uv = 0.0;  ///< second moments about the centroid
};

/// What the side above the plane does to the side below; the moment about the centroid.
struct SectionForce {
    glm::dvec3 force{0.0};
    glm::dvec3 moment{0.0};
};

/// Stresses that a section withstands, in the unit of its forces an area.
struct SectionStrength {
    double tensile = 0.0, compressive = 0.0, shear = 0.0;
};

enum class FailureMode : uint8_t { Tension, Compression, Shear };

/// Stress as a utilization of strength where it is largest; above 1 the section breaks.
struct SectionUtilization {
    double utilization = 0.0;
    FailureMode cause = FailureMode::Tension;
};

/// The cells of one layer of a brick, in the order of Section::cells.
uint64_t brickLayer(const BrickBits& bits, int axis, int layer);
/// The cells of a brick from one layer up.
BrickBits bitsFrom(const BrickBits& bits, int axis, int layer);

SectionShape sectionShape(const Section& section);
/// Cells of the plane of a section in its own brick, (0, 0), or in one beside it.
struct SectionTile {
    uint64_t cells = 0;
    int u = 0, v = 0;
};
SectionShape sectionShape(const Section& section, std::span<const SectionTile> tiles);
/// Beam theory: normal stress linear over `shape`, N/A + M c/I, at the outermost corners of the section, which may be
/// part of that shape only; shear V/A + T c/Ip.
SectionUtilization sectionUtilization(const Section& section, const SectionShape& shape, const SectionForce& load,
                                      const SectionStrength& strength);
/// The force on one cell face of a section, if it carries `load` as above.
glm::dvec3 faceForce(const Section& section, const SectionShape& shape, const SectionForce& load,
                     glm::dvec3 faceCenter);

}  // namespace rubble
