#include "physics/water/submersion.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

// The volume of voxels in a water, and its centroid.
//
// A water is a prism: its outline from the bottom to the surface. Bricks, layers and rows of voxels wholly in it are
// counted with popcount, in integers. A voxel that the surface or the bottom cuts is a unit cube below a plane, in
// cells: the points with n . x <= d, 0 <= x_i <= 1. With all n_i > 0 (else the cube is mirrored), its volume is the
// pyramid that the plane cuts from the corner at 0, less those that stick out beyond the other faces (inclusion and
// exclusion):
//     V(d) = 1 / (k! n_1 ... n_k) sum over subsets s of {1 .. k} of (-1)^|s| (d - sum of n_i in s)_+^k,
// where (t)_+ is max(t, 0) and k = 3 the number of dimensions. Its moment along x_i follows by parts: with F the same
// sum over the other n_j (still with the power k and 1 / k!), and G that with the power k + 1 and 1 / (k + 1)!,
//     M_i(d) = (G(d) - G(d - n_i)) / n_i^2 - F(d - n_i) / n_i.
// Axes along which the plane hardly rises are left out, and k is smaller. The bottom's part is taken from the
// surface's. A voxel that the outline may cut is divided into 4x4x4 cubes, each in or out by its middle.
//
// Where waters overlap, a place belongs to the first of them: of the others it is left out. So the height that a water
// has for itself is what the intervals of those before it leave of its own. Where these have all of a part within their
// outlines, it is one interval or several for the whole part, and they cost no more. Else their outlines cut voxels
// too.

namespace rubble {
namespace {

constexpr double kFlat = 1e-3;  ///< of the largest component of n: a smaller one is taken for 0
constexpr int kOutlineParts = 4;

/// The sum over subsets of n of (-1)^|s| (t - sum of s)_+^power / power!, divided by the product of n.
double pyramids(const double* n, int count, double t, int power) {
    double sum = 0.0;
    for (int subset = 0; subset < 1 << count; ++subset) {
        double rest = t;
        for (int i = 0; i < count; ++i)
            if (subset >> i & 1) rest -= n[i];
        if (rest <= 0.0) continue;
        double term = std::popcount(unsigned(subset)) % 2 ? -1.0 : 1.0;
        for (int i = 1; i <= power; ++i) term *= rest / i;
        sum += term;
    }
    for (int i = 0; i < count; ++i) sum /= n[i];
    return sum;
}

/// The number of voxels and the sums of their coordinates, in cells: exact in integers.
struct CellSums {
    int64_t count = 0, x = 0, y = 0, z = 0;

    /// Adds the voxels of one layer of a brick; base: of the layer's cell (0, 0).
    void add(uint64_t layer, glm::ivec3 base) {
        const int64_t n = std::popcount(layer);
        count += n;
        x += n * base.x + std::popcount(layer & 0xaaaaaaaaaaaaaaaaull) +
             2 * std::popcount(layer & 0xccccccccccccccccull) + 4 * std::popcount(layer & 0xf0f0f0f0f0f0f0f0ull);
        y += n * base.y + std::popcount(layer & 0xff00ff00ff00ff00ull) +
             2 * std::popcount(layer & 0xffff0000ffff0000ull) + 4 * std::popcount(layer & 0xffffffff00000000ull);
        z += n * base.z;
    }
};

enum class Place : uint8_t { In, Out, Cut };

double distanceToSegment(double x, double z, const GroundPoint& a, const GroundPoint& b) {
    const double dx = b.x - a.x, dz = b.z - a.z, length2 = dx * dx + dz * dz;
    const double t = length2 > 0.0 ? std::clamp(((x - a.x) * dx + (z - a.z) * dz) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(a.x + dx * t - x, a.z + dz * t - z);
}

/// Heights of a water, metres.
struct Interval {
    double top = 0.0, depth = 0.0;
};

/// Sums up what of one part is in one water, or in an interval of its height.
class PartSubmersion {
public:
    PartSubmersion(const CellTransform& cells, glm::dvec3 origin, const Water& water, Interval height, Waters before)
        : m_cells(cells),
          m_water(water),
          m_height(height),
          m_before(before),
          m_corner(origin + cells.corner),
          m_rise(cells.axes[0].y, cells.axes[1].y, cells.axes[2].y),
          m_half(0.5 * (std::abs(m_rise.x) + std::abs(m_rise.y) + std::abs(m_rise.z))) {}

    /// Where a box of cells is.
    Place placeOf(glm::dvec3 low, glm::dvec3 size) const {
        Place place = heightPlace(m_height, low, size);
        if (place == Place::Out) return place;
        if (!m_isWithin)
            if (const Place sideways = outlinePlace(m_water, low, size); sideways != Place::In) place = sideways;
        for (const Water* other : m_before) {
            const Place vertical = heightPlace({other->surface, other->depth}, low, size),
                        sideways = vertical == Place::Out ? vertical : outlinePlace(*other, low, size);
            if (vertical == Place::In && sideways == Place::In) return Place::Out;
            if (sideways != Place::Out && place == Place::In) place = Place::Cut;
        }
        return place;
    }
    /// Notes whether a box of cells is within the outline; then nothing in it need be tested against that.
    bool noteOutline(glm::dvec3 low, glm::dvec3 size) {
        return m_isWithin = outlinePlace(m_water, low, size) == Place::In;
    }
    /// place: of all the brick's cells. base: the brick's first cell.
    void addBrick(glm::ivec3 base, const Brick& brick, Place place) {
        for (int z = 0; z < 8; ++z) {
            const uint64_t layer = brick.occupancy[size_t(z)];
            if (!layer) continue;
            const glm::ivec3 at = base + glm::ivec3(0, 0, z);
            if (place == Place::In)
                m_whole.add(layer, at);
            else
                addLayer(at, layer);
        }
    }
    /// Adds the sums in world units.
    void addTo(double voxelVolume, Submersion& sum) const {
        const double n = double(m_whole.count);
        const glm::dvec3 cells =
            glm::dvec3(double(m_whole.x), double(m_whole.y), double(m_whole.z)) + 0.5 * n + m_cutMoment;
        sum.volume += (n + m_cut) * voxelVolume;
        sum.waterline += m_cutVoxels * voxelVolume / (2.0 * m_half);
        sum.moment += (m_cells.axes * cells + m_cells.corner * (n + m_cut)) * voxelVolume;
    }

    /// Where it is beside an interval of heights.
    Place heightPlace(Interval height, glm::dvec3 low, glm::dvec3 size) const {
        const double base = m_corner.y - height.top + glm::dot(m_rise, low);
        const glm::dvec3 span = m_rise * size;
        const double lowest = base + std::min(span.x, 0.0) + std::min(span.y, 0.0) + std::min(span.z, 0.0),
                     highest = base + std::max(span.x, 0.0) + std::max(span.y, 0.0) + std::max(span.z, 0.0);
        if (lowest >= 0.0 || highest <= -height.depth) return Place::Out;
        return highest <= 0.0 && lowest >= -height.depth ? Place::In : Place::Cut;
    }
    /// Where it is beside an outline.
    Place outlinePlace(const Water& water, glm::dvec3 low, glm::dvec3 size) const {
        const glm::dvec3 middle = m_corner + m_cells.axes * (low + 0.5 * size), half = m_cells.axes * (0.5 * size);
        const double radius = glm::length(half);
        const GroundPolygon& outline = water.outline;
        for (size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
            if (distanceToSegment(middle.x, middle.z, outline[j], outline[i]) < radius) return Place::Cut;
        return contains(outline, middle.x, middle.z) ? Place::In : Place::Out;
    }

private:
    void addLayer(glm::ivec3 base, uint64_t layer) {
        const Place place = placeOf(glm::dvec3(base), glm::dvec3(8.0, 8.0, 1.0));
        if (place == Place::Out) return;
        if (place == Place::In) return m_whole.add(layer, base);
        for (int y = 0; y < 8; ++y) {
            const uint64_t row = layer & 0xffull << (8 * y);
            if (!row) continue;
            const Place rowPlace = placeOf(glm::dvec3(base + glm::ivec3(0, y, 0)), glm::dvec3(8.0, 1.0, 1.0));
            if (rowPlace == Place::In) m_whole.add(row, base);
            if (rowPlace != Place::Cut) continue;
            for (uint64_t bits = row; bits; bits &= bits - 1)
                addVoxel(base + glm::ivec3(std::countr_zero(bits) & 7, y, 0));
        }
    }
    void addVoxel(glm::ivec3 cell) {
        const glm::dvec3 low(cell), one(1.0);
        const Place sideways = m_isWithin ? Place::In : outlinePlace(m_water, low, one);
        if (sideways == Place::Out) return;
        const double before = m_cut;
        const bool isWhole =
            sideways == Place::In && std::none_of(m_before.begin(), m_before.end(), [&](const Water* other) {
                return outlinePlace(*other, low, one) == Place::Cut;
            });
        if (isWhole)
            addCube(low, 1.0);
        else
            for (int i = 0; i < kOutlineParts * kOutlineParts * kOutlineParts; ++i) {
                const glm::ivec3 part(i % kOutlineParts, i / kOutlineParts % kOutlineParts,
                                      i / (kOutlineParts * kOutlineParts));
                const double size = 1.0 / kOutlineParts;
                const glm::dvec3 corner = low + glm::dvec3(part) * size;
                const glm::dvec3 middle = m_corner + m_cells.axes * (corner + 0.5 * size);
                if (contains(m_water.outline, middle.x, middle.z)) addCube(corner, size);
            }
        m_cutVoxels += m_cut > before && heightPlace(m_height, low, one) == Place::Cut ? 1.0 : 0.0;
    }
    /// Adds the part of a cube between bottom and surface that is in no water before; low, size: in cells.
    void addCube(glm::dvec3 low, double size) {
        double bottom = m_height.top - m_height.depth;
        if (m_before.empty()) return addCube(low, size, bottom, m_height.top);
        const glm::dvec3 middle = m_corner + m_cells.axes * (low + 0.5 * size);
        while (bottom < m_height.top) {  // up through those before, from one to the next
            double top = m_height.top, end = bottom;
            for (const Water* other : m_before) {
                const double from = other->surface - other->depth;
                if (other->surface <= bottom || !contains(other->outline, middle.x, middle.z)) continue;
                if (from <= bottom) end = std::max(end, other->surface);
                top = std::min(top, from);
            }
            const bool isFree = end == bottom;
            if (isFree) addCube(low, size, bottom, top);
            bottom = isFree ? top : end;
        }
    }
    /// The same between two heights, world.
    void addCube(glm::dvec3 low, double size, double bottom, double top) {
        const double height = m_corner.y + glm::dot(m_rise, low);
        const CubeBelowPlane under = cubeBelowPlane(m_rise * size, top - height),
                             below = cubeBelowPlane(m_rise * size, bottom - height);
        const double volume = (under.volume - below.volume) * size * size * size;
        m_cut += volume;
        m_cutMoment += low * volume + (under.moment - below.moment) * (size * size * size * size);
    }

    const CellTransform& m_cells;
    const Water& m_water;
    Interval m_height;  ///< of the water, or a part of it
    Waters m_before;
    bool m_isWithin = false;      ///< what is added now is within the outline
    glm::dvec3 m_corner;          ///< of cell (0, 0, 0), world
    glm::dvec3 m_rise;            ///< metres by which each cell axis rises
    double m_half;                ///< half the height of a rotated voxel, metres
    CellSums m_whole;             ///< voxels wholly in the water
    double m_cut = 0.0;           ///< volume of the cut voxels in the water, in voxels
    double m_cutVoxels = 0.0;     ///< the number of those that the surface cuts
    glm::dvec3 m_cutMoment{0.0};  ///< moment of that volume, in cells
};

/// What the heights of other waters leave of an interval, from below.
std::vector<Interval> freeIntervals(Interval height, std::vector<const Water*> others) {
    std::sort(others.begin(), others.end(),
              [](const Water* a, const Water* b) { return a->surface - a->depth < b->surface - b->depth; });
    std::vector<Interval> free;
    double bottom = height.top - height.depth;
    for (const Water* other : others) {
        const double end = std::min(other->surface - other->depth, height.top);
        if (end > bottom) free.push_back({end, end - bottom});
        bottom = std::max(bottom, other->surface);
    }
    if (others.empty()) return {height};
    if (height.top > bottom) free.push_back({height.top, height.top - bottom});
    return free;
}

/// Adds what of a part is in an interval of a water's height, and in no water before.
void addInterval(const ColliderPart& part, const CellTransform& cells, glm::dvec3 origin, const Water& water,
                 Interval height, Waters before, Submersion& sum) {
    PartSubmersion submersion(cells, origin, water, height, before);
    const double size = part.voxelSize();
    const glm::dvec3 low(part.bounds().low), high(part.bounds().high);
    const Place all = submersion.placeOf(low, high - low);
    if (all == Place::Out) return;
    const bool isWithin = submersion.noteOutline(low, high - low);
    part.grid().forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        const glm::ivec3 base = position * kBrickSize;
        const glm::dvec3 corner(base), extent{double(kBrickSize)};
        if (!isWithin) submersion.noteOutline(corner, extent);
        const Place place = all == Place::In ? Place::In : submersion.placeOf(corner, extent);
        if (place != Place::Out) submersion.addBrick(base, *brick, place);
    });
    submersion.addTo(size * size * size, sum);
}

}  // namespace

CubeBelowPlane cubeBelowPlane(glm::dvec3 n, double d) {
    std::array<double, 3> rise{};  // along the axes that count
    std::array<int, 3> axis{};
    int count = 0;
    const double flat = kFlat * std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    for (int i = 0; i < 3; ++i) {
        if (n[i] < 0.0) d -= n[i];  // the cube is mirrored: x -> 1 - x
        if (std::abs(n[i]) > flat)
            rise[size_t(count)] = std::abs(n[i]), axis[size_t(count++)] = i;
        else
            d -= 0.5 * std::abs(n[i]);
    }
    double whole = 0.0;
    for (int k = 0; k < count; ++k) whole += rise[size_t(k)];
    if (d <= 0.0) return {};
    if (d >= whole) return {1.0, glm::dvec3(0.5)};
    CubeBelowPlane part;
    part.volume = pyramids(rise.data(), count, d, count);
    part.moment = glm::dvec3(0.5 * part.volume);
    for (int k = 0; k < count; ++k) {
        std::array<double, 2> others{};
        for (int j = 0, m = 0; j < count; ++j)
            if (j != k) others[size_t(m++)] = rise[size_t(j)];
        const double r = rise[size_t(k)];
        double moment =
            (pyramids(others.data(), count - 1, d, count + 1) - pyramids(others.data(), count - 1, d - r, count + 1)) /
                (r * r) -
            pyramids(others.data(), count - 1, d - r, count) / r;
        const int i = axis[size_t(k)];
        part.moment[i] = n[i] < 0.0 ? part.volume - moment : moment;
    }
    return part;
}

void addSubmersion(const ColliderPart& part, const CellTransform& cells, glm::dvec3 origin, const Water& water,
                   Submersion& sum, Waters before) {
    const Interval height{water.surface, water.depth};
    if (before.empty()) return addInterval(part, cells, origin, water, height, {}, sum);
    const glm::dvec3 low(part.bounds().low), extent(part.bounds().high - part.bounds().low);
    const PartSubmersion own(cells, origin, water, height, {});
    if (own.placeOf(low, extent) == Place::Out) return;
    std::vector<const Water*> near;
    bool isAround = true;  // each of them has all of the part within its outline
    for (const Water* other : before) {
        if (own.heightPlace({other->surface, other->depth}, low, extent) == Place::Out) continue;
        const Place sideways = own.outlinePlace(*other, low, extent);
        if (sideways == Place::Out) continue;
        near.push_back(other);
        isAround = isAround && sideways == Place::In;
    }
    if (!isAround) return addInterval(part, cells, origin, water, height, near, sum);
    for (const Interval& free : freeIntervals(height, std::move(near)))
        addInterval(part, cells, origin, water, free, {}, sum);
}

}  // namespace rubble
