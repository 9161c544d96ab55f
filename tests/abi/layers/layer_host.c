/* Loads a library, plays a little, lets it go, and does so again: layer_host LIBRARY. Prints the layers that it has and
 * the shared objects that are loaded with it. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <link.h>
#include <rubble/rubble.h>
#include <stdio.h>

typedef rubble_result (*get_api_function)(uint32_t version, const rubble_api** table);

static int print_object(struct dl_phdr_info* info, size_t size, void* data) {
    (void)size, (void)data;
    if (info->dlpi_name[0]) printf("%s\n", info->dlpi_name);
    return 0;
}

static int fail(const rubble_api* api, const char* what) {
    return fprintf(stderr, "%s: %s\n", what, api ? api->get_last_error() : "no table"), 1;
}

static int play(const char* path, int is_last) {
    const rubble_api* api = NULL;
    rubble_world_settings settings = {.struct_size = sizeof settings};
    rubble_body_settings frame = {.struct_size = sizeof frame};
    rubble_shape_settings box = {.struct_size = sizeof box};
    rubble_world world;
    rubble_shape shape;
    uint32_t layers;
    get_api_function get_api;
    void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library) return fprintf(stderr, "%s\n", dlerror()), 1;
    *(void**)&get_api = dlsym(library, "rubble_get_api");
    if (!get_api || get_api(RUBBLE_VERSION, &api) != RUBBLE_OK) return fail(NULL, "rubble_get_api");
    if (api->get_layers(&layers) != RUBBLE_OK) return fail(api, "get_layers");
    if (!(layers & RUBBLE_LAYER_PHYSICS)) {
        if (api->create_world(NULL, &world) != RUBBLE_ERROR_UNSUPPORTED) return fail(api, "create_world");
        if (is_last) printf("refused: %s\n", api->get_last_error());
        settings.flags = RUBBLE_WORLD_HOST_PHYSICS;
    }
    if (api->create_world(&settings, &world) != RUBBLE_OK) return fail(api, "create_world");
    if (!(layers & RUBBLE_LAYER_RENDERER)) {
        rubble_renderer renderer = 1;
        if (api->create_renderer(world, NULL, &renderer) != RUBBLE_ERROR_UNSUPPORTED || renderer)
            return fail(api, "create_renderer");
        if (is_last) printf("refused: %s\n", api->get_last_error());
    }
    if (api->create_body(world, &frame, &box.body) != RUBBLE_OK) return fail(api, "create_body");
    box.source = RUBBLE_SHAPE_BOX, box.size[0] = box.size[1] = box.size[2] = 8;
    if (api->create_shape(world, &box, &shape) != RUBBLE_OK) return fail(api, "create_shape");
    for (int i = 0; i < 10; ++i)
        if (api->step(world) != RUBBLE_OK) return fail(api, "step");
    if (api->destroy_world(world) != RUBBLE_OK) return fail(api, "destroy_world");
    if (is_last) {
        printf("layers: %u\n", layers);
        dl_iterate_phdr(print_object, NULL);
    }
    if (dlclose(library) != 0) return fprintf(stderr, "%s\n", dlerror()), 1;
    if (dlopen(path, RTLD_NOW | RTLD_NOLOAD)) return fprintf(stderr, "%s stays in memory\n", path), 1;
    return 0;
}

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    for (int i = 0; i < 3; ++i)
        if (play(argv[1], i == 2)) return 1;
    return 0;
}
