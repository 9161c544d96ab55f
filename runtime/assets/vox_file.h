#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// The key-value pairs of a chunk.
using VoxAttributes = std::map<std::string, std::string>;

/// The voxels of one model as stored, with z up: the colour index of each cell.
struct VoxModel {
    glm::ivec3 size{0};
    VoxelGrid grid;  ///< of that size; of size 0 if the model has no voxels
};

enum class VoxNodeKind : uint8_t { Transform, Group, Shape };

/// A node of the scene graph. A transform has one child and a pose for each animation frame, a group has children, a
/// shape has a model for each frame.
struct VoxNode {
    VoxNodeKind kind = VoxNodeKind::Group;
    VoxAttributes attributes;
    std::vector<int32_t> children;      ///< node ids; for a shape: model numbers
    std::vector<VoxAttributes> frames;  ///< of a transform: its poses; of a shape: one for each model
    int32_t layer = -1;
    size_t offset = 0;  ///< of its chunk in the file, for messages
};

/// A layer of the editor.
struct VoxLayer {
    VoxAttributes attributes;
};

/// The chunks of a MagicaVoxel file, checked for their syntax; references between them are not. Format:
/// github.com/ephtracy/voxel-model. Teardown's own files have TDCZ chunks instead of XYZI (vox_packed_model.h).
struct VoxFile {
    uint32_t version = 0;
    std::vector<VoxModel> models;
    std::array<std::array<uint8_t, 4>, 256> colors{};  ///< by stored index, [0] unused
    bool defaultColors = true;                         ///< there is no RGBA chunk
    std::optional<std::array<uint8_t, 256>> indexMap;  ///< IMAP: shown slot - 1 -> stored index
    std::map<int32_t, VoxAttributes> materials;        ///< MATL and MATT, by stored index
    std::map<int32_t, VoxNode> nodes;
    std::map<int32_t, VoxLayer> layers;
    std::map<int32_t, VoxAttributes> cameras;
    std::vector<VoxAttributes> renderSettings;  ///< rOBJ
    std::vector<std::string> colorNotes;        ///< NOTE: names of the rows of colours
    std::map<std::string, int> skippedChunks;   ///< kinds that are not known, with their number
    std::vector<std::string> warnings;          ///< about oddities that lose nothing
};

/// Parses a file. `name`: of the file, for messages. Any bytes give a VoxFile or an error, in time linear in their
/// number.
Result<VoxFile> parseVox(std::span<const uint8_t> bytes, const std::string& name);

/// The colours of files without an RGBA chunk, by palette index: a 6x6x6 cube from white to almost black, then ten
/// steps each of red, green, blue and grey. Index 0 is unused.
std::array<std::array<uint8_t, 4>, 256> defaultVoxColors();

}  // namespace rubble
