// The icons of buttons and of the tree, drawn by lines within a unit square.
#include <cmath>

#include "editor/ui/panels/widgets.h"

namespace editor {
namespace {

/// Draws in a unit square, y down.
struct Pen {
    ImDrawList& list;
    ImVec2 low;
    float side;
    ImU32 color;
    float width;

    ImVec2 at(float x, float y) const { return {low.x + x * side, low.y + y * side}; }
    void path(std::initializer_list<ImVec2> points, bool isClosed = false) const {
        for (const ImVec2 p : points) list.PathLineTo(at(p.x, p.y));
        list.PathStroke(color, isClosed ? ImDrawFlags_Closed : 0, width);
    }
    void area(std::initializer_list<ImVec2> points) const {
        for (const ImVec2 p : points) list.PathLineTo(at(p.x, p.y));
        list.PathFillConvex(color);
    }
    void circle(float x, float y, float radius) const { list.AddCircle(at(x, y), radius * side, color, 24, width); }
    void disc(float x, float y, float radius) const { list.AddCircleFilled(at(x, y), radius * side, color, 20); }
    void arc(float x, float y, float radius, float from, float to) const {
        list.PathArcTo(at(x, y), radius * side, from, to, 20);
        list.PathStroke(color, 0, width);
    }
    void cube(float x, float y, float half) const {
        const float h = half, q = half * 0.5f;
        path({{x, y - h}, {x + h, y - q}, {x + h, y + q}, {x, y + h}, {x - h, y + q}, {x - h, y - q}}, true);
        path({{x - h, y - q}, {x, y}, {x + h, y - q}});
        path({{x, y}, {x, y + h}});
    }
};

void drawTool(const Pen& pen, Icon icon) {
    switch (icon) {
        case Icon::Select:
            return pen.area({{0.25f, 0.12f}, {0.78f, 0.56f}, {0.5f, 0.6f}, {0.32f, 0.84f}});
        case Icon::Move:
            pen.path({{0.5f, 0.1f}, {0.5f, 0.9f}});
            pen.path({{0.1f, 0.5f}, {0.9f, 0.5f}});
            pen.path({{0.38f, 0.22f}, {0.5f, 0.1f}, {0.62f, 0.22f}});
            pen.path({{0.38f, 0.78f}, {0.5f, 0.9f}, {0.62f, 0.78f}});
            pen.path({{0.22f, 0.38f}, {0.1f, 0.5f}, {0.22f, 0.62f}});
            return pen.path({{0.78f, 0.38f}, {0.9f, 0.5f}, {0.78f, 0.62f}});
        case Icon::Rotate:
            pen.arc(0.5f, 0.52f, 0.34f, -1.0f, 3.9f);
            return pen.area({{0.56f, 0.06f}, {0.86f, 0.22f}, {0.58f, 0.38f}});
        case Icon::Scale:
            pen.path({{0.14f, 0.52f}, {0.48f, 0.52f}, {0.48f, 0.86f}, {0.14f, 0.86f}}, true);
            pen.path({{0.52f, 0.48f}, {0.86f, 0.14f}});
            return pen.path({{0.58f, 0.14f}, {0.86f, 0.14f}, {0.86f, 0.42f}});
        case Icon::Brush:
            pen.path({{0.86f, 0.12f}, {0.46f, 0.54f}});
            pen.path({{0.9f, 0.2f}, {0.54f, 0.6f}});
            return pen.area(
                {{0.5f, 0.52f}, {0.52f, 0.7f}, {0.36f, 0.84f}, {0.1f, 0.88f}, {0.26f, 0.74f}, {0.34f, 0.56f}});
        case Icon::Break:
            for (int i = 0; i < 8; ++i) {
                const float c = std::cos(float(i) * 0.7854f), s = std::sin(float(i) * 0.7854f);
                const float far = i % 2 ? 0.34f : 0.44f;
                pen.path({{0.5f + 0.2f * c, 0.5f + 0.2f * s}, {0.5f + far * c, 0.5f + far * s}});
            }
            return pen.disc(0.5f, 0.5f, 0.1f);
        case Icon::Undo:
            pen.arc(0.52f, 0.58f, 0.28f, -2.6f, 1.3f);
            return pen.area({{0.08f, 0.44f}, {0.4f, 0.22f}, {0.42f, 0.58f}});
        case Icon::Redo:
            pen.arc(0.48f, 0.58f, 0.28f, 1.84f, 5.74f);
            return pen.area({{0.92f, 0.44f}, {0.6f, 0.22f}, {0.58f, 0.58f}});
        case Icon::Search:
            pen.circle(0.43f, 0.43f, 0.26f);
            return pen.path({{0.62f, 0.62f}, {0.86f, 0.86f}});
        case Icon::Open:
            pen.path({{0.1f, 0.8f}, {0.1f, 0.24f}, {0.38f, 0.24f}, {0.46f, 0.36f}, {0.82f, 0.36f}, {0.82f, 0.46f}});
            return pen.path({{0.1f, 0.8f}, {0.26f, 0.46f}, {0.94f, 0.46f}, {0.8f, 0.8f}}, true);
        case Icon::Save:
            pen.path({{0.16f, 0.16f}, {0.7f, 0.16f}, {0.84f, 0.3f}, {0.84f, 0.84f}, {0.16f, 0.84f}}, true);
            pen.path({{0.34f, 0.16f}, {0.34f, 0.38f}, {0.62f, 0.38f}, {0.62f, 0.16f}});
            return pen.path({{0.3f, 0.84f}, {0.3f, 0.58f}, {0.7f, 0.58f}, {0.7f, 0.84f}});
        default:
            return;
    }
}

void drawPlay(const Pen& pen, Icon icon) {
    switch (icon) {
        case Icon::Play:
            return pen.area({{0.26f, 0.14f}, {0.84f, 0.5f}, {0.26f, 0.86f}});
        case Icon::Pause:
            pen.area({{0.24f, 0.16f}, {0.42f, 0.16f}, {0.42f, 0.84f}, {0.24f, 0.84f}});
            return pen.area({{0.58f, 0.16f}, {0.76f, 0.16f}, {0.76f, 0.84f}, {0.58f, 0.84f}});
        case Icon::Step:
            pen.area({{0.2f, 0.16f}, {0.64f, 0.5f}, {0.2f, 0.84f}});
            return pen.area({{0.68f, 0.16f}, {0.82f, 0.16f}, {0.82f, 0.84f}, {0.68f, 0.84f}});
        case Icon::Stop:
            return pen.area({{0.2f, 0.2f}, {0.8f, 0.2f}, {0.8f, 0.8f}, {0.2f, 0.8f}});
        case Icon::Rewind:
            pen.area({{0.5f, 0.18f}, {0.5f, 0.82f}, {0.08f, 0.5f}});
            return pen.area({{0.9f, 0.18f}, {0.9f, 0.82f}, {0.48f, 0.5f}});
        case Icon::Keep:
            pen.path({{0.5f, 0.1f}, {0.5f, 0.56f}});
            pen.path({{0.3f, 0.38f}, {0.5f, 0.58f}, {0.7f, 0.38f}});
            return pen.path({{0.14f, 0.6f}, {0.14f, 0.86f}, {0.86f, 0.86f}, {0.86f, 0.6f}});
        default:
            return;
    }
}

void drawForm(const Pen& pen, Icon icon) {
    switch (icon) {
        case Icon::Voxel:
            return pen.cube(0.5f, 0.5f, 0.24f);
        case Icon::Box:
        case Icon::Shape:
            return pen.cube(0.5f, 0.5f, 0.42f);
        case Icon::Sphere:
            pen.circle(0.5f, 0.5f, 0.38f);
            return pen.arc(0.5f, 0.3f, 0.46f, 0.7f, 2.44f);
        case Icon::Line:
            pen.path({{0.18f, 0.82f}, {0.82f, 0.18f}});
            pen.disc(0.18f, 0.82f, 0.1f);
            return pen.disc(0.82f, 0.18f, 0.1f);
        case Icon::Face:
            pen.area({{0.5f, 0.14f}, {0.9f, 0.34f}, {0.5f, 0.54f}, {0.1f, 0.34f}});
            return pen.path({{0.1f, 0.34f}, {0.1f, 0.66f}, {0.5f, 0.88f}, {0.9f, 0.66f}, {0.9f, 0.34f}});
        case Icon::Flood:
            pen.path({{0.16f, 0.46f}, {0.48f, 0.14f}, {0.82f, 0.48f}, {0.5f, 0.8f}}, true);
            pen.path({{0.2f, 0.48f}, {0.78f, 0.48f}});
            return pen.disc(0.88f, 0.74f, 0.09f);
        case Icon::Body:
            pen.cube(0.36f, 0.4f, 0.28f);
            return pen.cube(0.68f, 0.66f, 0.24f);
        default:
            return;
    }
}

void drawObject(const Pen& pen, Icon icon) {
    switch (icon) {
        case Icon::Light:
            pen.circle(0.5f, 0.42f, 0.26f);
            pen.path({{0.4f, 0.76f}, {0.6f, 0.76f}});
            return pen.path({{0.42f, 0.88f}, {0.58f, 0.88f}});
        case Icon::Joint:
            pen.circle(0.26f, 0.5f, 0.16f);
            pen.circle(0.74f, 0.5f, 0.16f);
            return pen.path({{0.42f, 0.5f}, {0.58f, 0.5f}});
        case Icon::Water:
            for (const float y : {0.36f, 0.6f})
                pen.path({{0.1f, y}, {0.26f, y - 0.1f}, {0.42f, y}, {0.58f, y + 0.1f}, {0.74f, y}, {0.9f, y - 0.1f}});
            return;
        case Icon::Trigger:
            for (const float x : {0.14f, 0.86f})
                for (const float y : {0.14f, 0.86f}) {
                    const float dx = x < 0.5f ? 0.22f : -0.22f, dy = y < 0.5f ? 0.22f : -0.22f;
                    pen.path({{x + dx, y}, {x, y}, {x, y + dy}});
                }
            return;
        case Icon::Layer:
            for (const float y : {0.2f, 0.4f, 0.6f})
                pen.path({{0.1f, y + 0.1f}, {0.5f, y - 0.08f}, {0.9f, y + 0.1f}, {0.5f, y + 0.28f}}, y < 0.3f);
            return;
        case Icon::Shown:
            pen.path({{0.06f, 0.5f}, {0.28f, 0.3f}, {0.5f, 0.24f}, {0.72f, 0.3f}, {0.94f, 0.5f}});
            pen.path({{0.06f, 0.5f}, {0.28f, 0.7f}, {0.5f, 0.76f}, {0.72f, 0.7f}, {0.94f, 0.5f}});
            return pen.disc(0.5f, 0.5f, 0.13f);
        case Icon::Hidden:
            pen.path({{0.06f, 0.44f}, {0.28f, 0.62f}, {0.5f, 0.68f}, {0.72f, 0.62f}, {0.94f, 0.44f}});
            pen.path({{0.26f, 0.62f}, {0.18f, 0.78f}});
            pen.path({{0.5f, 0.68f}, {0.5f, 0.86f}});
            return pen.path({{0.74f, 0.62f}, {0.82f, 0.78f}});
        case Icon::Group:
            pen.circle(0.34f, 0.42f, 0.2f);
            return pen.circle(0.62f, 0.58f, 0.2f);
        default:
            return;
    }
}

}  // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 low, float side, ImU32 color) {
    const Pen pen{list, {std::round(low.x), std::round(low.y)}, side, color, std::max(1.4f, side / 12.0f)};
    drawTool(pen, icon);
    drawPlay(pen, icon);
    drawForm(pen, icon);
    drawObject(pen, icon);
}

}  // namespace editor
