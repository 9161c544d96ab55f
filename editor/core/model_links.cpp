#include "editor/core/model_links.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include "editor/core/models.h"
#include "editor/core/palette.h"

namespace editor {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLinkTag = "model_link";

/// What each index of a palette looks like and is made of.
std::vector<uint64_t> hashesOfEntries(const rubble::World& world, rubble_shape shape) {
    std::vector<uint64_t> hashes;
    for (const rubble_palette_entry& entry : paletteOf(world, shape)) {
        const uint8_t bytes[] = {entry.color[0],  entry.color[1], entry.color[2],     entry.opacity,
                                 entry.roughness, entry.metallic, entry.reflectivity, entry.light_group != 0};
        uint64_t hash = XXH3_64bits(bytes, sizeof bytes);
        hash = XXH3_64bits_withSeed(&entry.emission, sizeof entry.emission, hash);
        const char* const material = entry.material ? world.get_material(entry.material).name : "";
        hashes.push_back(XXH3_64bits_withSeed(material, std::strlen(material), hash));
    }
    return hashes;
}

std::string textOf(const ModelLink& link) {
    const MeshOptions& mesh = link.mesh;
    const auto point = [](glm::dvec3 p) { return fmt::format("{} {} {}", p.x, p.y, p.z); };
    return fmt::format("{:016x}:{:016x} {} {} {} {} {} {} {} {} {} {} {} {} {}", link.hash, link.fileHash, link.number,
                       point(link.place), link.turn.w, link.turn.x, link.turn.y, link.turn.z, point(link.corner),
                       mesh.voxels, mesh.voxel, mesh.shell, int(mesh.isZUp), int(mesh.isSmooth), link.name);
}

std::optional<std::string> tagOf(const rubble::World& world, rubble_shape shape, const char* tag) {
    const std::vector<char> value = world.get_tag(shape, tag);
    if (value.empty()) return std::nullopt;
    return std::string(value.data());
}

}  // namespace

Content contentOf(const rubble::World& world, rubble_shape shape) {
    Content content{.solid = solidOf(world, shape)};
    const std::vector<uint64_t> entries = hashesOfEntries(world, shape);
    content.hash = XXH3_64bits(&content.solid.size, sizeof content.solid.size);
    std::vector<uint64_t> seen;
    forEachLayer(world, shape, content.solid, [&](const Cells&, const std::vector<uint8_t>& voxels) {
        seen.resize(voxels.size());
        std::ranges::transform(voxels, seen.begin(), [&](uint8_t voxel) { return voxel ? entries[voxel] : 0; });
        content.hash = XXH3_64bits_withSeed(seen.data(), seen.size() * sizeof seen[0], content.hash);
    });
    return content;
}

std::optional<ModelLink> linkOf(const rubble::World& world, rubble_shape shape) {
    const std::optional<std::string> file = tagOf(world, shape, kModelTag), text = tagOf(world, shape, kLinkTag);
    if (!file || !text) return std::nullopt;
    ModelLink link{.file = *file};
    std::istringstream in(*text);
    const auto point = [&](glm::dvec3& p) { in >> p.x >> p.y >> p.z; };
    in >> std::hex >> link.hash;
    if (in.peek() == ':') in.ignore() >> link.fileHash;  // levels of before have none
    in >> std::dec >> link.number;
    point(link.place);
    in >> link.turn.w >> link.turn.x >> link.turn.y >> link.turn.z;
    point(link.corner);
    in >> link.mesh.voxels >> link.mesh.voxel >> link.mesh.shell >> link.mesh.isZUp >> link.mesh.isSmooth;
    if (!in || in.get() != ' ') return std::nullopt;
    std::getline(in, link.name, '\0');
    return link;
}

void setLink(rubble::World& world, rubble_shape shape, const ModelLink& link) {
    world.set_tag(shape, kModelTag, link.file.c_str());
    world.set_tag(shape, kLinkTag, textOf(link).c_str());
}

void removeLink(rubble::World& world, rubble_shape shape) {
    world.remove_tag(shape, kModelTag);
    world.remove_tag(shape, kLinkTag);
}

fs::path folderOfLinks(const std::string& levelPath) {
    return levelPath.empty() ? fs::current_path() : fs::absolute(levelPath).parent_path();
}

std::string relativeTo(const fs::path& folder, const std::string& path) {
    const fs::path whole = fs::absolute(path).lexically_normal();
    const fs::path relative = whole.lexically_relative(folder.lexically_normal());
    return relative.empty() ? whole.string() : relative.string();
}

uint64_t hashOfFile(const std::string& path) {
    std::error_code none;
    if (!fs::is_regular_file(path, none)) return 0;
    std::ifstream file(path, std::ios::binary);
    uint64_t hash = 1;
    std::vector<char> part(size_t(1) << 16);
    while (file) {
        file.read(part.data(), std::streamsize(part.size()));
        hash = XXH3_64bits_withSeed(part.data(), size_t(file.gcount()), hash);
    }
    return file.eof() ? std::max<uint64_t>(hash, 1) : 0;
}

}  // namespace editor
