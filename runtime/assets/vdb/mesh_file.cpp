#include "runtime/assets/vdb/mesh_file.h"

// The only file that includes Assimp, which reads the formats.
#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <map>
#include <new>
#include <utility>

#include "runtime/assets/assets.h"
#include "runtime/assets/file_bytes.h"
#include "runtime/assets/png_pixels.h"
#include "runtime/assets/vdb/glb_header.h"
#include "runtime/assets/vdb/ply_header.h"
#include "runtime/voxel/palette.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;
constexpr uint64_t kMaxFileBytes = uint64_t(1) << 30;
constexpr uint32_t kMaxTextureSide = 16384;
constexpr double kMaxCoordinate = 1e9;  // metres

glm::vec3 toLinear(glm::vec3 srgb) {
    const auto one = [](float value) { return srgbToLinear(uint8_t(glm::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f)); };
    return {one(srgb.x), one(srgb.y), one(srgb.z)};
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A colour of the file; white where it is no number.
glm::vec3 colorOf(const aiColor4D& color, bool isLinear) {
    const glm::vec3 value(color.r, color.g, color.b);
    if (!isFinite(value)) return glm::vec3(1.0f);
    return isLinear ? glm::clamp(value, 0.0f, 1.0f) : toLinear(value);
}

/// A PNG file in memory; false: it is none.
bool readPng(const void* bytes, size_t size, MeshTexture& out) {
    const std::string error =
        readPngPixels({static_cast<const uint8_t*>(bytes), size}, [&](uint32_t width, uint32_t height) {
            if (width > kMaxTextureSide || height > kMaxTextureSide) return static_cast<void*>(nullptr);
            out.size = {int(width), int(height)};
            out.pixels.resize(size_t(width) * height);
            return static_cast<void*>(out.pixels.data());
        });
    return error.empty() && !out.pixels.empty();
}

/// A .obj file whose numbers have a digit before the point, without which Assimp does not count them.
std::vector<uint8_t> withLeadingDigits(const std::vector<uint8_t>& obj) {
    std::vector<uint8_t> out;
    out.reserve(obj.size());
    bool isOfPoint = false;  // the line, which may go on after a backslash
    const auto at = [&](size_t i) { return i < obj.size() ? char(obj[i]) : '\n'; };
    for (size_t i = 0; i < obj.size(); ++i) {
        const char before = i ? at(i - 1) : '\n', each = at(i);
        const bool isContinued = i > 1 && (at(i - 2) == '\\' || (at(i - 2) == '\r' && i > 2 && at(i - 3) == '\\'));
        if (before == '\n' && !isContinued) isOfPoint = each == 'v';
        if (isOfPoint && each == '.' && (before == ' ' || before == '\t') && at(i + 1) >= '0' && at(i + 1) <= '9')
            out.push_back('0');
        out.push_back(uint8_t(each));
    }
    return out;
}

/// Gives Assimp one file from memory, and others from the disk.
class OneFileInMemory : public Assimp::DefaultIOSystem {
public:
    OneFileInMemory(std::string path, std::vector<uint8_t> bytes)
        : m_path(std::move(path)), m_bytes(std::move(bytes)) {}
    Assimp::IOStream* Open(const char* path, const char* mode) override {
        if (m_path != path) return DefaultIOSystem::Open(path, mode);
        return new Assimp::MemoryIOStream(m_bytes.data(), m_bytes.size());
    }

private:
    std::string m_path;
    std::vector<uint8_t> m_bytes;
};

/// Takes over what Assimp has read.
class MeshReader {
public:
    MeshReader(const aiScene& scene, const std::string& path)
        : m_scene(scene), m_folder(fs::path(path).parent_path()), m_isGltf(endingOf(path) == ".glb") {}

    Result<Mesh> read() {
        for (unsigned i = 0; i < m_scene.mNumMaterials; ++i) addMaterial(*m_scene.mMaterials[i]);
        if (m_mesh.materials.empty()) m_mesh.materials.emplace_back();
        addNode(*m_scene.mRootNode, aiMatrix4x4());
        if (m_error.empty() && m_mesh.triangles.empty()) {
            m_error = "expected triangles, found none";
            const std::string loss = m_flat > 0 ? m_mesh.lossNote(1e-3) : "";
            if (m_flat > 0) m_error += fmt::format(" but {} without an area", m_flat);
            if (!loss.empty()) m_error += ": " + loss;
        }
        if (!m_error.empty()) return Error{m_error};
        if (m_flat > 0) m_mesh.notes.push_back(fmt::format("{} triangles without an area were left out", m_flat));
        return std::move(m_mesh);
    }

private:
    void addMaterial(const aiMaterial& from) {
        MeshMaterial material;
        if (aiString name; from.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) material.name = name.C_Str();
        aiColor4D color(1.0f, 1.0f, 1.0f, 1.0f);
        if (from.Get(AI_MATKEY_BASE_COLOR, color) == AI_SUCCESS ||
            from.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS)
            material.color = colorOf(color, m_isGltf);
        aiString texture;
        const aiTextureType type =
            from.GetTextureCount(aiTextureType_BASE_COLOR) ? aiTextureType_BASE_COLOR : aiTextureType_DIFFUSE;
        unsigned channel = 0;
        if (from.GetTexture(type, 0, &texture, nullptr, &channel) == AI_SUCCESS) {
            material.texture = textureOf(texture.C_Str());
            if (material.texture >= 0 && !m_isGltf) material.color = glm::vec3(1.0f);  // as most programs have it
        }
        m_mesh.materials.push_back(std::move(material));
        m_channels.push_back(channel);
    }

    /// The index of a texture, which is read once; -1: it is left out, which is noted.
    int textureOf(const std::string& name) {
        if (const auto found = m_textures.find(name); found != m_textures.end()) return found->second;
        MeshTexture texture;
        int index = -1;
        if (readTexture(name, texture)) {
            index = int(m_mesh.textures.size());
            m_mesh.textures.push_back(std::move(texture));
        } else {
            m_mesh.notes.push_back(fmt::format("texture '{}': expected a PNG image, found none: it is left out", name));
        }
        return m_textures[name] = index;
    }

    bool readTexture(std::string name, MeshTexture& out) const {
        if (const aiTexture* inside = m_scene.GetEmbeddedTexture(name.c_str()))
            return inside->mHeight == 0 && readPng(inside->pcData, inside->mWidth, out);
        std::replace(name.begin(), name.end(), '\\', '/');
        const Result<std::vector<uint8_t>> bytes = readFileBytes((m_folder / name).string(), kMaxFileBytes);
        return bytes && readPng(bytes->data(), bytes->size(), out);
    }

    void addNode(const aiNode& node, const aiMatrix4x4& parent) {
        const aiMatrix4x4 pose = parent * node.mTransformation;
        for (unsigned i = 0; i < node.mNumMeshes && m_error.empty(); ++i)
            addMesh(*m_scene.mMeshes[node.mMeshes[i]], pose);
        for (unsigned i = 0; i < node.mNumChildren && m_error.empty(); ++i) addNode(*node.mChildren[i], pose);
    }

    void addMesh(const aiMesh& from, const aiMatrix4x4& pose) {
        m_vertices += from.mNumVertices;
        if (m_vertices > 3 * kMaxMeshTriangles)
            return void(m_error = fmt::format("expected at most {} vertices, found more", 3 * kMaxMeshTriangles));
        std::vector<uint32_t> points;
        for (unsigned i = 0; i < from.mNumVertices; ++i) {
            const aiVector3D at = pose * from.mVertices[i];
            const glm::dvec3 point(at.x, at.y, at.z);
            if (!(glm::max(glm::abs(point.x), glm::max(glm::abs(point.y), glm::abs(point.z))) <= kMaxCoordinate)) {
                m_error = fmt::format("vertex {}: expected numbers within {:g} m, found {}, {}, {}", i, kMaxCoordinate,
                                      at.x, at.y, at.z);
                return;
            }
            points.push_back(indexOf(point));
        }
        const bool isMirrored = aiMatrix3x3(pose).Determinant() < 0.0f;
        for (unsigned i = 0; i < from.mNumFaces && m_error.empty(); ++i)
            addTriangle(from, from.mFaces[i], points, isMirrored);
    }

    /// The point at a place, which is made if it is new.
    uint32_t indexOf(glm::dvec3 at) {
        at += 0.0;  // -0 is 0
        const auto [found, isNew] = m_places.try_emplace({at.x, at.y, at.z}, uint32_t(m_mesh.points.size()));
        if (isNew) m_mesh.points.push_back(at);
        return found->second;
    }

    void addTriangle(const aiMesh& from, const aiFace& face, const std::vector<uint32_t>& points, bool isMirrored) {
        if (face.mNumIndices != 3) return;
        MeshTriangle triangle;
        triangle.material = from.mMaterialIndex < m_mesh.materials.size() ? from.mMaterialIndex : 0;
        const unsigned channel = triangle.material < m_channels.size() ? m_channels[triangle.material] : 0;
        const bool hasPlaces = channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && from.HasTextureCoords(channel);
        const bool hasColors = from.HasVertexColors(0);
        for (size_t c = 0; c < 3; ++c) {
            const unsigned vertex = face.mIndices[isMirrored ? 2 - c : c];  // so that the same side is outside
            if (vertex >= points.size()) {
                m_error = fmt::format("expected a vertex below {}, found {}", points.size(), vertex);
                return;
            }
            triangle.points[c] = points[vertex];
            triangle.places[c] = hasPlaces ? placeOf(from.mTextureCoords[channel][vertex]) : glm::vec2(0.0f);
            triangle.colors[c] = hasColors ? colorOf(from.mColors[0][vertex], m_isGltf) : glm::vec3(1.0f);
        }
        const auto& p = triangle.points;
        if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) return void(++m_flat);
        if (hasColors && !m_isGltf) useOnlyCorners(triangle);
        m_mesh.triangles.push_back(triangle);
        if (m_mesh.triangles.size() > kMaxMeshTriangles)
            m_error = fmt::format("expected at most {} triangles, found more", kMaxMeshTriangles);
    }

    /// In formats that do not say, colours of corners take the place of that of the material, and a texture of both.
    void useOnlyCorners(MeshTriangle& triangle) {
        MeshMaterial& material = m_mesh.materials[triangle.material];
        if (material.texture >= 0)
            triangle.colors = {glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(1.0f)};
        else
            material.color = glm::vec3(1.0f);
    }

    static glm::vec2 placeOf(const aiVector3D& at) {
        return std::abs(at.x) <= 1e6f && std::abs(at.y) <= 1e6f ? glm::vec2(at.x, at.y) : glm::vec2(0.0f);
    }

    const aiScene& m_scene;
    fs::path m_folder;
    bool m_isGltf;
    Mesh m_mesh;
    std::vector<unsigned> m_channels;  ///< of places, by material
    std::map<std::string, int> m_textures;
    std::map<std::array<double, 3>, uint32_t> m_places;
    size_t m_flat = 0, m_vertices = 0;
    std::string m_error;
};

}  // namespace

Result<Mesh> readMesh(const std::string& path) {
    const std::string ending = endingOf(path);
    if (ending != ".obj" && ending != ".ply" && ending != ".glb")
        return Error{fmt::format("{}: expected a name ending in .obj, .ply or .glb, found '{}'", path, ending)};
    const Result<std::vector<uint8_t>> bytes = readFileBytes(path, kMaxFileBytes);
    if (!bytes) return Error{bytes.error()};
    if (const std::string error = ending == ".ply"   ? plyHeaderError(*bytes)
                                  : ending == ".glb" ? glbError(*bytes)
                                                     : "";
        !error.empty())
        return Error{path + ": " + error};
    Assimp::Importer importer;
    if (ending == ".obj") importer.SetIOHandler(new OneFileInMemory(path, withLeadingDigits(*bytes)));  // it takes it
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    // Validation comes first: the other steps trust what they are given.
    const aiScene* const scene = importer.ReadFile(
        path, aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_FlipUVs);
    const std::string said = importer.GetErrorString();
    if (said == std::bad_alloc().what()) throw std::bad_alloc();
    if (!scene || !scene->mRootNode) return Error{fmt::format("{}: {}", path, said)};
    Result<Mesh> mesh = MeshReader(*scene, path).read();
    return mesh ? std::move(mesh) : Error{path + ": " + mesh.error()};
}

}  // namespace rubble
