/* A host with a part of Rubble: says which layers its library has, and steps a world. */
#include <rubble/rubble.h>
#include <stdio.h>

int main(void) {
    const rubble_api* api;
    rubble_world_settings settings = {.struct_size = sizeof settings};
    rubble_world world;
    uint32_t layers;
    if (rubble_get_api(RUBBLE_VERSION, &api) != RUBBLE_OK || api->get_layers(&layers) != RUBBLE_OK) return 1;
    if (!(layers & RUBBLE_LAYER_PHYSICS)) settings.flags = RUBBLE_WORLD_HOST_PHYSICS;
    if (api->create_world(&settings, &world) != RUBBLE_OK || api->step(world) != RUBBLE_OK)
        return fprintf(stderr, "%s\n", api->get_last_error()), 1;
    printf("layers %u\n", layers);
    return api->destroy_world(world) == RUBBLE_OK ? 0 : 1;
}
