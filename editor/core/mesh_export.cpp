#include "editor/core/mesh_export.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <glm/common.hpp>
#include <iterator>
#include <limits>

#include "editor/core/cells.h"
#include "editor/core/editor.h"
#include "editor/core/palette.h"
#include "editor/core/rotation.h"
#include "runtime/script/sandbox/script_name.h"

namespace editor {
namespace {

/// Faces of one shape along its own axes, four vertices each.
struct Mesh {
    rubble_shape_state state{};
    std::string name;
    std::vector<rubble_mesh_vertex> opaque, transparent;
};

/// The faces of transparent voxels that opaque ones hide, behind a rectangle of these: so each kind is closed by
/// itself, and an import finds the inside of both.
class HiddenFaces {
public:
    HiddenFaces(const rubble::World& world, rubble_shape shape)
        : m_world(world),
          m_shape(shape),
          m_voxel(world.get_shape_state(shape).voxel_size),
          m_palette(paletteOf(world, shape)) {}

    /// face: the four corners of the rectangle.
    void addBehind(const rubble_mesh_vertex* face, std::vector<rubble_mesh_vertex>& to) const {
        const glm::ivec3 first = cornerOf(face[0]), right = cornerOf(face[1]) - first, up = cornerOf(face[3]) - first;
        const glm::ivec3 normal(face[0].normal[0], face[0].normal[1], face[0].normal[2]);
        Cells front{glm::min(first, first + right + up), glm::abs(right + up + normal)};
        front.low += glm::min(normal, glm::ivec3(0));
        const std::vector<uint8_t> voxels = readCells(m_world, m_shape, front);
        const glm::ivec3 u = glm::sign(right), v = glm::sign(up);
        const glm::ivec3 toFirst =
            glm::max(-u, glm::ivec3(0)) + glm::max(-v, glm::ivec3(0)) + glm::max(-normal, glm::ivec3(0));
        const CellSet places{m_shape, front.low, front.size, {}};
        for (glm::ivec3 cell = front.low; cell.z < front.low.z + front.size.z; ++cell.z)
            for (cell.y = front.low.y; cell.y < front.low.y + front.size.y; ++cell.y)
                for (cell.x = front.low.x; cell.x < front.low.x + front.size.x; ++cell.x) {
                    const uint8_t index = voxels[places.at(cell)];
                    if (!index || m_palette[index].opacity == 255) continue;
                    for (const glm::ivec3 corner : {glm::ivec3(0), v, u + v, u})
                        to.push_back(vertexAt(cell + toFirst + corner, -normal, index));
                }
    }

private:
    glm::ivec3 cornerOf(const rubble_mesh_vertex& vertex) const {
        return glm::ivec3(glm::round(glm::dvec3(vertex.position[0], vertex.position[1], vertex.position[2]) / m_voxel));
    }
    rubble_mesh_vertex vertexAt(glm::ivec3 corner, glm::ivec3 normal, uint8_t index) const {
        const rubble_palette_entry& entry = m_palette[index];
        rubble_mesh_vertex vertex{};
        for (int a = 0; a < 3; ++a) {
            vertex.position[a] = float(double(corner[a]) * m_voxel), vertex.normal[a] = float(normal[a]);
            vertex.color[a] = entry.color[a];
        }
        vertex.color[3] = entry.opacity;
        return vertex;
    }

    const rubble::World& m_world;
    rubble_shape m_shape;
    double m_voxel;  ///< metres
    std::vector<rubble_palette_entry> m_palette;
};

Mesh meshOf(const rubble::World& world, rubble_shape shape) {
    Mesh mesh;
    mesh.state = world.get_shape_state(shape);
    mesh.name = nameOf(world, shape);
    if (mesh.name.empty()) mesh.name = nameOf(world, mesh.state.body);
    if (mesh.name.empty()) mesh.name = "shape";
    rubble_brick_changes changes{};
    changes.what = RUBBLE_BRICKS_MESHES;
    changes.shape = shape;
    uint64_t version = 0;
    std::vector<rubble_mesh_vertex> vertices(RUBBLE_MAX_BRICK_VERTICES);
    for (const rubble_brick& brick : world.get_changed_bricks(changes, &version)) {
        const int32_t at[3] = {brick.x, brick.y, brick.z};
        uint32_t count = 0;
        rubble::check(
            rubble::api().mesh_brick(world.handle(), shape, at, vertices.data(), uint32_t(vertices.size()), &count));
        for (uint32_t i = 0; i < count; i += 4) {
            std::vector<rubble_mesh_vertex>& to = vertices[i].color[3] == 255 ? mesh.opaque : mesh.transparent;
            to.insert(to.end(), &vertices[i], &vertices[i] + 4);
        }
    }
    const HiddenFaces hidden(world, shape);
    for (size_t i = 0; i < mesh.opaque.size(); i += 4) hidden.addBehind(&mesh.opaque[i], mesh.transparent);
    return mesh;
}

/// A name that ends at no space.
std::string oneWord(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return uint8_t(c) <= ' '; }, '_');
    return name;
}

std::string objOf(const std::vector<Mesh>& meshes) {
    std::string out = "# metres, y up; the colours of vertices are sRGB\n";
    size_t first = 1;
    for (const Mesh& mesh : meshes) {
        out += fmt::format("o {}\n", oneWord(mesh.name));
        const glm::dquat turn = quaternionOf(mesh.state.rotation);
        const glm::dvec3 corner = vectorOf(mesh.state.position);
        for (const auto* part : {&mesh.opaque, &mesh.transparent})
            for (size_t i = 0; i < part->size(); ++i) {
                const rubble_mesh_vertex& vertex = (*part)[i];
                const glm::dvec3 at =
                    corner + turn * glm::dvec3(vertex.position[0], vertex.position[1], vertex.position[2]);
                fmt::format_to(std::back_inserter(out), "v {:.9g} {:.9g} {:.9g} {:.4f} {:.4f} {:.4f}\n", at.x, at.y,
                               at.z, vertex.color[0] / 255.0, vertex.color[1] / 255.0, vertex.color[2] / 255.0);
            }
        const size_t count = mesh.opaque.size() + mesh.transparent.size();
        for (size_t i = first; i < first + count; i += 4)
            fmt::format_to(std::back_inserter(out), "f {} {} {} {}\n", i, i + 1, i + 2, i + 3);
        first += count;
    }
    return out;
}

/// glTF's colours of vertices are linear.
uint16_t linearShort(uint8_t srgb) {
    const double s = srgb / 255.0;
    return uint16_t((s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4)) * 65535.0 + 0.5);
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (uint8_t(c) >= ' ') out += c;
    }
    return out + "\"";
}

template <class T>
void addBytes(std::string& out, const T& value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A .glb file: one binary buffer, and the JSON that says what is where in it.
class GlbWriter {
public:
    void add(const Mesh& mesh) {
        std::string primitives;
        for (const auto* part : {&mesh.opaque, &mesh.transparent}) {
            if (part->empty()) continue;
            if (!primitives.empty()) primitives += ',';
            primitives += addPrimitive(*part, part == &mesh.transparent);
        }
        const auto& p = mesh.state.position;
        const auto& r = mesh.state.rotation;
        append(m_nodes, fmt::format(R"({{"name":{},"mesh":{},"translation":[{},{},{}],"rotation":[{},{},{},{}]}})",
                                    quoted(mesh.name), m_count, p[0], p[1], p[2], r[0], r[1], r[2], r[3]));
        append(m_meshes, fmt::format(R"({{"primitives":[{}]}})", primitives));
        append(m_scene, fmt::format("{}", m_count++));
    }
    std::string bytes() const {
        std::string json = fmt::format(
            R"({{"asset":{{"version":"2.0","generator":"Rubble"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],)"
            R"("meshes":[{}],"materials":[{{"name":"opaque","pbrMetallicRoughness":{{"metallicFactor":0}}}},)"
            R"({{"name":"transparent","alphaMode":"BLEND","pbrMetallicRoughness":{{"metallicFactor":0}}}}],)"
            R"("accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
            m_scene, m_nodes, m_meshes, m_accessors, m_views, m_buffer.size());
        json.resize((json.size() + 3) / 4 * 4, ' ');
        const size_t size = 12 + 8 + json.size() + 8 + m_buffer.size();
        if (size > std::numeric_limits<uint32_t>::max())
            throw Refused(fmt::format("expected meshes that a .glb file can hold, found {} bytes", size));
        std::string out = "glTF";
        addBytes(out, uint32_t(2));
        addBytes(out, uint32_t(size));
        addBytes(out, uint32_t(json.size()));
        out += "JSON" + json;
        addBytes(out, uint32_t(m_buffer.size()));
        out.append("BIN\0", 4);
        return out + m_buffer;
    }

private:
    static void append(std::string& list, const std::string& item) { list += (list.empty() ? "" : ",") + item; }

    /// Tells of what was written to the buffer since `begin`; returns the accessor's number.
    size_t addAccessor(size_t begin, size_t count, int type, const char* kind, const std::string& more) {
        append(m_views,
               fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}}})", begin, m_buffer.size() - begin));
        append(m_accessors, fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})",
                                        m_viewCount, type, count, kind, more));
        return m_viewCount++;
    }

    std::string addPrimitive(const std::vector<rubble_mesh_vertex>& vertices, bool isTransparent) {
        constexpr int kFloat = 5126, kShort = 5123, kInteger = 5125;
        std::array<float, 3> low, high;
        low.fill(std::numeric_limits<float>::max());
        high.fill(std::numeric_limits<float>::lowest());
        size_t begin = m_buffer.size();
        for (const rubble_mesh_vertex& each : vertices) {
            addBytes(m_buffer, each.position);
            for (size_t a = 0; a < 3; ++a)
                low[a] = std::min(low[a], each.position[a]), high[a] = std::max(high[a], each.position[a]);
        }
        const std::string range =
            fmt::format(R"(,"min":[{},{},{}],"max":[{},{},{}])", low[0], low[1], low[2], high[0], high[1], high[2]);
        const size_t positions = addAccessor(begin, vertices.size(), kFloat, "VEC3", range);
        begin = m_buffer.size();
        for (const rubble_mesh_vertex& each : vertices) addBytes(m_buffer, each.normal);
        const size_t normals = addAccessor(begin, vertices.size(), kFloat, "VEC3", "");
        begin = m_buffer.size();
        for (const rubble_mesh_vertex& each : vertices) {
            for (size_t a = 0; a < 3; ++a) addBytes(m_buffer, linearShort(each.color[a]));
            addBytes(m_buffer, uint16_t(each.color[3] * 257));
        }
        const size_t colors = addAccessor(begin, vertices.size(), kShort, "VEC4", R"(,"normalized":true)");
        begin = m_buffer.size();
        for (uint32_t i = 0; i < vertices.size(); i += 4)
            for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) addBytes(m_buffer, i + corner);
        const size_t indices = addAccessor(begin, vertices.size() / 4 * 6, kInteger, "SCALAR", "");
        return fmt::format(R"({{"attributes":{{"POSITION":{},"NORMAL":{},"COLOR_0":{}}},"indices":{},"material":{}}})",
                           positions, normals, colors, indices, isTransparent ? 1 : 0);
    }

    std::string m_buffer, m_nodes, m_meshes, m_scene, m_accessors, m_views;
    size_t m_count = 0, m_viewCount = 0;
};

}  // namespace

void writeFile(const std::string& path, const std::string& bytes) {
    const std::string beside = fmt::format("{}.{}.tmp", path, ::getpid());
    const auto fail = [&](const char* what) {
        const std::string reason = std::strerror(errno);
        ::unlink(beside.c_str());
        throw Refused(fmt::format("{}: {}: {}", path, what, reason));
    };
    const int file = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) fail("cannot open");
    size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t part = ::write(file, bytes.data() + done, bytes.size() - done);
        if (part < 0 && errno != EINTR) break;
        done += size_t(std::max<ssize_t>(part, 0));
    }
    const bool isWhole = done == bytes.size() && ::fsync(file) == 0;
    ::close(file);
    if (!isWhole || std::rename(beside.c_str(), path.c_str()) != 0) fail("cannot write");
}

MeshCounts writeMeshes(const rubble::World& world, const std::vector<rubble_shape>& shapes, const std::string& path) {
    std::vector<Mesh> meshes;
    MeshCounts counts;
    for (const rubble_shape shape : shapes) {
        Mesh mesh = meshOf(world, shape);
        if (mesh.opaque.empty() && mesh.transparent.empty()) continue;
        counts.faces += (mesh.opaque.size() + mesh.transparent.size()) / 4;
        ++counts.shapes;
        meshes.push_back(std::move(mesh));
    }
    if (meshes.empty()) throw Refused("expected shapes with voxels, found none");
    if (rubble::script::hasEnding(path, ".obj")) return writeFile(path, objOf(meshes)), counts;
    GlbWriter writer;
    for (const Mesh& mesh : meshes) writer.add(mesh);
    writeFile(path, writer.bytes());
    return counts;
}

}  // namespace editor
