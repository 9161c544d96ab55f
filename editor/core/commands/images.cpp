// What images become: palettes, ground, and voxels.
#include <fmt/format.h>

#include <algorithm>

#include "editor/core/editor.h"
#include "editor/core/image.h"
#include "editor/core/material_colors.h"
#include "editor/core/palette.h"
#include "editor/core/rotation.h"
#include "runtime/core/counted.h"

namespace editor {
namespace {

const Parameter kFile{"file", Type::Text, "a PNG file", kRequired, 0, 0, ".png"};

void setColors(rubble::World& world, rubble_shape shape, const std::vector<Rgb>& colors, uint32_t first) {
    std::vector<rubble_palette_entry> entries = world.get_palette(paletteRange(shape, first, uint32_t(colors.size())));
    for (size_t i = 0; i < colors.size(); ++i) std::copy(colors[i].begin(), colors[i].end(), entries[i].color);
    world.set_palette(paletteRange(shape, first, uint32_t(colors.size())), entries.data());
}

void paletteFromImage(Editor& editor, const Arguments& arguments) {
    const auto first = uint32_t(arguments.whole("first"));
    const size_t count = std::min<size_t>(size_t(arguments.whole("count")), 256 - first);
    const std::vector<Rgb> colors = reduceColors(readImage(arguments.text("file")), count);
    if (colors.empty()) arguments.refuse("file", "an image with opaque pixels, found none");
    for (const rubble_shape shape : editor.objects(arguments, "shape", {RUBBLE_KIND_SHAPE}))
        setColors(editor.world(), shape, colors, first);
    editor.say(fmt::format("{}: entries {} to {}", rubble::counted(colors.size(), "colour"), first,
                           first + colors.size() - 1));
}

/// A body with a shape of those voxels, x fastest, then y, then z, whose lowest layer is in the middle at a place.
rubble_shape makeShape(Editor& editor, const Arguments& arguments, glm::ivec3 size, const std::vector<uint8_t>& voxels,
                       bool isStatic) {
    rubble_body_settings body{};
    body.flags = isStatic ? RUBBLE_BODY_STATIC : RUBBLE_BODY_ASLEEP;
    put(body.position, arguments.point("at"));
    rubble_shape_settings shape{};
    shape.source = RUBBLE_SHAPE_INDICES;
    shape.voxel_size = arguments.number("voxel");
    for (int a = 0; a < 3; ++a) shape.size[a] = size[a];
    put(shape.position, {-size.x * shape.voxel_size / 2, 0.0, -size.z * shape.voxel_size / 2});
    shape.indices = voxels.data();
    shape.count = voxels.size();
    shape.body = editor.world().create_body(body);
    const rubble_shape made = editor.world().create_shape(shape);
    colorByMaterial(editor, made);
    editor.giveName(arguments, shape.body);
    editor.selection() = {{shape.body}, {}};
    return made;
}

size_t countVoxels(const std::vector<uint8_t>& voxels) {
    return voxels.size() - size_t(std::count(voxels.begin(), voxels.end(), uint8_t(0)));
}

/// Columns as high as the pixels are bright.
void heightMap(Editor& editor, const Arguments& arguments) {
    const Heights image = readHeights(arguments.text("file"));
    const glm::ivec3 size(image.size.x, arguments.whole("height"), image.size.y);
    if (int64_t(size.x) * size.y * size.z > int64_t(1) << 30)
        arguments.refuse("height",
                         fmt::format("at most 2^30 cells in all, found {} x {} x {}", size.x, size.y, size.z));
    const auto index = uint8_t(arguments.whole("index"));
    std::vector<uint8_t> voxels(size_t(size.x) * size_t(size.y) * size_t(size.z));
    for (int z = 0; z < size.z; ++z)
        for (int x = 0; x < size.x; ++x) {
            const double bright = image.values[size_t(z) * size_t(size.x) + size_t(x)];
            const int top = bright < 0.0 ? 0 : std::max(1, int(bright * size.y + 0.5));
            for (int y = 0; y < top; ++y)
                voxels[(size_t(z) * size_t(size.y) + size_t(y)) * size_t(size.x) + size_t(x)] = index;
        }
    if (countVoxels(voxels) == 0) arguments.refuse("file", "an image with opaque pixels, found none");
    makeShape(editor, arguments, size, voxels, true);
    editor.say(fmt::format("{} x {} pixels: {}", size.x, size.z, rubble::counted(countVoxels(voxels), "voxel")));
}

/// Opaque pixels become voxels of their colours, in a plate that stands.
void extrudeImage(Editor& editor, const Arguments& arguments) {
    const Image image = readImage(arguments.text("file"));
    const std::vector<Rgb> colors = reduceColors(image, 255);
    if (colors.empty()) arguments.refuse("file", "an image with opaque pixels, found none");
    const glm::ivec3 size(image.size.x, image.size.y, arguments.whole("depth"));
    std::vector<uint8_t> layer(size_t(size.x) * size_t(size.y));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            if (const auto& pixel = image.at(x, size.y - 1 - y); isOpaque(pixel))
                layer[size_t(y) * size_t(size.x) + size_t(x)] = uint8_t(1 + nearestColor(colors, pixel));
    std::vector<uint8_t> voxels;
    for (int z = 0; z < size.z; ++z) voxels.insert(voxels.end(), layer.begin(), layer.end());
    const rubble_shape shape = makeShape(editor, arguments, size, voxels, false);
    setColors(editor.world(), shape, colors, 1);
    editor.say(fmt::format("{} x {} pixels: {}, {}", size.x, size.y, rubble::counted(countVoxels(voxels), "voxel"),
                           rubble::counted(colors.size(), "colour")));
}

}  // namespace

std::vector<Command> imageCommands() {
    const Parameter at{"at", Type::Point, "where the middle of its lowest layer comes, in metres", "0,0,0"};
    const Parameter voxel{"voxel", Type::Number, "metres along an edge of a voxel", "0.1", 0.001, 1000};
    const Parameter name{"name", Type::Text, "by which others find the body", ""};
    return {
        {"palette_image",
         "images",
         Kind::Edit,
         "Gives entries of a palette the colours of an image.",
         {kFile,
          {"count", Type::Whole, "how many colours at most", "255", 1, 255},
          {"first", Type::Whole, "the first entry", "1", 1, 255},
          {"shape", Type::Objects, "the shapes whose palette it is", "selected"}},
         paletteFromImage,
         "palette_image image.png 16 shape=crate"},
        {"height_map",
         "images",
         Kind::Edit,
         "Makes ground of an image: a column for each pixel, as high as it is bright, of 8 or 16 bits.",
         {kFile,
          {"height", Type::Whole, "of white, in voxels", "64", 1, 4096},
          at,
          voxel,
          {"index", Type::Whole, "entry of the palette", "3", 1, 255},
          name},
         heightMap,
         "height_map image.png 20 0,-3,0 name=hills"},
        {"extrude_image",
         "images",
         Kind::Edit,
         "Makes a plate of an image: a voxel for each opaque pixel, with its colour.",
         {kFile, {"depth", Type::Whole, "of the plate, in voxels", "1", 1, 256}, at, voxel, name},
         extrudeImage,
         "extrude_image image.png 2 0,4,0 name=sign"},
    };
}

}  // namespace editor
