/* A pressure plate: a trigger above it tells when a body comes and goes. */
#include "cookbook.h"

int main(void) {
    rubble_trigger_settings plate = {.struct_size = sizeof plate, .kind = RUBBLE_TRIGGER_BOX, .position = {0, 0.2, 0}};
    rubble_body_change away = {.struct_size = sizeof away, .fields = RUBBLE_SET_POSE, .position = {5, 1, 0}};
    rubble_trigger_event events[4];
    rubble_trigger trigger;
    uint32_t count, i, came = 0, left = 0;
    int step;
    begin();
    plate.half_size[0] = plate.half_size[2] = 0.5, plate.half_size[1] = 0.2;
    OK(api->create_trigger(world, &plate, &trigger));
    away.body = make_body(-0.2, 1, -0.2, 0);
    make_box(away.body, 0, 0, 0, 4, 4, 4, WOOD);
    for (step = 0; step < 120; ++step) {
        if (step == 90) OK(api->set_body(world, &away));
        steps(1);
        OK(api->get_trigger_events(world, events, 4, &count));
        for (i = 0; i < count; ++i) events[i].entered ? ++came : ++left;
    }
    printf("came %u times, left %u times\n", came, left);
    require(came == 1 && left == 1, "the crate fell on the plate and was taken away");
    OK(api->destroy_world(world));
    return 0;
}
