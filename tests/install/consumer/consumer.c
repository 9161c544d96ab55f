/* A host outside Rubble's tree: makes a world, steps it, and finds the rubble-vdb that was installed. */
#include <rubble/rubble.h>
#include <stdio.h>

int main(void) {
    const rubble_api* api;
    rubble_world world;
    uint64_t hash;
    FILE* tool = fopen(VDB_TOOL, "rb");
    if (!tool) return fprintf(stderr, "no rubble-vdb at %s\n", VDB_TOOL), 1;
    fclose(tool);
    if (rubble_get_api(RUBBLE_VERSION, &api) != RUBBLE_OK) return fprintf(stderr, "another version\n"), 1;
    if (api->create_world(NULL, &world) != RUBBLE_OK || api->step(world) != RUBBLE_OK ||
        api->get_state_hash(world, &hash) != RUBBLE_OK)
        return fprintf(stderr, "%s\n", api->get_last_error()), 1;
    /* rubble-vdb runs: it says that this file is missing, not that it could not be started. */
    if (api->load_level(world, "missing.vdb", VDB_TOOL) != RUBBLE_ERROR_FILE)
        return fprintf(stderr, "no error for a missing file\n"), 1;
    printf("consumer: %s\n", api->get_last_error());
    return api->destroy_world(world) == RUBBLE_OK ? 0 : 1;
}
