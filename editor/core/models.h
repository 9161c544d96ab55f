#pragma once
#include <cstdint>
#include <rubble/rubble.hpp>
#include <string>
#include <vector>

#include "editor/core/editor.h"
#include "editor/core/mesh_import.h"
#include "editor/core/places.h"

namespace editor {

/// The tag of a shape that is linked to a file. Its value is the file's path from the level's folder, or from the
/// current one while the level has no file. A second tag, model_link, says what came in.
inline constexpr const char* kModelTag = "model_file";

/// A file whose shapes can be placed: .vox, .vdb, .rubble, or a mesh, and how that becomes voxels.
struct ModelSource {
    std::string path;
    MeshOptions mesh;
};

/// What reloadModel() throws where a file cannot be read: nothing has changed.
class UnreadableModel : public Refused {
public:
    using Refused::Refused;
};

/// What became of the shapes that are linked to a file.
struct ModelReport {
    size_t updated = 0, equal = 0;    ///< shapes that were brought up to date; whose part of the file has not changed
    std::vector<std::string> kept;    ///< names of those that stay because they were edited here
    std::vector<std::string> locked;  ///< names of those that stay because they are locked
    std::vector<std::string> gone;    ///< names of those that the file has no longer
    std::vector<std::string> lostJoints;   ///< names of joints that find no voxel any more
    std::vector<std::string> otherVoxels;  ///< names of those whose voxels have another size in the file
    std::vector<std::string> notRound;     ///< names of those that were round, as wheels, and are touched as voxels now
};

/// Queues the shapes of a file for a world; adds lines of the report on meshes. Throws Refused and rubble::Error.
std::vector<rubble_prefab_row> placeModel(rubble::World& world, const ModelSource& source, const std::string& vdbTool,
                                          const Place& place, std::vector<std::string>& report);
/// Links shapes that placeModel() has queued in this step to their file.
void linkModels(Editor& editor, const ModelSource& source, const Place& place,
                const std::vector<rubble_prefab_row>& rows);
/// Takes the links of shapes away; one without stays as it is. Returns how many had one.
size_t unlinkModels(rubble::World& world, const std::vector<rubble_shape>& shapes);
/// Whether a shape is linked to a file.
bool isLinked(const rubble::World& world, rubble_shape shape);
/// The files to which shapes of a level are linked, as the level says them: each once, in order.
std::vector<std::string> linkedFiles(const rubble::World& world);
/// Linked files that are not as they were when shapes were read from them last.
struct ChangedFiles {
    std::vector<std::string> changed;     ///< but for shapes that are locked
    std::vector<std::string> unreadable;  ///< such as those that are gone
};
/// Those of a level.
ChangedFiles changedFiles(const Document& document);
/// The first of some names, for people.
std::string listOf(const std::vector<std::string>& names);
/// The path of a file that the level says.
std::string modelPath(const Document& document, const std::string& file);
/// Before the level is saved to another folder: lets the paths of its links begin there, as a step of the history.
/// False: there was nothing to do.
bool moveLinks(Document& document, const std::string& levelPath);

/// Shapes that are linked to one file, which is read in one way.
struct LinkedShapes {
    std::string file;  ///< as the level says it
    ModelSource source;
    std::vector<rubble_shape> shapes;
};
/// Those of these shapes that are linked, by their files.
std::vector<LinkedShapes> linkedShapes(const Document& document, const std::vector<rubble_shape>& shapes);
/// Reads their file again, and gives them its voxels and palettes: those whose voxels are still what came in, or all
/// if reverts. All else of a shape stays, as its place, name, tags, anchors, lights and paint. An axle through the
/// middle of a wheel goes through its new middle. Throws UnreadableModel, Refused and rubble::Error.
ModelReport reloadModel(Editor& editor, const LinkedShapes& linked, bool reverts);

}  // namespace editor
