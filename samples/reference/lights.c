/* Examples: sky, lights and their groups. */
#include "example.h"

EXAMPLE(set_environment) {
    rubble_environment sky = {.struct_size = sizeof sky};
    OK(api->get_environment(world, &sky)); /* zeros are values: read all, change some, set all */
    sky.gravity[1] = -1.62;                /* on the moon */
    OK(api->set_environment(world, &sky));
}

EXAMPLE(apply_sky_model) {
    const double evening[3] = {0.9, 0.1, 0.3}; /* towards the sun */
    rubble_environment sky = {.struct_size = sizeof sky};
    OK(api->get_environment(world, &sky));
    OK(api->apply_sky_model(&sky, evening)); /* changes the struct alone */
    OK(api->set_environment(world, &sky));
    require(sky.sun_color[0] > sky.sun_color[2], "a red sun");
}

EXAMPLE(add_light) {
    rubble_light_settings bulb = {.struct_size = sizeof bulb, .flags = RUBBLE_LIGHT_ENABLED, .reach = 8};
    rubble_light added, all[16];
    uint32_t count;
    bulb.color[0] = bulb.color[1] = bulb.color[2] = 10;
    OK(api->add_light(world, &bulb)); /* create_light() gives its handle at once */
    steps(1);
    OK(api->get_added_lights(world, &added, 1, &count));
    OK(api->get_lights(world, all, 16, &count));
    require(count == 1 && all[0] == added, "the only light");
    OK(api->remove_light(world, added));
}

EXAMPLE(set_light) {
    rubble_light_settings bulb = {.struct_size = sizeof bulb, .flags = RUBBLE_LIGHT_ENABLED, .reach = 8};
    rubble_light light;
    OK(api->create_light(world, &bulb, &light));
    steps(1);
    OK(api->get_light_settings(world, light, &bulb)); /* zeros are values: read all, change some, set all */
    bulb.color[0] = 30;
    OK(api->set_light(world, &bulb));
}

EXAMPLE(create_light_group) {
    rubble_light_group_settings settings = {.struct_size = sizeof settings, .threshold = 0.3};
    rubble_light_group_change off = {.struct_size = sizeof off, .fields = RUBBLE_GROUP_SWITCH}; /* .on is 0 */
    rubble_light_settings bulb = {.struct_size = sizeof bulb, .flags = RUBBLE_LIGHT_ENABLED, .reach = 8};
    rubble_light_group_state state = {.struct_size = sizeof state};
    rubble_light light;
    OK(api->create_light_group(world, &settings, &off.group));
    bulb.group = off.group; /* entries of palettes may glow with it too */
    OK(api->create_light(world, &bulb, &light));
    OK(api->set_light_group(world, &off));
    steps(1);
    OK(api->get_light_group(world, off.group, &state));
    require(!(state.flags & RUBBLE_GROUP_ON), "all its lights are dark");
}
