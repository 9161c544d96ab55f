#include "samples/scenes/fence.h"

#include <algorithm>

#include "runtime/core/random.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {

LevelShape makeConcreteWall(std::string name, int length, int height) {
    const int top = kFenceFoot + height;
    Canvas c({length, top + 1, 5});
    const Swatch concrete = c.addSurface(kConcrete), seam = c.addSurface(kConcreteDark),
                 coping = c.addSurface(kKerb, 108), rebar = c.addSurface(kRebar), moss = c.addSurface(kMoss),
                 dirty = c.addSurface(kConcrete, 82);
    c.box({0, 0, 1}, {length, top, 4}, concrete);
    // Seams between formwork panels, and their tie holes.
    for (int x = 0; x < length; x += 24) c.box({x, kFenceFoot, 1}, {x + 1, top, 4}, seam);
    for (int x = 6; x < length; x += 12)
        for (int y : {kFenceFoot + height / 3, kFenceFoot + height * 2 / 3}) c.box({x, y, 1}, {x + 1, y + 1, 4}, seam);
    for (int x = 2; x < length; x += 5) c.box({x, 1, 2}, {x + 1, top, 3}, rebar);
    for (int y = kFenceFoot + 2; y < top; y += 5) c.box({1, y, 2}, {length - 1, y + 1, 3}, rebar);
    for (int x = 0; x < length; x += 48) c.box({x, 0, 0}, {std::min(x + 4, length), top, 5}, concrete);
    c.box({0, top, 0}, {length, top + 1, 5}, coping);
    c.stain({0, kFenceFoot, 0}, {length, kFenceFoot + 3, 5}, moss, 34);
    c.stain({0, top - 3, 0}, {length, top, 5}, dirty, 40);
    c.stain({0, kFenceFoot, 0}, {length, top, 5}, dirty, 16);
    return c.finish(std::move(name));
}

LevelShape makeGate(std::string name, int width, int height) {
    const int top = kFenceFoot + height;
    Canvas c({width, top + 3, 5});
    const Swatch iron = c.addSurface(kDarkSteel), post = c.addSurface(kBrick), cap = c.addSurface(kKerb);
    for (int x : {0, width - 4}) {
        c.box({x, 0, 0}, {x + 4, top + 1, 5}, post);
        c.box({x, top + 1, 0}, {x + 4, top + 2, 5}, cap);
        c.box({x + 1, top + 2, 1}, {x + 3, top + 3, 4}, cap);
    }
    for (int y : {kFenceFoot + 1, top - 3}) c.box({4, y, 2}, {width - 4, y + 1, 3}, iron);
    for (int x = 5; x < width - 4; x += 2) c.box({x, kFenceFoot + 1, 2}, {x + 1, top - (x % 4 == 1 ? 0 : 1), 3}, iron);
    return c.finish(std::move(name));
}

LevelShape makePicketFence(std::string name, int length, int height, bool alongZ) {
    const int top = kFenceFoot + height;
    Canvas c(alongZ ? ivec3(2, top, length) : ivec3(length, top, 2));
    const Swatch wood = c.addSurface(kFenceWood), dark = c.addSurface(kFenceWood, 84), moss = c.addSurface(kMoss);
    const auto place = [&](int u0, int u1, int y0, int y1, int k0, int k1, Swatch swatch) {
        if (alongZ)
            c.box({k0, y0, u0}, {k1, y1, u1}, swatch);
        else
            c.box({u0, y0, k0}, {u1, y1, k1}, swatch);
    };
    for (int y : {kFenceFoot + 3, kFenceFoot + height * 3 / 4}) place(0, length, y, y + 1, 1, 2, dark);
    for (int u = 0; u < length; u += 3) {
        const int shorter = int(hashCell(u, length, 0, 111) % 3 == 0);
        if (hashCell(u, length, 1, 111) % 23 != 0) place(u, u + 2, kFenceFoot + 1, top - shorter, 0, 1, wood);
    }
    for (int u = 0; u < length; u += 18) place(u, std::min(u + 2, length), 0, top, 1, 2, dark);
    place(length - 2, length, 0, top, 1, 2, dark);
    c.stain({0, kFenceFoot, 0}, {c.size().x, kFenceFoot + 3, c.size().z}, moss, 25);
    return c.finish(std::move(name));
}

}  // namespace rubble::scenes
