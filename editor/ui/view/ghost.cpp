#include "editor/ui/view/ghost.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "editor/core/cells.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

constexpr int kFaceReach = 24;  ///< cells around the mouse of which the ghost of a face is made

struct Ghost {
    Wires& wires;
    const rubble_shape_state& shape;
    ImU32 line, fill;

    void box(glm::ivec3 a, glm::ivec3 b) const {
        const Cells cells = between(a, b);
        wires.cells(shape, glm::dvec3(cells.low) - 0.02, glm::dvec3(cells.size) + 0.04, line, fill, 2.0f);
    }

    void ball(glm::ivec3 cell, double radius) const {
        const glm::dvec3 middle = glm::dvec3(cell) + 0.5;
        for (int a = 0; a < 3; ++a) {
            glm::dvec3 u(0.0), v(0.0);
            u[(a + 1) % 3] = v[(a + 2) % 3] = radius + 0.5;
            const glm::dvec3 center = worldOf(shape, middle);
            wires.ring(center, worldOf(shape, middle + u) - center, worldOf(shape, middle + v) - center, line, 2.0f);
        }
    }

    void capsule(glm::ivec3 from, glm::ivec3 to, double radius) const {
        wires.line(worldOf(shape, glm::dvec3(from) + 0.5), worldOf(shape, glm::dvec3(to) + 0.5), line, 2.0f);
        if (radius < 1.0) return box(from, from), box(to, to);
        ball(from, radius);
        ball(to, radius);
    }
};

/// The cells of a face of one entry around a cell, as the command `face` finds them, within some reach.
std::vector<glm::ivec3> faceCells(const rubble::World& world, const Stroke& stroke) {
    Cells box{stroke.from - kFaceReach, glm::ivec3(2 * kFaceReach + 1)};
    box.low[stroke.axis] = stroke.from[stroke.axis] + std::min(stroke.side, 0), box.size[stroke.axis] = 2;
    const std::vector<uint8_t> voxels = readCells(world, stroke.shape, box);
    CellSet seen{stroke.shape, box.low, box.size, std::vector<uint8_t>(voxels.size())};
    glm::ivec3 out(0);
    out[stroke.axis] = stroke.side;
    std::vector<glm::ivec3> found{stroke.from};
    seen.mask[seen.at(stroke.from)] = 1;
    for (size_t i = 0; i < found.size(); ++i)
        for (int a = 0; a < 3; ++a)
            for (const int step : {-1, 1}) {
                glm::ivec3 next = found[i];
                next[a] += step;
                if (a == stroke.axis || !box.contains(next) || seen.mask[seen.at(next)]) continue;
                if (voxels[seen.at(next)] != voxels[seen.at(stroke.from)] || voxels[seen.at(next + out)]) continue;
                seen.mask[seen.at(next)] = 1;
                found.push_back(next);
            }
    return found;
}

void drawFaceGhost(const Ghost& ghost, const rubble::World& world, const Stroke& stroke) {
    for (const glm::ivec3 cell : faceCells(world, stroke)) {
        glm::dvec3 low(cell), u(0.0), v(0.0);
        low[stroke.axis] += stroke.side > 0 ? 1.03 : -0.03;
        u[(stroke.axis + 1) % 3] = v[(stroke.axis + 2) % 3] = 1.0;
        const auto at = [&](glm::dvec3 point) { return worldOf(ghost.shape, point); };
        ghost.wires.face({at(low), at(low + u), at(low + u + v), at(low + v)}, ghost.fill);
    }
    ghost.box(stroke.from, stroke.from);
}

}  // namespace

void drawGhost(Wires& wires, const rubble::World& world, const Brush& brush, const Stroke& stroke) {
    rubble_shape_state shape{};
    try {
        shape = world.get_shape_state(stroke.shape);
    } catch (const rubble::Error&) {
        return;
    }
    const bool erases = brush.operation == 1;
    const ImU32 line = erases ? theme::kError : theme::kAccent;
    const Ghost ghost{wires, shape, line, (line & 0x00ffffffu) | 0x38000000u};
    if (brush.form == Form::Face) return drawFaceGhost(ghost, world, stroke);
    const std::string_view axes = kMirrors[brush.mirror];
    for (unsigned some = 0; some < 8; ++some) {
        Stroke image = stroke;
        bool isMirrored = true;
        for (int a = 0; a < 3; ++a) {
            if (!(some >> a & 1)) continue;
            isMirrored = isMirrored && axes != "none" && axes.find("xyz"[a]) != axes.npos;
            image.from[a] = shape.size[a] - 1 - stroke.from[a];
            image.to[a] = shape.size[a] - 1 - stroke.to[a];
        }
        if (!isMirrored) continue;
        const bool isLine = brush.form == Form::Line || (stroke.from != stroke.to && brush.form != Form::Box);
        if (isLine)
            ghost.capsule(image.from, image.to, strokeRadius(brush));
        else if (brush.form == Form::Sphere)
            ghost.ball(image.from, brush.size);
        else
            ghost.box(image.from, image.to);
    }
}

}  // namespace editor
