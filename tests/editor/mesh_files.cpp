#include "tests/editor/mesh_files.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>

namespace editor {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

template <class T>
void put(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string padded(std::string bytes, char with) {
    while (bytes.size() % 4 != 0) bytes += with;
    return bytes;
}

std::string chunk(uint32_t kind, const std::string& bytes) {
    std::string out;
    put(out, uint32_t(bytes.size()));
    put(out, kind);
    return out + bytes;
}

}  // namespace

TestMesh turned(const std::vector<glm::dvec2>& line, int segments) {
    TestMesh mesh;
    const int rings = int(line.size()) - 2;
    for (int r = 1; r <= rings; ++r)
        for (int s = 0; s < segments; ++s) {
            const double angle = kTurn * s / segments;
            mesh.points.emplace_back(line[size_t(r)].x * std::cos(angle), line[size_t(r)].y,
                                     line[size_t(r)].x * std::sin(angle));
        }
    const int first = int(mesh.points.size()), last = first + 1;
    mesh.points.emplace_back(0.0, line.front().y, 0.0);
    mesh.points.emplace_back(0.0, line.back().y, 0.0);
    for (int s = 0; s < segments; ++s) {
        const int next = (s + 1) % segments, top = (rings - 1) * segments;
        mesh.faces.push_back({first, s, next});
        for (int r = 0; r + 1 < rings; ++r)
            mesh.faces.push_back(
                {r * segments + s, (r + 1) * segments + s, (r + 1) * segments + next, r * segments + next});
        mesh.faces.push_back({last, top + next, top + s});
    }
    return mesh;
}

TestMesh tube(const std::vector<glm::dvec3>& line, double radius, int segments) {
    const int count = int(line.size());
    return closedSurface(count, segments, [&](double u, double v) {
        const int i = int(std::lround(u * count));
        const auto at = [&](int k) { return line[size_t((k + count) % count)]; };
        const glm::dvec3 along = glm::normalize(at(i + 1) - at(i - 1));
        const glm::dvec3 side = glm::normalize(glm::cross(along, glm::dvec3(0.0, 0.0, 1.0)));
        return at(i) + radius * (std::cos(kTurn * v) * side + std::sin(kTurn * v) * glm::cross(along, side));
    });
}

TestMesh cube(double side, glm::dvec2 turn) {
    const double cx = std::cos(turn.x), sx = std::sin(turn.x), cy = std::cos(turn.y), sy = std::sin(turn.y);
    TestMesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            std::vector<int> face;
            for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                glm::dvec3 at;
                at[axis] = sign * side / 2;
                at[(axis + 1) % 3] = (a - 0.5) * side;
                at[(axis + 2) % 3] = (b - 0.5) * side;
                at = {at.x, cx * at.y - sx * at.z, sx * at.y + cx * at.z};
                at = {cy * at.x + sy * at.z, at.y, cy * at.z - sy * at.x};
                face.push_back(int(mesh.points.size()));
                mesh.points.push_back(at);
                mesh.places.emplace_back(a, b);
            }
            if (sign < 0) std::swap(face[1], face[3]);
            mesh.faces.push_back(face);
        }
    return mesh;
}

void writeObj(const std::string& path, const TestMesh& mesh, const std::string& head) {
    std::ofstream out(path);
    out << head;
    for (const glm::dvec3& p : mesh.points) out << fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const glm::dvec2& p : mesh.places) out << fmt::format("vt {} {}\n", p.x, p.y);
    for (const std::vector<int>& face : mesh.faces) {
        out << "f";
        for (const int point : face)
            out << (mesh.places.empty() ? fmt::format(" {}", point + 1) : fmt::format(" {0}/{0}", point + 1));
        out << "\n";
    }
}

void writePly(const std::string& path, const TestMesh& mesh, const std::vector<std::array<unsigned char, 3>>& colors) {
    std::string out = fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float "
        "z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face {}\n"
        "property list uchar int vertex_indices\nend_header\n",
        mesh.points.size(), mesh.faces.size());
    for (size_t i = 0; i < mesh.points.size(); ++i) {
        for (int a = 0; a < 3; ++a) put(out, float(mesh.points[i][a]));
        for (const unsigned char byte : colors[i]) put(out, byte);
    }
    for (const std::vector<int>& face : mesh.faces) {
        put(out, uint8_t(face.size()));
        for (const int point : face) put(out, int32_t(point));
    }
    std::ofstream(path, std::ios::binary) << out;
}

void writeGlb(const std::string& path, const TestMesh& mesh, const std::string& png) {
    std::string points, places, indices;
    for (const glm::dvec3& p : mesh.points)
        for (int a = 0; a < 3; ++a) put(points, float(p[a]));
    for (const glm::dvec2& p : mesh.places) put(places, float(p.x)), put(places, float(1.0 - p.y));
    for (const std::vector<int>& face : mesh.faces)
        for (size_t i = 2; i < face.size(); ++i)
            for (const int point : {face[0], face[i - 1], face[i]}) put(indices, uint32_t(point));
    const std::string bytes = padded(points + places + indices + png, '\0');
    const size_t placesAt = points.size(), indicesAt = placesAt + places.size(), pngAt = indicesAt + indices.size();
    const std::string json = fmt::format(
        R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0,"scale":[2,2,2]}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"TEXCOORD_0":1}},"indices":2,"material":0}}]}}],
"materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}}}}}}],"textures":[{{"source":0}}],
"images":[{{"bufferView":3,"mimeType":"image/png"}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":{0},"type":"VEC3","min":[-9,-9,-9],"max":[9,9,9]}},
{{"bufferView":1,"componentType":5126,"count":{0},"type":"VEC2"}},
{{"bufferView":2,"componentType":5125,"count":{1},"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":{2}}},{{"buffer":0,"byteOffset":{2},"byteLength":{3}}},
{{"buffer":0,"byteOffset":{4},"byteLength":{5}}},{{"buffer":0,"byteOffset":{6},"byteLength":{7}}}],
"buffers":[{{"byteLength":{8}}}]}})",
        mesh.points.size(), indices.size() / 4, placesAt, places.size(), indicesAt, indices.size(), pngAt, png.size(),
        bytes.size());
    writeGlbParts(path, json, bytes);
}

void writeGlbParts(const std::string& path, const std::string& json, const std::string& bytes) {
    const std::string body = chunk(0x4E4F534A, padded(json, ' ')) + chunk(0x004E4942, bytes);
    std::string out;
    put(out, uint32_t(0x46546C67));
    put(out, uint32_t(2));
    put(out, uint32_t(body.size() + 12));
    std::ofstream(path, std::ios::binary) << out << body;
}

}  // namespace editor
