#include "tests/reference/scene.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "runtime/core/hash.h"
#include "runtime/voxel/ray_walk.h"

namespace rubble::reference {
namespace {

constexpr int kShapesPerLeaf = 2;
constexpr int kMaxDepth = 64;

/// Colour of a painted voxel as in paintedColor() of shaders/lib/paint.glsl, sRGB in [0, 1].
glm::vec3 paintedSrgb(glm::vec3 own, const PaintColorsRef& colors, uint8_t paint) {
    if (!paint || !colors) return own;
    const Srgb& over = colors->colors[size_t(paintColor(paint) - 1)];
    return glm::mix(own, glm::vec3(over[0], over[1], over[2]) / 255.0f, float(paintSteps(paint)) / 16.0f);
}

/// As transmittance() in shaders/lib/glass_walk.glsl.
glm::vec3 glassTransmittance(const PaletteEntry& e) {
    const glm::vec3 color = glm::pow(glm::vec3(e.red, e.green, e.blue) / 255.0f, glm::vec3(2.2f));
    const glm::vec3 hue = color / std::max(std::max(color.r, color.g), std::max(color.b, 0.01f));
    return (1.0f - float(e.opacity) / 255.0f) * glm::mix(glm::vec3(1.0f), hue, 0.7f);
}

bool rayHitsBox(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& origin, const glm::dvec3& inverse,
                double tMax) {
    const glm::dvec3 a = (low - origin) * inverse, b = (high - origin) * inverse;
    const glm::dvec3 enter = glm::min(a, b), leave = glm::max(a, b);
    const double first = std::max(std::max(enter.x, enter.y), std::max(enter.z, 0.0));
    return first <= std::min(std::min(leave.x, leave.y), std::min(leave.z, tMax));
}

/// Hashes value by value, as structs may have padding.
void add(uint64_t& hash, double value) {
    hash = hashValue(value, hash);
}
void add(uint64_t& hash, glm::dvec3 v) {
    add(hash, v.x), add(hash, v.y), add(hash, v.z);
}

}  // namespace

glm::vec3 linear(glm::vec3 srgb) {
    const auto channel = [](float c) { return c < 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
    return {channel(srgb.x), channel(srgb.y), channel(srgb.z)};
}

Scene::Scene(const FrameSnapshot& snapshot) : m_lights(snapshot.lights), m_environment(snapshot.environment) {
    assert(snapshot.replacesAll);
    std::map<uint32_t, Pose> poses;
    for (const SnapshotPose& pose : snapshot.poses) poses[pose.shape.slot()] = pose.current;
    for (const SnapshotShape& given : snapshot.created) {
        Shape shape{VoxelGrid(given.size),
                    poses[given.shape.slot()],
                    double(given.voxelSize),
                    given.paintColors,
                    paletteIndex(given.palette),
                    {},
                    {}};
        for (const BrickChange& brick : given.bricks) shape.grid.setBrick(brick.brick, brick.content);
        shape.low = glm::dvec3(1e30), shape.high = glm::dvec3(-1e30);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 local =
                glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * glm::dvec3(given.size) * shape.voxelSize;
            shape.low = glm::min(shape.low, shape.pose.transformPoint(local) - 1e-6);
            shape.high = glm::max(shape.high, shape.pose.transformPoint(local) + 1e-6);
        }
        m_hash = hashValue(shape.grid.contentHash(), m_hash);
        m_hash = hashValue(hashPalette(*given.palette), m_hash);
        add(m_hash, shape.pose.position), add(m_hash, shape.pose.rotation.w),
            add(m_hash, {shape.pose.rotation.x, shape.pose.rotation.y, shape.pose.rotation.z});
        m_shapes.push_back(std::move(shape));
    }
    const Environment& e = m_environment;
    for (const glm::vec3& v : {e.sunDirection, e.sunColor, e.skyColor, e.horizonColor, e.groundColor, e.fogColor})
        add(m_hash, glm::dvec3(v));
    add(m_hash, {e.sunAngle, e.fogDistance, 0.0});
    for (const SnapshotLight& light : m_lights) {
        add(m_hash, light.position), add(m_hash, glm::dvec3(light.direction)), add(m_hash, glm::dvec3(light.color));
        add(m_hash, {light.radius, light.reach, light.coneInner}),
            add(m_hash, {light.coneOuter, double(light.kind), double(light.twoSided)});
        add(m_hash, glm::dvec3(light.right)), add(m_hash, {light.width, light.height, double(light.image.width)});
        for (const uint32_t texel : light.image.texels) m_hash = hashValue(texel, m_hash);
    }
    m_nodes.push_back({});
    build(0, 0, int(m_shapes.size()));
}

size_t Scene::paletteIndex(const PaletteRef& palette) {
    for (size_t i = 0; i < m_palettes.size(); ++i)
        if (m_palettes[i].key == palette) return i;
    PaletteTable table{palette, {}, {}, {}, false};
    for (size_t i = 1; i < 256; ++i) {
        const PaletteEntry& e = (*palette)[i];
        table.entries[i] = {linear(glm::vec3(e.red, e.green, e.blue) / 255.0f),
                            glassTransmittance(e),
                            e.emission,
                            float(e.roughness) / 255.0f,
                            float(e.metallic) / 255.0f,
                            float(e.reflectivity) / 255.0f,
                            e.lightGroup != 0};
        table.opaque[i] = e.opacity == 255;
        table.glass[i] = e.opacity < 255;
        table.hasGlass |= e.material != 0 && table.glass[i];
    }
    m_hasGlass |= table.hasGlass;
    m_palettes.push_back(table);
    return m_palettes.size() - 1;
}

/// A bounding volume hierarchy: splits the shapes at the median along the widest axis.
void Scene::build(int node, int first, int count) {
    glm::dvec3 low(1e30), high(-1e30);
    for (int i = first; i < first + count; ++i)
        low = glm::min(low, m_shapes[size_t(i)].low), high = glm::max(high, m_shapes[size_t(i)].high);
    m_nodes[size_t(node)] = {low, high, first, count};
    if (count <= kShapesPerLeaf) return;
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = m_shapes.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](const Shape& a, const Shape& b) {
        return a.low[axis] + a.high[axis] < b.low[axis] + b.high[axis];
    });
    const int child = int(m_nodes.size());
    m_nodes.resize(m_nodes.size() + 2);
    m_nodes[size_t(node)].first = child;
    m_nodes[size_t(node)].count = 0;
    build(child, first, count / 2);
    build(child + 1, first + count / 2, count - count / 2);
}

/// Calls f(shape) for each shape whose box the ray hits before tMax, which f may lower. f returns false to stop.
template <class F>
void Scene::forEachShapeOnRay(const Ray& ray, const double& tMax, F&& f) const {
    // An infinite inverse times 0 would be NaN: such a ray is tilted a little off the axis.
    glm::dvec3 inverse;
    for (int a = 0; a < 3; ++a) inverse[a] = 1.0 / (std::abs(ray.direction[a]) < 1e-18 ? 1e-18 : ray.direction[a]);
    int stack[kMaxDepth], depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = m_nodes[size_t(stack[--depth])];
        if (!rayHitsBox(node.low, node.high, ray.origin, inverse, tMax)) continue;
        if (node.count == 0 && !m_shapes.empty()) {
            stack[depth++] = node.first;
            stack[depth++] = node.first + 1;
            continue;
        }
        for (int i = node.first; i < node.first + node.count; ++i) {
            const Shape& shape = m_shapes[size_t(i)];
            if (rayHitsBox(shape.low, shape.high, ray.origin, inverse, tMax) && !f(shape)) return;
        }
    }
}

namespace {

/// A world ray in a shape's cells; t stays in metres.
CellRay cellRay(const Pose& pose, double voxelSize, const Ray& ray, double tMax) {
    return {pose.inversePoint(ray.origin) / voxelSize, glm::conjugate(pose.rotation) * ray.direction / voxelSize, tMax};
}

glm::dvec3 normalOf(const Pose& pose, const CellHit& hit, glm::dvec3 direction) {
    if (hit.axis < 0) return -direction;
    glm::dvec3 local(0.0);
    local[hit.axis] = hit.sign;
    return pose.rotation * local;
}

}  // namespace

glm::vec3 Scene::colorAt(const Shape& shape, const PaletteTable& table, glm::ivec3 cell) const {
    const Brick* brick = shape.grid.brickAt(brickOfCell(cell));
    const int index = brick->at(cellInBrick(cell));
    const uint8_t paint = shape.paint ? brick->paintAt(voxelIndex(cellInBrick(cell))) : uint8_t(0);
    if (!paint) return table.entries[size_t(index)].albedo;
    const PaletteEntry& e = (*table.key)[size_t(index)];
    return linear(paintedSrgb(glm::vec3(e.red, e.green, e.blue) / 255.0f, shape.paint, paint));
}

Surface Scene::closest(const Ray& ray) const {
    Surface s;
    CellHit nearest;
    const Shape* found = nullptr;
    double tMax = ray.tMax;
    forEachShapeOnRay(ray, tMax, [&](const Shape& shape) {
        const CellHit hit =
            walkRay(shape.grid, cellRay(shape.pose, shape.voxelSize, ray, tMax), &m_palettes[shape.palette].opaque);
        if (hit.hit && (hit.t < tMax || !found)) tMax = hit.t, nearest = hit, found = &shape;
        return true;
    });
    if (!found) return s;
    const PaletteTable& table = m_palettes[found->palette];
    const Entry& entry = table.entries[found->grid.at(nearest.cell)];
    s.hit = true;
    s.t = nearest.t;
    s.position = ray.origin + ray.direction * nearest.t;
    s.normal = normalOf(found->pose, nearest, ray.direction);
    s.albedo = colorAt(*found, table, nearest.cell);
    s.emission = entry.emission, s.roughness = entry.roughness, s.metallic = entry.metallic,
    s.reflectivity = entry.reflectivity;
    s.hasLight = entry.hasLight;
    return s;
}

/// Neighbouring cells of glass are one pane, tinted by the first cell (shaders/lib/glass_walk.glsl).
void Scene::addPanes(const Shape& shape, const Ray& ray, Panes& panes) const {
    const PaletteTable& table = m_palettes[shape.palette];
    CellRay cells = cellRay(shape.pose, shape.voxelSize, ray, ray.tMax);
    const glm::dvec3 origin = cells.origin;
    for (double passed = 0.0; passed < ray.tMax;) {
        cells.origin = origin + cells.direction * passed;
        cells.tMax = ray.tMax - passed;
        const CellHit hit = walkRay(shape.grid, cells, &table.glass);
        if (!hit.hit) return;
        panes.tint *= table.entries[shape.grid.at(hit.cell)].glassTint;
        const double t = passed + hit.t;
        if (!panes.any || t < panes.t)
            panes = {true, t, ray.origin + ray.direction * t, normalOf(shape.pose, hit, ray.direction), panes.tint};
        double leave = t;
        for (glm::ivec3 cell = hit.cell; table.glass[shape.grid.at(cell)];) {
            int axis = 0;
            double exit[3];
            for (int a = 0; a < 3; ++a) {
                const double d = cells.direction[a];
                exit[a] = d == 0.0 ? 1e30 : (double(cell[a] + (d > 0.0)) - origin[a]) / d;
                if (exit[a] < exit[axis]) axis = a;
            }
            leave = exit[axis];
            cell[axis] += cells.direction[axis] > 0.0 ? 1 : -1;
        }
        passed = leave + 1e-7;
    }
}

Panes Scene::panes(const Ray& ray) const {
    Panes panes;
    if (!m_hasGlass) return panes;
    forEachShapeOnRay(ray, ray.tMax, [&](const Shape& shape) {
        if (m_palettes[shape.palette].hasGlass) addPanes(shape, ray, panes);
        return true;
    });
    return panes;
}

glm::vec3 Scene::transmittance(const Ray& ray) const {
    bool hit = false;
    forEachShapeOnRay(ray, ray.tMax, [&](const Shape& shape) {
        hit =
            walkRay(shape.grid, cellRay(shape.pose, shape.voxelSize, ray, ray.tMax), &m_palettes[shape.palette].opaque)
                .hit;
        return !hit;
    });
    return hit ? glm::vec3(0.0f) : panes(ray).tint;
}

}  // namespace rubble::reference
