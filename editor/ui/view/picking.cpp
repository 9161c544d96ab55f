#include "editor/ui/view/picking.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "editor/core/rotation.h"

namespace editor {
namespace {

constexpr double kReach = 2000.0;  ///< metres

bool fillsEmptyCells(const Brush& brush) {
    return brush.operation == 0 || brush.operation == 3;
}

bool coversFaces(Form form) {
    return form == Form::Face || form == Form::Flood;
}

}  // namespace

int strokeRadius(const Brush& brush) {
    if (brush.form == Form::Sphere) return brush.size;
    return brush.form == Form::Line ? brush.size - 1 : 0;
}

rubble_query_filter seenBy(const Session& session) {
    const std::vector<rubble_shape>& hidden = session.editor().view().hidden;
    rubble_query_filter filter{};
    filter.rejected_shapes = hidden.data();
    filter.rejected_shape_count = uint32_t(hidden.size());
    return filter;
}

rubble_ray rayAt(const ViewFrame& frame, ImVec2 at) {
    rubble_ray ray{};
    put(ray.origin, frame.camera.position());
    put(ray.direction, frame.direction(at));
    ray.max_distance = kReach;
    return ray;
}

std::optional<Hover> pick(Session& session, const ViewFrame& frame, ImVec2 at) {
    const rubble::World& world = session.world();
    const rubble_ray ray = rayAt(frame, at);
    Hover hover;
    hover.hit = world.cast_rays(&ray, 1, seenBy(session)).at(0);
    if (!hover.hit.hit || !hover.hit.shape) return std::nullopt;
    const rubble_shape_state shape = world.get_shape_state(hover.hit.shape);
    const glm::dvec3 normal = glm::inverse(quaternionOf(shape.rotation)) * vectorOf(hover.hit.normal);
    for (int a = 0; a < 3; ++a) {
        hover.cell[a] = hover.hit.cell[a];
        if (std::abs(normal[a]) > std::abs(normal[hover.axis])) hover.axis = a;
    }
    hover.side = normal[hover.axis] < 0.0 ? -1 : 1;
    return hover;
}

Stroke beginStroke(const Brush& brush, const Hover& hover) {
    Stroke stroke{hover.hit.shape, hover.cell, hover.cell, hover.axis, hover.side};
    if (fillsEmptyCells(brush) && !coversFaces(brush.form)) stroke.from[hover.axis] += hover.side;
    stroke.to = stroke.from;
    return stroke;
}

void followMouse(Stroke& stroke, const rubble::World& world, const ViewFrame& frame, ImVec2 at) {
    const rubble_shape_state shape = world.get_shape_state(stroke.shape);
    const glm::dquat inverse = glm::inverse(quaternionOf(shape.rotation));
    const glm::dvec3 eye = inverse * (frame.camera.position() - vectorOf(shape.position)) / shape.voxel_size;
    const glm::dvec3 direction = inverse * frame.direction(at);
    const double plane = stroke.from[stroke.axis] + 0.5;
    if (std::abs(direction[stroke.axis]) < 1e-6) return;
    const double t = (plane - eye[stroke.axis]) / direction[stroke.axis];
    if (t <= 0.0 || t * shape.voxel_size > kReach) return;
    glm::ivec3 cell(glm::floor(eye + direction * t));
    cell[stroke.axis] = stroke.from[stroke.axis];
    constexpr int kMaxLength = 512;
    stroke.to = glm::clamp(cell, stroke.from - kMaxLength, stroke.from + kMaxLength);
}

Line lineOf(const rubble::World& world, const Brush& brush, const Stroke& stroke) {
    Line line;
    const bool isDragged = stroke.from != stroke.to;
    const std::string size = std::to_string(brush.size);
    const auto add = [&](const char* name, const std::string& value) { line.given.push_back({name, value}); };
    Form form = brush.form;
    if (isDragged && (form == Form::Voxel || form == Form::Sphere)) form = Form::Line;
    line.command = kForms[int(form)];
    switch (form) {
        case Form::Voxel:
        case Form::Flood:
            add("cell", cellText(stroke.from));
            break;
        case Form::Box:
            add("from", cellText(stroke.from));
            add("to", cellText(stroke.to));
            break;
        case Form::Sphere:
            add("center", cellText(stroke.from));
            add("radius", size);
            break;
        case Form::Line:
            add("from", cellText(stroke.from));
            add("to", cellText(stroke.to));
            add("radius", std::to_string(strokeRadius(brush)));
            break;
        case Form::Face:
            add("cell", cellText(stroke.from));
            add("side", std::string(stroke.side < 0 ? "-" : "+") + "xyz"[stroke.axis]);
            add("depth", size);
            break;
    }
    add("do", kOperations[brush.operation]);
    if (brush.operation != 1) add("index", std::to_string(brush.index));
    if (brush.mirror) add("mirror", kMirrors[brush.mirror]);
    add("shape", referenceTo(world, stroke.shape));
    return line;
}

}  // namespace editor
