#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace rubble {

inline constexpr size_t kMaxMeshTriangles = 20'000'000;

/// An image that a mesh is coloured by: sRGB, rows from above.
struct MeshTexture {
    glm::ivec2 size{0};
    std::vector<std::array<uint8_t, 4>> pixels;

    /// The linear colour at a place: (0, 0) is the upper left corner, (1, 1) the lower right; the image repeats.
    /// isSmooth: bilinear, else the nearest pixel.
    glm::vec3 at(glm::vec2 place, bool isSmooth) const;
};

/// What triangles of a mesh look like.
struct MeshMaterial {
    std::string name;
    glm::vec3 color{1.0f};  ///< linear; multiplied with the texture and the colours of corners
    int texture = -1;       ///< of Mesh::textures; -1: none
};

/// A triangle; its corners have a place in the texture and a linear colour.
struct MeshTriangle {
    std::array<uint32_t, 3> points;
    std::array<glm::vec2, 3> places;
    std::array<glm::vec3, 3> colors;
    uint32_t material;
};

/// Triangles in metres with y up. Points at the same place are one.
struct Mesh {
    std::vector<glm::dvec3> points;
    std::vector<MeshTriangle> triangles;
    std::vector<MeshMaterial> materials;
    std::vector<MeshTexture> textures;
    std::vector<std::string> notes;  ///< what was left out, for people

    /// The linear colour of a triangle at the weights of its corners, whose sum is 1.
    glm::vec3 colorOf(const MeshTriangle& triangle, glm::dvec3 weights, bool isSmooth) const;
    /// What coordinates lose that are read as floats, if that is more than a length in metres; else "".
    std::string lossNote(double length) const;
};

}  // namespace rubble
