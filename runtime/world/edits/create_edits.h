#pragma once
#include <cstdint>
#include <glm/vec3.hpp>

#include "runtime/core/handle.h"
#include "runtime/world/level/level.h"
#include "runtime/world/objects/body.h"

namespace rubble {

/// Makes a body without shapes.
struct CreateBodyEdit {
    Body body;  ///< its shapes and what it lived through are not read
};

/// Where the voxels of a shape that is made come from.
enum class ShapeSource : uint8_t {
    Grid,    ///< its grid
    Box,     ///< all cells have a voxel
    Sphere,  ///< the cells of a ball that touches the grid's sides; of an ellipsoid, if they are not equally long
    Copy     ///< another shape as it is when the edit is carried out, with its palette, paint and properties
};

/// A shape as data that archives hold with its voxels and its palette.
struct WholeShape : LevelShape {};

/// Makes a shape on a body, as a level brings it: parts of it that touch nothing stay until something is cut. One that
/// has no voxels when the step has carried out all edits is refused.
struct CreateShapeEdit {
    BodyHandle body;
    ShapeSource source = ShapeSource::Grid;
    glm::ivec3 size{0};     ///< of a box or sphere, in cells
    uint8_t entry = 1;      ///< of the palette, of a box or sphere
    ShapeHandle copied;     ///< by ShapeSource::Copy; a voxel size of 0 and an empty name mean those of the copied one
    ShapeHandle paletteOf;  ///< the palette is that of this shape; empty: `shape.palette`, if null materialPalette()
    WholeShape shape;       ///< of a copy: name, place and voxel size are read
};

}  // namespace rubble
