#include "tests/reference/flip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "runtime/core/constants.h"

namespace rubble::reference {
namespace {

using glm::dvec3;

// The paper's constants: exponents of colour and feature differences (q_c, q_f), and the knee of the error map (p_c,
// p_t).
constexpr double kColorExponent = 0.7, kFeatureExponent = 0.5, kBendAt = 0.4, kBendTo = 0.95;
constexpr double kFeatureWidth = 0.082;  // degrees

/// An image of three numbers a pixel.
struct Plane {
    glm::ivec2 size;
    std::vector<dvec3> values;
    const dvec3& at(int x, int y) const {  // clamped to the border
        return values[size_t(std::clamp(y, 0, size.y - 1)) * size_t(size.x) + size_t(std::clamp(x, 0, size.x - 1))];
    }
};

template <class F>
Plane map(const Plane& from, F&& f) {
    Plane to{from.size, {}};
    to.values.reserve(from.values.size());
    for (const dvec3& v : from.values) to.values.push_back(f(v));
    return to;
}

// Linear sRGB to CIE XYZ, D65.
const glm::dmat3 kToXyz =
    glm::transpose(glm::dmat3(10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0,  //
                              2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0,    //
                              1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0));
const dvec3 kWhite = kToXyz * dvec3(1.0);

dvec3 linear(dvec3 srgb) {
    for (int i = 0; i < 3; ++i)
        srgb[i] = srgb[i] <= 0.04045 ? srgb[i] / 12.92 : std::pow((srgb[i] + 0.055) / 1.055, 2.4);
    return srgb;
}

/// YCxCz, the opponent space in which contrast sensitivity is measured.
dvec3 toYCxCz(dvec3 linearRgb) {
    const dvec3 n = kToXyz * linearRgb / kWhite;
    return {116.0 * n.y - 16.0, 500.0 * (n.x - n.y), 200.0 * (n.y - n.z)};
}

dvec3 fromYCxCz(dvec3 v) {
    const double y = (v.x + 16.0) / 116.0;
    static const glm::dmat3 back = glm::inverse(kToXyz);
    return back * (dvec3(y + v.y / 500.0, y, y - v.z / 200.0) * kWhite);
}

/// CIELAB with Hunt's adjustment: dark colours have less chroma.
dvec3 toHuntLab(dvec3 linearRgb) {
    dvec3 n = kToXyz * linearRgb / kWhite;
    constexpr double delta = 6.0 / 29.0;
    for (int i = 0; i < 3; ++i)
        n[i] = n[i] > delta * delta * delta ? std::cbrt(n[i]) : n[i] / (3.0 * delta * delta) + 4.0 / 29.0;
    const double lightness = 116.0 * n.y - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (n.x - n.y), 0.01 * lightness * 200.0 * (n.y - n.z)};
}

/// City-block distance in lightness plus Euclidean distance in chroma (Abasi et al. 2020).
double hyab(dvec3 a, dvec3 b) {
    const dvec3 d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

/// A filter for each channel: a sum of two Gaussians, which are separable.
struct Gaussians {
    dvec3 a1, b1, a2, b2;
};
// Contrast sensitivity of achromatic, red-green and blue-yellow (the paper's table 1).
const Gaussians kSensitivity{{1.0, 1.0, 34.1}, {0.0047, 0.0053, 0.04}, {0.0, 0.0, 13.5}, {1e-5, 1e-5, 0.025}};

/// Rows, then columns, with one Gaussian each channel: g(d) = exp(-pi^2 d^2 / b), d in degrees.
Plane blurred(const Plane& from, dvec3 b, int radius, double pixelsPerDegree) {
    std::vector<dvec3> kernel;
    for (int i = -radius; i <= radius; ++i)
        kernel.push_back(glm::exp(dvec3(-kPi * kPi * (i / pixelsPerDegree) * (i / pixelsPerDegree)) / b));
    Plane rows{from.size, std::vector<dvec3>(from.values.size())}, out = rows;
    for (int pass = 0; pass < 2; ++pass) {
        const Plane& source = pass ? rows : from;
        Plane& target = pass ? out : rows;
        for (int y = 0; y < from.size.y; ++y)
            for (int x = 0; x < from.size.x; ++x) {
                dvec3 sum(0.0);
                for (int i = -radius; i <= radius; ++i)
                    sum += kernel[size_t(i + radius)] * (pass ? source.at(x, y + i) : source.at(x + i, y));
                target.values[size_t(y) * size_t(from.size.x) + size_t(x)] = sum;
            }
    }
    return out;
}

/// Removes the detail that a viewer at this distance cannot see (contrast sensitivity), and converts to Hunt-adjusted
/// CIELAB.
Plane contrastFiltered(const Plane& opponent, double pixelsPerDegree) {
    const Gaussians& g = kSensitivity;
    const int radius = int(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * pixelsPerDegree));
    const Plane one{{1, 1}, {dvec3(1.0)}};  // filtered, it gives the sums of the filters
    const dvec3 w1 = g.a1 * glm::sqrt(kPi / g.b1), w2 = g.a2 * glm::sqrt(kPi / g.b2);
    const dvec3 total = w1 * blurred(one, g.b1, radius, pixelsPerDegree).values[0] +
                        w2 * blurred(one, g.b2, radius, pixelsPerDegree).values[0];
    const Plane first = blurred(opponent, g.b1, radius, pixelsPerDegree),
                second = blurred(opponent, g.b2, radius, pixelsPerDegree);
    Plane out = first;
    for (size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = (w1 * first.values[i] + w2 * second.values[i]) / total;
    return map(out, [](const dvec3& v) { return toHuntLab(glm::clamp(fromYCxCz(v), 0.0, 1.0)); });
}

/// The HyAB difference, raised to q_c and mapped so that it is 1 between pure green and pure blue.
double colorDifference(dvec3 a, dvec3 b) {
    static const double largest = std::pow(hyab(toHuntLab({0, 1, 0}), toHuntLab({0, 0, 1})), kColorExponent);
    const double d = std::pow(hyab(a, b), kColorExponent), bend = kBendAt * largest;
    return d < bend ? kBendTo / bend * d : kBendTo + (d - bend) / (largest - bend) * (1.0 - kBendTo);
}

/// First (edges) or second (points) Gaussian derivatives along x and y, in x and y of the result.
Plane features(const Plane& gray, bool points, double pixelsPerDegree) {
    const double deviation = 0.5 * kFeatureWidth * pixelsPerDegree;
    const int radius = int(std::ceil(3.0 * deviation));
    std::vector<double> across, along;  // the derivative, and the Gaussian at right angles to it
    double positive = 0.0, negative = 0.0, sum = 0.0;
    for (int i = -radius; i <= radius; ++i) {
        const double g = std::exp(-i * i / (2.0 * deviation * deviation));
        const double d = points ? (i * i / (deviation * deviation) - 1.0) * g : -i * g;
        along.push_back(g), across.push_back(d);
        sum += g;
        (d > 0.0 ? positive : negative) += std::abs(d);
    }
    for (double& g : along) g /= sum;
    for (double& d : across)
        d /= d > 0.0 ? positive : negative;  // the positive weights sum to one, the negative to minus one
    Plane rows{gray.size, std::vector<dvec3>(gray.values.size())}, out = rows;
    for (int y = 0; y < gray.size.y; ++y)
        for (int x = 0; x < gray.size.x; ++x)
            for (int i = -radius; i <= radius; ++i) {
                const double v = gray.at(x + i, y).x;
                rows.values[size_t(y) * size_t(gray.size.x) + size_t(x)] +=
                    dvec3(across[size_t(i + radius)] * v, along[size_t(i + radius)] * v, 0.0);
            }
    for (int y = 0; y < gray.size.y; ++y)
        for (int x = 0; x < gray.size.x; ++x)
            for (int i = -radius; i <= radius; ++i)
                out.values[size_t(y) * size_t(gray.size.x) + size_t(x)] +=
                    dvec3(along[size_t(i + radius)], across[size_t(i + radius)], 0.0) * rows.at(x, y + i);
    return out;
}

}  // namespace

FloatImage flipMap(const FloatImage& reference, const FloatImage& test, double pixelsPerDegree) {
    assert(reference.size == test.size);
    Plane opponent[2], lab[2], edges[2], points[2];
    for (int i = 0; i < 2; ++i) {
        Plane image{reference.size, {}};
        for (const glm::vec4& p : (i ? test : reference).pixels)
            image.values.push_back(toYCxCz(linear(glm::clamp(dvec3(p), 0.0, 1.0))));
        lab[i] = contrastFiltered(image, pixelsPerDegree);
        const Plane gray = map(image, [](const dvec3& v) { return dvec3((v.x + 16.0) / 116.0); });
        edges[i] = features(gray, false, pixelsPerDegree);
        points[i] = features(gray, true, pixelsPerDegree);
    }
    FloatImage out(reference.size);
    for (size_t i = 0; i < out.pixels.size(); ++i) {
        const double color = colorDifference(lab[0].values[i], lab[1].values[i]);
        const double edge = std::abs(glm::length(edges[0].values[i]) - glm::length(edges[1].values[i]));
        const double point = std::abs(glm::length(points[0].values[i]) - glm::length(points[1].values[i]));
        const double feature = std::pow(std::max(edge, point) / std::sqrt(2.0), kFeatureExponent);
        out.pixels[i].x = float(std::pow(color, 1.0 - std::min(feature, 1.0)));
    }
    return out;
}

double flip(const FloatImage& reference, const FloatImage& test, double pixelsPerDegree) {
    const FloatImage map = flipMap(reference, test, pixelsPerDegree);
    double sum = 0.0;
    for (const glm::vec4& p : map.pixels) sum += p.x;
    return sum / double(map.pixels.size());
}

}  // namespace rubble::reference
