/* A light that goes out when what it hangs on is destroyed: the light is fixed to the shape of its bulb. */
#include "cookbook.h"

int main(void) {
    rubble_light_settings bulb = {.struct_size = sizeof bulb, .flags = RUBBLE_LIGHT_ENABLED, .reach = 8};
    rubble_break shot = {.struct_size = sizeof shot, .position = {0.15, 2.15, 0.15}, .radii = {0.5, 0.5, 0.5}};
    rubble_light light;
    begin();
    bulb.shape = make_box(make_body(0, 2, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 3, 3, 3, GLASS);
    bulb.position[0] = bulb.position[1] = bulb.position[2] = 0.15; /* in the shape's space */
    bulb.color[0] = bulb.color[1] = bulb.color[2] = 20, bulb.radius = 0.05;
    OK(api->create_light(world, &bulb, &light));
    steps(1);
    OK(api->get_light_settings(world, light, &bulb));
    require(bulb.flags & RUBBLE_LIGHT_ENABLED, "the light is on");
    OK(api->break_voxels(world, &shot));
    steps(1);
    OK(api->get_light_settings(world, light, &bulb));
    printf("the light is %s\n", bulb.flags & RUBBLE_LIGHT_ENABLED ? "on" : "out");
    require(!(bulb.flags & RUBBLE_LIGHT_ENABLED), "the light is out");
    OK(api->destroy_world(world));
    return 0;
}
