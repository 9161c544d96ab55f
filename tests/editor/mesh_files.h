#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace editor {

/// A mesh that a test makes: its faces have three or four corners, counter-clockwise from outside.
struct TestMesh {
    std::vector<glm::dvec3> points;
    std::vector<std::vector<int>> faces;
    std::vector<glm::dvec2> places;  ///< in the texture, v up, by point; may be empty
};

/// A surface point(u, v), u and v from 0 to 1, of so many quads each way, whose ends meet.
template <class F>
TestMesh closedSurface(int us, int vs, F point) {
    TestMesh mesh;
    for (int u = 0; u < us; ++u)
        for (int v = 0; v < vs; ++v) mesh.points.push_back(point(double(u) / us, double(v) / vs));
    const auto at = [&](int u, int v) { return u % us * vs + v % vs; };
    for (int u = 0; u < us; ++u)
        for (int v = 0; v < vs; ++v) mesh.faces.push_back({at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1)});
    return mesh;
}
/// A line (radius, height) that goes from the axis to the axis, turned about y.
TestMesh turned(const std::vector<glm::dvec2>& line, int segments);
/// A tube about a closed line.
TestMesh tube(const std::vector<glm::dvec3>& line, double radius, int segments);
/// A cube about the origin, turned about two axes; each face shows the whole texture.
TestMesh cube(double side, glm::dvec2 turn);

/// As a .obj file; head: lines before, as "mtllib ...".
void writeObj(const std::string& path, const TestMesh& mesh, const std::string& head = "");
/// As a binary .ply file of triangles and quads, with a colour for each point.
void writePly(const std::string& path, const TestMesh& mesh, const std::vector<std::array<unsigned char, 3>>& colors);
/// As a .glb file with a PNG texture inside, in a node that is scaled by 2.
void writeGlb(const std::string& path, const TestMesh& mesh, const std::string& png);
/// A .glb file of these two parts.
void writeGlbParts(const std::string& path, const std::string& json, const std::string& bytes);

}  // namespace editor
