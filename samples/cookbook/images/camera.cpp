// Draws recipes: LD_PRELOAD of this library gives a recipe a table of functions whose worlds have a renderer.
// RUBBLE_SHOTS lists what is drawn: "FILE.png STEP EYE TARGET\n" for each image, with x y z of the camera and of what
// it looks at, in metres. STEP counts calls of step(); a recipe that ends before goes on for so long.
#include <dlfcn.h>
#include <rubble/rubble.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "render/gl/gl.h"
#include "render/gl/offscreen.h"
#include "samples/support/gl_context.h"
#include "samples/support/image.h"
#include "samples/support/material_colors.h"

namespace {

constexpr int kWidth = 960, kHeight = 720;  // nine pixels for one that is shown
constexpr int kFrames = 12;                 // of the same step, so that light settles

struct Shot {
    std::string file;
    int step = 0;
    glm::dvec3 eye{}, target{};
};

const rubble_api* real;
rubble_world filmed = 0;  // the first world
rubble_renderer renderer = 0;
std::optional<rubble::Offscreen> target;
std::vector<rubble_palette_entry> palette;  // from entry 1 on
std::vector<Shot> shots;
rubble_body figure = 0;  // stands where the character is, which is not drawn itself
int stepCount = 0;

template <class T>
T sized() {
    T value = {};
    value.struct_size = sizeof(T);
    return value;
}

void check(bool holds, const std::string& what) {
    if (holds) return;
    std::fprintf(stderr, "camera: %s\n", what.c_str());
    std::exit(1);
}

void check(rubble_result result) {
    check(result == RUBBLE_OK, real->get_last_error());
}

void draw(const Shot& shot) {
    auto view = sized<rubble_view>();
    view.framebuffer = target->framebuffer(), view.width = kWidth, view.height = kHeight;
    view.vertical_fov = 0.8, view.alpha = 1.0;
    const glm::dquat turn = glm::quatLookAt(glm::normalize(shot.target - shot.eye), glm::dvec3(0.0, 1.0, 0.0));
    for (int i = 0; i < 3; ++i) view.position[i] = shot.eye[i];
    view.rotation[0] = turn.x, view.rotation[1] = turn.y, view.rotation[2] = turn.z, view.rotation[3] = turn.w;
    view.flags = RUBBLE_VIEW_CUT;
    for (int frame = 0; frame < kFrames; ++frame, view.flags = 0) check(real->draw(renderer, &view));
    rubble::Image image(kWidth, kHeight);
    image.rgb = target->readRgb();
    const auto written = rubble::writePng(shot.file, image);
    check(bool(written), written ? "" : written.error());
}

void drawShotsOf(int step) {
    for (const Shot& shot : shots)
        if (shot.step == step) draw(shot);
}

/// The palette of new shapes, in colours, from a world that is made for it.
std::vector<rubble_palette_entry> readPalette() {
    rubble_world scratch = 0;
    auto body = sized<rubble_body_settings>();
    auto box = sized<rubble_shape_settings>();
    auto range = sized<rubble_palette_range>();
    std::vector<rubble_palette_entry> entries(20);
    box.source = RUBBLE_SHAPE_BOX, box.size[0] = box.size[1] = box.size[2] = 4;
    range.count = uint32_t(entries.size());
    check(real->create_world(nullptr, &scratch));
    check(real->create_body(scratch, &body, &box.body));
    check(real->create_shape(scratch, &box, &range.shape));
    check(real->step(scratch));
    check(real->get_palette(scratch, &range, entries.data()));
    check(real->destroy_world(scratch));
    for (const rubble::MaterialColor& colour : rubble::kMaterialColors) {
        rubble_palette_entry& entry = entries[size_t(colour.entry - 1)];
        std::copy_n(colour.rgb, 3, entry.color);
        entry.opacity = colour.opacity;
    }
    return entries;
}

rubble_result createShape(rubble_world world, const rubble_shape_settings* settings, rubble_shape* out) {
    const rubble_result result = real->create_shape(world, settings, out);
    if (result != RUBBLE_OK || settings->source == RUBBLE_SHAPE_COPY) return result;
    auto range = sized<rubble_palette_range>();
    range.shape = *out, range.count = uint32_t(palette.size());
    return real->set_palette(world, &range, palette.data());
}

void setSun(const char* direction) {
    double sun[3] = {};
    auto sky = sized<rubble_environment>();
    if (!direction) return;
    check(std::sscanf(direction, "%lf %lf %lf", &sun[0], &sun[1], &sun[2]) == 3, "RUBBLE_SUN: expected X Y Z");
    check(real->get_environment(filmed, &sky));
    check(real->apply_sky_model(&sky, sun));
    std::copy_n(sun, 3, sky.sun_direction);
    check(real->set_environment(filmed, &sky));
}

rubble_result createWorld(const rubble_world_settings* settings, rubble_world* out) {
    auto drawn = settings ? *settings : sized<rubble_world_settings>();
    drawn.flags = (drawn.flags & ~RUBBLE_WORLD_NO_RENDERER) | RUBBLE_WORLD_WAIT_FOR_SHADOW;
    const rubble_result result = real->create_world(&drawn, out);
    if (result != RUBBLE_OK || filmed) return result;
    filmed = *out;
    setSun(std::getenv("RUBBLE_SUN"));
    auto late = sized<rubble_renderer_settings>();
    late.flags = RUBBLE_RENDERER_COMPILE_LATE;
    check(real->create_renderer(filmed, &late, &renderer));
    return result;
}

rubble_result createCharacter(rubble_world world, const rubble_character_settings* settings, rubble_character* out) {
    auto body = sized<rubble_body_settings>();
    auto box = sized<rubble_shape_settings>();
    auto ghost = sized<rubble_collision_filter>();
    body.flags = RUBBLE_BODY_STATIC;
    check(real->create_body(world, &body, &figure));
    box.body = figure, box.source = RUBBLE_SHAPE_BOX, box.index = 11;
    box.size[0] = box.size[2] = 4, box.size[1] = 18;
    check(createShape(world, &box, &ghost.shape));
    ghost.layer = ghost.mask = RUBBLE_COLLISION_NONE;
    check(real->set_collision_filter(world, &ghost));
    return real->create_character(world, settings, out);
}

/// For the next step.
void placeFigure() {
    rubble_character_state character;
    uint32_t count = 0;
    auto change = sized<rubble_body_change>();
    change.body = figure, change.fields = RUBBLE_SET_POSE;
    check(real->get_character_states(filmed, &character, 1, &count));
    const double half[3] = {0.2, 0.0, 0.2};
    for (int i = 0; i < 3; ++i) change.position[i] = character.position[i] - half[i];
    check(real->set_body(filmed, &change));
}

rubble_result step(rubble_world world) {
    const rubble_result result = real->step(world);
    if (result != RUBBLE_OK || world != filmed) return result;
    if (figure) placeFigure();
    drawShotsOf(++stepCount);
    return result;
}

rubble_result destroyWorld(rubble_world world) {
    if (world == filmed) {
        int last = 0;
        for (const Shot& shot : shots) last = std::max(last, shot.step);
        while (stepCount < last) check(step(world));
        check(real->destroy_renderer(renderer));
    }
    return real->destroy_world(world);
}

std::vector<Shot> shotsFrom(const char* text) {
    std::vector<Shot> found;
    std::istringstream lines(text ? text : "");
    Shot shot;
    while (lines >> shot.file >> shot.step >> shot.eye.x >> shot.eye.y >> shot.eye.z >> shot.target.x >>
           shot.target.y >> shot.target.z)
        found.push_back(shot);
    return found;
}

}  // namespace

/// What the recipe calls in place of the library's function of this name.
RUBBLE_EXPORT rubble_result rubble_get_api(uint32_t version, const rubble_api** table) {
    static const auto context = rubble::GlContext::create(rubble::GlContext::Kind::OsMesa);
    static rubble_api drawn;
    const auto next = reinterpret_cast<decltype(&rubble_get_api)>(dlsym(RTLD_NEXT, "rubble_get_api"));
    check(next && next(version, &real) == RUBBLE_OK, "no librubble of this version");
    check(context && rubble::loadGl(context.value()->loader()), "no OpenGL");
    target.emplace(glm::ivec2(kWidth, kHeight));
    shots = shotsFrom(std::getenv("RUBBLE_SHOTS"));
    auto host = sized<rubble_host>();
    host.gl_get_proc_address = context.value()->loader();
    check(real->set_host(&host));
    palette = readPalette();
    drawn = *real;
    drawn.create_world = createWorld, drawn.create_shape = createShape, drawn.create_character = createCharacter,
    drawn.step = step, drawn.destroy_world = destroyWorld;
    *table = &drawn;
    return RUBBLE_OK;
}
