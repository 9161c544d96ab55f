/* A fire that spreads through a crate, and is put out. */
#include "cookbook.h"

int main(void) {
    rubble_heat match = {.struct_size = sizeof match, .flags = RUBBLE_HEAT_IGNITE, .position = {0.4, 0.8, 0.4}};
    rubble_extinguish hose = {.struct_size = sizeof hose, .position = {0.4, 0.8, 0.4}, .radius = 5, .wet_seconds = 20};
    uint32_t lit, later, left;
    begin();
    make_box(make_body(0, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 16, 16, 16, WOOD);
    steps(1);
    OK(api->heat(world, &match));
    steps(2);
    OK(api->get_fires(world, NULL, 0, &lit));
    steps(600);
    OK(api->get_fires(world, NULL, 0, &later));
    OK(api->extinguish(world, &hose));
    steps(1);
    OK(api->get_fires(world, NULL, 0, &left));
    printf("%u parts burn, %u after ten seconds, %u after the hose\n", lit, later, left);
    require(lit > 0 && later > lit && left == 0, "a fire that spreads and goes out");
    OK(api->destroy_world(world));
    return 0;
}
