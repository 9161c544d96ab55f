/* A host in C99 that uses every function of rubble.h: it runs all examples of the reference, each in a new world, and
 * prints "good". A warning of the library ends it. The folder that it runs in has a level.rubble, and takes files. */
#include "examples.c" /* samples/reference, with a table of them */
#include "tests/support/gl_host.h"

static const char* running = "";

static void write_message(void* user, int32_t level, const char* message) {
    (void)user;
    if (level < RUBBLE_LOG_WARNING || strcmp(running, "get_refusals") == 0) return; /* a refusal is logged as well */
    fprintf(stderr, "the example of %s: expected no warning, found: %s\n", running, message);
    exit(1);
}

/* The world that example.h describes. */
static void make_scene(void) {
    begin();
    wall = make_box(make_body(-2, 0, 0, RUBBLE_BODY_STATIC), 0, 0, 0, 40, 25, 3, BRICK);
    crate = make_body(-0.4, 0, -2, 0);
    crate_box = make_box(crate, 0, 0, 0, 8, 8, 8, WOOD);
    steps(1);
}

int main(void) {
    rubble_host host = {.struct_size = sizeof host, .log = write_message};
    size_t i;
    host.gl_get_proc_address = make_gl_context();
    framebuffer = make_framebuffer(64, 36);
    require(rubble_get_api(RUBBLE_VERSION, &api) == RUBBLE_OK, "rubble_get_api");
    for (i = 0; i < sizeof examples / sizeof *examples; ++i) {
        running = examples[i].function;
        OK(api->set_host(&host));
        make_scene();
        printf("%s\n", running);
        examples[i].run();
        OK(api->destroy_world(world));
    }
    puts("good");
    return 0;
}
