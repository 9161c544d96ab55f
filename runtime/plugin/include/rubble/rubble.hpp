/* Generated from rubble.h by runtime/plugin/bindings/generate.py: change that, not this.
 *
 * rubble.h for C++17: worlds and renderers that destroy themselves, values that are returned, errors that are thrown.
 * Names, units, threads and meanings are those of rubble.h. struct_size is set here.
 *
 *     rubble::World world;
 *     world.load_level("model.vox");
 *     rubble_explosion explosion{};
 *     explosion.position[1] = 1.0;
 *     world.explode(explosion);
 *     world.step();
 *     for (const rubble_body_state& body : world.get_body_states()) draw(body.position, body.rotation); */
#ifndef RUBBLE_RUBBLE_HPP
#define RUBBLE_RUBBLE_HPP
#include <rubble/rubble.h>

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace rubble {
inline namespace wrapper {  // apart from the library's own classes, for programs that link its parts too

/** What a call that failed throws: what() is get_last_error(). */
class Error : public std::runtime_error {
public:
    Error(rubble_result result, const char* text) : std::runtime_error(text), m_result(result) {}
    rubble_result result() const noexcept { return m_result; }

private:
    rubble_result m_result;
};

/** The table of the library that is linked. Throws Error if that is of another version than rubble.h. */
inline const rubble_api& api() {
    static const rubble_api* const table = [] {
        const rubble_api* found = nullptr;
        if (const rubble_result result = rubble_get_api(RUBBLE_VERSION, &found); result != RUBBLE_OK)
            throw Error(result, "librubble is of another version than rubble.h");
        return found;
    }();
    return *table;
}

/** Throws Error unless `result` is RUBBLE_OK. */
inline void check(rubble_result result) {
    if (result != RUBBLE_OK) throw Error(result, api().get_last_error());
}

/** The rows of a list. read: a call with (rows, capacity, count), as lists of rubble.h take them. */
template <class Row, class Count, class Read>
std::vector<Row> rows(Read&& read) {
    Count count = 0;
    check(read(nullptr, Count(0), &count));
    std::vector<Row> all(count);
    if (count > 0) check(read(all.data(), count, &count));
    all.resize(count);
    return all;
}

/** rubble.h's set_host(): call it before the first world is made. */
inline void set_host(rubble_host host) {
    host.struct_size = sizeof host;
    check(api().set_host(&host));
}

/** rubble.h's apply_sky_model(). */
inline rubble_environment apply_sky_model(rubble_environment environment, const double (&sun_direction)[3]) {
    environment.struct_size = sizeof environment;
    check(api().apply_sky_model(&environment, sun_direction));
    return environment;
}

/** rubble.h's get_layers(). */
inline uint32_t get_layers() {
    uint32_t layers = 0;
    check(api().get_layers(&layers));
    return layers;
}

/** rubble.h's measure_text(): width and height in `out`. */
inline void measure_text(rubble_overlay_item item, double (&out)[2]) {
    item.struct_size = sizeof item;
    check(api().measure_text(&item, out));
}

/** A world, destroyed at the end of its life. Moves, but is not copied. */
class World {
public:
    explicit World(rubble_world_settings settings = {}) {
        settings.struct_size = sizeof settings;
        check(api().create_world(&settings, &m_handle));
    }
    ~World() { release(); }
    World(World&& other) noexcept : m_handle(std::exchange(other.m_handle, 0)) {}
    World& operator=(World&& other) noexcept {
        if (this != &other) release(), m_handle = std::exchange(other.m_handle, 0);
        return *this;
    }
    /** Its handle, for calls of rubble.h. */
    rubble_world handle() const noexcept { return m_handle; }

    /** Replaces the whole world by a level: a .rubble, .vdb or .vox file, told apart by the ending of the UTF-8 path.
     * vdb_tool: path of the program rubble-vdb, which is run as a child process for .vdb files; may be null for others.
     * Drops the edits that wait in the queue, with a warning in the log, and stops a recording. Until the next step()
     * get_events() is empty, and draw() shows what was there before. Bodies begin asleep where the level has them, in
     * the air too, until something wakes them: a hit, an impulse (one of length 0 is enough), or an edit that changes
     * what they touch. Those to which the level gives a velocity begin awake. RUBBLE_ERROR_FILE says what is wrong with
     * the file and where, or that there is not enough memory for what it describes; the world is then unchanged. */
    void load_level(const char* path, const char* vdb_tool = nullptr) {
        check(api().load_level(m_handle, path, vdb_tool));
    }
    /** Advances the world by exactly 1/60 s: queued edits, then physics. The host decides how many steps a frame needs
     * and draws between them with rubble_view.alpha. */
    void step() {
        check(api().step(m_handle));
    }
    /** Removes voxels; see rubble_carve. */
    void carve(rubble_carve carve) {
        carve.struct_size = sizeof carve;
        check(api().carve(m_handle, &carve));
    }
    /** Breaks voxels into fragments; see rubble_break. */
    void break_voxels(rubble_break edit) {
        edit.struct_size = sizeof edit;
        check(api().break_voxels(m_handle, &edit));
    }
    /** Breaks and pushes; see rubble_explosion. */
    void explode(rubble_explosion explosion) {
        explosion.struct_size = sizeof explosion;
        check(api().explode(m_handle, &explosion));
    }
    /** Paints voxels; see rubble_paint. */
    void paint(rubble_paint paint) {
        paint.struct_size = sizeof paint;
        check(api().paint(m_handle, &paint));
    }
    /** Pushes a body and wakes it; see rubble_impulse. */
    void apply_impulse(rubble_impulse impulse) {
        impulse.struct_size = sizeof impulse;
        check(api().apply_impulse(m_handle, &impulse));
    }
    /** Adds a joint; see rubble_joint_settings. If a side finds no voxel in anchor_radius, the step adds no joint and
     * logs a warning. get_joint_states() lists it after the step. */
    void add_joint(rubble_joint_settings settings) {
        settings.struct_size = sizeof settings;
        check(api().add_joint(m_handle, &settings));
    }
    /** Removes a joint. */
    void remove_joint(rubble_joint joint) {
        check(api().remove_joint(m_handle, joint));
    }
    /** Sets motor, friction and steering of a joint and wakes its bodies. */
    void set_joint_motor(rubble_joint_motor motor) {
        motor.struct_size = sizeof motor;
        check(api().set_joint_motor(m_handle, &motor));
    }
    /** Drives the wheels of a body; see rubble_drive. */
    void drive_wheels(rubble_drive drive) {
        drive.struct_size = sizeof drive;
        check(api().drive_wheels(m_handle, &drive));
    }
    /** Holds a body; see rubble_grab. */
    void grab_body(rubble_grab grab) {
        grab.struct_size = sizeof grab;
        check(api().grab_body(m_handle, &grab));
    }
    /** Lets go of a body; see rubble_release. An empty hand does nothing. */
    void release_body(rubble_release release) {
        release.struct_size = sizeof release;
        check(api().release_body(m_handle, &release));
    }
    /** Sets which shapes a shape collides with. */
    void set_collision_filter(rubble_collision_filter filter) {
        filter.struct_size = sizeof filter;
        check(api().set_collision_filter(m_handle, &filter));
    }
    /** Adds water; see rubble_water_settings. */
    void add_water(rubble_water_settings water) {
        water.struct_size = sizeof water;
        check(api().add_water(m_handle, &water));
    }
    /** Removes water. */
    void remove_water(rubble_water water) {
        check(api().remove_water(m_handle, water));
    }
    /** Adds a trigger; see rubble_trigger_settings. Bodies that are in it already enter in the same step. */
    void add_trigger(rubble_trigger_settings trigger) {
        trigger.struct_size = sizeof trigger;
        check(api().add_trigger(m_handle, &trigger));
    }
    /** Removes a trigger. */
    void remove_trigger(rubble_trigger trigger) {
        check(api().remove_trigger(m_handle, trigger));
    }
    /** Adds a character; see rubble_character_settings. */
    void add_character(rubble_character_settings character) {
        character.struct_size = sizeof character;
        check(api().add_character(m_handle, &character));
    }
    /** Removes a character. */
    void remove_character(rubble_character character) {
        check(api().remove_character(m_handle, character));
    }
    /** Says where a character shall go; see rubble_character_move. */
    void move_character(rubble_character_move move) {
        move.struct_size = sizeof move;
        check(api().move_character(m_handle, &move));
    }
    /** Puts a character somewhere else. */
    void teleport_character(rubble_character_teleport teleport) {
        teleport.struct_size = sizeof teleport;
        check(api().teleport_character(m_handle, &teleport));
    }
    /** Replaces sky, sun, air, exposure and gravity; see rubble_environment. */
    void set_environment(rubble_environment environment) {
        environment.struct_size = sizeof environment;
        check(api().set_environment(m_handle, &environment));
    }
    /** Adds a light. A light on a shape moves with it; when the shape is destroyed the light stays where it was, turned
     * off. A world that has 65,536 lights gets no more. */
    void add_light(rubble_light_settings light) {
        light.struct_size = sizeof light;
        check(api().add_light(m_handle, &light));
    }
    /** Replaces all values of a light under its handle. */
    void set_light(rubble_light_settings light) {
        light.struct_size = sizeof light;
        check(api().set_light(m_handle, &light));
    }
    /** Removes a light. */
    void remove_light(rubble_light light) {
        check(api().remove_light(m_handle, light));
    }
    /** How many undo marks are kept. 0, the default: none, at no cost. */
    void set_undo_limit(uint32_t marks) {
        check(api().set_undo_limit(m_handle, marks));
    }
    /** Sets a mark to which undo() returns: the world as the last step left it. */
    void add_undo_mark() {
        check(api().add_undo_mark(m_handle));
    }
    /** Returns to the last mark: objects, motion, environment, materials, settings and bounds. How many marks are kept
     * stays. If nothing but motion has come since the last undo, it returns to the mark before; else to the same mark
     * again. Without such a mark the step logs a warning and undoes nothing. A second undo or redo for the same step is
     * RUBBLE_ERROR_ARGUMENT. What impacts of the step before would break in this one is dropped. Contacts and the
     * tension of joints are no state of the world: they are found again, so that the world goes on in one way whenever
     * the undo comes, but not with the bits of the first time. */
    void undo() {
        check(api().undo(m_handle));
    }
    /** Takes the last undo back, unless something has changed since, in the step of the undo too. */
    void redo() {
        check(api().redo(m_handle));
    }
    /** What the last step() did, without copying: see the rules for how long the arrays live. */
    rubble_events get_events() const {
        rubble_events out{};
        out.struct_size = sizeof out;
        check(api().get_events(m_handle, &out));
        return out;
    }
    /** All bodies, in an order that does not change while none is created. */
    std::vector<rubble_body_state> get_body_states() const {
        rubble_row_list list{};
        list.kind = RUBBLE_ROWS_BODIES;
        return read_rows<rubble_body_state>(list);
    }
    /** One body. */
    rubble_body_state get_body_state(rubble_body body) const {
        rubble_body_state out{};
        check(api().get_body_state(m_handle, body, &out));
        return out;
    }
    /** The shapes of one body; body 0: of all bodies. */
    std::vector<rubble_shape_state> get_shape_states(rubble_body body) const {
        rubble_row_list list{};
        list.kind = RUBBLE_ROWS_SHAPES;
        list.body = body;
        return read_rows<rubble_shape_state>(list);
    }
    /** All joints, in a fixed order. */
    std::vector<rubble_joint_state> get_joint_states() const {
        rubble_row_list list{};
        list.kind = RUBBLE_ROWS_JOINTS;
        return read_rows<rubble_joint_state>(list);
    }
    /** The points of a rope from its first end on: x, y, z of each, world. capacity and *count are numbers of doubles:
     * three for each point. */
    std::vector<double> get_rope_points(rubble_joint joint) const {
        return rows<double, uint32_t>([&](double* out, uint32_t capacity, uint32_t* count) {
            return api().get_rope_points(m_handle, joint, out, capacity, count);
        });
    }
    /** All volumes of water, in a fixed order. What add_water() added is the last row, unless one was removed before,
     * or made by create_water() in that step. */
    std::vector<rubble_water> get_waters() const {
        return rows<rubble_water, uint32_t>([&](rubble_water* out, uint32_t capacity, uint32_t* count) {
            return api().get_waters(m_handle, out, capacity, count);
        });
    }
    /** All triggers, in the same order as get_waters(). */
    std::vector<rubble_trigger> get_triggers() const {
        return rows<rubble_trigger, uint32_t>([&](rubble_trigger* out, uint32_t capacity, uint32_t* count) {
            return api().get_triggers(m_handle, out, capacity, count);
        });
    }
    /** Which bodies entered and left triggers in the last step: where its edits found them. What its physics has moved
     * in or out counts in the next step. */
    std::vector<rubble_trigger_event> get_trigger_events() const {
        rubble_row_list list{};
        list.kind = RUBBLE_ROWS_TRIGGER_EVENTS;
        return read_rows<rubble_trigger_event>(list);
    }
    /** The bodies that had a voxel in a trigger when the last step found its events. */
    std::vector<rubble_body> get_trigger_bodies(rubble_trigger trigger) const {
        return rows<rubble_body, uint32_t>([&](rubble_body* out, uint32_t capacity, uint32_t* count) {
            return api().get_trigger_bodies(m_handle, trigger, out, capacity, count);
        });
    }
    /** All characters, in the same order as get_waters(). */
    std::vector<rubble_character_state> get_character_states() const {
        rubble_row_list list{};
        list.kind = RUBBLE_ROWS_CHARACTERS;
        return read_rows<rubble_character_state>(list);
    }
    /** The present sky, sun, air, exposure and gravity. */
    rubble_environment get_environment() const {
        rubble_environment out{};
        out.struct_size = sizeof out;
        check(api().get_environment(m_handle, &out));
        return out;
    }
    /** All lights, in a fixed order. */
    std::vector<rubble_light> get_lights() const {
        return rows<rubble_light, uint32_t>([&](rubble_light* out, uint32_t capacity, uint32_t* count) {
            return api().get_lights(m_handle, out, capacity, count);
        });
    }
    /** All values of one light. */
    rubble_light_settings get_light_settings(rubble_light light) const {
        rubble_light_settings out{};
        out.struct_size = sizeof out;
        check(api().get_light_settings(m_handle, light, &out));
        return out;
    }
    /** The lights that the last step added: one row for each add_light() in the order of the calls, 0 for one that the
     * step refused. */
    std::vector<rubble_light> get_added_lights() const {
        return rows<rubble_light, uint32_t>([&](rubble_light* out, uint32_t capacity, uint32_t* count) {
            return api().get_added_lights(m_handle, out, capacity, count);
        });
    }
    /** Counts of voxels; see rubble_voxel_accounting. */
    rubble_voxel_accounting get_voxel_accounting() const {
        rubble_voxel_accounting out{};
        out.struct_size = sizeof out;
        check(api().get_voxel_accounting(m_handle, &out));
        return out;
    }
    /** A hash of everything that decides what happens next: equal worlds have equal hashes. Costs a pass over the
     * objects of the world. */
    uint64_t get_state_hash() const {
        uint64_t out{};
        check(api().get_state_hash(m_handle, &out));
        return out;
    }
    /** Counters and times of the last step. */
    rubble_step_stats get_step_stats() const {
        rubble_step_stats out{};
        out.struct_size = sizeof out;
        check(api().get_step_stats(m_handle, &out));
        return out;
    }
    /** The first voxel that a ray meets. max_distance: metres, 0 to 1e6. Nothing met: RUBBLE_OK, out->hit 0.
     * cast_rays() takes many rays, and a filter. */
    rubble_hit cast_ray(const double (&origin)[3], const double (&direction)[3], double max_distance) const {
        rubble_hit out{};
        check(api().cast_ray(m_handle, origin, direction, max_distance, &out));
        return out;
    }
    /** out[i] is the first voxel that rays[i] meets. `count` rows each. */
    std::vector<rubble_hit> cast_rays(const rubble_ray* rays, uint32_t count, rubble_query_filter filter = {}) const {
        filter.struct_size = sizeof filter;
        filter.hit_size = sizeof(rubble_hit);
        filter.query_size = sizeof(rubble_ray);
        std::vector<rubble_hit> out(count);
        check(api().cast_rays(m_handle, rays, count, &filter, out.data()));
        return out;
    }
    /** out[i] is the first voxel that casts[i] meets; distance 0 if it touches one where it starts: of several that a
     * sphere or capsule overlaps there, the one nearest to its centre, or to its axis. */
    std::vector<rubble_hit> cast_shapes(const rubble_shape_cast* casts, uint32_t count, rubble_query_filter filter = {})
        const {
        filter.struct_size = sizeof filter;
        filter.hit_size = sizeof(rubble_hit);
        filter.query_size = sizeof(rubble_shape_cast);
        std::vector<rubble_hit> out(count);
        check(api().cast_shapes(m_handle, casts, count, &filter, out.data()));
        return out;
    }
    /** The bodies that have a voxel in a region, in a fixed order. */
    std::vector<rubble_body> overlap_bodies(const rubble_query_shape& region, rubble_query_filter filter = {}) const {
        filter.struct_size = sizeof filter;
        filter.hit_size = sizeof(rubble_hit);
        return rows<rubble_body, uint32_t>([&](rubble_body* out, uint32_t capacity, uint32_t* count) {
            return api().overlap_bodies(m_handle, &region, &filter, out, capacity, count);
        });
    }
    /** The shapes that have a voxel in a region, in a fixed order. */
    std::vector<rubble_shape> overlap_shapes(const rubble_query_shape& region, rubble_query_filter filter = {}) const {
        filter.struct_size = sizeof filter;
        filter.hit_size = sizeof(rubble_hit);
        return rows<rubble_shape, uint32_t>([&](rubble_shape* out, uint32_t capacity, uint32_t* count) {
            return api().overlap_shapes(m_handle, &region, &filter, out, capacity, count);
        });
    }
    /** The point of a voxel that is closest to a position; distance 0 inside a voxel. max_distance: metres, at most
     * 1e6. Nothing within it: out->hit is 0. */
    rubble_hit find_closest_point(const double (&position)[3], double max_distance, rubble_query_filter filter = {})
        const {
        filter.struct_size = sizeof filter;
        filter.hit_size = sizeof(rubble_hit);
        rubble_hit out{};
        check(api().find_closest_point(m_handle, position, max_distance, &filter, &out));
        return out;
    }
    /** Writes the game between two steps to a file, whole or not at all, with the edits that wait in the queue.
     * Symbolic links are followed; what is no regular file, such as a folder or a device, is not replaced. The next
     * step of the running game begins with physics rebuilt from the world, as a loaded game does, so that playing on
     * and loading give the same result. What takes several steps to compute, as stress and what comes off under
     * `split_parts`, begins again in both: get_state_hash() has it, get_resolved_hash() does not. Undo marks are not in
     * the file: a loaded game has none. RUBBLE_ERROR_ARGUMENT: an undo or redo waits for the next step.
     * RUBBLE_ERROR_FILE: the file cannot be written; nothing has changed. */
    void save_game(const char* path) {
        check(api().save_game(m_handle, path));
    }
    /** Replaces the whole world and its queue of edits by those of a saved game, and stops a recording.
     * translate_handle() gives the handles of this world for those that the objects had when they were saved.
     * RUBBLE_ERROR_FILE: the world is unchanged. */
    void load_game(const char* path) {
        check(api().load_game(m_handle, path));
    }
    /** Records every step from here on, beginning with a saved game. The file has its name after stop_recording() or
     * destroy_world(); a recording that is running is stopped, and the log says what of it could not be written. Undo
     * marks from before are dropped. RUBBLE_ERROR_FILE: the file cannot be written, with the saved game in it, or a
     * recording is being written to it; the world and its marks are unchanged, and a recording that is running goes on.
     * */
    void start_recording(const char* path) {
        check(api().start_recording(m_handle, path));
    }
    /** Completes the file; without a recording it does nothing. RUBBLE_ERROR_FILE: some of it could not be written, as
     * the log said in that step; the file has the steps before. */
    void stop_recording() {
        check(api().stop_recording(m_handle));
    }
    /** Loads the start of a recording and plays all its steps. *steps (may be null) counts the steps that had the
     * recorded state hash. RUBBLE_ERROR_FILE: the file is damaged (the world is unchanged), or a step had another hash
     * because another build made the recording (the world is as after that step). */
    uint64_t play_recording(const char* path) {
        uint64_t out{};
        check(api().play_recording(m_handle, path, &out));
        return out;
    }
    /** Sets where the world ends from the next step on; see rubble_bounds. Saves and recordings keep it. */
    void set_bounds(rubble_bounds bounds) {
        bounds.struct_size = sizeof bounds;
        check(api().set_bounds(m_handle, &bounds));
    }
    /** The bounds in use, as the last step() knew them. Low and high are equal if there are none. */
    rubble_bounds get_bounds() const {
        rubble_bounds out{};
        out.struct_size = sizeof out;
        check(api().get_bounds(m_handle, &out));
        return out;
    }
    /** Sets what a shape is touched as; see rubble_collision_shape. Pieces of it inherit it. */
    void set_collision_shape(rubble_collision_shape shape) {
        shape.struct_size = sizeof shape;
        check(api().set_collision_shape(m_handle, &shape));
    }
    /** The handle that something has in this world: `handle` named it in the world that was saved, if this one was
     * loaded from there. A handle carries the number of its world, so a host that stores handles beside a saved game
     * asks for each after load_game(). Nothing of that name is here: *out is 0 and RUBBLE_ERROR_STALE. */
    uint64_t translate_handle(uint64_t handle) const {
        uint64_t out{};
        check(api().translate_handle(m_handle, handle, &out));
        return out;
    }
    /** A list as get_body_states() and its like write it, with rows of the host's size; see rubble_row_list. `out`
     * holds `capacity` rows of list->row_size bytes. */
    template <class Row>
    std::vector<Row> read_rows(rubble_row_list list) const {
        list.struct_size = sizeof list;
        list.row_size = sizeof(Row);
        return rows<Row, uint32_t>([&](void* out, uint32_t capacity, uint32_t* count) {
            return api().read_rows(m_handle, &list, out, capacity, count);
        });
    }
    /** Makes shapes of the parts of a shape that do not touch: what is held to the world, or else the largest part,
     * stays. For shapes that come in parts from a level; what an edit cuts off comes off by itself. All parts come off
     * in one step, whose cost grows with their number. */
    void split_shape(rubble_shape shape) {
        check(api().split_shape(m_handle, shape));
    }
    /** Adds a shape to another one of the same body and voxel size that it touches face to face; 0: to the first that
     * fits. Where both have a voxel, `into` keeps its own. Joints and lights go with it, and its voxels' palette
     * entries: those of `into` that no voxel has make room. The step logs a warning, and does nothing, if their cells
     * do not line up or their voxels need more than 255 entries. */
    void merge_shape(rubble_shape shape, rubble_shape into) {
        check(api().merge_shape(m_handle, shape, into));
    }
    /** Shrinks a shape's grid to its voxels. If it gets smaller, its fires go out. */
    void trim_shape(rubble_shape shape) {
        check(api().trim_shape(m_handle, shape));
    }
    /** Gives a shape's grid another box of cells; see rubble_resize. */
    void resize_shape(rubble_resize resize) {
        resize.struct_size = sizeof resize;
        check(api().resize_shape(m_handle, &resize));
    }
    /** Reads a box of cells as the last step left them: one byte each, x fastest, then y, then z. `capacity` is in
     * bytes; *count becomes the number of cells in the box. Capacity 0 asks for that alone; fewer bytes than cells:
     * RUBBLE_ERROR_CAPACITY, and nothing is written. */
    std::vector<uint8_t> read_voxels(rubble_voxel_box box) const {
        box.struct_size = sizeof box;
        return rows<uint8_t, uint64_t>([&](uint8_t* out, uint64_t capacity, uint64_t* count) {
            return api().read_voxels(m_handle, &box, out, capacity, count);
        });
    }
    /** Frees the end of a rope that is on a shape. Joints of other kinds are removed, and a rope that nothing holds any
     * more. */
    void detach_joint(rubble_joint joint, rubble_shape shape) {
        check(api().detach_joint(m_handle, joint, shape));
    }
    /** Heats or lights what lies in a sphere; see rubble_heat. */
    void heat(rubble_heat heat) {
        heat.struct_size = sizeof heat;
        check(api().heat(m_handle, &heat));
    }
    /** Puts fires out; see rubble_extinguish. */
    void extinguish(rubble_extinguish extinguish) {
        extinguish.struct_size = sizeof extinguish;
        check(api().extinguish(m_handle, &extinguish));
    }
    /** Puts out all fires in a box along the world's axes. */
    void remove_fires(const double (&low)[3], const double (&high)[3]) {
        check(api().remove_fires(m_handle, low, high));
    }
    /** All that burns, in a fixed order. Costs what is hot. */
    std::vector<rubble_fire> get_fires() const {
        rubble_row_list list{};
        list.kind = RUBBLE_ROWS_FIRES;
        return read_rows<rubble_fire>(list);
    }
    /** Changes place, motion or sleep of a body; see rubble_body_change. Shapes of a static body that moves keep their
     * handles and meshes: it is among RUBBLE_ROWS_MOVED_BODIES. */
    void set_body(rubble_body_change change) {
        change.struct_size = sizeof change;
        check(api().set_body(m_handle, &change));
    }
    /** Erases a body and all its shapes, without dust or pieces. Their joints break, their lights go out. */
    void destroy_body(rubble_body body) {
        check(api().destroy_body(m_handle, body));
    }
    /** Erases a shape, without dust or pieces, and its body if it has no other. */
    void destroy_shape(rubble_shape shape) {
        check(api().destroy_shape(m_handle, shape));
    }
    /** Gives the cells of a box, which lies within the shape's grid, other voxels: one byte each as read_voxels() gives
     * them, RUBBLE_VOXEL_INDEX only; `size` is the number of cells. Copied by the call, with the box's mask. Who draws
     * in what read_voxels() gave names the changed cells there: the others would go back to what the last step left,
     * and undo a carve() of this one. Cells that change lose their paint; no event and no dust tells of voxels that are
     * gone by it. Voxels that then touch nothing that holds them come off in the same step, and so does what hung on
     * voxels that are gone. */
    void write_voxels(rubble_voxel_box box, const uint8_t* voxels, uint64_t size) {
        box.struct_size = sizeof box;
        check(api().write_voxels(m_handle, &box, voxels, size));
    }
    /** Makes a body without shapes: a frame, which is not simulated until it has one. *out names it: in edits from now
     * on, in reads after the next step(). */
    rubble_body create_body(rubble_body_settings settings) {
        settings.struct_size = sizeof settings;
        rubble_body out{};
        check(api().create_body(m_handle, &settings, &out));
        return out;
    }
    /** Makes a shape on a body, as a level brings it: on a static body its lowest layer of voxels holds it to the world
     * (of RUBBLE_SHAPE_EMPTY the lowest cells), and parts of it that touch nothing stay until something is cut. The
     * lowest layer is that at the side of its grid which faces -y of the world most when the step makes it, of equal
     * ones that of the lowest cells along y; a static body that is turned later is held by the same cells. Each point
     * of a free body moves on as it did. A shape that has no voxels after the edits of the step is refused. *out as by
     * create_body(). */
    rubble_shape create_shape(rubble_shape_settings settings) {
        settings.struct_size = sizeof settings;
        rubble_shape out{};
        check(api().create_shape(m_handle, &settings, &out));
        return out;
    }
    /** As add_joint(), with a handle as by create_body(). The joint is placed where its shapes are when the step
     * carries it out; refused if it finds no voxel to hold on to. */
    rubble_joint create_joint(rubble_joint_settings settings) {
        settings.struct_size = sizeof settings;
        rubble_joint out{};
        check(api().create_joint(m_handle, &settings, &out));
        return out;
    }
    /** As add_light(), with a handle as by create_body(). */
    rubble_light create_light(rubble_light_settings settings) {
        settings.struct_size = sizeof settings;
        rubble_light out{};
        check(api().create_light(m_handle, &settings, &out));
        return out;
    }
    /** As add_water(), with a handle as by create_body(). */
    rubble_water create_water(rubble_water_settings settings) {
        settings.struct_size = sizeof settings;
        rubble_water out{};
        check(api().create_water(m_handle, &settings, &out));
        return out;
    }
    /** As add_trigger(), with a handle as by create_body(). */
    rubble_trigger create_trigger(rubble_trigger_settings settings) {
        settings.struct_size = sizeof settings;
        rubble_trigger out{};
        check(api().create_trigger(m_handle, &settings, &out));
        return out;
    }
    /** As add_character(), with a handle as by create_body(). */
    rubble_character create_character(rubble_character_settings settings) {
        settings.struct_size = sizeof settings;
        rubble_character out{};
        check(api().create_character(m_handle, &settings, &out));
        return out;
    }
    /** Places the bodies of a level into the running world, with their shapes, joints and lights; see rubble_prefab.
     * The rows of `out` are in the order of the file: bodies, shapes, joints, lights; each handle is as by
     * create_body(). Capacity 0 asks for their number alone; fewer rows than that: RUBBLE_ERROR_CAPACITY, and nothing
     * is made either way. RUBBLE_ERROR_FILE: the level cannot be read. */
    std::vector<rubble_prefab_row> create_prefab(rubble_prefab prefab) {
        prefab.struct_size = sizeof prefab;
        return rows<rubble_prefab_row, uint32_t>([&](rubble_prefab_row* out, uint32_t capacity, uint32_t* count) {
            return api().create_prefab(m_handle, &prefab, out, capacity, count);
        });
    }
    /** What the last step did not make, though a call gave a handle for it, and why: its body was destroyed before its
     * turn, it has no voxels, an undo in the same step took its place. In the order of the calls, but for shapes
     * without voxels, which are last. */
    std::vector<rubble_refusal> get_refusals() const {
        return rows<rubble_refusal, uint32_t>([&](rubble_refusal* out, uint32_t capacity, uint32_t* count) {
            return api().get_refusals(m_handle, out, capacity, count);
        });
    }
    /** Gives an object a name: UTF-8, at most 4096 bytes. Names need not be unique. */
    void set_name(uint64_t object, const char* name) {
        check(api().set_name(m_handle, object, name));
    }
    /** The name of an object, with a zero byte at its end, which *count counts. Fewer bytes of capacity:
     * RUBBLE_ERROR_CAPACITY, and nothing is written. */
    std::vector<char> get_name(uint64_t object) const {
        return rows<char, uint32_t>([&](char* out, uint32_t capacity, uint32_t* count) {
            return api().get_name(m_handle, object, out, capacity, count);
        });
    }
    /** Gives an object a tag, or a tag that it has another value. tag: UTF-8, 1 to 4096 bytes without "=". value: as a
     * name; may be null, as "". */
    void set_tag(uint64_t object, const char* tag, const char* value) {
        check(api().set_tag(m_handle, object, tag, value));
    }
    /** Takes a tag away; an object without it stays as it is. */
    void remove_tag(uint64_t object, const char* tag) {
        check(api().remove_tag(m_handle, object, tag));
    }
    /** The value of a tag, as get_name() gives a name; *count is 0 if the object has no such tag, and 1 if it has it
     * without a value. */
    std::vector<char> get_tag(uint64_t object, const char* tag) const {
        return rows<char, uint32_t>([&](char* out, uint32_t capacity, uint32_t* count) {
            return api().get_tag(m_handle, object, tag, out, capacity, count);
        });
    }
    /** All tags of an object, as get_name() gives a name: "TAG" or "TAG=VALUE", each with a zero byte at its end. */
    std::vector<char> get_tags(uint64_t object) const {
        return rows<char, uint32_t>([&](char* out, uint32_t capacity, uint32_t* count) {
            return api().get_tags(m_handle, object, out, capacity, count);
        });
    }
    /** Gives an object a number of the host's own, such as a pointer or an index. */
    void set_user_value(uint64_t object, uint64_t value) {
        check(api().set_user_value(m_handle, object, value));
    }
    /** That number; 0 if there is none. */
    uint64_t get_user_value(uint64_t object) const {
        uint64_t out{};
        check(api().get_user_value(m_handle, object, &out));
        return out;
    }
    /** All objects of a kind, RUBBLE_KIND_..., in a fixed order. */
    std::vector<uint64_t> get_objects(uint32_t kind) const {
        return rows<uint64_t, uint32_t>([&](uint64_t* out, uint32_t capacity, uint32_t* count) {
            return api().get_objects(m_handle, kind, out, capacity, count);
        });
    }
    /** What belongs to an object, in a fixed order: shapes, joints and lights of a body, joints and lights of a shape,
     * lights of a light group. Other pairs of kinds are RUBBLE_ERROR_ARGUMENT. */
    std::vector<uint64_t> get_objects_of(uint64_t owner, uint32_t kind) const {
        return rows<uint64_t, uint32_t>([&](uint64_t* out, uint32_t capacity, uint32_t* count) {
            return api().get_objects_of(m_handle, owner, kind, out, capacity, count);
        });
    }
    /** The objects of a kind that have a name, in a fixed order. Costs a look at each of that kind. */
    std::vector<uint64_t> find_by_name(uint32_t kind, const char* name) const {
        return rows<uint64_t, uint32_t>([&](uint64_t* out, uint32_t capacity, uint32_t* count) {
            return api().find_by_name(m_handle, kind, name, out, capacity, count);
        });
    }
    /** The objects of a kind that have a tag, in a fixed order. value: that it has; null: any. */
    std::vector<uint64_t> find_by_tag(uint32_t kind, const char* tag, const char* value) const {
        return rows<uint64_t, uint32_t>([&](uint64_t* out, uint32_t capacity, uint32_t* count) {
            return api().find_by_tag(m_handle, kind, tag, value, out, capacity, count);
        });
    }
    /** What a piece came off: *parent is the shape that it was a part of, *root the first shape of that line, which is
     * no piece. Either may be gone by now. 0: the shape is no piece, or nobody asked for it; see
     * RUBBLE_SETTING_KEEP_ORIGINS. */
    rubble_shape get_origin(rubble_shape shape, rubble_shape* parent) const {
        rubble_shape out{};
        check(api().get_origin(m_handle, shape, parent, &out));
        return out;
    }
    /** What became of a shape: the pieces that have it as their parent or root, in a fixed order. The shape may be
     * gone; if it is not, it is what is left of itself and not in the list. */
    std::vector<rubble_shape> get_pieces(rubble_shape shape) const {
        return rows<rubble_shape, uint32_t>([&](rubble_shape* out, uint32_t capacity, uint32_t* count) {
            return api().get_pieces(m_handle, shape, out, capacity, count);
        });
    }
    /** Replaces the settings of the world from the next step on. Saves and recordings keep them. */
    void set_settings(rubble_settings settings) {
        settings.struct_size = sizeof settings;
        check(api().set_settings(m_handle, &settings));
    }
    /** The settings in use, as the last step() knew them. */
    rubble_settings get_settings() const {
        rubble_settings out{};
        out.struct_size = sizeof out;
        check(api().get_settings(m_handle, &out));
        return out;
    }
    /** Replaces entries of a shape's palette from the next step on: `range->count` rows. Voxels look, weigh, break,
     * burn and slide as their new material does; those that change their light group count in the new one. Shapes that
     * share the palette keep theirs, but with RUBBLE_PALETTE_ALL_EQUAL. Voxels that were painted or have charred are of
     * entries of their own, which stay as they are. Paint that blends takes entries that no voxel has: those without a
     * material, then those that equal another one, then any. */
    void set_palette(rubble_palette_range range, const rubble_palette_entry* entries) {
        range.struct_size = sizeof range;
        range.entry_size = sizeof(rubble_palette_entry);
        check(api().set_palette(m_handle, &range, entries));
    }
    /** Reads entries of a shape's palette: `range->count` rows. */
    std::vector<rubble_palette_entry> get_palette(rubble_palette_range range) const {
        range.struct_size = sizeof range;
        range.entry_size = sizeof(rubble_palette_entry);
        std::vector<rubble_palette_entry> out(range.count < 256 ? range.count : 255);
        check(api().get_palette(m_handle, &range, out.data()));
        return out;
    }
    /** Mass, centre, inertia and motion of bodies, in a fixed order. which: RUBBLE_BODIES_CHANGED or RUBBLE_BODIES_ALL.
     * Costs the bodies that are listed. Of worlds with physics of their own as well. */
    std::vector<rubble_rigid_body> get_rigid_bodies(uint32_t which) const {
        return rows<rubble_rigid_body, uint32_t>([&](rubble_rigid_body* out, uint32_t capacity, uint32_t* count) {
            return api().get_rigid_bodies(m_handle, which, out, capacity, count);
        });
    }
    /** Boxes for a collider of the host: a compound, in the body's frame. Costs the bricks of its shapes. */
    std::vector<rubble_body_box> get_body_boxes(rubble_body body) const {
        return rows<rubble_body_box, uint32_t>([&](rubble_body_box* out, uint32_t capacity, uint32_t* count) {
            return api().get_body_boxes(m_handle, body, out, capacity, count);
        });
    }
    /** The impulses that edits of the last step gave to free bodies, as explosions and apply_impulse() do, in their
     * order. A physics of the world's own has applied them; the host's has to. */
    std::vector<rubble_body_impulse> get_body_impulses() const {
        return rows<rubble_body_impulse, uint32_t>([&](rubble_body_impulse* out, uint32_t capacity, uint32_t* count) {
            return api().get_body_impulses(m_handle, out, capacity, count);
        });
    }
    /** What a step of the host's physics has made of bodies, at once: later reads see it, and undo marks and edits of
     * the next step. `count` rows as get_body_states() gives them; shape_count is not read. Only of free bodies: what
     * is static moves by set_body(). Recordings keep it. RUBBLE_ERROR_UNSUPPORTED: the world has physics of its own. */
    void set_body_states(const rubble_body_state* states, uint32_t count) {
        check(api().set_body_states(m_handle, states, count));
    }
    /** Hits of the host's physics, at places as the last set_body_states() left them: the next step breaks what they
     * break by strength, impulse and rubble_settings, the hardest first. What has broken through something gets the
     * rest of its momentum back by get_body_impulses(). A hit that lasts for several steps is reported once, and
     * resting contacts not at all. Recordings keep it. RUBBLE_ERROR_UNSUPPORTED: as by set_body_states(). */
    void report_impacts(const rubble_impact* impacts, uint32_t count) {
        check(api().report_impacts(m_handle, impacts, count));
    }
    /** As load_level(), of a .rubble or .vox file in memory, which is not read after the call. */
    void load_level_data(const void* data, uint64_t size) {
        check(api().load_level_data(m_handle, data, size));
    }
    /** As save_game(), into memory: `capacity` is in bytes; *count becomes the size of the file. Capacity 0 asks for
     * that alone and saves nothing; fewer bytes than that: RUBBLE_ERROR_CAPACITY, and nothing is saved.
     * RUBBLE_ERROR_FILE: a file cannot be so large. */
    std::vector<uint8_t> save_game_data() {
        return rows<uint8_t, uint64_t>([&](uint8_t* out, uint64_t capacity, uint64_t* count) {
            return api().save_game_data(m_handle, out, capacity, count);
        });
    }
    /** As load_game(), of a saved game in memory, which is not read after the call. */
    void load_game_data(const void* data, uint64_t size) {
        check(api().load_game_data(m_handle, data, size));
    }
    /** As play_recording(), of a recording in memory. rubble_host.write_file takes recordings into memory. */
    uint64_t play_recording_data(const void* data, uint64_t size) {
        uint64_t out{};
        check(api().play_recording_data(m_handle, data, size, &out));
        return out;
    }
    /** From now on each step keeps what it changed, for worlds that are equal to this one now, to their handles: those
     * that load save_game_data() of now. One that has come by the same voxels in another way may have given its objects
     * other handles, and is then refused. What was kept before is dropped: take it first. on: RUBBLE_DELTAS_...;
     * RUBBLE_DELTAS_NONE ends it, as loading does, and costs nothing. */
    void keep_deltas(uint32_t on) {
        check(api().keep_deltas(m_handle, on));
    }
    /** Takes what steps have kept since the last call that gave it. `capacity` is in bytes; *count becomes the size.
     * Capacity 0 asks for that alone; fewer bytes than that: RUBBLE_ERROR_CAPACITY; nothing is taken either way.
     * RUBBLE_ERROR_ARGUMENT: none are kept. */
    std::vector<uint8_t> take_deltas() {
        return rows<uint8_t, uint64_t>([&](uint8_t* out, uint64_t capacity, uint64_t* count) {
            return api().take_deltas(m_handle, out, capacity, count);
        });
    }
    /** Carries out steps of another world: objects, voxels and motion become those, without edits or physics. Each take
     * of the other world is applied once, in their order, from the first after keep_deltas() on; a step() of this world
     * in between ends that. get_events() tells which objects came and went in the last of the steps, also a shape that
     * its leader tells of as changed; what was removed, painted, split and broken only with RUBBLE_DELTAS_EVENTS.
     * get_reports() has the breaks then, and is empty otherwise: nothing tells of contacts, joints, fires, water and
     * footsteps of the other world. It stops a recording, and keep_deltas() of this world. Heat, ropes between their
     * ends, what is still to split and data of the host are left out, see get_resolved_hash(). Of RUBBLE_DELTAS_EDITS,
     * poses, velocities and sleep of free bodies that were there before and of characters are left out too: see
     * get_voxel_hash(). A world with RUBBLE_WORLD_HOST_PHYSICS gets them by set_body_states(), before this call.
     * RUBBLE_ERROR_FILE: the bytes are wrong or steps are missing, and this world is as after the step before; or a
     * step has shown that it was another one. What it makes in steps of its own may get other handles than there. */
    void apply_deltas(const void* data, uint64_t size) {
        check(api().apply_deltas(m_handle, data, size));
    }
    /** A hash of what RUBBLE_DELTAS_ALL keep equal: all objects, voxels, environment, materials, settings and bounds.
     * How many undo marks are kept is not among them. */
    uint64_t get_resolved_hash() const {
        uint64_t out{};
        check(api().get_resolved_hash(m_handle, &out));
        return out;
    }
    /** Begins to read a level, as load_level() does, on a thread of its own; the world plays on. Where there are no
     * threads, as in browsers, it reads it now. A level that is being read already is dropped, when it has been read.
     * */
    void start_loading(const char* path, const char* vdb_tool = nullptr) {
        check(api().start_loading(m_handle, path, vdb_tool));
    }
    /** How far that is: *out is 0 to 1, by parts of the file; 1: finish_loading() does not wait for it.
     * RUBBLE_ERROR_ARGUMENT: no level is being read. */
    double get_loading_progress() const {
        double out{};
        check(api().get_loading_progress(m_handle, &out));
        return out;
    }
    /** Replaces the world by that level, as load_level() does. Waits for the rest of it. RUBBLE_ERROR_ARGUMENT: no
     * level is being read. RUBBLE_ERROR_FILE: as by load_level(). */
    void finish_loading() {
        check(api().finish_loading(m_handle));
    }
    /** Replaces rows of the table of materials from the next step on, or adds rows behind its last one: row `first` and
     * those behind it, 1 to 255. All that is of them weighs, breaks, burns and slides as they say. Rows are never
     * removed, because palettes hold their numbers; row 0 is that of no material. */
    void set_materials(uint32_t first, std::vector<rubble_material> materials) {
        for (rubble_material& row : materials) row.struct_size = sizeof row;
        check(api().set_materials(m_handle, first, materials.data(), uint32_t(materials.size())));
    }
    /** A row of the table. RUBBLE_ERROR_ARGUMENT: there is no such row. */
    rubble_material get_material(uint32_t index) const {
        rubble_material out{};
        out.struct_size = sizeof out;
        check(api().get_material(m_handle, index, &out));
        return out;
    }
    /** How many rows the table has, with row 0. */
    uint32_t get_material_count() const {
        uint32_t out{};
        check(api().get_material_count(m_handle, &out));
        return out;
    }
    /** The row of a name; of several the first. 0: there is none. */
    uint32_t find_material(const char* name) const {
        uint32_t out{};
        check(api().find_material(m_handle, name, &out));
        return out;
    }
    /** Mass, gravity and damping of a body; set_body() changes the last two. */
    rubble_body_properties get_body_properties(rubble_body body) const {
        rubble_body_properties out{};
        out.struct_size = sizeof out;
        check(api().get_body_properties(m_handle, body, &out));
        return out;
    }
    /** Changes strength, density, emission, load or anchors of a shape; see rubble_shape_change. */
    void set_shape(rubble_shape_change change) {
        change.struct_size = sizeof change;
        check(api().set_shape(m_handle, &change));
    }
    /** What set_shape(), set_collision_filter() and set_collision_shape() set. */
    rubble_shape_properties get_shape_properties(rubble_shape shape) const {
        rubble_shape_properties out{};
        out.struct_size = sizeof out;
        check(api().get_shape_properties(m_handle, shape, &out));
        return out;
    }
    /** The boxes of cells that hold a static shape to the world. */
    std::vector<rubble_cell_box> get_anchors(rubble_shape shape) const {
        return rows<rubble_cell_box, uint32_t>([&](rubble_cell_box* out, uint32_t capacity, uint32_t* count) {
            return api().get_anchors(m_handle, shape, out, capacity, count);
        });
    }
    /** How many threads physics has from the next step on, with the one that calls step(): 1 to 64, as in
     * rubble_world_settings. No edit: results do not depend on it, and neither saves nor recordings keep it. */
    void set_physics_threads(uint32_t threads) {
        check(api().set_physics_threads(m_handle, threads));
    }
    /** The fire whose middle is closest to a position; of equals the first of get_fires(). max_distance: metres, 0 to
     * 1e6. None within it: RUBBLE_OK, out->shape 0. Costs what is hot. */
    rubble_fire find_closest_fire(const double (&position)[3], double max_distance) const {
        rubble_fire out{};
        check(api().find_closest_fire(m_handle, position, max_distance, &out));
        return out;
    }
    /** How many fires have their middle in a box along the world's axes. Costs what is hot. */
    uint32_t count_fires(const double (&low)[3], const double (&high)[3]) {
        uint32_t out{};
        check(api().count_fires(m_handle, low, high, &out));
        return out;
    }
    /** Makes a light group, with a handle as by create_body(): for lights, and for entries of palettes whose voxels
     * then count in it. A world keeps its groups for good. */
    rubble_light_group create_light_group(rubble_light_group_settings settings) {
        settings.struct_size = sizeof settings;
        rubble_light_group out{};
        check(api().create_light_group(m_handle, &settings, &out));
        return out;
    }
    /** Switches a light group, or says what puts it out; see rubble_light_group_change. */
    void set_light_group(rubble_light_group_change change) {
        change.struct_size = sizeof change;
        check(api().set_light_group(m_handle, &change));
    }
    /** One light group; get_objects() lists them. */
    rubble_light_group_state get_light_group(rubble_light_group group) const {
        rubble_light_group_state out{};
        out.struct_size = sizeof out;
        check(api().get_light_group(m_handle, group, &out));
        return out;
    }
    /** What get_reports() lists from the next step on, until this is called again; see rubble_report_filter. It belongs
     * to the host, not to the game: levels, saves and recordings do not have it. RUBBLE_ERROR_UNSUPPORTED: contacts,
     * water and footsteps in a world with RUBBLE_WORLD_HOST_PHYSICS, whose host knows of them. */
    void set_report_filter(rubble_report_filter filter) {
        filter.struct_size = sizeof filter;
        check(api().set_report_filter(m_handle, &filter));
    }
    /** What happened in the last step of what the host has asked for, without copying: the arrays live as long as those
     * of get_events(). It is empty after a load; see apply_deltas(). */
    rubble_reports get_reports() const {
        rubble_reports out{};
        out.struct_size = sizeof out;
        check(api().get_reports(m_handle, &out));
        return out;
    }
    /** The bricks of a shape that changed after a version, by z, then y, then x. *version becomes that of now: what the
     * host copies before the next step() is of it. From the first such call on, steps note what changes.
     * RUBBLE_ERROR_STALE: the shape is gone, or has another grid since that version: drop the copy and ask with version
     * 0. */
    std::vector<rubble_brick> get_changed_bricks(rubble_brick_changes changes, uint64_t* version) const {
        changes.struct_size = sizeof changes;
        return rows<rubble_brick, uint32_t>([&](rubble_brick* out, uint32_t capacity, uint32_t* count) {
            return api().get_changed_bricks(m_handle, &changes, version, out, capacity, count);
        });
    }
    /** The faces of a brick that are seen, as rectangles: four vertices each, RUBBLE_MAX_BRICK_VERTICES at most. Opaque
     * voxels hide the faces of opaque ones, all voxels hide those of transparent ones. The rectangles of all bricks
     * cover each such face once. Their corners may lie on edges of others (T-junctions): transform equal positions
     * alike. brick: x, y, z; of one outside the grid, and of an empty one, there are none. */
    std::vector<rubble_mesh_vertex> mesh_brick(rubble_shape shape, const int32_t (&brick)[3]) {
        return rows<rubble_mesh_vertex, uint32_t>([&](rubble_mesh_vertex* out, uint32_t capacity, uint32_t* count) {
            return api().mesh_brick(m_handle, shape, brick, out, capacity, count);
        });
    }
    /** Copies palette indices and paint of bricks of a shape, RUBBLE_BRICK_BYTES each, in the order of `bricks`, whose
     * is_empty is not read. All are 0 where there is no brick. `capacity` is in bytes; *count becomes the number of
     * bytes. Capacity 0 asks for that alone; fewer: RUBBLE_ERROR_CAPACITY, and nothing is written. */
    std::vector<uint8_t> read_bricks(rubble_shape shape, const rubble_brick* bricks, uint32_t brick_count) const {
        return rows<uint8_t, uint64_t>([&](uint8_t* out, uint64_t capacity, uint64_t* count) {
            return api().read_bricks(m_handle, shape, bricks, brick_count, out, capacity, count);
        });
    }
    /** The bricks of the shadow volume that changed after a version, by z, then y, then x; 0: all with cells. *version
     * becomes that of now, which may be some steps behind; see rubble_step_stats.shadow_lag. RUBBLE_ERROR_STALE: all
     * has been replaced since that version, as by a level: drop the copy and ask with 0. RUBBLE_ERROR_ARGUMENT: the
     * world was created without RUBBLE_WORLD_SHADOW_DATA. */
    std::vector<rubble_shadow_brick> get_shadow_bricks(uint64_t since, uint64_t* version) const {
        return rows<rubble_shadow_brick, uint32_t>([&](rubble_shadow_brick* out, uint32_t capacity, uint32_t* count) {
            return api().get_shadow_bricks(m_handle, since, version, out, capacity, count);
        });
    }
    /** Throws particles into the air at once; they move from the next step on. They are only drawn: recordings and
     * saves do not have them. RUBBLE_ERROR_ARGUMENT, here and below: the world was created with
     * RUBBLE_WORLD_NO_RENDERER and without RUBBLE_WORLD_PARTICLES. */
    void spawn_particles(rubble_particle_burst burst) {
        burst.struct_size = sizeof burst;
        check(api().spawn_particles(m_handle, &burst));
    }
    /** All that is in the air, the oldest first: dust, smoke, flames and what the host has added. A load takes all of
     * it away, and so does the step of an undo() or redo(). */
    std::vector<rubble_particle> get_particles() const {
        return rows<rubble_particle, uint32_t>([&](rubble_particle* out, uint32_t capacity, uint32_t* count) {
            return api().get_particles(m_handle, out, capacity, count);
        });
    }
    /** The points of all ropes, one rope after the other, for hosts that draw them. */
    std::vector<rubble_rope_point> get_ropes() const {
        return rows<rubble_rope_point, uint32_t>([&](rubble_rope_point* out, uint32_t capacity, uint32_t* count) {
            return api().get_ropes(m_handle, out, capacity, count);
        });
    }
    /** One shape: where a piece is that get_events() has named. */
    rubble_shape_state get_shape_state(rubble_shape shape) const {
        rubble_shape_state out{};
        check(api().get_shape_state(m_handle, shape, &out));
        return out;
    }
    /** One character. */
    rubble_character_state get_character_state(rubble_character character) const {
        rubble_character_state out{};
        check(api().get_character_state(m_handle, character, &out));
        return out;
    }
    /** A hash of what RUBBLE_DELTAS_EDITS keep equal: voxels, their palettes and paint, and light groups. Poses are not
     * in it: it is the same on every machine. */
    uint64_t get_voxel_hash() const {
        uint64_t out{};
        check(api().get_voxel_hash(m_handle, &out));
        return out;
    }
    /** How many voxels that carve() would remove from the world as the last step left it. Nothing is queued, and edits
     * that wait are not counted; nor is what would come off and is too small to be a piece. Costs what the carve costs.
     * */
    uint64_t count_carve(rubble_carve carve) {
        carve.struct_size = sizeof carve;
        uint64_t out{};
        check(api().count_carve(m_handle, &carve, &out));
        return out;
    }
    /** Holds the velocity of a body in the next step; see rubble_body_constraint. Wakes both bodies. */
    void constrain_bodies(rubble_body_constraint constraint) {
        constraint.struct_size = sizeof constraint;
        check(api().constrain_bodies(m_handle, &constraint));
    }
    /** One joint. */
    rubble_joint_state get_joint_state(rubble_joint joint) const {
        rubble_joint_state out{};
        check(api().get_joint_state(m_handle, joint, &out));
        return out;
    }
    /** Limits, motor and spring of a joint, and where its free motion is. */
    rubble_joint_properties get_joint_properties(rubble_joint joint) const {
        rubble_joint_properties out{};
        out.struct_size = sizeof out;
        check(api().get_joint_properties(m_handle, joint, &out));
        return out;
    }
    /** The named places of the level. Saves keep them. */
    std::vector<rubble_location> get_locations() const {
        return rows<rubble_location, uint32_t>([&](rubble_location* out, uint32_t capacity, uint32_t* count) {
            return api().get_locations(m_handle, out, capacity, count);
        });
    }
    /** The scripts of the level, then those of the prefabs that were placed, as the last step left them. Saves keep
     * them. */
    std::vector<rubble_level_script> get_level_scripts() const {
        return rows<rubble_level_script, uint32_t>([&](rubble_level_script* out, uint32_t capacity, uint32_t* count) {
            return api().get_level_scripts(m_handle, out, capacity, count);
        });
    }
    /** Keeps bytes under a name with the game, at once: saves have them, and the start of a recording. They are no part
     * of the state hash. name: UTF-8, 1 to 4096 bytes. size: at most 16 MiB; 0: forgets them. A level that is loaded
     * forgets all. RUBBLE_ERROR_CAPACITY: there are 1000 other names already. */
    void set_host_data(const char* name, const uint8_t* data, uint64_t size) {
        check(api().set_host_data(m_handle, name, data, size));
    }
    /** Copies such bytes. *count becomes their number, 0 where there are none. Capacity 0 asks for that alone; fewer:
     * RUBBLE_ERROR_CAPACITY, and nothing is written. */
    std::vector<uint8_t> get_host_data(const char* name) const {
        return rows<uint8_t, uint64_t>([&](uint8_t* out, uint64_t capacity, uint64_t* count) {
            return api().get_host_data(m_handle, name, out, capacity, count);
        });
    }
    /** Carries out the edits that wait and nothing else, as a step() in which no time passes: nothing moves, comes off,
     * burns or breaks under load, and no dust rises; particles stay where they are. What is made counts as brought by
     * the level, what is taken as never there: parts that touch nothing stay until a later step() cuts their shape, and
     * no light group begins to fail. The next step() begins with physics rebuilt from the world, as of a loaded game.
     * What impacts of the step before break waits for it. get_reports() is empty after apply_edits().
     * RUBBLE_ERROR_ARGUMENT: a recording runs. */
    void apply_edits() {
        check(api().apply_edits(m_handle));
    }
    /** Writes the world as the last step left it as a level, whole or not at all: a .rubble, .vdb or .vox file, as the
     * ending of the UTF-8 path says. vdb_tool: as in load_level(). Names and tags are those that edits have given; what
     * joints, lights and light groups need to find each other gets a name. Left out are settings, fires, the motion of
     * ropes, user values, and what the host keeps with the game. A .vox file holds shapes with one palette; what else
     * it leaves out is logged as warnings. RUBBLE_ERROR_FILE: it cannot be written. */
    void save_level(const char* path, const char* vdb_tool = nullptr) {
        check(api().save_level(m_handle, path, vdb_tool));
    }
    /** Whether steps have changed the world since its last undo mark, undo or redo: 1 if get_resolved_hash() is another
     * one than it was then, else 0. Costs the objects that changed since. RUBBLE_ERROR_ARGUMENT: no marks are kept; see
     * set_undo_limit(). */
    uint32_t has_changed() {
        uint32_t out{};
        check(api().has_changed(m_handle, &out));
        return out;
    }
    /** Names the scripts of the level, in place of those that get_level_scripts() lists: a command for the next step,
     * as edits are. Levels, saves, deltas and undo have them. Texts are copied; `parameters` may be null. count: at
     * most 10,000; 0: the level names none. A path has 1 to 4096 bytes, parameters at most 65,536. */
    void set_level_scripts(const rubble_level_script* scripts, uint32_t count) {
        check(api().set_level_scripts(m_handle, scripts, count));
    }
    /** A hash of what save_level() writes of the world: one that is written and loaded has the same. Costs a pass over
     * the objects of the world. */
    uint64_t get_level_hash() const {
        uint64_t out{};
        check(api().get_level_hash(m_handle, &out));
        return out;
    }
private:
    void release() noexcept {
        if (m_handle) api().destroy_world(std::exchange(m_handle, 0));
    }
    rubble_world m_handle = 0;
};

/** The renderer of a world; its GL context is current wherever it is used and destroyed. Moves, but is not copied. */
class Renderer {
public:
    explicit Renderer(const World& world, rubble_renderer_settings settings = {}) {
        settings.struct_size = sizeof settings;
        check(api().create_renderer(world.handle(), &settings, &m_handle));
    }
    ~Renderer() { release(); }
    Renderer(Renderer&& other) noexcept : m_handle(std::exchange(other.m_handle, 0)) {}
    Renderer& operator=(Renderer&& other) noexcept {
        if (this != &other) release(), m_handle = std::exchange(other.m_handle, 0);
        return *this;
    }
    /** Its handle, for calls of rubble.h. */
    rubble_renderer handle() const noexcept { return m_handle; }

    /** Draws the world as the last step() left it. RUBBLE_ERROR_GL: nothing was drawn. RUBBLE_ERROR_STALE: the world
     * was destroyed. */
    void draw(rubble_view view) {
        view.struct_size = sizeof view;
        check(api().draw(m_handle, &view));
    }
    /** Makes draw() show an intermediate image ("albedo", "normal", "depth", ...), for debugging. Null or "final": the
     * finished frame. RUBBLE_ERROR_ARGUMENT lists the names that there are. */
    void set_debug_view(const char* name) {
        check(api().set_debug_view(m_handle, name));
    }
    /** Counters and times of the last draw(). */
    rubble_draw_stats get_draw_stats() const {
        rubble_draw_stats out{};
        out.struct_size = sizeof out;
        check(api().get_draw_stats(m_handle, &out));
        return out;
    }
    /** What draw() draws over the image from now on, in this order; count 0: nothing, which costs nothing. The items
     * are copied. All have the struct_size of the first one; 65536 at most. The first draw() with an overlay builds its
     * program. RUBBLE_ERROR_FILE: a font cannot be read. RUBBLE_ERROR_ARGUMENT: an image is not there, among others.
     * Then the items are as before. */
    void set_overlay(std::vector<rubble_overlay_item> items) {
        for (rubble_overlay_item& row : items) row.struct_size = sizeof row;
        check(api().set_overlay(m_handle, items.data(), uint32_t(items.size())));
    }
    /** Gives an image a name for items, or replaces it. The pixels are copied. RUBBLE_ERROR_CAPACITY: there would be
     * more than 4096 images of this renderer, or more than 1 GiB of pixels. */
    void set_overlay_image(rubble_overlay_image image) {
        image.struct_size = sizeof image;
        check(api().set_overlay_image(m_handle, &image));
    }
private:
    void release() noexcept {
        if (m_handle) api().destroy_renderer(std::exchange(m_handle, 0));
    }
    rubble_renderer m_handle = 0;
};

}  // namespace wrapper
}  // namespace rubble

#endif
