/* Examples: names, tags, lists, palettes and materials. */
#include "example.h"

EXAMPLE(set_name) {
    uint64_t found;
    uint32_t count, size;
    char name[32];
    OK(api->set_name(world, crate, "treasure"));
    steps(1);
    OK(api->find_by_name(world, RUBBLE_KIND_BODY, "treasure", &found, 1, &count));
    OK(api->get_name(world, crate, name, sizeof name, &size));
    require(found == crate && size == 9 && strcmp(name, "treasure") == 0, "eight letters and a zero byte");
}

EXAMPLE(set_tag) {
    uint64_t found[8];
    uint32_t count, size;
    char text[32];
    OK(api->set_tag(world, crate_box, "points", "25"));
    steps(1);
    OK(api->get_tag(world, crate_box, "points", text, sizeof text, &size));
    require(atoi(text) == 25, "its value");
    OK(api->get_tags(world, crate_box, text, sizeof text, &size));
    require(strcmp(text, "points=25") == 0, "all its tags");
    OK(api->find_by_tag(world, RUBBLE_KIND_SHAPE, "points", NULL, found, 8, &count));
    require(count == 1 && found[0] == crate_box, "all shapes that have it");
    OK(api->remove_tag(world, crate_box, "points"));
}

EXAMPLE(set_user_value) {
    uint64_t value;
    OK(api->set_user_value(world, crate_box, 7)); /* such as an index into a list of the host */
    steps(1);
    OK(api->get_user_value(world, crate_box, &value)); /* pieces of the shape have it too */
    require(value == 7, "the host's own number");
}

EXAMPLE(get_objects) {
    uint64_t bodies[16], shapes[16];
    uint32_t body_count, shape_count;
    OK(api->get_objects(world, RUBBLE_KIND_BODY, bodies, 16, &body_count));
    OK(api->get_objects_of(world, crate, RUBBLE_KIND_SHAPE, shapes, 16, &shape_count));
    require(body_count == 3 && shape_count == 1 && shapes[0] == crate_box, "three bodies; the crate's shape");
}

EXAMPLE(get_pieces) {
    rubble_break hit = {.struct_size = sizeof hit, .position = {0, 1.5, 0}, .radii = {0.6, 0.6, 0.6}};
    rubble_shape pieces[256], parent, root;
    uint32_t count;
    OK(api->set_user_value(world, wall,
                           1)); /* origins are kept of what a host knows, or by RUBBLE_SETTING_KEEP_ORIGINS */
    OK(api->break_voxels(world, &hit));
    steps(1);
    OK(api->get_pieces(world, wall, pieces, 256, &count));
    OK(api->get_origin(world, pieces[0], &parent, &root));
    require(count > 0 && parent == wall && root == wall, "fragments of the wall");
}

EXAMPLE(set_palette) {
    rubble_palette_range entry = {.struct_size = sizeof entry, .shape = wall, .first = BRICK, .count = 1};
    rubble_palette_entry red;
    OK(api->get_palette(world, &entry, &red));
    red.color[0] = 170, red.color[1] = 70, red.color[2] = 50; /* sRGB */
    OK(api->set_palette(world, &entry, &red));
    steps(1);
}

EXAMPLE(set_materials) {
    rubble_material oak = {.struct_size = sizeof oak};
    uint32_t wood, count, row;
    OK(api->find_material(world, "wood", &wood));
    OK(api->get_material(world, wood, &oak)); /* zeros are values: begin with a row that exists */
    oak.name = "oak", oak.density = 700;
    OK(api->get_material_count(world, &count));
    OK(api->set_materials(world, count, &oak, 1)); /* a row behind the last */
    steps(1);
    OK(api->find_material(world, "oak", &row));
    require(row == count, "for rubble_palette_entry.material");
}
