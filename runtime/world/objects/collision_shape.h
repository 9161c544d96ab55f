#pragma once
#include <cstdint>

namespace rubble {

/// What physics takes a shape for where it touches others. The round ones are the smallest that hold all its voxels,
/// about the middle of its bounds: a wheel rolls on a cylinder and a ball on a sphere, not on the corners of voxels.
/// A shape whose voxels do not fill it to a voxel, as a wide full box or after a cut, is touched as voxels.
enum class CollisionShape : uint8_t { Voxels, Sphere, CylinderX, CylinderY, CylinderZ };

}  // namespace rubble
