#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <rubble/rubble.hpp>
#include <string>

#include "editor/core/cells.h"
#include "editor/core/mesh_import.h"

namespace editor {

/// The voxels of a shape, apart from the size of its grid and the order of its palette.
struct Content {
    Cells solid;  ///< the least box that holds all voxels
    uint64_t hash = 0;
};
/// That of a shape as the last edit left it.
Content contentOf(const rubble::World& world, rubble_shape shape);

/// What a shape knows of the file that it came from: in the values of its tags model_file and model_link.
struct ModelLink {
    std::string file;  ///< as the level says it
    MeshOptions mesh;
    size_t number = 0;            ///< of the shape in the file
    std::string name;             ///< that it had there
    uint64_t hash = 0;            ///< of the content that came in
    uint64_t fileHash = 0;        ///< of the file, when it was read last for this shape; 0: nobody knows
    glm::dvec3 place{0.0};        ///< of its first voxel's corner in the file's frame, metres
    glm::dquat turn{1, 0, 0, 0};  ///< of its axes there
    glm::dvec3 corner{0.0};       ///< of the same voxel in the frame of its body, metres
};
/// The link of a shape. None: it has no link, or one that somebody has written by hand.
std::optional<ModelLink> linkOf(const rubble::World& world, rubble_shape shape);
/// Gives a shape a link, as an edit.
void setLink(rubble::World& world, rubble_shape shape, const ModelLink& link);
/// Takes it away, as an edit.
void removeLink(rubble::World& world, rubble_shape shape);

/// The folder in which links of a level begin.
std::filesystem::path folderOfLinks(const std::string& levelPath);
/// A path as a level says it whose links begin in a folder.
std::string relativeTo(const std::filesystem::path& folder, const std::string& path);
/// A hash of the bytes of a file; 0: it cannot be read.
uint64_t hashOfFile(const std::string& path);

}  // namespace editor
