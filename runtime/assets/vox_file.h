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

namespace rubble {

/// The key-value pairs that most chunks of a .vox file are made of.
using VoxAttributes = std::map<std::string, std::string>;

/// One model's voxels, as stored: Z up, cell and colour index.
struct VoxModel {
    glm::ivec3 size{0};
    std::vector<std::array<uint8_t, 4>> voxels;
};

enum class VoxNodeKind : uint8_t { Transform, Group, Shape };

/// A node of the scene graph. Transform: one child and a pose a frame; group: children; shape: a model a frame.
struct VoxNode {
    VoxNodeKind kind = VoxNodeKind::Group;
    VoxAttributes attributes;
    std::vector<int32_t> children;      ///< node ids; for a shape: model numbers
    std::vector<VoxAttributes> frames;  ///< transform: poses; shape: one a model
    int32_t layer = -1;
    size_t offset = 0;  ///< of its chunk in the file, for messages
};

struct VoxLayer {
    VoxAttributes attributes;
};

/// What a MagicaVoxel file says, chunk by chunk, checked for form but not for sense.
/// Format: github.com/ephtracy/voxel-model.
struct VoxFile {
    uint32_t version = 0;
    std::vector<VoxModel> models;
    std::array<std::array<uint8_t, 4>, 256> colors{};  ///< by stored index, [0] unused
    bool defaultColors = true;                         ///< no RGBA chunk
    std::optional<std::array<uint8_t, 256>> indexMap;  ///< IMAP: shown slot - 1 -> stored index
    std::map<int32_t, VoxAttributes> materials;        ///< MATL and MATT, by stored index
    std::map<int32_t, VoxNode> nodes;
    std::map<int32_t, VoxLayer> layers;
    std::map<int32_t, VoxAttributes> cameras;
    std::vector<VoxAttributes> renderSettings;  ///< rOBJ
    std::vector<std::string> colorNotes;        ///< NOTE: names of the rows of colours
    std::map<std::string, int> skippedChunks;   ///< unknown kinds and how many
    std::vector<std::string> warnings;          ///< oddities that lose nothing
};

/// `name` is the file's name, for messages. Any bytes give a VoxFile or an error, in time linear in their number.
Result<VoxFile> parseVox(std::span<const uint8_t> bytes, const std::string& name);

/// MagicaVoxel's colours for files without RGBA: a 6x6x6 cube, white to almost black, then ten steps each of red,
/// green, blue and grey.
std::array<std::array<uint8_t, 4>, 256> defaultVoxColors();

}  // namespace rubble
