/* A host that knows rubble.h as it was in the first version. It uses a struct of each kind (filled in, results, rows of
 * arrays, rows that the plugin keeps) and checks that nothing behind them is written: host LEVEL. */
#include <rubble/rubble.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const rubble_api* api;

static void check(int good, const char* what) {
    if (good) return;
    fprintf(stderr, "%s: %s\n", what, api->get_last_error());
    exit(1);
}
#define CHECK(condition) check(condition, #condition)
#define OK(call) check((call) == RUBBLE_OK, #call)

/* A struct of results with bytes behind it that must stay. */
#define GUARDED(type)       \
    struct {                \
        type value;         \
        uint64_t behind[8]; \
    }
#define GUARD(it) memset((it).behind, 0x5a, sizeof(it).behind)
static int isWhole(const uint64_t* behind) {
    int i;
    for (i = 0; i < 8; ++i)
        if (behind[i] != 0x5a5a5a5a5a5a5a5aull) return 0;
    return 1;
}

static rubble_explosion tableExplosion(void) {
    rubble_explosion explosion = {.struct_size = sizeof explosion};
    explosion.position[0] = explosion.position[2] = 0.85;
    explosion.position[1] = 0.95;
    explosion.size = 0.5;
    return explosion;
}

int main(int argc, char** argv) {
    GUARDED(rubble_world_settings) settings;
    GUARDED(rubble_events) events;
    GUARDED(rubble_environment) environment;
    rubble_body_state one;
    GUARDED(rubble_query_filter) filter;
    rubble_hit hits[2];
    rubble_ray rays[2];
    rubble_explosion explosion = tableExplosion();
    rubble_world world;
    uint32_t count = 0, i;
    if (argc < 2 || rubble_get_api(RUBBLE_VERSION, &api) != RUBBLE_OK) return 2;
    CHECK(api->struct_size >= sizeof(rubble_api));
    memset(&settings, 0x77, sizeof settings); /* what lies behind is no field */
    settings.value.struct_size = sizeof settings.value;
    settings.value.flags = RUBBLE_WORLD_NO_RENDERER;
    OK(api->create_world(&settings.value, &world));
    OK(api->load_level(world, argv[1], NULL));
    OK(api->explode(world, &explosion));
    OK(api->step(world));

    GUARD(events);
    events.value.struct_size = sizeof events.value;
    OK(api->get_events(world, &events.value));
    CHECK(isWhole(events.behind) && events.value.split_count > 0);
    for (i = 0; i < events.value.split_count; ++i) CHECK(events.value.splits[i].piece != 0);
    GUARD(environment);
    environment.value.struct_size = sizeof environment.value;
    OK(api->get_environment(world, &environment.value));
    CHECK(isWhole(environment.behind));

    /* rows lie one behind the other, as large as they were */
    OK(api->get_body_states(world, NULL, 0, &count));
    CHECK(count > 2);
    {
        rubble_body_state* rows = malloc((count + 1) * sizeof *rows);
        memset(rows, 0x5a, (count + 1) * sizeof *rows);
        OK(api->get_body_states(world, rows, count, &count));
        for (i = 0; i < count; ++i) {
            OK(api->get_body_state(world, rows[i].body, &one));
            CHECK(memcmp(&rows[i], &one, sizeof *rows) == 0);
        }
        CHECK(((unsigned char*)rows)[count * sizeof *rows] == 0x5a);
        free(rows);
    }
    memset(&filter, 0x77, sizeof filter);
    memset(&filter.value, 0, sizeof filter.value);
    filter.value.struct_size = sizeof filter.value;
    memset(rays, 0, sizeof rays);
    for (i = 0; i < 2; ++i) {
        rays[i].origin[0] = 0.25, rays[i].origin[1] = 5.0, rays[i].origin[2] = 0.25;
        rays[i].direction[1] = i ? 1.0 : -1.0;
        rays[i].max_distance = 10.0;
    }
    OK(api->cast_rays(world, rays, 2, &filter.value, hits));
    CHECK(hits[0].hit == 1 && hits[1].hit == 0);
    OK(api->destroy_world(world));
    puts("good");
    return 0;
}
