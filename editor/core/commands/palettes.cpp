// Entries of palettes, and the materials of the level.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "editor/core/editor.h"
#include "editor/core/palette.h"

namespace editor {
namespace {

const Parameter kShapes{"shape", Type::Objects, "the shapes whose palette it is", "selected"};

uint8_t materialOf(Editor& editor, const Arguments& arguments, std::string_view parameter) {
    const uint32_t index = editor.world().find_material(arguments.text(parameter).c_str());
    if (!index)
        arguments.refuse(parameter, fmt::format("a material of the level, found '{}'", arguments.text(parameter)));
    return uint8_t(index);
}

void setEntry(Editor& editor, const Arguments& arguments) {
    for (const rubble_shape shape : editor.objects(arguments, "shape", {RUBBLE_KIND_SHAPE})) {
        const auto first = uint32_t(arguments.whole("index"));
        rubble_palette_entry entry = editor.world().get_palette(paletteRange(shape, first, 1)).front();
        const auto share = [&](const char* name, uint8_t& value) {
            if (arguments.has(name)) value = uint8_t(arguments.number(name) * 255.0 + 0.5);
        };
        if (arguments.has("color")) {
            const auto color = arguments.color("color");
            std::copy(color.begin(), color.end(), entry.color);
        }
        if (arguments.has("material")) entry.material = materialOf(editor, arguments, "material");
        share("opacity", entry.opacity);
        share("roughness", entry.roughness);
        share("metallic", entry.metallic);
        share("reflectivity", entry.reflectivity);
        if (arguments.has("glow")) entry.emission = arguments.number("glow");
        if (arguments.has("group")) entry.light_group = editor.object(arguments, "group", {RUBBLE_KIND_LIGHT_GROUP});
        editor.world().set_palette(paletteRange(shape, first, 1, arguments.flag("all_equal")), &entry);
    }
}

void swapEntries(Editor& editor, const Arguments& arguments) {
    const auto a = uint32_t(arguments.whole("first")), b = uint32_t(arguments.whole("second"));
    for (const rubble_shape shape : editor.objects(arguments, "shape", {RUBBLE_KIND_SHAPE})) {
        const rubble_palette_entry first = editor.world().get_palette(paletteRange(shape, a, 1)).front();
        const rubble_palette_entry second = editor.world().get_palette(paletteRange(shape, b, 1)).front();
        editor.world().set_palette(paletteRange(shape, a, 1), &second);
        editor.world().set_palette(paletteRange(shape, b, 1), &first);
    }
}

void sharePalette(Editor& editor, const Arguments& arguments) {
    const rubble_shape from = editor.object(arguments, "from", {RUBBLE_KIND_SHAPE});
    const std::vector<rubble_palette_entry> all = editor.world().get_palette(paletteRange(from, 1, 255));
    for (const rubble_shape shape : editor.objects(arguments, "shape", {RUBBLE_KIND_SHAPE}))
        editor.world().set_palette(paletteRange(shape, 1, 255), all.data());
}

void setMaterial(Editor& editor, const Arguments& arguments) {
    rubble::World& world = editor.world();
    const std::string& name = arguments.text("name");
    const uint32_t index = world.find_material(name.c_str());
    const uint32_t base = arguments.has("like") ? materialOf(editor, arguments, "like") : index;
    if (!base) arguments.refuse("like", "a material that a new one is like, found none");
    rubble_material material = world.get_material(base);
    const std::string fragments = arguments.has("fragments") ? arguments.text("fragments") : material.fragments;
    material.struct_size = sizeof material;
    material.name = name.c_str();
    material.fragments = fragments.c_str();
    const auto read = [&](const char* parameter, double& value) {
        if (arguments.has(parameter)) value = arguments.number(parameter);
    };
    if (arguments.has("density")) material.density = uint32_t(arguments.whole("density"));
    if (arguments.has("hardness")) material.hardness = uint32_t(arguments.choice("hardness")) + RUBBLE_HARDNESS_SOFT;
    read("tension", material.tensile_strength);
    read("compression", material.compressive_strength);
    read("shear", material.shear_strength);
    read("friction", material.friction);
    read("bounce", material.restitution);
    read("ignites_at", material.ignition_temperature);
    read("burns_for", material.burn_time);
    world.set_materials(index ? index : world.get_material_count(), {material});
}

void listMaterials(Editor& editor, const Arguments&) {
    const uint32_t count = editor.world().get_material_count();
    for (uint32_t i = 1; i < count; ++i) {
        const rubble_material material = editor.world().get_material(i);
        editor.say(fmt::format("{:3} {:<16} {:>6} kg/m3, breaks as {}", i, material.name, material.density,
                               material.fragments));
    }
}

Parameter optional(std::string_view name, std::string_view help, double low, double high) {
    return {name, Type::Number, help, kOptional, low, high};
}

}  // namespace

std::vector<Command> paletteCommands() {
    const auto index = [](std::string_view name, std::string_view help) {
        return Parameter{name, Type::Whole, help, kRequired, 1, 255};
    };
    return {
        {"entry",
         "palette",
         Kind::Edit,
         "Sets how the voxels of one entry look, and what they are made of.",
         {index("index", "the entry"),
          {"color", Type::Color, "sRGB", kOptional},
          {"material", Type::Text, "its name; materials lists them", kOptional},
          optional("opacity", "1: opaque", 0, 1),
          optional("roughness", "0: a mirror", 0, 1),
          optional("metallic", "1: metal", 0, 1),
          optional("reflectivity", "of what is no metal, from above", 0, 1),
          optional("glow", "radiance, in multiples of the colour", 0, 1e6),
          {"group", Type::Objects, "the light group that it glows with", kOptional},
          {"all_equal", Type::Flag, "also of other shapes whose palette is the same", "no"},
          kShapes},
         setEntry,
         "entry 5 color=#b5802e roughness=0.4 shape=crate"},
        {"swap_entries",
         "palette",
         Kind::Edit,
         "Exchanges two entries; voxels keep their numbers.",
         {index("first", "one entry"), index("second", "the other"), kShapes},
         swapEntries,
         "swap_entries 5 7 crate"},
        {"copy_palette",
         "palette",
         Kind::Edit,
         "Gives shapes the palette of another one.",
         {{"from", Type::Objects, "whose palette it is", kRequired}, kShapes},
         sharePalette,
         "copy_palette painted wall"},
        {"material",
         "palette",
         Kind::Edit,
         "Changes a material of the level, or adds one.",
         {{"name", Type::Text, "its name", kRequired},
          {"like", Type::Text, "the material that it is like where nothing is said", kOptional},
          {"density", Type::Whole, "kg/m3", kOptional, 0, 30000},
          {"hardness", Type::Choice, "which tools break it", kOptional, 0, 0, "soft medium hard unbreakable"},
          {"fragments", Type::Choice, "how it breaks", kOptional, 0, 0, "chunk bond splinter pane tear crumble none"},
          optional("tension", "Pa that it bears", 0, 1e15),
          optional("compression", "Pa that it bears", 0, 1e15),
          optional("shear", "Pa that it bears", 0, 1e15),
          optional("friction", "coefficient", 0, 100),
          optional("bounce", "speed after an impact over that before", 0, 1),
          optional("ignites_at", "K; 0: it does not burn", 0, 1e5),
          optional("burns_for", "s", 0, 1e6)},
         setMaterial,
         "material oak like=wood density=750"},
        {"materials", "palette", Kind::View, "Lists the materials of the level.", {}, listMaterials, "materials"},
    };
}

}  // namespace editor
