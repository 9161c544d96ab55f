/* A host's own physics: it gets mass and boxes of what is new, moves the bodies, and says what hit what. Here it knows
 * free fall and a floor. */
#include "cookbook.h"

int main(void) {
    rubble_world_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_WORLD_HOST_PHYSICS};
    rubble_rigid_body rigid;
    rubble_body_state state;
    rubble_impact hit = {.normal = {0, 1, 0}};
    uint32_t count;
    require(rubble_get_api(RUBBLE_VERSION, &api) == RUBBLE_OK, "rubble_get_api");
    OK(api->create_world(&settings, &world));
    make_box(make_body(0, 12, 0, 0), 0, 0, 0, 8, 8, 8, BRICK);
    steps(1);
    OK(api->get_rigid_bodies(world, RUBBLE_BODIES_CHANGED, &rigid, 1, &count));
    state = state_of(rigid.body); /* get_body_boxes() gives its collider */
    while (!hit.body) {
        state.velocity[1] -= 9.81 / 60, state.position[1] += state.velocity[1] / 60;
        if (state.position[1] < 0) hit.body = rigid.body, hit.speed = -state.velocity[1], state.velocity[1] = 0;
        OK(api->set_body_states(world, &state, 1));
        hit.impulse = hit.speed * rigid.mass;
        if (hit.body) OK(api->report_impacts(world, &hit, 1));
        steps(1);
    }
    OK(api->get_rigid_bodies(world, RUBBLE_BODIES_CHANGED, NULL, 0, &count));
    printf("%.0f kg hit the floor at %.0f m/s: %d voxels gone, %u bodies to follow\n", rigid.mass, hit.speed,
           (int)voxels_gone(), count);
    require(voxels_gone() > 0 && count > 0, "it breaks");
    OK(api->destroy_world(world));
    return 0;
}
