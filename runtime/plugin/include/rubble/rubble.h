/* Rubble: destructible voxel worlds behind a C interface (C99, C++, and every language that can call C).
 *
 * A world is made of bodies; a body is a rigid frame that carries shapes; a shape is a grid of voxels. The host
 * queues edits (carve, explode, paint, ...), calls step() sixty times a second, reads what happened from
 * get_events(), and may draw the world with the renderer or read poses and voxel counts and draw it itself. A
 * complete host:
 *
 *     #include <rubble/rubble.h>
 *     #include <stdio.h>
 *
 *     int main(void) {
 *         const rubble_api* api;
 *         rubble_world world;
 *         rubble_body_settings body = {.struct_size = sizeof body, .flags = RUBBLE_BODY_STATIC};
 *         rubble_shape_settings wall = {.struct_size = sizeof wall, .source = RUBBLE_SHAPE_BOX, .size = {40, 25, 3}};
 *         rubble_explosion explosion = {.struct_size = sizeof explosion, .position = {2, 1, 0}};
 *         rubble_events events = {.struct_size = sizeof events};
 *         rubble_shape shape;
 *         if (rubble_get_api(RUBBLE_VERSION, &api) != RUBBLE_OK) return 1;
 *         if (api->create_world(NULL, &world) != RUBBLE_OK) return 1;
 *         api->create_body(world, &body, &wall.body); // or load_level(world, "model.vox", NULL)
 *         wall.index = 7;                             // brick
 *         if (api->create_shape(world, &wall, &shape) != RUBBLE_OK) puts(api->get_last_error());
 *         api->explode(world, &explosion);
 *         for (int i = 0; i < 600; ++i) {
 *             api->step(world);
 *             api->get_events(world, &events);
 *             if (events.split_count) printf("step %d: %u pieces came off\n", i, (unsigned)events.split_count);
 *         }
 *         api->destroy_world(world);
 *         return 0;
 *     }
 *
 * Rules that hold for every function and struct:
 *
 *  - Units and spaces: metres, kilograms, seconds, radians, newtons. The world is right-handed with y up. World
 *    positions are doubles. Rotations are unit quaternions x, y, z, w; all zeros means no rotation. Lengths of vectors
 *    are in the unit of the field; a "direction" may have any length but zero. Components of vectors are at most 1e9.
 *    A free body that is more than 1,000 km from the middle of the level, or from 0 without one, is frozen there.
 *    Colours of voxels are sRGB bytes, colours of light are linear.
 *  - Structs: a struct that begins with `struct_size` is filled in by the host: struct_size = sizeof(the struct), every
 *    other field zero or set. Zero selects the default that the comment names. Such structs may grow at their end in
 *    later versions: a field that the host's rubble.h does not have is as if it were zero, and one that this plugin
 *    does not know must be zero. Fields named `reserved` must be zero.
 *  - Rows of arrays have no struct_size. They may grow at their end as well: functions with an array write and read
 *    rows of the size that they had in the first version, unless the host says how large its rows are (read_rows(),
 *    rubble_query_filter).
 *  - The function table may grow at its end: function f exists if api->struct_size > offsetof(rubble_api, f).
 *  - Handles are 64-bit values, not pointers. 0 names nothing. A handle of something that was destroyed is recognised
 *    and answered with RUBBLE_ERROR_STALE; it is never followed.
 *  - Errors: a result other than RUBBLE_OK means that the call had no effect, but for lists that are longer than the
 *    array (see below) and where a function says otherwise. get_last_error() says in words what was expected and what
 *    was found. Numbers that are not finite or out of range are RUBBLE_ERROR_ARGUMENT; the errors named at a function
 *    come on top of RUBBLE_ERROR_NULL, _STRUCT_SIZE, _STALE, _ARGUMENT, _BUSY, _BROKEN and _MEMORY, which most
 *    functions can give. RUBBLE_ERROR_MEMORY of those that work on a world as a whole leaves it half done, and broken:
 *    step(), what loads a level or game or plays a recording, apply_deltas(), set_body_states() and report_impacts().
 *    Where the shadow volume runs out of memory, the log says so, and shadows stay as they are.
 *  - Edits are commands: the call checks them and puts them into the world's queue. The next step() carries them out in
 *    the order of the calls, those of undo before all others. An edit whose object is destroyed before its turn does
 *    nothing, and what only step() can find out (a joint without a voxel to hold on to, an undo where no marks are
 *    kept) is logged.
 *  - What a call makes (create_body() and its like) has its handle at once: later edits may name it, so that a chain of
 *    calls needs no step() in between. Reads find it after the next step(). If that could not make it, the handle names
 *    nothing, and get_refusals() says why; so do handles that wait when a level or game is loaded.
 *  - Reads copy into the host's memory, except get_events() and get_reports(): their arrays live until the next step(),
 *    load_level(), load_game(), play_recording() or destroy_world() of that world.
 *  - Lists are read with an array, its capacity and a count: the function writes the first `capacity` rows and stores
 *    the number of all rows in *count. More rows than capacity: RUBBLE_ERROR_CAPACITY. Capacity 0 asks for the count
 *    alone: the array may be null and the result is RUBBLE_OK.
 *  - Threads: [main-thread] functions of one world are called by one thread at a time; different worlds may be stepped
 *    at the same time. [render-thread] functions are called by the thread that has the GL context current, one at a
 *    time; they may run beside the main thread. [any-thread] functions may be called from everywhere. A call for a
 *    world or a renderer that is in another call, of another thread or around a log callback, has no effect:
 *    RUBBLE_ERROR_BUSY. Destroy a world only while its renderer is not drawing.
 *  - Determinism: the same level, edits and number of steps give the same state bit for bit with the same build of the
 *    plugin; get_state_hash() compares. Frame times, threads and the renderer have no influence.
 *  - The plugin opens no window, makes no GL context, opens no file that the host did not name (a file that it writes
 *    has a temporary neighbour while it is written, that of a recording is PATH.part; a .vdb level is baked in a folder
 *    of $TMPDIR meanwhile), and restores the GL state that it changes (or resets it: RUBBLE_RENDERER_RESET_STATE).
 *
 * Not included: network, sound, input, textured triangles, use of the host's allocator. */
#ifndef RUBBLE_RUBBLE_H
#define RUBBLE_RUBBLE_H
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this interface. Ask for it in rubble_get_api(). */
#define RUBBLE_VERSION 1u

#if defined(_WIN32) && defined(RUBBLE_BUILDS_LIBRARY)
#define RUBBLE_EXPORT __declspec(dllexport)
#elif defined(_WIN32)
#define RUBBLE_EXPORT __declspec(dllimport)
#else
#define RUBBLE_EXPORT __attribute__((visibility("default")))
#endif

/* Handles. A handle belongs to the world that gave it: another world answers it with RUBBLE_ERROR_STALE. */
typedef uint64_t rubble_world;    /* all that one level holds; its objects know no other world */
typedef uint64_t rubble_renderer; /* draws one world */
typedef uint64_t rubble_body;     /* a rigid body, static or dynamic: a frame that shapes are fixed to */
typedef uint64_t rubble_shape;    /* a grid of voxels on a body */
typedef uint64_t rubble_joint;    /* connects two shapes, or a shape and the world */
typedef uint64_t rubble_light;    /* a light source, fixed to a shape or to the world */
/* lights and glowing voxels that go out together when enough of them is destroyed */
typedef uint64_t rubble_light_group;
typedef uint64_t rubble_water;     /* a volume of water with a level surface */
typedef uint64_t rubble_trigger;   /* a region that reports the bodies that enter and leave it */
typedef uint64_t rubble_character; /* a walking capsule */

/* What a call came to. */
typedef int32_t rubble_result;
enum {
    RUBBLE_OK = 0,
    RUBBLE_ERROR_NULL = 1,    /* a pointer that must not be null is null */
    RUBBLE_ERROR_VERSION = 2, /* the plugin does not implement the version asked for */
    /* struct_size is smaller than in version 1, or a field that the plugin does not know is set */
    RUBBLE_ERROR_STRUCT_SIZE = 3,
    RUBBLE_ERROR_STALE = 4,    /* the handle is 0, destroyed, of another type or of another world */
    RUBBLE_ERROR_ARGUMENT = 5, /* a value is out of range */
    /* the array is too short: *count says how long it must be; or there are 255 worlds already */
    RUBBLE_ERROR_CAPACITY = 6,
    RUBBLE_ERROR_FILE = 7,      /* the file is missing, damaged, of an unknown kind, or cannot be written */
    RUBBLE_ERROR_GL = 8,        /* OpenGL lacks something, the context was lost, or a shader does not compile */
    RUBBLE_ERROR_MEMORY = 9,    /* out of memory */
    RUBBLE_ERROR_INTERNAL = 10, /* a bug of the plugin: please report the text of get_last_error() */
    /* the world or renderer is in another call: of another thread, or around a callback */
    RUBBLE_ERROR_BUSY = 11,
    /* a bug of the plugin, or RUBBLE_ERROR_MEMORY, has left the world or renderer in no defined state: destroy it */
    RUBBLE_ERROR_BROKEN = 12,
    /* this library lacks the layer that does it, see get_layers(); or the host's physics does it in this world */
    RUBBLE_ERROR_UNSUPPORTED = 13,
    RUBBLE_ERROR_THREAD = 14 /* a call from another thread than that of the world; see RUBBLE_WORLD_ONE_THREAD */
};

/* ---- host and worlds ---- */

enum { RUBBLE_LOG_INFO = 0, RUBBLE_LOG_WARNING = 1, RUBBLE_LOG_ERROR = 2 };

/* What the host does for the plugin, for the whole process; see set_host(). */
typedef struct rubble_host {
    uint32_t struct_size;
    uint32_t reserved;
    void* user; /* passed to the functions below */
    /* Receives messages of level RUBBLE_LOG_..., UTF-8, without a line break. Called from any thread, one message
     * at a time. Null: messages go to standard error, as do those that a call from the callback logs. It may call all
     * functions, set_host() too, but none for the world or renderer whose call has logged: RUBBLE_ERROR_BUSY. */
    void (*log)(void* user, int32_t level, const char* message);
    /* Returns the address of a GL function in the current context, as SDL_GL_GetProcAddress and its like do.
     * Null: no renderer can be created. */
    void* (*gl_get_proc_address)(const char* name);
    /* Hears of a bug that an assert of the plugin has found: "FILE:LINE: assertion failed: CONDITION". Called on the
     * thread where it failed, before the call returns RUBBLE_ERROR_BROKEN: the place for a breakpoint or a report. It
     * may call nothing of the plugin. Null: nothing is called. The process goes on either way. */
    void (*assertion_failed)(void* user, const char* message);
    /* Files of the host, as in an archive or in memory, by the paths that calls name; called from any thread. The bytes
     * of a file that is read; RUBBLE_FILE_ON_DISK: the host does not have it. Null: it has none. Files for rubble-vdb,
     * .vdb levels, are on the disk. */
    uint64_t (*file_size)(void* user, const char* path);
    /* Reads a whole file into `out`; 0: it cannot, which is RUBBLE_ERROR_FILE. Null only if file_size is. */
    int32_t (*read_file)(void* user, const char* path, void* out, uint64_t size);
    /* Writes a whole file; above 0: done, 0: it cannot, below 0: it belongs on the disk. A recording is kept in memory
     * until then. Null: all belong there. */
    int32_t (*write_file)(void* user, const char* path, const void* bytes, uint64_t size);
} rubble_host;

#define RUBBLE_FILE_ON_DISK UINT64_MAX

enum {
    /* for servers and for hosts that draw themselves: nothing is prepared for a renderer */
    RUBBLE_WORLD_NO_RENDERER = 1,
    /* step() updates the shadow volume itself; without the flag a thread of the world does */
    RUBBLE_WORLD_SHADOW_INLINE = 2,
    /* step() waits for the shadow volume: frames do not depend on the timing of threads */
    RUBBLE_WORLD_WAIT_FOR_SHADOW = 4,
    /* the host's own physics moves the bodies; see rubble_rigid_body */
    RUBBLE_WORLD_HOST_PHYSICS = 8,
    /* for tests of a host: a [main-thread] call from another thread than that of create_world() is refused
     * (RUBBLE_ERROR_THREAD), also if the two do not meet */
    RUBBLE_WORLD_ONE_THREAD = 16,
    /* keeps the shadow volume for get_shadow_bricks(), also with RUBBLE_WORLD_NO_RENDERER */
    RUBBLE_WORLD_SHADOW_DATA = 32,
    /* moves particles for get_particles(), also with RUBBLE_WORLD_NO_RENDERER */
    RUBBLE_WORLD_PARTICLES = 64
};

typedef struct rubble_world_settings {
    uint32_t struct_size;
    uint32_t flags;           /* RUBBLE_WORLD_... */
    uint32_t physics_threads; /* with the one that calls step(), 1 to 64; 0: 1. Results do not depend on it */
    uint32_t reserved;
    void* user; /* passed to the functions below, which are this world's: null ones are those of rubble_host */
    /* As rubble_host.log, for what the calls of this world say. What its threads say goes to rubble_host. */
    void (*log)(void* user, int32_t level, const char* message);
    /* As rubble_host.assertion_failed, for the calls of this world. */
    void (*assertion_failed)(void* user, const char* message);
    /* Calls job(context, i) once for each i below count, in any order, on any threads, and returns when all have
     * returned: the host's job system, in place of physics_threads. Results do not depend on it. One that leaves calls
     * out breaks the world. */
    void (*parallel_for)(void* user, uint32_t count, void (*job)(void* context, uint32_t index), void* context);
} rubble_world_settings;

/* Where the world ends. A free body that has left the box with all of its voxels is removed in the next step, and its
 * voxels become dust (RUBBLE_BOUNDS_DUST), or it goes on (RUBBLE_BOUNDS_KEEP). RUBBLE_BOUNDS_GROUND is as DUST, and the
 * fields that are drawn around a level, at a height of -0.05 m, are solid within the box: bodies, ropes and characters
 * rest on them. Below the level, the box around all static shapes wherever a step has left them, the ground lies at its
 * lowest point. It is a slab, a metre thick, or as the level reaches below its surface, or as a 32nd of the box's width
 * or depth, whichever is most; below it is air. Casts of rays and shapes, and closest points, find it as a static shape
 * of layer 1, but with shape, body and palette index 0; queries of overlaps have no shape to name. */
enum { RUBBLE_BOUNDS_DUST = 0, RUBBLE_BOUNDS_KEEP = 1, RUBBLE_BOUNDS_GROUND = 2 };
typedef struct rubble_bounds {
    uint32_t struct_size;
    uint32_t rule; /* RUBBLE_BOUNDS_... */
    /* metres; all equal: the box of the level. If it has none, with a margin around all shapes that it brought or that
     * were created since, where that step left them; static ones also wherever a later step, and all wherever
     * apply_edits() has put them */
    double low[3], high[3];
} rubble_bounds;

/* ---- edits of voxels ---- */

enum { RUBBLE_BRUSH_SPHERE = 0, RUBBLE_BRUSH_BOX = 1, RUBBLE_BRUSH_CAPSULE = 2 };
/* Each material says which tools break it. RUBBLE_TOOL_ANY breaks everything but unbreakable materials. */
enum {
    RUBBLE_TOOL_ANY = 0,
    RUBBLE_TOOL_SLEDGE = 1,
    RUBBLE_TOOL_TORCH = 2,
    RUBBLE_TOOL_GUN = 3,
    RUBBLE_TOOL_EXPLOSIVE = 4
};
/* Hardness classes of materials. RUBBLE_HARDNESS_DEFAULT stands for RUBBLE_HARDNESS_HARD. */
enum {
    RUBBLE_HARDNESS_DEFAULT = 0,
    RUBBLE_HARDNESS_SOFT = 1,
    RUBBLE_HARDNESS_MEDIUM = 2,
    RUBBLE_HARDNESS_HARD = 3,
    RUBBLE_HARDNESS_UNBREAKABLE = 4, /* of materials alone: nothing removes it */
    RUBBLE_HARDNESS_UNPHYSICAL = 5   /* of materials alone: it is seen; nothing breaks it or touches it */
};

/* Removes the voxels inside a brush, depending on the hardness of their material. Positions are in the world. */
typedef struct rubble_carve {
    uint32_t struct_size;
    uint32_t brush;      /* RUBBLE_BRUSH_... */
    double position[3];  /* sphere and box: centre; capsule: one end of its axis */
    double end[3];       /* capsule: the other end of its axis */
    double half_size[3]; /* box: metres, above 0, at most 100 */
    double rotation[4];  /* box */
    /* sphere, capsule: metres, for soft, medium and hard materials; 0.001 to 100, none larger than the one before; 0:
     * spares that class, but the first must be above 0 */
    double radii[3];
    uint32_t max_hardness; /* box: the hardest class that it removes, RUBBLE_HARDNESS_...; 0: hard */
    uint32_t tool;         /* RUBBLE_TOOL_... */
    rubble_shape shape;    /* carves this shape only; 0: all shapes */
} rubble_carve;

/* Breaks what lies in a sphere out of its shapes, as fragments and dust in the style of each material. Panes of
 * glass break as a whole. */
typedef struct rubble_break {
    uint32_t struct_size;
    uint32_t tool;      /* RUBBLE_TOOL_... */
    double position[3]; /* centre, world */
    double radii[3];    /* metres, for soft, medium and hard materials; ranges as in rubble_carve */
    uint32_t seed;      /* selects the pattern of cracks */
    uint32_t reserved;
    rubble_shape shape; /* breaks this shape only; 0: all shapes */
} rubble_break;

/* Breaks what lies in a sphere and gives the bodies around it, up to 2.5 times size metres, an impulse away from its
 * centre, which falls to 0 with the distance: to the body's centre of mass, of a large body to 0.3 m inside the nearest
 * side of the boxes around its grids. What still stands between the centre and a body shelters it: of a large body the
 * part that the centre sees counts. Nothing shelters from what breaks, and what stands within 0.4 times size metres
 * shelters nothing. */
typedef struct rubble_explosion {
    uint32_t struct_size;
    uint32_t reserved;
    double position[3]; /* centre, world */
    /* 0.5 to 4; 0: 1. Breaks soft, medium and hard voxels within 1.0, 0.7 and 0.4 times size metres; materials that
     * tear, as metal does, within somewhat more than half of that, and panes beyond it; carve() takes a whole sphere */
    double size;
    double impulse; /* N s at distance 0, 0: follows from size. No body gets faster than 9 m/s times size */
} rubble_explosion;

/* Blends the colours of surface voxels toward a paint, a part of the difference each call. Materials do not
 * change. */
typedef struct rubble_paint {
    uint32_t struct_size;
    uint8_t color[4];   /* sRGB red, green, blue; the fourth byte is not read */
    double position[3]; /* centre, world */
    double radius;      /* metres, 0.001 to 10; 0: 0.5 */
    uint32_t strength;  /* part of the difference of colour that one call removes, in 255ths: 1 to 255; 0: 64 */
    /* part of the voxels painted at the rim, in 255ths: 1 to 255; 0: 255. The centre is always painted */
    uint32_t probability;
    uint32_t seed; /* selects which voxels those are */
    uint32_t reserved;
} rubble_paint;

/* Pushes a body. */
typedef struct rubble_impulse {
    uint32_t struct_size;
    uint32_t reserved;
    rubble_body body;
    double position[3]; /* world: where it acts */
    double impulse[3];  /* N s, world */
} rubble_impulse;

/* ---- edits of bodies ---- */

enum {
    RUBBLE_SET_POSE = 1,     /* position and rotation */
    RUBBLE_SET_VELOCITY = 2, /* velocity and angular_velocity; of a dynamic body */
    RUBBLE_SET_ASLEEP = 4,   /* stops and sleeps until something wakes it; of a dynamic body */
    RUBBLE_SET_AWAKE = 8,    /* any other change wakes it too; of a dynamic body */
    /* it stands still where it is, or where the same call places it: what holds its shapes to the world is as in
     * create_shape() */
    RUBBLE_SET_STATIC = 16,
    RUBBLE_SET_DYNAMIC = 32, /* it moves freely, as all in one: nothing holds it any more */
    RUBBLE_SET_GRAVITY_SCALE = 64,
    RUBBLE_SET_DAMPING = 128 /* linear_damping and angular_damping */
};

/* Changes where a body is and how it moves. Nothing that it meets on the way holds it back. A static body has no
 * velocity while it is moved: what stands on one that goes up by more than 0.1 m/s sinks in. A lift is a free body, see
 * constrain_bodies(). */
typedef struct rubble_body_change {
    uint32_t struct_size;
    uint32_t fields; /* RUBBLE_SET_...: what changes; the other values are not read */
    rubble_body body;
    double position[3]; /* of its frame, world */
    double rotation[4];
    double velocity[3];         /* m/s, of the centre of mass */
    double angular_velocity[3]; /* rad/s, world axes */
    double gravity_scale;       /* multiple of the world's gravity that acts on it, -100 to 100. Pieces inherit it */
    double linear_damping;      /* 1/s, 0 to 1000: the rate at which its velocity decays. Pieces inherit it */
    double angular_damping;     /* 1/s: the same of its angular velocity */
} rubble_body_change;

/* What a body weighs and how it moves, as get_body_properties() gives it. */
typedef struct rubble_body_properties {
    uint32_t struct_size;
    uint32_t is_broken; /* 1: it has lost voxels, and no undo gave them back */
    double mass;        /* kg; physics moves it as one of 1e-9 to 1e12 kg */
    double center[3];   /* of mass, in the body's frame */
    double inertia[6];  /* kg m2 about the centre, in the axes of the body's frame: xx, yy, zz, xy, yz, xz */
    double gravity_scale, linear_damping, angular_damping; /* as in rubble_body_change */
} rubble_body_properties;

/* ---- making things ---- */

/* A body that create_body() makes. */
typedef struct rubble_body_settings {
    uint32_t struct_size;
    uint32_t flags;             /* RUBBLE_BODY_STATIC, or RUBBLE_BODY_ASLEEP; 0: a free body that is awake */
    double position[3];         /* of its frame, world */
    double rotation[4];         /* of its frame */
    double velocity[3];         /* m/s, of the centre of mass; 0 of a body that is static or asleep */
    double angular_velocity[3]; /* rad/s, world axes; the same */
} rubble_body_settings;

/* Cells in a row that hold the same. */
typedef struct rubble_voxel_run {
    uint32_t cells;
    uint32_t index; /* of the palette, 1 to 255; 0: no voxel */
} rubble_voxel_run;

/* Where the voxels of a shape come from. */
enum {
    RUBBLE_SHAPE_EMPTY = 0,   /* none: write_voxels() must bring some before the step */
    RUBBLE_SHAPE_BOX = 1,     /* in each cell `index` */
    RUBBLE_SHAPE_SPHERE = 2,  /* `index` in the cells of a ball in the middle that is as large as fits; an ellipsoid, if
                                 the sides are not equally long */
    RUBBLE_SHAPE_INDICES = 3, /* `indices` */
    RUBBLE_SHAPE_RUNS = 4,    /* `runs`; cells behind the last have no voxel */
    RUBBLE_SHAPE_COPY = 5     /* of `copied` as it is when the step carries this out: size, voxels, palette, paint and
                                 properties */
};

/* A shape that create_shape() makes. */
typedef struct rubble_shape_settings {
    uint32_t struct_size;
    uint32_t source;              /* RUBBLE_SHAPE_... */
    rubble_body body;             /* that it is fixed to */
    double position[3];           /* of the minimum corner of its grid, in metres of the body's frame */
    double rotation[4];           /* of its grid's axes, in the body's frame */
    double voxel_size;            /* metres, 0.001 to 1000; 0: 0.1, or that of the copied shape */
    int32_t size[3];              /* of the grid, in cells: 1 to 4096 each, and 2^30 in all of a box, sphere or runs */
    uint32_t index;               /* box and sphere: of the palette, 1 to 255; 0: 1 */
    const uint8_t* indices;       /* a byte each cell, as read_voxels() gives them; copied by the call */
    const rubble_voxel_run* runs; /* in the same order; copied by the call */
    uint64_t count;               /* of `indices` or `runs` */
    rubble_shape copied;
    /* whose palette it shares. 0: that of the copied shape, or else one whose entry i is white and opaque, of material
     * i of the world, but for 1 and 15, which change places: 1 generic, 2 foliage, 3 dirt, 4 rock, 5 wood, 6 concrete,
     * 7 brick, 8 plaster, 9 metal, 10 heavy metal, 11 plastic, 12 hard metal, 13 hard masonry, 14 ice, 15 glass,
     * 17 snow, 18 wire, 19 rubber and all behind, unless a level has brought other materials; set_palette() */
    rubble_shape palette_of;
} rubble_shape_settings;

/* What create_prefab() places: a level from a file, or from memory. Left out are what load_level() leaves out, and its
 * sky, light groups, waters, triggers, characters and named places. Its materials are those of the world that have the
 * same names; free bodies are awake. */
typedef struct rubble_prefab {
    uint32_t struct_size;
    uint32_t reserved;
    const char* path;     /* .rubble, .vox or .vdb; null: `data` */
    const char* vdb_tool; /* for .vdb: as in load_level() */
    /* a .rubble or .vox file in memory; not read after the call. The world keeps what it has made of such files, here
     * and from `path`, up to 64 MiB: of the same bytes again nothing is made */
    const void* data;
    uint64_t size;      /* bytes of `data` */
    double position[3]; /* of the level's origin, world */
    double rotation[4]; /* of the level's axes */
} rubble_prefab;

/* A row of create_prefab(). */
typedef struct rubble_prefab_row {
    uint64_t handle; /* rubble_body, rubble_shape, rubble_joint or rubble_light, as `kind` says */
    uint32_t kind;   /* RUBBLE_PREFAB_... */
    uint32_t owner;  /* of a shape: the row of its body; else 0 */
} rubble_prefab_row;

enum { RUBBLE_PREFAB_BODY = 0, RUBBLE_PREFAB_SHAPE = 1, RUBBLE_PREFAB_JOINT = 2, RUBBLE_PREFAB_LIGHT = 3 };

/* A row of get_refusals(). */
typedef struct rubble_refusal {
    uint64_t handle;    /* as the call gave it; it names nothing and never will */
    const char* reason; /* the function, what was expected, what was found: UTF-8; lives as long as events */
} rubble_refusal;

/* ---- edits and reads of whole shapes ---- */

/* Gives a shape's grid another box of cells; voxels outside are removed, and its fires go out. Its present cells keep
 * their places in the world. */
typedef struct rubble_resize {
    uint32_t struct_size;
    uint32_t reserved;
    rubble_shape shape;
    int32_t low[3];  /* the first cell of the box, in present cells: -4096 to 4096 */
    int32_t size[3]; /* cells along each axis, 1 to 4096 */
} rubble_resize;

enum {
    RUBBLE_VOXEL_INDEX = 0, /* of the shape's palette, 1 to 255; 0: no voxel */
    RUBBLE_VOXEL_PAINT = 1  /* of the paint layer: colour, 1 to 15, times 16, and its strength, 0 to 15; 0: none */
};

/* Which cells read_voxels() reads, where those outside the grid are 0, and write_voxels() writes. */
typedef struct rubble_voxel_box {
    uint32_t struct_size;
    uint32_t what; /* RUBBLE_VOXEL_... */
    rubble_shape shape;
    int32_t low[3];  /* the first cell: -4096 to 4096 */
    int32_t size[3]; /* cells along each axis, 1 to 4096 */
    /* of write_voxels(): a byte each cell in the same order, 0 where the cell stays as the edits before have left it.
     * Null: all cells are written. read_voxels() does not read it */
    const uint8_t* mask;
} rubble_voxel_box;

/* ---- properties of shapes ---- */

/* A box of cells of a shape's grid, in arrays. */
typedef struct rubble_cell_box {
    int32_t low[3];  /* the first cell */
    int32_t size[3]; /* cells along each axis, 1 to 4096 */
} rubble_cell_box;

enum {
    RUBBLE_SHAPE_STRENGTH = 1,
    RUBBLE_SHAPE_DENSITY = 2,
    RUBBLE_SHAPE_EMISSION = 4,
    RUBBLE_SHAPE_LOAD = 8,     /* bears_load */
    RUBBLE_SHAPE_ANCHORS = 16, /* anchors, anchor_count */
    /* in place of it: what holds a static shape that is made, the lowest layer with a voxel, of the side of its grid
     * that faces the ground most. A free one has it from when it becomes static */
    RUBBLE_SHAPE_DEFAULT_ANCHORS = 32
};

/* Changes what a shape is beside its voxels. Pieces inherit all of it but the anchors. */
typedef struct rubble_shape_change {
    uint32_t struct_size;
    uint32_t fields; /* RUBBLE_SHAPE_...: what changes; the other values are not read */
    rubble_shape shape;
    double strength;     /* multiple of its materials' strengths under load, 1e-6 to 1e6 */
    double density;      /* multiple of its materials' densities, 0.001 to 1000 */
    double emission;     /* multiple of what its palette's entries emit, 0 to 1000 */
    uint32_t bears_load; /* 0: neither weight nor impacts break it; 1: they do, if the settings say so */
    /* boxes of `anchors`, at most 10000, each of which reaches into the grid: what of a static shape none of them
     * holds comes off in the same step; 0: all of it */
    uint32_t anchor_count;
    const rubble_cell_box* anchors; /* copied by the call */
} rubble_shape_change;

/* What a shape is beside its voxels, as get_shape_properties() gives it. */
typedef struct rubble_shape_properties {
    uint32_t struct_size;
    uint32_t bears_load;
    double strength, density, emission; /* as in rubble_shape_change */
    uint32_t collision_layer;           /* bits, see rubble_collision_filter */
    uint32_t collision_mask;            /* bits */
    uint32_t collision_shape;           /* RUBBLE_COLLISION_VOXELS ... */
    uint32_t is_piece;                  /* 1: it came off another shape, or lost its last anchor */
    uint32_t anchor_count;              /* of get_anchors() */
    uint32_t is_broken;                 /* 1: it has lost voxels, and no undo gave them back */
} rubble_shape_properties;

/* ---- palettes ---- */

/* An entry of a shape's palette: the looks and the material of the voxels that have its index. Rows of arrays: see
 * rubble_palette_range. */
typedef struct rubble_palette_entry {
    uint8_t color[3];     /* sRGB */
    uint8_t opacity;      /* 255ths; below 255: transparent, as glass */
    uint8_t roughness;    /* 255ths: 0 is a mirror */
    uint8_t metallic;     /* 255ths */
    uint8_t reflectivity; /* 255ths, of what is no metal, seen from straight above; plastic: 10 */
    uint8_t material;     /* index into the world's materials; 0: without weight, touched by nothing */
    uint32_t reserved;
    /* radiance in multiples of the linear colour, 0 to 1e6; 0: does not glow. Voxels that glow without a light group
     * light what is around them (the 512 brightest flat sides of a world), unless there is a light within 0.5 m of
     * them, on or off. For those of a group its own lights do that: see create_light() */
    double emission;
    rubble_light_group light_group; /* that it glows with; 0: none. While the group is out it does not glow */
} rubble_palette_entry;

enum { RUBBLE_PALETTE_ALL_EQUAL = 1 /* of all shapes whose palette has the same entries as that of the shape */ };

/* Entries of a palette, one after the other. */
typedef struct rubble_palette_range {
    uint32_t struct_size;
    uint32_t flags; /* RUBBLE_PALETTE_...; 0 for get_palette() */
    rubble_shape shape;
    uint32_t first;      /* the entry of the first row, 1 to 255; 0: 1 */
    uint32_t count;      /* rows of the host's array: at least 1; the last entry is 255 at most */
    uint32_t entry_size; /* sizeof(rubble_palette_entry) of the host; 0: that of version 1 */
    uint32_t reserved;
} rubble_palette_range;

/* ---- materials ---- */

/* Which tools break a material, besides RUBBLE_TOOL_ANY. */
enum {
    RUBBLE_BREAKS_BY_SLEDGE = 1,
    RUBBLE_BREAKS_BY_TORCH = 2,
    RUBBLE_BREAKS_BY_GUN = 4,
    RUBBLE_BREAKS_BY_EXPLOSIVE = 8
};

/* A row of the world's table of materials. Zeros are values here, not defaults. */
typedef struct rubble_material {
    uint32_t struct_size;
    uint32_t hardness;     /* RUBBLE_HARDNESS_SOFT ... RUBBLE_HARDNESS_UNPHYSICAL */
    const char* name;      /* UTF-8, 1 to 4096 bytes; copied by the call, and read: lives until the next step() */
    const char* fragments; /* how it breaks: "chunk", "bond", "splinter", "pane", "tear", "crumble", "none" */
    uint32_t density;      /* kg/m3, 0 to 30000 */
    uint32_t tools;        /* RUBBLE_BREAKS_BY_... */
    double tensile_strength, compressive_strength, shear_strength; /* Pa, 0 to 1e15 */
    double friction;             /* Coulomb coefficient, 0 to 100; of two that touch the geometric mean holds */
    double restitution;          /* speed after an impact over that before, 0 to 1; the same */
    double heat_capacity;        /* J/(kg K), 0 to 1e6 */
    double ignition_temperature; /* K, 0 to 1e5; 0: does not burn */
    double burn_time;            /* s in which the surface of what burns recedes by about a voxel, 0 to 1e6; of small
                                  * things more goes at once: fewer than 8 voxels of a brick burn as fast as 8 */
} rubble_material;

/* ---- bricks: copies that a host keeps of shapes ---- */

/* A brick is 8 x 8 x 8 cells of a shape's grid: brick (x, y, z) begins at cell (8 x, 8 y, 8 z). */
typedef struct rubble_brick {
    int32_t x, y, z;
    uint32_t is_empty; /* 1: it holds no voxel */
} rubble_brick;

enum {
    RUBBLE_BRICKS_VOXELS = 0, /* bricks whose voxels or paint have changed */
    /* bricks whose meshes may have: also those with voxels of palette entries, paint colours and light groups that look
     * otherwise now, and those beside them */
    RUBBLE_BRICKS_MESHES = 1
};

/* Which bricks get_changed_bricks() lists. */
typedef struct rubble_brick_changes {
    uint32_t struct_size;
    uint32_t what; /* RUBBLE_BRICKS_... */
    rubble_shape shape;
    uint64_t since; /* the version that the call gave when the host took its copy; 0: all bricks with voxels */
} rubble_brick_changes;

/* The most vertices that mesh_brick() can give. */
#define RUBBLE_MAX_BRICK_VERTICES 6144u

/* A corner of a rectangle of faces of voxels that look alike. Four vertices are a rectangle, counter-clockwise seen
 * from outside: its triangles are 0 1 2 and 0 2 3. */
typedef struct rubble_mesh_vertex {
    float position[3]; /* metres from the corner of the shape's grid, along its axes; a whole number of voxels */
    float normal[3];   /* unit, along the same axes */
    uint8_t color[4];  /* sRGB with paint; the fourth is the opacity, 255: opaque */
    float emission;    /* radiance as a multiple of the linear colour; 0: none, or its light group is dark */
    uint8_t material;  /* index into the level's materials */
    uint8_t palette_index;
    uint8_t roughness, metallic; /* in 255ths */
} rubble_mesh_vertex;

/* Bytes that read_bricks() writes for a brick: 512 palette indices, then 512 bytes of paint, both with x fastest, then
 * y, then z, and as read_voxels() gives them. */
#define RUBBLE_BRICK_BYTES 1024u

/* 16 x 16 x 16 cells of 0.1 m along the world's axes, for rays through the whole world: a cell is set if its centre
 * lies in a voxel that casts shadow; of voxels smaller than cells, if one of a grid of points in it does. So a ray that
 * walks from each cell to one that shares a face with it never passes a wall of one voxel, however that is turned; of a
 * turned wall, points in voxels and on straight lines through it may lie in no set cell. Brick (x, y, z) begins at cell
 * (16 x, 16 y, 16 z), 0 at the world's origin. It is made of words of 4 x 4 x 4 cells: word x + 4 y + 16 z, whose cells
 * are bits x + 4 y + 16 z. */
typedef struct rubble_shadow_brick {
    int32_t x, y, z;
    uint32_t is_empty; /* 1: it holds no cell, and all that follows is 0 */
    uint64_t occupied; /* bit x + 4 y + 16 z: which words hold cells */
    /* the cells of a word that holds some. Of another, how far a ray may skip from it: for each octant of directions o
     * (bit 0: down x, bit 1: down y, bit 2: down z) the size in words of an empty box that begins with this word, less
     * one: along x in bits 2 o and 2 o + 1, y in those 16 on, z in those 32 on */
    uint64_t texels[64];
} rubble_shadow_brick;

/* ---- particles ---- */

/* How a particle moves and looks. Breaking and burning throw them up by themselves; they change nothing in the world.
 */
enum {
    RUBBLE_PARTICLE_DUST = 0,
    RUBBLE_PARTICLE_SMOKE = 1,
    RUBBLE_PARTICLE_FLAME = 2,
    RUBBLE_PARTICLE_SPARK = 3,
    RUBBLE_PARTICLE_CRUMB = 4,
    RUBBLE_PARTICLE_GLINT = 5,
    RUBBLE_PARTICLE_EMBER = 6
};

enum { RUBBLE_PARTICLE_PASSES = 1 /* it falls through the ground */ };

/* Particles that spawn_particles() adds. */
typedef struct rubble_particle_burst {
    uint32_t struct_size;
    uint32_t kind;      /* RUBBLE_PARTICLE_... */
    uint32_t count;     /* 1 to 4096; 0: 1. A world has 4096 at a time: what is beyond is left out */
    uint32_t flags;     /* RUBBLE_PARTICLE_PASSES */
    double position[3]; /* world */
    double radius;      /* metres around it within which they begin, 0 to 100 */
    double velocity[3]; /* m/s, -1000 to 1000 */
    double spread;      /* m/s that each has more, in any direction, 0 to 1000 */
    double color[3];    /* linear, 0 to 1e6; of sparks: of their glow */
    double size;        /* metres: radius at birth, 0.001 to 10; 0: 0.1 */
    double growth;      /* metres a second, 0 to 10 */
    double opacity;     /* 0.001 to 1; 0: 1 */
    double life;        /* seconds, 0.02 to 60; 0: 2 */
    double glow;        /* radiant intensity at birth, 0 to 1e6 */
    double gravity;     /* m/s2 downward, beside what its kind falls and rises by, -100 to 100 */
    double drag;        /* 1/s, beside that of its kind: the rate at which its velocity decays, 0 to 100 */
    double spin;        /* rad/s of its image, -100 to 100; where drawn by the renderer, as what follows */
    double stretch;     /* seconds of its motion by which its image is longer along it, 0 to 1 */
} rubble_particle_burst;

/* A row of get_particles(). */
typedef struct rubble_particle {
    double position[3]; /* world */
    float velocity[3];  /* m/s */
    float color[3];     /* linear */
    float radius;       /* metres, now */
    float opacity;      /* 0 to 1, now */
    float age;          /* share of its life, 0 to 1 */
    uint32_t kind;      /* RUBBLE_PARTICLE_... */
    uint32_t seed;      /* the same from its first step to its last */
    uint32_t reserved;
} rubble_particle;

/* ---- fire ---- */

enum { RUBBLE_HEAT_IGNITE = 1 /* ignites at once what can burn */ };

/* Heats what lies in a sphere, by its share of the surface there. What gets hot enough ignites by itself. */
typedef struct rubble_heat {
    uint32_t struct_size;
    uint32_t flags;     /* RUBBLE_HEAT_... */
    double position[3]; /* centre, world */
    double radius;      /* metres, 0.001 to 1000; 0: 0.5 */
    /* in all, 0 to 1e15. A wooden floor of 5 or 10 cm voxels ignites at about 200 to 800 kJ for each square metre of
     * the sphere's cross-section, with radii of 0.5 to 1.5 m: a floor of one voxel at the least, thick ones, of which
     * more lies in the sphere, at more; a smaller sphere, or larger voxels, need more */
    double joules;
    rubble_shape shape; /* heats this shape only; 0: all shapes */
    uint64_t reserved;
} rubble_heat;

/* Puts out what burns in a sphere. */
typedef struct rubble_extinguish {
    uint32_t struct_size;
    uint32_t reserved;
    double position[3]; /* centre, world */
    double radius;      /* metres, 0.001 to 1000; 0: 1 */
    double wet_seconds; /* for which what lies there takes no heat, 0 to 6000; water: about 20 */
} rubble_extinguish;

/* What burns: a part of a shape of at most 8 x 8 x 8 voxels. */
typedef struct rubble_fire {
    rubble_shape shape;
    double position[3]; /* world */
    double radius;      /* metres */
    double intensity;   /* 0 to 1: rises when lit, falls with the fuel */
} rubble_fire;

/* ---- joints and wheels ---- */

/* What a joint leaves free. Its axis is the x axis of its frame. */
enum {
    RUBBLE_JOINT_BALL,      /* holds one point; turns freely about it */
    RUBBLE_JOINT_HINGE,     /* turns about the axis */
    RUBBLE_JOINT_PRISMATIC, /* slides along the axis and does not turn */
    RUBBLE_JOINT_CONE,      /* holds one point; the axes of both sides stay within upper_limit radians of each other */
    RUBBLE_JOINT_FIXED,     /* nothing */
    RUBBLE_JOINT_ROPE,      /* a chain of points between two ends */
    /* shapes[0]: chassis, shapes[1]: wheel. Suspension along y of the frame; spins about x, which points left */
    RUBBLE_JOINT_WHEEL
};
enum {
    RUBBLE_MOTOR_OFF,     /* no motor */
    RUBBLE_MOTOR_SPEED,   /* holds a speed */
    RUBBLE_MOTOR_POSITION /* goes to a position and holds it */
};
enum {
    RUBBLE_JOINT_COLLIDES = 1, /* the two shapes collide with each other */
    RUBBLE_JOINT_LIMITED = 2,  /* lower_limit and upper_limit apply */
    /* an end of a rope that hangs free; in rubble_joint_properties alone */
    RUBBLE_JOINT_FIRST_LOOSE = 4,
    RUBBLE_JOINT_SECOND_LOOSE = 8
};

/* A joint between two shapes in their present poses. Each side is attached to a voxel of its shape: it stays with
 * that voxel when the shape splits, and the joint breaks when the voxel is removed. Forces and torques are 0 or
 * more. */
typedef struct rubble_joint_settings {
    uint32_t struct_size;
    uint32_t kind;          /* RUBBLE_JOINT_BALL ... */
    rubble_shape shapes[2]; /* 0: the world. Of two bodies; only a rope may have both ends on one */
    double position[3];     /* world; rope: its first end */
    double rotation[4];     /* world */
    double anchor_radius;   /* metres around the position in which each side looks for its voxel; 0: 0.2 */
    uint32_t flags;         /* RUBBLE_JOINT_COLLIDES ... */
    uint32_t motor;         /* RUBBLE_MOTOR_...; rope: a winch that changes its length */
    double motor_target;    /* rad/s or m/s; RUBBLE_MOTOR_POSITION: radians (-pi to pi) or metres */
    /* N m for turning, N for sliding; a winch does not read it. 0: RUBBLE_MOTOR_SPEED does nothing,
     * RUBBLE_MOTOR_POSITION takes what it needs, up to 1,000 m/s2 of what it moves */
    double motor_max_force;
    /* hinge: radians, -pi to pi; prismatic and wheel: metres; cone: upper_limit, radians, 0 to pi */
    double lower_limit, upper_limit;
    /* hinge, prismatic, wheel: pulls the free motion back to 0; others: makes the joint give. Frequency 0: no spring,
     * or rigid. Damping ratio 1: critical */
    double spring_hertz, spring_damping_ratio;
    double friction;                  /* N m for turning, N for sliding; wheel: a brake that is always on */
    double break_force, break_torque; /* N, N m, as the mean of a step; 0: never breaks */
    double rope_end[3];               /* world: the rope's second end */
    /* metres; length 0: the distance of its ends, a shorter one pulls them together at 0.2 m/s; radius 0: 0.03 */
    double rope_length, rope_radius;
    double rope_stretch;  /* relative elongation under 10 kN, as of a critically damped spring */
    double rope_strength; /* N at which the rope breaks; 0: never */
    /* wheel: N m at full throttle and at full brake, see drive_wheels(). From the first call of that on a hundredth of
     * the larger one holds against rolling, as tyres do */
    double drive_torque, brake_torque;
    double max_spin;                    /* wheel: rad/s forward, half of it backward; 0: 60 */
    double max_steer_angle, steer_rate; /* wheel: radians to each side, at most 1.5; rad/s of steering, 0: 2 */
} rubble_joint_settings;

/* Replaces the motor, friction and steering of a joint. */
typedef struct rubble_joint_motor {
    uint32_t struct_size;
    uint32_t motor; /* RUBBLE_MOTOR_... */
    rubble_joint joint;
    double motor_target, motor_max_force; /* as in rubble_joint_settings */
    double friction;                      /* as in rubble_joint_settings */
    double steer_angle;                   /* wheel: radians about y, -3 to 3; positive turns left */
} rubble_joint_motor;

/* Drives, steers and brakes all wheels of a body, which turn by their steer_rate. Holds until the next such command. */
typedef struct rubble_drive {
    uint32_t struct_size;
    uint32_t reserved;
    rubble_body body; /* the chassis: the body of shapes[0] of its wheels' joints */
    double throttle;  /* -1 (backward) to 1 */
    double steer;     /* -1 (right) to 1 (left) */
    double brake;     /* 0 to 1 */
} rubble_drive;

/* A row of get_joint_states(). */
typedef struct rubble_joint_state {
    rubble_joint joint;
    uint32_t kind;                            /* RUBBLE_JOINT_BALL ... */
    uint32_t rope_point_count;                /* for get_rope_points(); 0 for other joints */
    rubble_shape shapes[2];                   /* 0: the world, or a loose end of a rope, see RUBBLE_JOINT_FIRST_LOOSE */
    double first_anchor[3], second_anchor[3]; /* where it holds its two sides, world */
    double rope_length;                       /* metres */
} rubble_joint_state;

enum {
    RUBBLE_GRAB_TURNS = 1, /* turns the body toward `rotation` too; without it the body hangs at the point */
    /* holds the point at `velocity`, and with RUBBLE_GRAB_TURNS the body's spin at `angular_velocity`, not at the
     * places `target` and `rotation` */
    RUBBLE_GRAB_VELOCITY = 2
};

/* Pulls a body by a point toward a target or at a velocity, and may turn it. A hand holds one body: the same hand and
 * body again moves the target, another body lets go of the first. Holds until release_body(). */
typedef struct rubble_grab {
    uint32_t struct_size;
    uint32_t hand; /* any number that the host chooses, below 4294967295 */
    rubble_body body;
    double point[3];     /* world: where the body is held; counts when it is grabbed */
    double target[3];    /* world: where that point shall go */
    double max_force;    /* N; 0: 1000 */
    double spring_hertz; /* stiffness of the pull as a frequency, 0.1 to 60 Hz; 0: 4. Not of a velocity */
    uint32_t flags;      /* RUBBLE_GRAB_... */
    uint32_t reserved;
    double rotation[4];         /* RUBBLE_GRAB_TURNS: that the body's frame shall have, world */
    double max_torque;          /* RUBBLE_GRAB_TURNS: N m; 0: no limit */
    double velocity[3];         /* RUBBLE_GRAB_VELOCITY: m/s of the point, world */
    double angular_velocity[3]; /* RUBBLE_GRAB_VELOCITY and RUBBLE_GRAB_TURNS: rad/s, world axes */
} rubble_grab;

/* Lets go of what a hand holds and may throw it. */
typedef struct rubble_release {
    uint32_t struct_size;
    uint32_t hand;
    double impulse[3]; /* N s, world, at the point that was held */
} rubble_release;

/* What a joint is and where it is, as get_joint_properties() gives it. */
typedef struct rubble_joint_properties {
    uint32_t struct_size;
    uint32_t kind;                                       /* RUBBLE_JOINT_BALL ... */
    uint32_t flags;                                      /* RUBBLE_JOINT_COLLIDES ... */
    uint32_t motor;                                      /* RUBBLE_MOTOR_... */
    double motor_target, motor_max_force;                /* as in rubble_joint_settings, as all that follows */
    double lower_limit, upper_limit;                     /* of RUBBLE_JOINT_LIMITED; else 0 */
    double spring_hertz, spring_damping_ratio, friction; /* the same */
    double break_force, break_torque;                    /* the same */
    double steer_angle;                                  /* wheel: radians about y, now */
    /* where its free motion is, 0 in the pose in which it was made. Hinge: radians, -pi to pi; prismatic and wheel:
     * metres; ball and cone: radians between the axes of both sides; fixed: 0. Rope: metres between its ends */
    double movement;
    double rotation[4];   /* world: of the frame of its first end, whose x axis is the joint's */
    double anchor_radius; /* as in rubble_joint_settings */
    /* wheel: as in rubble_joint_settings; else 0 */
    double drive_torque, brake_torque, max_spin, max_steer_angle, steer_rate;
} rubble_joint_properties;

enum {
    RUBBLE_CONSTRAINT_VELOCITY = 0,        /* of a point, along a direction */
    RUBBLE_CONSTRAINT_ANGULAR_VELOCITY = 1 /* about a direction */
};

/* Holds one component of the velocity of a body, against the world or another body, which then bears the force. It acts
 * in one step, together with contacts and joints: call it before each step for which it shall hold. Three of them hold
 * a point, and three more a rotation: toward a place by the speed that leads there within the step, its distance
 * times 60. */
typedef struct rubble_body_constraint {
    uint32_t struct_size;
    uint32_t kind; /* RUBBLE_CONSTRAINT_... */
    rubble_body body;
    rubble_body other;   /* 0: the world. One of the two must be free */
    double position[3];  /* RUBBLE_CONSTRAINT_VELOCITY: the point, world */
    double direction[3]; /* world */
    double speed;        /* of body against other: m/s along the direction, or rad/s about it */
    /* N or N m on the body along the direction, -1e9 to 1e9. Both 0: no limit. A minimum of 0 pushes and never pulls */
    double min_force, max_force;
} rubble_body_constraint;

/* A row of get_ropes(). */
typedef struct rubble_rope_point {
    rubble_joint joint; /* the rope: its points follow each other from its first end to its second */
    double position[3]; /* world */
    float velocity[3];  /* m/s */
    float radius;       /* metres */
    uint8_t color[3];   /* sRGB */
    uint8_t is_last;    /* 1: of its rope */
    uint32_t reserved;
} rubble_rope_point;

/* ---- events: what the last step did ---- */

/* Voxels of one palette entry that one edit removed from one shape. */
typedef struct rubble_removed_voxels {
    rubble_shape shape;
    uint64_t count;
    uint8_t color[3];       /* sRGB */
    uint8_t material;       /* index into the level's materials */
    uint32_t palette_index; /* of the shape's palette, 1 to 255 */
} rubble_removed_voxels;

/* A piece that came off a shape and is now a shape of its own: one row for each piece. */
typedef struct rubble_shape_split {
    rubble_shape parent;
    rubble_shape piece;
    int32_t parent_offset[3]; /* the cell of the parent's grid at which cell 0 of the piece's grid lies */
    uint32_t reserved;
} rubble_shape_split;

/* Removed voxels of one colour and where they were, for particles. Every voxel that a step() removed is in exactly one
 * cloud. */
typedef struct rubble_dust_cloud {
    double position[3]; /* centre, world */
    double radius;      /* metres */
    double velocity[3]; /* m/s, of the body that they were part of */
    uint64_t count;     /* voxels */
    uint8_t color[3];   /* sRGB */
    uint8_t material;   /* index into the level's materials */
    uint32_t reserved;
} rubble_dust_cloud;

/* What get_events() returns. Handles in the destroyed lists are stale already, but those of bodies that became static
 * or free and of shapes that got another grid: these are in the created lists too, and go on as other objects under the
 * same handle. Use them to find the host's own objects. */
typedef struct rubble_events {
    uint32_t struct_size;
    /* 1: a level was loaded and every older handle is stale: ask for get_body_states() again */
    uint32_t level_loaded;
    uint64_t step; /* number of steps since the level was loaded */
    uint64_t painted_voxel_count;
    const rubble_removed_voxels* removed;
    const rubble_shape_split* splits;
    const rubble_body* bodies_created;
    const rubble_body* bodies_destroyed;
    const rubble_shape* shapes_created;
    const rubble_shape* shapes_destroyed;
    const rubble_light_group* light_groups_out; /* that went out */
    uint32_t removed_count;
    uint32_t split_count;
    uint32_t bodies_created_count;
    uint32_t bodies_destroyed_count;
    uint32_t shapes_created_count;
    uint32_t shapes_destroyed_count;
    uint32_t light_groups_out_count;
    uint32_t dust_cloud_count;
    const rubble_dust_cloud* dust_clouds;
    const rubble_body* bodies_broken; /* lost voxels for the first time */
    /* debris that came to rest and left the simulation until something breaks or moves near it */
    const rubble_body* bodies_settled;
    const rubble_body* bodies_unsettled; /* settled debris that is simulated again; if physics woke it, a step later */
    uint32_t bodies_broken_count;
    uint32_t bodies_settled_count;
    uint32_t bodies_unsettled_count;
    uint32_t reserved;
} rubble_events;

/* ---- reports: what happened, for sound and score ---- */

/* Kinds of reports: what a host asks for by set_report_filter(). */
enum {
    RUBBLE_REPORT_CONTACT_BEGUN = 1, /* bodies touch that did not, unless an edit of the step has made or cut one */
    RUBBLE_REPORT_CONTACT_SLID = 2,  /* bodies touch and slide along each other: in each step */
    RUBBLE_REPORT_CONTACT_HIT = 4,   /* bodies meet, also those that touch already */
    RUBBLE_REPORT_BREAK = 8,         /* voxels were removed */
    RUBBLE_REPORT_JOINT = 16,        /* a joint is gone, or an end of it followed its voxel into another shape */
    RUBBLE_REPORT_FIRE = 32,         /* something was lit or went out */
    RUBBLE_REPORT_WATER = 64,        /* a body or character got into water */
    RUBBLE_REPORT_FOOTSTEP = 128     /* a character made a step on the ground, or landed on it */
};

/* What get_reports() lists. What is not asked for is not collected. */
typedef struct rubble_report_filter {
    uint32_t struct_size;
    uint32_t kinds;        /* RUBBLE_REPORT_...; 0: none */
    double min_impulse;    /* N s in the step, 0 to 1e12: softer contacts are left out */
    double min_hit_speed;  /* m/s at which bodies meet, at most 1e6, for RUBBLE_REPORT_CONTACT_HIT; 0: 0.5 */
    double min_slip_speed; /* m/s along each other, at most 1e6, for RUBBLE_REPORT_CONTACT_SLID; 0: 0.1 */
    double stride;         /* metres that a character walks from one step to the next, 0.01 to 1000; 0: 0.8 */
} rubble_report_filter;

/* Two bodies in contact, or a body and one shape of a static body. Characters and ropes are not among them. */
typedef struct rubble_contact {
    uint32_t kinds;        /* RUBBLE_REPORT_CONTACT_...: those that were asked for and hold */
    uint32_t materials[2]; /* indices into the level's materials; 0: not known */
    uint32_t reserved;
    rubble_body bodies[2];  /* the second one 0: the ground around the level */
    rubble_shape shapes[2]; /* where they touch the hardest */
    double position[3];     /* world: the middle of the points at which they touch */
    double normal[3];       /* unit, towards bodies[0] */
    double impulse;         /* N s along the normal, in the step */
    double hit_speed;       /* m/s at which they came together */
    double slip_speed;      /* m/s along each other, mean of the points */
    double size;            /* metres: the largest distance of two of the points, at least the side of a voxel */
} rubble_contact;

/* Voxels of one material that were removed near each other. */
typedef struct rubble_break_report {
    uint32_t material; /* index into the level's materials */
    uint32_t reserved;
    uint64_t voxels;
    double position[3]; /* world: their middle */
    double radius;      /* metres around it in which they were */
} rubble_break_report;

enum {
    RUBBLE_REPORT_JOINT_VOXEL_GONE = 0, /* the voxel that held an end was removed, of a rope that of its last end */
    RUBBLE_REPORT_JOINT_OVERLOADED = 1, /* by its force or torque; the first part of a rope keeps the handle */
    RUBBLE_REPORT_JOINT_REMOVED = 2,    /* by an edit */
    RUBBLE_REPORT_JOINT_CUT = 3,        /* a rope was cut; its first part keeps the handle */
    RUBBLE_REPORT_JOINT_MOVED = 4,      /* an end of it is on another shape now */
    RUBBLE_REPORT_JOINT_LOOSE = 5       /* an end of a rope hangs free now, the other one holds */
};

/* What became of a joint. */
typedef struct rubble_joint_report {
    rubble_joint joint;
    uint32_t what; /* RUBBLE_REPORT_JOINT_VOXEL_GONE ... */
    uint32_t reserved;
    double position[3];    /* world, where it was or came loose; of a joint that moved, 0 */
    rubble_shape from, to; /* of a joint that moved; from: of an end that came loose too; else 0 */
} rubble_joint_report;

/* A part of a shape of at most 8 x 8 x 8 voxels that get_fires() lists since the last step, or no longer. One that
 * comes off with a piece while it burns goes out on its shape and is lit on the piece. What burns when a level or game
 * is loaded, or when these reports are asked for first, is not listed as lit. */
typedef struct rubble_fire_report {
    rubble_shape shape; /* of one that is out, it may be gone */
    uint32_t lit;       /* 1: lit, 0: out */
    uint32_t reserved;
    double position[3]; /* world; of one that is out, where it burned last */
} rubble_fire_report;

/* What got into water. */
typedef struct rubble_water_report {
    rubble_water water;
    uint64_t object;    /* rubble_body or rubble_character */
    double position[3]; /* world, at the surface */
    double speed;       /* m/s, against the water */
    double mass;        /* kg */
} rubble_water_report;

enum { RUBBLE_FOOTSTEP_LANDED = 1 /* it comes out of the air */ };

/* A step of a character. */
typedef struct rubble_footstep {
    rubble_character character;
    uint32_t flags;     /* RUBBLE_FOOTSTEP_... */
    uint32_t material;  /* index into the level's materials; 0: the ground around the level */
    rubble_shape shape; /* that it steps on; 0: the same */
    double position[3]; /* of the feet, world */
    double speed;       /* m/s along the ground; of a landing, downward */
} rubble_footstep;

/* What get_reports() returns, each list in a fixed order. Rows of these lists do not grow in later versions. */
typedef struct rubble_reports {
    uint32_t struct_size;
    uint32_t kinds; /* that the last step listed */
    const rubble_contact* contacts;
    const rubble_break_report* breaks;
    const rubble_joint_report* joints;
    const rubble_fire_report* fires;
    const rubble_water_report* waters;
    const rubble_footstep* footsteps;
    uint32_t contact_count;
    uint32_t break_count;
    uint32_t joint_count;
    uint32_t fire_count;
    uint32_t water_count;
    uint32_t footstep_count;
} rubble_reports;

/* ---- state ---- */

enum { RUBBLE_BODY_STATIC = 1, RUBBLE_BODY_ASLEEP = 2 };

/* A body after the last step. */
typedef struct rubble_body_state {
    rubble_body body;
    double position[3];         /* of its frame, world; the frame's origin is not the centre of mass */
    double rotation[4];         /* of its frame */
    double velocity[3];         /* m/s, of the centre of mass */
    double angular_velocity[3]; /* rad/s, world axes */
    uint32_t flags;             /* RUBBLE_BODY_... */
    uint32_t shape_count;
} rubble_body_state;

/* A shape after the last step. */
typedef struct rubble_shape_state {
    rubble_shape shape;
    rubble_body body;
    double position[3]; /* of the minimum corner of its grid, world */
    double rotation[4]; /* of its grid's axes */
    double voxel_size;  /* metres */
    int32_t size[3];    /* of the grid, in voxels */
    uint32_t reserved;
    uint64_t voxel_count; /* of those that are not empty */
} rubble_shape_state;

/* Where the voxels of the level are now: imported = standing + in_pieces + removed. */
typedef struct rubble_voxel_accounting {
    uint32_t struct_size;
    uint32_t reserved;
    uint64_t imported;  /* loaded with the level or written, less those that were overwritten or destroyed */
    uint64_t standing;  /* in shapes of the level */
    uint64_t in_pieces; /* in shapes that came off */
    uint64_t removed;
} rubble_voxel_accounting;

/* Counters and wall-clock times of the last step. */
typedef struct rubble_step_stats {
    uint32_t struct_size;
    uint32_t bodies; /* dynamic ones that physics knows, asleep and settled ones too */
    uint32_t bodies_awake;
    uint32_t contacts;
    uint64_t step;
    uint64_t shadow_lag; /* steps by which the shadow volume was behind */
    double edits_ms;     /* edits, splits and fire */
    double physics_ms;
    double poses_ms;   /* poses back into the world */
    double impacts_ms; /* damage by impacts */
    double shadow_ms;  /* handing changes to the shadow volume */
    double publish_ms; /* the snapshot for the renderer */
} rubble_step_stats;

/* ---- collision layers, water, triggers, characters ---- */

enum { RUBBLE_COLLISION_NONE = 256 /* as a mask: collides with nothing; as a layer: nothing collides with it */ };

/* Two shapes collide if the layer of each is in the mask of the other. */
typedef struct rubble_collision_filter {
    uint32_t struct_size;
    uint32_t layer; /* 8 bits; 0: 1 */
    uint32_t mask;  /* 8 bits; 0: 255 */
    uint32_t reserved;
    rubble_shape shape;
} rubble_collision_filter;

enum {
    RUBBLE_COLLISION_VOXELS = 0,
    RUBBLE_COLLISION_SPHERE = 1,
    RUBBLE_COLLISION_CYLINDER_X = 2, /* about the x axis of the shape's grid */
    RUBBLE_COLLISION_CYLINDER_Y = 3,
    RUBBLE_COLLISION_CYLINDER_Z = 4
};

/* What physics takes a shape for where it touches others. The round ones are the smallest that hold all its voxels,
 * about the middle of its bounds: a wheel rolls on a cylinder and a ball on a sphere, not on the corners of voxels. A
 * shape that leaves more than a voxel of it, as after a cut, is touched as voxels, and so is a full box more than 4
 * voxels wide: the log says so when it is set. Queries, water and characters always see voxels. */
typedef struct rubble_collision_shape {
    uint32_t struct_size;
    uint32_t kind; /* RUBBLE_COLLISION_VOXELS ... RUBBLE_COLLISION_CYLINDER_Z */
    rubble_shape shape;
} rubble_collision_shape;

/* A volume of water: bodies in it float or sink, characters swim, fires go out. Where waters overlap, one of them
 * counts. A body displaces the volume of its solid voxels and nothing else: water fills every hollow, also a closed
 * one, so that a hull of metal sinks. What shall float is of light material, or is made solid with one. */
typedef struct rubble_water_settings {
    uint32_t struct_size;
    uint32_t outline_count; /* corners: 3 to 10000 */
    const double* outline;  /* x and z of each corner, world; copied by the call */
    double surface_height;  /* y of the surface, world */
    double depth;           /* metres below the surface; 0: 1 */
    double density;         /* kg/m3; 0: 1000 */
    double linear_drag;     /* 1/s: rate at which the displaced water drags a body along; 0: 1.5 */
    double angular_drag;    /* 1/s: the same for its spin; 0: 1.5 */
    double flow[3];         /* m/s: current, -100 to 100 along each axis */
} rubble_water_settings;

enum { RUBBLE_TRIGGER_SPHERE = 0, RUBBLE_TRIGGER_BOX = 1, RUBBLE_TRIGGER_POLYGON = 2 };

/* A region that reports the dynamic bodies that have a voxel in it. It collides with nothing. */
typedef struct rubble_trigger_settings {
    uint32_t struct_size;
    uint32_t kind;         /* RUBBLE_TRIGGER_... */
    double position[3];    /* world; sphere and box: centre; polygon: the origin of its outline */
    double rotation[4];    /* box */
    double radius;         /* sphere: metres; 0: 1 */
    double half_size[3];   /* box: metres; 0: 1 */
    double height;         /* polygon: metres upward from the position; 0: 1 */
    const double* outline; /* polygon: x and z of each corner, relative to the position; copied by the call */
    uint32_t outline_count;
    uint32_t layer_mask; /* only shapes with a collision layer in this mask count; 0: all */
} rubble_trigger_settings;

/* A body has entered a trigger or left it. */
typedef struct rubble_trigger_event {
    rubble_trigger trigger;
    rubble_body body;
    uint32_t entered; /* 1: entered, 0: left */
    uint32_t reserved;
} rubble_trigger_event;

/* A character: an upright capsule that walks, jumps, climbs steps, crouches and swims. A body that it walks on bears
 * its weight and goes back under it as it gets faster, but does not feel its inertia otherwise, nor its jumps. It is no
 * obstacle for bodies: it pushes them with max_push_force, is pushed aside, and what falls on it with more goes through
 * it and leaves it on top. Characters push each other apart.
 * It climbs steps up to step_height, from tread to tread, at any speed and angle, if the treads are 0.2 m deep or more,
 * whatever its radius; less deep ones only where they are together no steeper than max_slope.
 * In the air it keeps the velocity of what it left, falls with gravity alone, also where its ground falls faster, and
 * desired_velocity only makes it faster. */
typedef struct rubble_character_settings {
    uint32_t struct_size;
    uint32_t reserved;
    double position[3];     /* of the feet, world */
    double radius;          /* metres; 0: 0.3 */
    double height;          /* metres; 0: 1.8 */
    double crouched_height; /* metres, at least two radii; 0: 1.1 */
    double step_height;     /* metres that it climbs without a jump; 0: 0.45 */
    double max_slope;       /* steepest ground that it can stand on, rise over run; 0: 1 */
    double mass;            /* kg; 0: 80 */
    double walk_speed;      /* m/s; 0: 4. No character moves faster than 60 m/s */
    double jump_speed;      /* m/s upward; 0: 4.5 */
    double swim_speed;      /* m/s; 0: 2 */
    double max_push_force;  /* N on bodies that it walks against or on; 0: 400 */
} rubble_character_settings;

enum { RUBBLE_MOVE_JUMP = 1, RUBBLE_MOVE_CROUCH = 2 };

/* Where a character shall go. The velocity and RUBBLE_MOVE_CROUCH hold until the next command, a jump is for one
 * step. */
typedef struct rubble_character_move {
    uint32_t struct_size;
    uint32_t flags; /* RUBBLE_MOVE_... */
    rubble_character character;
    double desired_velocity[3]; /* m/s, world, at most 1000; the vertical part counts in water only */
} rubble_character_move;

/* Puts a character somewhere else. */
typedef struct rubble_character_teleport {
    uint32_t struct_size;
    uint32_t reserved;
    rubble_character character;
    double position[3]; /* of the feet, world */
    double velocity[3]; /* m/s, at most 1000 */
} rubble_character_teleport;

enum { RUBBLE_CHARACTER_GROUNDED = 1, RUBBLE_CHARACTER_CROUCHED = 2, RUBBLE_CHARACTER_SWIMMING = 4 };

/* A character after the last step. */
typedef struct rubble_character_state {
    rubble_character character;
    double position[3];      /* of the feet, world */
    double velocity[3];      /* m/s, world: with that of ground_body, without what slopes and steps lift it by */
    rubble_body ground_body; /* the body that it stands on; 0: none */
    uint32_t flags;          /* RUBBLE_CHARACTER_... */
    uint32_t reserved;
} rubble_character_state;

/* ---- queries ---- */

enum {
    RUBBLE_FILTER_REJECT_STATIC = 1,      /* static bodies are not found */
    RUBBLE_FILTER_REJECT_DYNAMIC = 2,     /* dynamic bodies are not found */
    RUBBLE_FILTER_REJECT_TRANSPARENT = 4, /* passes through voxels that are not opaque, such as glass */
    RUBBLE_FILTER_REJECT_UNPHYSICAL = 8   /* passes through voxels that are seen but do not collide */
};

/* What a query may find. A null filter finds everything. */
typedef struct rubble_query_filter {
    uint32_t struct_size;
    uint32_t flags;      /* RUBBLE_FILTER_... */
    uint32_t layer_mask; /* finds only shapes with a collision layer in this mask, 0 to 255; 0: all */
    uint32_t rejected_body_count;
    uint32_t rejected_shape_count;
    uint32_t reserved;
    const rubble_body* rejected_bodies; /* are not found; stale handles do no harm */
    const rubble_shape* rejected_shapes;
    uint32_t query_size; /* sizeof(rubble_ray) or sizeof(rubble_shape_cast) of the host; 0: those of version 1 */
    uint32_t hit_size;   /* sizeof(rubble_hit) of the host; 0: that of version 1 */
} rubble_query_filter;

/* A ray, or a sphere that moves along one. */
typedef struct rubble_ray {
    double origin[3]; /* world */
    double direction[3];
    double max_distance; /* metres, 0 to 1e6 */
    double radius;       /* metres; above 0: a sphere of this radius is cast */
} rubble_ray;

enum { RUBBLE_QUERY_SPHERE = 0, RUBBLE_QUERY_BOX = 1, RUBBLE_QUERY_CAPSULE = 2 }; /* numbered as brushes are */

/* A region of space for overlap queries and shape casts. */
typedef struct rubble_query_shape {
    uint32_t kind; /* RUBBLE_QUERY_... */
    uint32_t reserved;
    double position[3];  /* world; sphere and box: centre; capsule: one end of its axis */
    double end[3];       /* capsule: the other end of its axis */
    double radius;       /* sphere and capsule: metres */
    double half_size[3]; /* box: metres */
    double rotation[4];  /* box */
} rubble_query_shape;

/* A region that moves along a line without turning. */
typedef struct rubble_shape_cast {
    rubble_query_shape shape;
    double direction[3];
    double max_distance; /* metres, 0 to 1e6 */
} rubble_shape_cast;

/* The voxel that a query found. */
typedef struct rubble_hit {
    uint32_t hit;           /* 0: nothing was found, and all other fields are 0 */
    uint32_t palette_index; /* of the shape's palette, 1 to 255 */
    double distance;        /* metres; of a cast sphere or shape: how far it moves */
    double position[3];     /* world: the point of the voxel that is met */
    double normal[3];       /* unit, away from the voxel */
    rubble_shape shape;     /* 0: the ground around the level, see rubble_bounds */
    rubble_body body;
    int32_t cell[3]; /* of the shape's grid */
    uint32_t reserved;
} rubble_hit;

/* ---- lists with rows of any version ---- */

enum {
    RUBBLE_ROWS_BODIES = 0,         /* rubble_body_state */
    RUBBLE_ROWS_SHAPES = 1,         /* rubble_shape_state */
    RUBBLE_ROWS_JOINTS = 2,         /* rubble_joint_state */
    RUBBLE_ROWS_CHARACTERS = 3,     /* rubble_character_state */
    RUBBLE_ROWS_TRIGGER_EVENTS = 4, /* rubble_trigger_event, of the last step */
    RUBBLE_ROWS_REMOVED_VOXELS = 5, /* rubble_removed_voxels, as in get_events() */
    RUBBLE_ROWS_SPLITS = 6,         /* rubble_shape_split, as in get_events() */
    RUBBLE_ROWS_DUST_CLOUDS = 7,    /* rubble_dust_cloud, as in get_events() */
    RUBBLE_ROWS_FIRES = 8,          /* rubble_fire */
    /* the bodies that the last step moved, each as rubble_body_state: by physics, by the host's or by an edit. One that
     * has fallen asleep in it is among them for the last time. Costs what moved */
    RUBBLE_ROWS_MOVED_BODIES = 9
};

/* What deltas tell of a step, for keep_deltas(): one of the first three, and RUBBLE_DELTAS_EVENTS beside it. */
enum {
    RUBBLE_DELTAS_NONE = 0,
    RUBBLE_DELTAS_ALL = 1, /* all that it changed: some 100 bytes for each body that moves */
    /* what edits changed, and no motion: for hosts that send poses as their network allows. Costs what edits change and
     * a hash of the voxels in steps that change some */
    RUBBLE_DELTAS_EDITS = 2,
    /* a bit: what was removed, painted and split, dust, explosions, and bodies that broke, settled and woke. Followers
     * have them in get_events(), breaks in get_reports(), and draw the dust, but for that of bodies that hit each
     * other. Some 80 bytes for each material of each shape that an edit breaks, before packing */
    RUBBLE_DELTAS_EVENTS = 4
};

/* What read_rows() lists. A host that gives sizeof of the row in its own rubble.h works with every version of the
 * plugin: an older plugin leaves the fields zero that it does not know, a newer one leaves out those that the host does
 * not know. */
typedef struct rubble_row_list {
    uint32_t struct_size;
    uint32_t kind;     /* RUBBLE_ROWS_... */
    uint32_t row_size; /* bytes from one row to the next: sizeof(the row); 0: that of version 1 */
    uint32_t reserved;
    rubble_body body; /* RUBBLE_ROWS_SHAPES: of this body only; 0: of all */
} rubble_row_list;

/* ---- objects of any kind ---- */

/* Kinds of objects, for lists of them. */
enum {
    RUBBLE_KIND_BODY = 0,
    RUBBLE_KIND_SHAPE = 1,
    RUBBLE_KIND_LIGHT = 2,
    RUBBLE_KIND_LIGHT_GROUP = 3,
    RUBBLE_KIND_WATER = 4,
    RUBBLE_KIND_TRIGGER = 5,
    RUBBLE_KIND_CHARACTER = 6,
    RUBBLE_KIND_JOINT = 7
};

/* ---- settings of a world ---- */

enum {
    RUBBLE_SETTING_STRESS = 1,      /* standing shapes break under their own weight and under impacts */
    RUBBLE_SETTING_FIRE = 2,        /* off: nothing burns */
    RUBBLE_SETTING_PAINT_LAYER = 4, /* paint is a layer over the voxels; off: it blends palette entries */
    /* get_origin() knows of all pieces what they came off; off: of those only whose shape had been given a name, a tag
     * or a user value. Costs some 200 bytes a piece */
    RUBBLE_SETTING_KEEP_ORIGINS = 8
};

/* How accurately bodies move, at what cost. The default is "balanced". */
enum { RUBBLE_PHYSICS_DEFAULT = 0, RUBBLE_PHYSICS_FAST = 1, RUBBLE_PHYSICS_BALANCED = 2, RUBBLE_PHYSICS_ACCURATE = 3 };

/* How a world breaks, burns and remembers. Zeros are values here, not defaults: read the present ones with
 * get_settings(), change some, set all. Budgets count work, never time: results are the same on every machine. Bounds
 * are apart (rubble_bounds), and so is gravity (rubble_environment). */
typedef struct rubble_settings {
    uint32_t struct_size;
    uint32_t flags;             /* RUBBLE_SETTING_... */
    uint64_t min_piece_voxels;  /* smaller pieces are removed */
    double impact_threshold;    /* N s below which an impact breaks nothing, 0 to 1e12 */
    double impact_speed;        /* m/s that an impact must change the heavier body by to break it, 0 to 1e6 */
    double impact_radius;       /* metres of a hole at the threshold, 0 to 4 */
    double impact_radius_limit; /* metres of the largest such hole, 0 to 4 */
    /* parts (of at most 32x32x32 voxels) that a step tests for what came off; 0: all, in the step of the cut. The first
     * test of a shape looks at all of it, at once */
    uint64_t split_parts;
    uint64_t debris_voxels;       /* of all pieces together; beyond, pieces become dust */
    uint64_t largest_debris;      /* voxels; a larger piece is no debris: not counted, never removed */
    uint32_t debris_bodies;       /* pieces in all */
    uint32_t awake_debris_bodies; /* pieces that are awake */
    uint32_t settle_steps;        /* a piece that has slept for so long settles: contacts no longer wake it */
    uint32_t fragments_per_break; /* that one break makes of one shape, 1 to 100000 */
    uint32_t impacts_per_step;    /* that break something, the hardest first, 1 to 1000 */
    uint32_t cracks_per_step;     /* of one shape under stress */
    double strength_scale;        /* multiple of all materials' strengths under weight, 1e-6 to 1e6 */
    uint64_t stress_work;         /* a step, in units of about 20 ns, 1 to 1e12 */
    double contact_time;          /* s: an impact's force is its impulse over that, 1e-4 to 10 */
    double min_load_impulse;      /* N s below which an impact loads nothing, 0 to 1e12 */
    uint32_t min_struck_voxels;   /* of a piece; a smaller one breaks only where it is hit */
    uint32_t largest_stressed;    /* bricks; a larger shape does not break under its weight */
    uint32_t max_fires;           /* parts of shapes that burn at a time */
    uint32_t max_hot;             /* parts of shapes that are hot, burning or wet */
    uint32_t max_fire_lights;     /* lights for the biggest fires */
    uint32_t physics_preset;      /* RUBBLE_PHYSICS_... */
    double fire_spread;           /* multiple of the heat that fires pass on, 0 to 100 */
    double fire_burn_time;        /* multiple of the materials' times, 0.001 to 1000 */
} rubble_settings;

/* ---- layers, and worlds that the host's physics moves ---- */

/* What is in a library beside the runtime, which has worlds, edits, what breaks, queries and files. */
enum {
    RUBBLE_LAYER_PHYSICS = 1, /* without it, worlds are made with RUBBLE_WORLD_HOST_PHYSICS */
    RUBBLE_LAYER_RENDERER = 2 /* without it, create_renderer() and its like are RUBBLE_ERROR_UNSUPPORTED */
};

/* Which bodies get_rigid_bodies() lists. */
enum {
    RUBBLE_BODIES_CHANGED = 0, /* made or changed by the last step; all, if that was the first of a level or a game */
    RUBBLE_BODIES_ALL = 1
};

/* What a body needs of the host's physics. */
enum {
    RUBBLE_RIGID_NEW = 1,   /* it is to be made */
    RUBBLE_RIGID_SOLID = 2, /* its voxels are others: mass, centre, inertia and boxes */
    /* an edit has set its pose or motion, put it to sleep, woken it or changed its kind; of free bodies also with
     * RUBBLE_RIGID_SOLID: about another centre what turns has another velocity */
    RUBBLE_RIGID_MOVED = 4
};

/* A row of get_rigid_bodies(). In a world with RUBBLE_WORLD_HOST_PHYSICS, a frame of the host is: step(); rigid bodies
 * of its own as get_events() lists bodies_destroyed and get_rigid_bodies() the others; get_body_impulses(); a step of
 * its physics; set_body_states() and report_impacts(). Joints with wheels, ropes and waters are data there, which the
 * host may follow: nothing in the plugin moves them. Hands, constrain_bodies(), drive_wheels() and characters are
 * RUBBLE_ERROR_UNSUPPORTED. Bodies that fall asleep in the host's physics are to be set asleep: debris settles then. */
typedef struct rubble_rigid_body {
    rubble_body body;
    uint32_t changes;           /* RUBBLE_RIGID_... */
    uint32_t flags;             /* RUBBLE_BODY_... */
    double mass;                /* kg; 0: no voxel has a weight */
    double center[3];           /* of mass, in metres of the body's frame */
    double inertia[3];          /* kg m2: principal moments about that centre */
    double inertia_rotation[4]; /* of the principal axes, in the body's frame */
    double position[3];         /* of its frame, world */
    double rotation[4];         /* of its frame */
    double velocity[3];         /* m/s, of the centre of mass */
    double angular_velocity[3]; /* rad/s, world axes */
} rubble_rigid_body;

/* A row of get_body_boxes(). The boxes hold the voxels that collide, each once, and no other place. */
typedef struct rubble_body_box {
    rubble_shape shape;  /* whose voxels it holds */
    double center[3];    /* metres, in the body's frame */
    double rotation[4];  /* in the body's frame: all boxes of a shape have the same */
    double half_size[3]; /* metres */
    uint32_t layer;      /* collision layer and mask of the shape, bits; see rubble_collision_filter */
    uint32_t mask;
} rubble_body_box;

/* A row of get_body_impulses(). */
typedef struct rubble_body_impulse {
    rubble_body body;
    double position[3]; /* world: where it acts */
    double impulse[3];  /* N s, world */
} rubble_body_impulse;

/* A row of report_impacts(): a hit in the host's physics. */
typedef struct rubble_impact {
    rubble_body body;   /* 0: something of the host */
    rubble_body other;  /* the same; not both */
    double position[3]; /* world: where they touch */
    double normal[3];   /* the direction in which `body` is pushed; any length but zero */
    double impulse;     /* N s, in all of the hit, 0 to 1e16 */
    double speed;       /* m/s at which they met, 0 to 1e9 */
} rubble_impact;

/* ---- sky, sun, air and lights ---- */

/* Sky, sun, air, exposure and gravity. Zeros are values here, not defaults: read the present ones with
 * get_environment(), change some, set all. Colours are linear. Out of range: RUBBLE_ERROR_ARGUMENT with the
 * range. */
typedef struct rubble_environment {
    uint32_t struct_size;
    uint32_t reserved;
    double sun_direction[3]; /* towards the sun */
    double sun_color[3];     /* irradiance of a face turned to the sun */
    double sun_angle;        /* radians: angular radius of the sun; larger makes its shadows softer */
    double sky_color[3];     /* radiance at the zenith */
    double horizon_color[3]; /* radiance at the horizon */
    double ground_color[3];  /* radiance below the horizon */
    double fog_color[3];     /* radiance of the distant haze */
    double fog_distance;     /* metres at which the haze hides half */
    /* extinction per metre at fog_base of the volumetric fog that shows shafts of light; 0: none, at no cost */
    double fog_density;
    double fog_base;    /* y, metres */
    double fog_height;  /* scale height: metres above fog_base in which the density falls to 1/e */
    double fog_forward; /* anisotropy: mean cosine of the scattering angle (Henyey-Greenstein g), -0.9 to 0.9 */
    double fog_tint[3]; /* single-scattering albedo */
    double clouds;      /* 0: clear sky, 1: overcast */
    double stars;       /* brightness of the stars; 0: none */
    double exposure;    /* factor on all radiance before tone mapping; views adapt to it: RUBBLE_VIEW_FIXED_EXPOSURE */
    double wetness;     /* of what is open to the sky: 0 dry, 0.5 dark and smooth, 1 with puddles */
    double gravity[3];  /* m/s2 */
} rubble_environment;

enum {
    RUBBLE_LIGHT_SPHERE = 0,  /* a glowing ball */
    RUBBLE_LIGHT_CONE = 1,    /* a ball that shines into a cone */
    RUBBLE_LIGHT_CAPSULE = 2, /* a glowing tube of `width` metres along x */
    RUBBLE_LIGHT_AREA = 3,    /* a rectangle of `width` by `height` metres along x and y */
    RUBBLE_LIGHT_SCREEN = 4   /* a rectangle that shows an image */
};
enum { RUBBLE_LIGHT_ENABLED = 1, RUBBLE_LIGHT_TWO_SIDED = 2 /* an area shines along +z too */ };

/* All values of a light, to add, set and read it. Zeros are values here, not defaults. Ranges: colours 0 to 1e6;
 * radius, width and height 0 to 1000 m; reach 0 to 1e5 m; cone angles 0 to 3.15. set_light() keeps the image of a
 * screen; a screen that is added is white. */
typedef struct rubble_light_settings {
    uint32_t struct_size;
    uint32_t kind;            /* RUBBLE_LIGHT_SPHERE ... */
    rubble_light light;       /* add_light() does not read it */
    rubble_shape shape;       /* position and rotation are in this shape's space and follow it; 0: the world */
    rubble_light_group group; /* while the group is out, the light stays dark; 0: none */
    uint32_t flags;           /* RUBBLE_LIGHT_ENABLED ... */
    uint32_t reserved;
    double position[3]; /* metres */
    double rotation[4]; /* cones, areas and screens face -z */
    double color[3];    /* linear radiant intensity (W/sr in the renderer's units); of areas: straight ahead */
    double radius;      /* metres, of the glowing ball or tube: decides how soft its shadows are */
    double reach;       /* metres beyond which it lights nothing */
    double cone_inner;  /* radians, half angle: full intensity inside */
    double cone_outer;  /* radians, half angle: dark outside */
    double width;       /* metres, along x */
    double height;      /* metres, along y */
} rubble_light_settings;

/* ---- light groups ---- */

enum {
    RUBBLE_GROUP_SWITCH = 1, /* on */
    RUBBLE_GROUP_THRESHOLD = 2,
    RUBBLE_GROUP_SUPPLY = 4 /* supply_shape and supply_cell */
};

/* A light group that create_light_group() makes. */
typedef struct rubble_light_group_settings {
    uint32_t struct_size;
    uint32_t flicker_steps; /* for which it flickers before it goes out */
    double threshold;       /* share of its voxels whose loss puts it out, 0 to 1; 0: 0.4 */
} rubble_light_group_settings;

/* Changes a light group. */
typedef struct rubble_light_group_change {
    uint32_t struct_size;
    uint32_t fields; /* RUBBLE_GROUP_...: what changes; the other values are not read */
    rubble_light_group group;
    uint32_t on; /* 0: lights and voxels of the group are dark until it is switched on. One that is out stays dark */
    uint32_t reserved;
    double threshold;          /* share of its voxels whose loss puts it out, 0 to 1 */
    rubble_shape supply_shape; /* 0: it needs no supply */
    /* a cell of that shape where its wire begins: voxels of the material "wire", which lead to a voxel of the group in
     * the same shape. It goes out if none do, or when they are cut. Trims, resizes and merges take the cell along */
    int32_t supply_cell[3];
    uint32_t reserved_2;
} rubble_light_group_change;

enum { RUBBLE_GROUP_ON = 1, RUBBLE_GROUP_OUT = 2, RUBBLE_GROUP_FAILING = 4 /* it flickers and is about to go out */ };

/* A light group after the last step. */
typedef struct rubble_light_group_state {
    uint32_t struct_size;
    uint32_t flags;            /* RUBBLE_GROUP_ON ... */
    uint64_t voxels;           /* that it began with */
    uint64_t removed_voxels;   /* of those */
    double threshold;          /* as in rubble_light_group_change */
    rubble_shape supply_shape; /* 0: it needs no supply */
    int32_t supply_cell[3];
    uint32_t reserved;
} rubble_light_group_state;

/* ---- renderer ---- */

enum {
    /* draw() leaves what it changes of the GL's state as in a new context (but viewport and scissor), instead of as
     * it was: to know that, it asks the GL some 170 questions a draw. For hosts that set the state that they need,
     * or whose cache of it can be emptied. */
    RUBBLE_RENDERER_RESET_STATE = 1,
    /* Programs are compiled when something is first seen that needs them, not by create_renderer(). It returns
     * seconds earlier; the first explosion, fog or water may stop the game for as long. */
    RUBBLE_RENDERER_COMPILE_LATE = 2
};

typedef struct rubble_renderer_settings {
    uint32_t struct_size;
    uint32_t flags; /* RUBBLE_RENDERER_... */
    /* Null, as the shaders are in the library. Those who change them name a folder with their shaders/, from which
     * programs are rebuilt as its files change. */
    const char* shader_folder;
    const char* preset; /* "draft", "fast", "balanced" or "accurate"; null: "balanced" */
    /* Path of a folder, made if it is missing, in which compiled programs are kept for later runs, where the driver
     * supports that. Null: none. */
    const char* program_cache;
} rubble_renderer_settings;

enum {
    RUBBLE_VIEW_CUT = 1, /* the camera jumped: do not reuse earlier frames */
    /* composes with what the host has drawn: where the framebuffer's depth buffer is nearer than opaque voxels, colour
     * and depth stay, to the pixel; else both are written, also for hosts that draw on. Depths are those of
     * `projection`, in a depth range of 0 to 1. Panes, water, fog and particles that lie before what the host has drawn
     * are drawn over its colours, which count as those that the view writes: of a display, or with RUBBLE_VIEW_LINEAR
     * radiance times exposure. Not in a multisampled framebuffer. Mirrors and shadows do not show it */
    RUBBLE_VIEW_DEPTH = 2,
    RUBBLE_VIEW_ZERO_TO_ONE = 4, /* `projection` has clip depths of 0 to 1, as with glClipControl; else -1 to 1 */
    /* writes radiance times the environment's exposure, for an HDR target and the host's own tone mapping, not the
     * colours of a display. There is no automatic exposure */
    RUBBLE_VIEW_LINEAR = 8,
    RUBBLE_VIEW_FLIP_Y = 16, /* the first row of pixels is the top one */
    /* no automatic exposure: the colours of the display are those of radiance times the environment's exposure. Without
     * it a view adapts as an eye does: within about a third of a second a factor of 0.7 to 2.2 brings the
     * log-average luminance of the image nearer to a middle one, and so works against a part of each change of light
     * and of exposure. RUBBLE_VIEW_CUT adapts at once */
    RUBBLE_VIEW_FIXED_EXPOSURE = 32
};

/* A camera and the target that it draws to. */
typedef struct rubble_view {
    uint32_t struct_size;
    uint32_t flags;       /* RUBBLE_VIEW_... */
    uint32_t framebuffer; /* GL name of the target; 0: the window's */
    uint32_t width;       /* pixels, 1 to 16384 */
    uint32_t height;      /* pixels, 1 to 16384 */
    uint32_t slot;        /* 0 to 15: views drawn in turn, as those of a split screen, have slots of their own, in
                             which the renderer keeps their earlier frames */
    double position[3];   /* of the camera, world */
    double rotation[4];   /* the camera looks along -z with y up */
    double vertical_fov;  /* radians, 0.01 to 3; 0: 1.05 */
    /* 0 to 1: interpolates between the poses of the last two steps. A body that set_body() or undo() has moved half a
     * metre or turned half a radian farther than its velocity does in a step is drawn at its new pose at once */
    double alpha;
    /* column-major, from an eye that looks along -z with y up to clip space: a perspective, also with an infinite far
     * plane, or an orthographic projection, which shows nothing before its near plane, where haze and fog begin. Both
     * also off-centre, with reversed depth. Near and far may be any: voxels before a perspective's near plane and
     * beyond the far one are drawn too, to 65 km along the view axis, and depths end at the planes. Of a perspective,
     * [0] and [5] are 0.001 to 10,000 (fields of view of 3.14 to 0.0002 radians: rays are floats) and [8] and [9] -4 to
     * 4; of an orthographic projection, 1e-4 to 100 (views of 20 km to 2 cm), [12] and [13] -1e5 to 1e5, and the near
     * plane lies within 100 km of the eye. All zeros, without VIEW_DEPTH or _ZERO_TO_ONE: vertical_fov, centred */
    double projection[16];
    /* Shapes that this view leaves out, as its own player or a roof: it draws them neither itself nor in mirrors, and
     * their colours are not in the light that surfaces throw back. They keep their shadows. Pieces that break off are
     * drawn. The array is read in the call; stale handles do no harm. None costs nothing */
    const rubble_shape* hidden_shapes;
    uint32_t hidden_shape_count;
    uint32_t reserved;
} rubble_view;

/* Counters and wall-clock times of the last draw(). */
typedef struct rubble_draw_stats {
    uint32_t struct_size;
    uint32_t draw_calls;
    uint32_t shapes;
    uint32_t bricks;        /* of 8 x 8 x 8 voxels, held on the GPU */
    uint64_t upload_bytes;  /* sent to the GPU by this draw */
    uint64_t texture_bytes; /* held on the GPU now */
    double apply_ms;        /* taking over what steps have changed */
    double draw_ms;         /* of the calling thread; the GPU may take longer */
} rubble_draw_stats;

/* A named place of the level. Its texts live until the next step, level or save, as those of what follows. */
typedef struct rubble_location {
    const char* name;
    double position[3]; /* world */
    double rotation[4];
} rubble_location;

/* A script that the level names, or a prefab that was placed. The library does not run it. */
typedef struct rubble_level_script {
    const char* path;       /* in the level's folder */
    const char* parameters; /* "name=value", a line each */
} rubble_level_script;

/* What an item of an overlay is; RUBBLE_OVERLAY_LINE and those before it lie on a surface. */
enum {
    RUBBLE_OVERLAY_TEXT = 0,
    RUBBLE_OVERLAY_BOX = 1, /* a rectangle of `size`; with a radius of half of it a circle */
    RUBBLE_OVERLAY_IMAGE = 2,
    RUBBLE_OVERLAY_LINE = 3,      /* from (0, 0) to `size` */
    RUBBLE_OVERLAY_WORLD_LINE = 4 /* from `position` to `end`, its stroke in pixels */
};

/* Flags of rubble_overlay_item. */
enum {
    RUBBLE_OVERLAY_IN_WORLD = 1, /* its surface is a plane in the world, else the view */
    RUBBLE_OVERLAY_FACING = 2,   /* that plane faces the camera: rotation is not read */
    RUBBLE_OVERLAY_OCCLUDED = 4, /* in the world: voxels that are nearer hide it */
    RUBBLE_OVERLAY_BASELINE = 8  /* of a text: y = 0 is its first baseline; align[1] is not read */
};

/* Something that is drawn over the image. Its surface has x to the right and y down: the view in pixels from its left
 * upper corner, or a plane in the world in units of `scale` metres. Colours are sRGB with opacity, 0 to 1. */
typedef struct rubble_overlay_item {
    uint32_t struct_size;
    uint32_t kind;  /* RUBBLE_OVERLAY_TEXT ... */
    uint32_t flags; /* RUBBLE_OVERLAY_IN_WORLD ... */
    uint32_t reserved;
    const char* text; /* UTF-8, at most 65536 bytes: a text, whose line feeds begin lines; the name of an image */
    const char* font; /* null or "sans", "bold", "mono": DejaVu; else the path of a font's file */
    double font_size; /* height of an em, 0 to 10000; 0: 16 */
    double
        size[2]; /* 0 to 1e6, of a line -1e6 to 1e6; size[0] of a text: the width at which lines are broken, 0: none */
    double transform[6]; /* (x, y) of the item is (t0 x + t2 y + t4, t1 x + t3 y + t5) of the surface; all 0: (x, y) */
    double align[2];     /* the point of it that is at (0, 0): 0 left or top, 0.5 middle, 1 right or bottom */
    double color[4];     /* also multiplies an image */
    double clip[4];      /* left, top, right, bottom on the surface: nothing is drawn outside; all 0: no such limit */
    double source[4];    /* left, top, right, bottom of the part of an image, in shares; all 0: the whole image */
    double radius;       /* of a box's corners, 0 to 1e6 */
    double stroke;       /* width of a line, or of a box's border, 0 to 1e6; 0: a line of 1, a filled box */
    double outline;      /* width round letters, 0 to 1e4; at most a fifth of font_size is drawn */
    double outline_color[4];
    double shadow_offset[2];
    double shadow_blur;     /* 0 to 1e4; at most a quarter of font_size is drawn */
    double shadow_color[4]; /* opacity 0: letters without a shadow */
    double position[3];     /* in the world, metres: of the surface's (0, 0) */
    double rotation[4];     /* of the surface, whose x is to the right and whose y is against the world's y */
    double scale;           /* metres of a unit, 0 to 1000; 0: 0.01 */
    double end[3];          /* of a world line */
} rubble_overlay_item;

/* An image for items of an overlay. */
typedef struct rubble_overlay_image {
    uint32_t struct_size;
    uint32_t width, height; /* pixels, 1 to 8192 */
    uint32_t reserved;
    const char* name;      /* UTF-8, 1 to 4096 bytes */
    const uint8_t* pixels; /* RGBA with straight alpha, sRGB, rows from the top; null: takes the image away */
} rubble_overlay_image;

/* ---- the function table ---- */

typedef struct rubble_api {
    uint32_t struct_size; /* of the plugin's table */
    uint32_t version;     /* RUBBLE_VERSION of the plugin */

    /* [any-thread] Why the calling thread's last failed call failed: function, what was expected, what was found.
     * Never null; valid until the next call of this thread that fails. */
    const char* (*get_last_error)(void);
    /* [main-thread] Copies the host's services. Null: the defaults. Call it before everything else, not while
     * worlds step. */
    rubble_result (*set_host)(const rubble_host* host);

    /* ---- worlds ---- */

    /* [main-thread] Creates an empty world. settings may be null. More than 255 worlds: RUBBLE_ERROR_CAPACITY. */
    rubble_result (*create_world)(const rubble_world_settings* settings, rubble_world* out);
    /* [main-thread] Destroys a world and all its objects. A renderer of it remains, draws no more, and is
     * destroyed apart. */
    rubble_result (*destroy_world)(rubble_world world);
    /* [main-thread] Replaces the whole world by a level: a .rubble, .vdb or .vox file, told apart by the ending
     * of the UTF-8 path. vdb_tool: path of the program rubble-vdb, which is run as a child process for .vdb
     * files; may be null for others. Drops the edits that wait in the queue, with a warning in the log, and stops a
     * recording. Until the next step() get_events() is empty, and draw() shows what was there before. Bodies begin
     * asleep where the level has them, in the air too, until something wakes them: a hit, an impulse (one of length 0
     * is enough), or an edit that changes what they touch. Those to which the level gives a velocity begin awake.
     * RUBBLE_ERROR_FILE says what is wrong with the file and where, or that there is not enough memory for what it
     * describes; the world is then unchanged. */
    rubble_result (*load_level)(rubble_world world, const char* path, const char* vdb_tool);
    /* [main-thread] Advances the world by exactly 1/60 s: queued edits, then physics. The host decides how many
     * steps a frame needs and draws between them with rubble_view.alpha. */
    rubble_result (*step)(rubble_world world);

    /* ---- edits: commands for the next step ---- */

    /* [main-thread] Removes voxels; see rubble_carve. */
    rubble_result (*carve)(rubble_world world, const rubble_carve* carve);
    /* [main-thread] Breaks voxels into fragments; see rubble_break. */
    rubble_result (*break_voxels)(rubble_world world, const rubble_break* edit);
    /* [main-thread] Breaks and pushes; see rubble_explosion. */
    rubble_result (*explode)(rubble_world world, const rubble_explosion* explosion);
    /* [main-thread] Paints voxels; see rubble_paint. */
    rubble_result (*paint)(rubble_world world, const rubble_paint* paint);
    /* [main-thread] Pushes a body and wakes it; see rubble_impulse. */
    rubble_result (*apply_impulse)(rubble_world world, const rubble_impulse* impulse);

    /* ---- edits: joints, wheels and grabbing ---- */

    /* [main-thread] Adds a joint; see rubble_joint_settings. If a side finds no voxel in anchor_radius, the step
     * adds no joint and logs a warning. get_joint_states() lists it after the step. */
    rubble_result (*add_joint)(rubble_world world, const rubble_joint_settings* settings);
    /* [main-thread] Removes a joint. */
    rubble_result (*remove_joint)(rubble_world world, rubble_joint joint);
    /* [main-thread] Sets motor, friction and steering of a joint and wakes its bodies. */
    rubble_result (*set_joint_motor)(rubble_world world, const rubble_joint_motor* motor);
    /* [main-thread] Drives the wheels of a body; see rubble_drive. */
    rubble_result (*drive_wheels)(rubble_world world, const rubble_drive* drive);
    /* [main-thread] Holds a body; see rubble_grab. */
    rubble_result (*grab_body)(rubble_world world, const rubble_grab* grab);
    /* [main-thread] Lets go of a body; see rubble_release. An empty hand does nothing. */
    rubble_result (*release_body)(rubble_world world, const rubble_release* release);

    /* ---- edits: collision layers, water, triggers and characters ---- */

    /* [main-thread] Sets which shapes a shape collides with. */
    rubble_result (*set_collision_filter)(rubble_world world, const rubble_collision_filter* filter);
    /* [main-thread] Adds water; see rubble_water_settings. */
    rubble_result (*add_water)(rubble_world world, const rubble_water_settings* water);
    /* [main-thread] Removes water. */
    rubble_result (*remove_water)(rubble_world world, rubble_water water);
    /* [main-thread] Adds a trigger; see rubble_trigger_settings. Bodies that are in it already enter in the same
     * step. */
    rubble_result (*add_trigger)(rubble_world world, const rubble_trigger_settings* trigger);
    /* [main-thread] Removes a trigger. */
    rubble_result (*remove_trigger)(rubble_world world, rubble_trigger trigger);
    /* [main-thread] Adds a character; see rubble_character_settings. */
    rubble_result (*add_character)(rubble_world world, const rubble_character_settings* character);
    /* [main-thread] Removes a character. */
    rubble_result (*remove_character)(rubble_world world, rubble_character character);
    /* [main-thread] Says where a character shall go; see rubble_character_move. */
    rubble_result (*move_character)(rubble_world world, const rubble_character_move* move);
    /* [main-thread] Puts a character somewhere else. */
    rubble_result (*teleport_character)(rubble_world world, const rubble_character_teleport* teleport);

    /* ---- edits: environment and lights ---- */

    /* [main-thread] Replaces sky, sun, air, exposure and gravity; see rubble_environment. */
    rubble_result (*set_environment)(rubble_world world, const rubble_environment* environment);
    /* [main-thread] Adds a light. A light on a shape moves with it; when the shape is destroyed the light stays
     * where it was, turned off. A world that has 65,536 lights gets no more. */
    rubble_result (*add_light)(rubble_world world, const rubble_light_settings* light);
    /* [main-thread] Replaces all values of a light under its handle. */
    rubble_result (*set_light)(rubble_world world, const rubble_light_settings* light);
    /* [main-thread] Removes a light. */
    rubble_result (*remove_light)(rubble_world world, rubble_light light);

    /* ---- edits: undo ---- */

    /* A step carries out these four before its other edits, in the order of their calls: a mark is the world as the
     * last step left it, and a call of undo() takes back nothing that waits for the same step. */

    /* [main-thread] How many undo marks are kept. 0, the default: none, at no cost. */
    rubble_result (*set_undo_limit)(rubble_world world, uint32_t marks);
    /* [main-thread] Sets a mark to which undo() returns: the world as the last step left it. */
    rubble_result (*add_undo_mark)(rubble_world world);
    /* [main-thread] Returns to the last mark: objects, motion, environment, materials, settings and bounds. How many
     * marks are kept stays. If nothing but motion has come since the last undo, it returns to the mark before; else to
     * the same mark again. Without such a mark the step logs a warning and undoes nothing. A second undo or redo for
     * the same step is RUBBLE_ERROR_ARGUMENT. What impacts of the step before would break in this one is dropped.
     * Contacts and the tension of joints are no state of the world: they are found again, so that the world goes on
     * in one way whenever the undo comes, but not with the bits of the first time. */
    rubble_result (*undo)(rubble_world world);
    /* [main-thread] Takes the last undo back, unless something has changed since, in the step of the undo too. */
    rubble_result (*redo)(rubble_world world);

    /* ---- state: the world as the last step left it ---- */

    /* [main-thread] What the last step() did, without copying: see the rules for how long the arrays live. */
    rubble_result (*get_events)(rubble_world world, rubble_events* out);
    /* [main-thread] All bodies, in an order that does not change while none is created. */
    rubble_result (*get_body_states)(rubble_world world, rubble_body_state* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] One body. */
    rubble_result (*get_body_state)(rubble_world world, rubble_body body, rubble_body_state* out);
    /* [main-thread] The shapes of one body; body 0: of all bodies. */
    rubble_result (*get_shape_states)(rubble_world world, rubble_body body, rubble_shape_state* out, uint32_t capacity,
                                      uint32_t* count);
    /* [main-thread] All joints, in a fixed order. */
    rubble_result (*get_joint_states)(rubble_world world, rubble_joint_state* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] The points of a rope from its first end on: x, y, z of each, world. capacity and *count are
     * numbers of doubles: three for each point. */
    rubble_result (*get_rope_points)(rubble_world world, rubble_joint joint, double* out, uint32_t capacity,
                                     uint32_t* count);
    /* [main-thread] All volumes of water, in a fixed order. What add_water() added is the last row, unless one was
     * removed before, or made by create_water() in that step. */
    rubble_result (*get_waters)(rubble_world world, rubble_water* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] All triggers, in the same order as get_waters(). */
    rubble_result (*get_triggers)(rubble_world world, rubble_trigger* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] Which bodies entered and left triggers in the last step: where its edits found them. What its
     * physics has moved in or out counts in the next step. */
    rubble_result (*get_trigger_events)(rubble_world world, rubble_trigger_event* out, uint32_t capacity,
                                        uint32_t* count);
    /* [main-thread] The bodies that had a voxel in a trigger when the last step found its events. */
    rubble_result (*get_trigger_bodies)(rubble_world world, rubble_trigger trigger, rubble_body* out, uint32_t capacity,
                                        uint32_t* count);
    /* [main-thread] All characters, in the same order as get_waters(). */
    rubble_result (*get_character_states)(rubble_world world, rubble_character_state* out, uint32_t capacity,
                                          uint32_t* count);
    /* [main-thread] The present sky, sun, air, exposure and gravity. */
    rubble_result (*get_environment)(rubble_world world, rubble_environment* out);
    /* [main-thread] All lights, in a fixed order. */
    rubble_result (*get_lights)(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] All values of one light. */
    rubble_result (*get_light_settings)(rubble_world world, rubble_light light, rubble_light_settings* out);
    /* [main-thread] The lights that the last step added: one row for each add_light() in the order of the calls,
     * 0 for one that the step refused. */
    rubble_result (*get_added_lights)(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] Counts of voxels; see rubble_voxel_accounting. */
    rubble_result (*get_voxel_accounting)(rubble_world world, rubble_voxel_accounting* out);
    /* [main-thread] A hash of everything that decides what happens next: equal worlds have equal hashes. Costs a
     * pass over the objects of the world. */
    rubble_result (*get_state_hash)(rubble_world world, uint64_t* out);
    /* [main-thread] Counters and times of the last step. */
    rubble_result (*get_step_stats)(rubble_world world, rubble_step_stats* out);

    /* ---- queries of the world as the last step left it; filter may be null ---- */

    /* [main-thread] The first voxel that a ray meets. max_distance: metres, 0 to 1e6. Nothing met: RUBBLE_OK,
     * out->hit 0. cast_rays() takes many rays, and a filter. */
    rubble_result (*cast_ray)(rubble_world world, const double origin[3], const double direction[3],
                              double max_distance, rubble_hit* out);
    /* [main-thread] out[i] is the first voxel that rays[i] meets. `count` rows each. */
    rubble_result (*cast_rays)(rubble_world world, const rubble_ray* rays, uint32_t count,
                               const rubble_query_filter* filter, rubble_hit* out);
    /* [main-thread] out[i] is the first voxel that casts[i] meets; distance 0 if it touches one where it starts: of
     * several that a sphere or capsule overlaps there, the one nearest to its centre, or to its axis. */
    rubble_result (*cast_shapes)(rubble_world world, const rubble_shape_cast* casts, uint32_t count,
                                 const rubble_query_filter* filter, rubble_hit* out);
    /* [main-thread] The bodies that have a voxel in a region, in a fixed order. */
    rubble_result (*overlap_bodies)(rubble_world world, const rubble_query_shape* region,
                                    const rubble_query_filter* filter, rubble_body* out, uint32_t capacity,
                                    uint32_t* count);
    /* [main-thread] The shapes that have a voxel in a region, in a fixed order. */
    rubble_result (*overlap_shapes)(rubble_world world, const rubble_query_shape* region,
                                    const rubble_query_filter* filter, rubble_shape* out, uint32_t capacity,
                                    uint32_t* count);
    /* [main-thread] The point of a voxel that is closest to a position; distance 0 inside a voxel. max_distance:
     * metres, at most 1e6. Nothing within it: out->hit is 0. */
    rubble_result (*find_closest_point)(rubble_world world, const double position[3], double max_distance,
                                        const rubble_query_filter* filter, rubble_hit* out);

    /* ---- a model of the sky ---- */

    /* [any-thread] Sets the colours of sun, sky, haze and ground, and the stars, to those of a position of the sun and
     * the struct's `clouds`: redder near the horizon, twilight and night below it. The other fields stay.
     * sun_direction: towards the sun, world. The environment must be valid, as for set_environment(). */
    rubble_result (*apply_sky_model)(rubble_environment* environment, const double sun_direction[3]);

    /* ---- saved games and recordings ---- */

    /* [main-thread] Writes the game between two steps to a file, whole or not at all, with the edits that wait in
     * the queue. Symbolic links are followed; what is no regular file, such as a folder or a device, is not replaced.
     * The next step of the running game begins with physics rebuilt from the world, as a loaded game
     * does, so that playing on and loading give the same result. What takes several steps to compute, as stress and
     * what comes off under `split_parts`, begins again in both: get_state_hash() has it, get_resolved_hash() does not.
     * Undo marks are not in the file: a loaded game has none. RUBBLE_ERROR_ARGUMENT: an undo or redo waits for the
     * next step. RUBBLE_ERROR_FILE: the file cannot be written; nothing has changed. */
    rubble_result (*save_game)(rubble_world world, const char* path);
    /* [main-thread] Replaces the whole world and its queue of edits by those of a saved game, and stops a recording.
     * translate_handle() gives the handles of this world for those that the objects had when they were saved.
     * RUBBLE_ERROR_FILE: the world is unchanged. */
    rubble_result (*load_game)(rubble_world world, const char* path);
    /* [main-thread] Records every step from here on, beginning with a saved game. The file has its name after
     * stop_recording() or destroy_world(); a recording that is running is stopped, and the log says what of it could
     * not be written. Undo marks from before are dropped. RUBBLE_ERROR_FILE: the file cannot be written, with the
     * saved game in it, or a recording is being written to it; the world and its marks are unchanged, and a recording
     * that is running goes on. */
    rubble_result (*start_recording)(rubble_world world, const char* path);
    /* [main-thread] Completes the file; without a recording it does nothing. RUBBLE_ERROR_FILE: some of it could
     * not be written, as the log said in that step; the file has the steps before. */
    rubble_result (*stop_recording)(rubble_world world);
    /* [main-thread] Loads the start of a recording and plays all its steps. *steps (may be null) counts the steps
     * that had the recorded state hash. RUBBLE_ERROR_FILE: the file is damaged (the world is unchanged), or a
     * step had another hash because another build made the recording (the world is as after that step). */
    rubble_result (*play_recording)(rubble_world world, const char* path, uint64_t* steps);

    /* ---- renderer: OpenGL 3.3 core or later, OpenGL ES 3.0 or WebGL 2, always with the same context current ---- */

    /* [render-thread] Creates the renderer of a world, which can have one at a time. Another one after the first, as
     * after a lost context, shows the world from the next step() on. Needs rubble_host.gl_get_proc_address.
     * RUBBLE_ERROR_GL: something of GL is missing, or a shader does not compile (with file and line). */
    rubble_result (*create_renderer)(rubble_world world, const rubble_renderer_settings* settings,
                                     rubble_renderer* out);
    /* [render-thread] Draws the world as the last step() left it. RUBBLE_ERROR_GL: nothing was drawn.
     * RUBBLE_ERROR_STALE: the world was destroyed. */
    rubble_result (*draw)(rubble_renderer renderer, const rubble_view* view);
    /* [render-thread] Makes draw() show an intermediate image ("albedo", "normal", "depth", ...), for debugging.
     * Null or "final": the finished frame. RUBBLE_ERROR_ARGUMENT lists the names that there are. */
    rubble_result (*set_debug_view)(rubble_renderer renderer, const char* name);
    /* [render-thread] Counters and times of the last draw(). */
    rubble_result (*get_draw_stats)(rubble_renderer renderer, rubble_draw_stats* out);
    /* [render-thread] Destroys the renderer and its GL objects. Its context must be current. With another one current,
     * as after a lost context, no GL object is touched: what its own context still has goes with that.
     * RUBBLE_ERROR_GL: no context is current. */
    rubble_result (*destroy_renderer)(rubble_renderer renderer);

    /* ---- bounds ---- */

    /* [main-thread] Sets where the world ends from the next step on; see rubble_bounds. Saves and recordings keep it.
     */
    rubble_result (*set_bounds)(rubble_world world, const rubble_bounds* bounds);
    /* [main-thread] The bounds in use, as the last step() knew them. Low and high are equal if there are none. */
    rubble_result (*get_bounds)(rubble_world world, rubble_bounds* out);

    /* ---- edits: collision shapes ---- */

    /* [main-thread] Sets what a shape is touched as; see rubble_collision_shape. Pieces of it inherit it. */
    rubble_result (*set_collision_shape)(rubble_world world, const rubble_collision_shape* shape);

    /* ---- handles of saved games, rows of later versions ---- */

    /* [main-thread] The handle that something has in this world: `handle` named it in the world that was saved, if this
     * one was loaded from there. A handle carries the number of its world, so a host that stores handles beside a saved
     * game asks for each after load_game(). Nothing of that name is here: *out is 0 and RUBBLE_ERROR_STALE. */
    rubble_result (*translate_handle)(rubble_world world, uint64_t handle, uint64_t* out);
    /* [main-thread] A list as get_body_states() and its like write it, with rows of the host's size; see
     * rubble_row_list. `out` holds `capacity` rows of list->row_size bytes. */
    rubble_result (*read_rows)(rubble_world world, const rubble_row_list* list, void* out, uint32_t capacity,
                               uint32_t* count);

    /* ---- edits and reads of whole shapes ---- */

    /* [main-thread] Makes shapes of the parts of a shape that do not touch: what is held to the world, or else the
     * largest part, stays. For shapes that come in parts from a level; what an edit cuts off comes off by itself. All
     * parts come off in one step, whose cost grows with their number. */
    rubble_result (*split_shape)(rubble_world world, rubble_shape shape);
    /* [main-thread] Adds a shape to another one of the same body and voxel size that it touches face to face; 0: to the
     * first that fits. Where both have a voxel, `into` keeps its own. Joints and lights go with it, and its voxels'
     * palette entries: those of `into` that no voxel has make room. The step logs a warning, and does nothing, if their
     * cells do not line up or their voxels need more than 255 entries. */
    rubble_result (*merge_shape)(rubble_world world, rubble_shape shape, rubble_shape into);
    /* [main-thread] Shrinks a shape's grid to its voxels. If it gets smaller, its fires go out. */
    rubble_result (*trim_shape)(rubble_world world, rubble_shape shape);
    /* [main-thread] Gives a shape's grid another box of cells; see rubble_resize. */
    rubble_result (*resize_shape)(rubble_world world, const rubble_resize* resize);
    /* [main-thread] Reads a box of cells as the last step left them: one byte each, x fastest, then y, then z.
     * `capacity` is in bytes; *count becomes the number of cells in the box. Capacity 0 asks for that alone; fewer
     * bytes than cells: RUBBLE_ERROR_CAPACITY, and nothing is written. */
    rubble_result (*read_voxels)(rubble_world world, const rubble_voxel_box* box, uint8_t* out, uint64_t capacity,
                                 uint64_t* count);
    /* [main-thread] Frees the end of a rope that is on a shape. Joints of other kinds are removed, and a rope that
     * nothing holds any more. */
    rubble_result (*detach_joint)(rubble_world world, rubble_joint joint, rubble_shape shape);

    /* ---- fire ---- */

    /* [main-thread] Heats or lights what lies in a sphere; see rubble_heat. */
    rubble_result (*heat)(rubble_world world, const rubble_heat* heat);
    /* [main-thread] Puts fires out; see rubble_extinguish. */
    rubble_result (*extinguish)(rubble_world world, const rubble_extinguish* extinguish);
    /* [main-thread] Puts out all fires in a box along the world's axes. */
    rubble_result (*remove_fires)(rubble_world world, const double low[3], const double high[3]);
    /* [main-thread] All that burns, in a fixed order. Costs what is hot. */
    rubble_result (*get_fires)(rubble_world world, rubble_fire* out, uint32_t capacity, uint32_t* count);

    /* ---- edits of bodies and voxels ---- */

    /* [main-thread] Changes place, motion or sleep of a body; see rubble_body_change. Shapes of a static
     * body that moves keep their handles and meshes: it is among RUBBLE_ROWS_MOVED_BODIES. */
    rubble_result (*set_body)(rubble_world world, const rubble_body_change* change);
    /* [main-thread] Erases a body and all its shapes, without dust or pieces. Their joints break, their lights go out.
     */
    rubble_result (*destroy_body)(rubble_world world, rubble_body body);
    /* [main-thread] Erases a shape, without dust or pieces, and its body if it has no other. */
    rubble_result (*destroy_shape)(rubble_world world, rubble_shape shape);
    /* [main-thread] Gives the cells of a box, which lies within the shape's grid, other voxels: one byte each as
     * read_voxels() gives them, RUBBLE_VOXEL_INDEX only; `size` is the number of cells. Copied by the call, with the
     * box's mask. Who draws in what read_voxels() gave names the changed cells there: the others would go back to what
     * the last step left, and undo a carve() of this one. Cells that change lose their paint; no event and no
     * dust tells of voxels that are gone by it. Voxels that then touch nothing that holds them come off in the same
     * step, and so does what hung on voxels that are gone. */
    rubble_result (*write_voxels)(rubble_world world, const rubble_voxel_box* box, const uint8_t* voxels,
                                  uint64_t size);

    /* ---- making things: edits that give a handle at once ---- */

    /* [main-thread] Makes a body without shapes: a frame, which is not simulated until it has one. *out names it: in
     * edits from now on, in reads after the next step(). */
    rubble_result (*create_body)(rubble_world world, const rubble_body_settings* settings, rubble_body* out);
    /* [main-thread] Makes a shape on a body, as a level brings it: on a static body its lowest layer of voxels holds it
     * to the world (of RUBBLE_SHAPE_EMPTY the lowest cells), and parts of it that touch nothing stay until something is
     * cut. The lowest layer is that at the side of its grid which faces -y of the world most when the step makes it, of
     * equal ones that of the lowest cells along y; a static body that is turned later is held by the same cells. Each
     * point of a free body moves on as it did. A shape that has no voxels after the edits of the step is refused. *out
     * as by create_body(). */
    rubble_result (*create_shape)(rubble_world world, const rubble_shape_settings* settings, rubble_shape* out);
    /* [main-thread] As add_joint(), with a handle as by create_body(). The joint is placed where its shapes are when
     * the step carries it out; refused if it finds no voxel to hold on to. */
    rubble_result (*create_joint)(rubble_world world, const rubble_joint_settings* settings, rubble_joint* out);
    /* [main-thread] As add_light(), with a handle as by create_body(). */
    rubble_result (*create_light)(rubble_world world, const rubble_light_settings* settings, rubble_light* out);
    /* [main-thread] As add_water(), with a handle as by create_body(). */
    rubble_result (*create_water)(rubble_world world, const rubble_water_settings* settings, rubble_water* out);
    /* [main-thread] As add_trigger(), with a handle as by create_body(). */
    rubble_result (*create_trigger)(rubble_world world, const rubble_trigger_settings* settings, rubble_trigger* out);
    /* [main-thread] As add_character(), with a handle as by create_body(). */
    rubble_result (*create_character)(rubble_world world, const rubble_character_settings* settings,
                                      rubble_character* out);
    /* [main-thread] Places the bodies of a level into the running world, with their shapes, joints and lights; see
     * rubble_prefab. The rows of `out` are in the order of the file: bodies, shapes, joints, lights; each handle is as
     * by create_body(). Capacity 0 asks for their number alone; fewer rows than that: RUBBLE_ERROR_CAPACITY, and
     * nothing is made either way. RUBBLE_ERROR_FILE: the level cannot be read. */
    rubble_result (*create_prefab)(rubble_world world, const rubble_prefab* prefab, rubble_prefab_row* out,
                                   uint32_t capacity, uint32_t* count);
    /* [main-thread] What the last step did not make, though a call gave a handle for it, and why: its body was
     * destroyed before its turn, it has no voxels, an undo in the same step took its place. In the order of the calls,
     * but for shapes without voxels, which are last. */
    rubble_result (*get_refusals)(rubble_world world, rubble_refusal* out, uint32_t capacity, uint32_t* count);

    /* ---- names, tags and values of objects ---- */

    /* `object` is the handle of a body, shape, light, light group, water, trigger, character or joint. What a level
     * says of names and tags is there after load_level(). A piece has the name, the tags and the user value of the
     * shape that it came off; its body only the name that a level gave. Objects of which a host says nothing cost
     * nothing. */

    /* [main-thread] Gives an object a name: UTF-8, at most 4096 bytes. Names need not be unique. */
    rubble_result (*set_name)(rubble_world world, uint64_t object, const char* name);
    /* [main-thread] The name of an object, with a zero byte at its end, which *count counts. Fewer bytes of capacity:
     * RUBBLE_ERROR_CAPACITY, and nothing is written. */
    rubble_result (*get_name)(rubble_world world, uint64_t object, char* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] Gives an object a tag, or a tag that it has another value. tag: UTF-8, 1 to 4096 bytes without "=".
     * value: as a name; may be null, as "". */
    rubble_result (*set_tag)(rubble_world world, uint64_t object, const char* tag, const char* value);
    /* [main-thread] Takes a tag away; an object without it stays as it is. */
    rubble_result (*remove_tag)(rubble_world world, uint64_t object, const char* tag);
    /* [main-thread] The value of a tag, as get_name() gives a name; *count is 0 if the object has no such tag, and 1 if
     * it has it without a value. */
    rubble_result (*get_tag)(rubble_world world, uint64_t object, const char* tag, char* out, uint32_t capacity,
                             uint32_t* count);
    /* [main-thread] All tags of an object, as get_name() gives a name: "TAG" or "TAG=VALUE", each with a zero byte at
     * its end. */
    rubble_result (*get_tags)(rubble_world world, uint64_t object, char* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] Gives an object a number of the host's own, such as a pointer or an index. */
    rubble_result (*set_user_value)(rubble_world world, uint64_t object, uint64_t value);
    /* [main-thread] That number; 0 if there is none. */
    rubble_result (*get_user_value)(rubble_world world, uint64_t object, uint64_t* out);

    /* ---- lists of objects ---- */

    /* [main-thread] All objects of a kind, RUBBLE_KIND_..., in a fixed order. */
    rubble_result (*get_objects)(rubble_world world, uint32_t kind, uint64_t* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] What belongs to an object, in a fixed order: shapes, joints and lights of a body, joints and lights
     * of a shape, lights of a light group. Other pairs of kinds are RUBBLE_ERROR_ARGUMENT. */
    rubble_result (*get_objects_of)(rubble_world world, uint64_t owner, uint32_t kind, uint64_t* out, uint32_t capacity,
                                    uint32_t* count);
    /* [main-thread] The objects of a kind that have a name, in a fixed order. Costs a look at each of that kind. */
    rubble_result (*find_by_name)(rubble_world world, uint32_t kind, const char* name, uint64_t* out, uint32_t capacity,
                                  uint32_t* count);
    /* [main-thread] The objects of a kind that have a tag, in a fixed order. value: that it has; null: any. */
    rubble_result (*find_by_tag)(rubble_world world, uint32_t kind, const char* tag, const char* value, uint64_t* out,
                                 uint32_t capacity, uint32_t* count);
    /* [main-thread] What a piece came off: *parent is the shape that it was a part of, *root the first shape of that
     * line, which is no piece. Either may be gone by now. 0: the shape is no piece, or nobody asked for it; see
     * RUBBLE_SETTING_KEEP_ORIGINS. */
    rubble_result (*get_origin)(rubble_world world, rubble_shape shape, rubble_shape* parent, rubble_shape* root);
    /* [main-thread] What became of a shape: the pieces that have it as their parent or root, in a fixed order. The
     * shape may be gone; if it is not, it is what is left of itself and not in the list. */
    rubble_result (*get_pieces)(rubble_world world, rubble_shape shape, rubble_shape* out, uint32_t capacity,
                                uint32_t* count);

    /* ---- settings ---- */

    /* [main-thread] Replaces the settings of the world from the next step on. Saves and recordings keep them. */
    rubble_result (*set_settings)(rubble_world world, const rubble_settings* settings);
    /* [main-thread] The settings in use, as the last step() knew them. */
    rubble_result (*get_settings)(rubble_world world, rubble_settings* out);

    /* ---- palettes ---- */

    /* [main-thread] Replaces entries of a shape's palette from the next step on: `range->count` rows. Voxels look,
     * weigh, break, burn and slide as their new material does; those that change their light group count in the new
     * one. Shapes that share the palette keep theirs, but with RUBBLE_PALETTE_ALL_EQUAL. Voxels that were painted
     * or have charred are of entries of their own, which stay as they are. Paint that blends takes entries that no
     * voxel has: those without a material, then those that equal another one, then any. */
    rubble_result (*set_palette)(rubble_world world, const rubble_palette_range* range,
                                 const rubble_palette_entry* entries);
    /* [main-thread] Reads entries of a shape's palette: `range->count` rows. */
    rubble_result (*get_palette)(rubble_world world, const rubble_palette_range* range, rubble_palette_entry* out);

    /* ---- layers, and worlds that the host's physics moves ---- */

    /* [any-thread] What this library has beside the runtime: bits of RUBBLE_LAYER_... */
    rubble_result (*get_layers)(uint32_t* layers);
    /* [main-thread] Mass, centre, inertia and motion of bodies, in a fixed order. which: RUBBLE_BODIES_CHANGED or
     * RUBBLE_BODIES_ALL. Costs the bodies that are listed. Of worlds with physics of their own as well. */
    rubble_result (*get_rigid_bodies)(rubble_world world, uint32_t which, rubble_rigid_body* out, uint32_t capacity,
                                      uint32_t* count);
    /* [main-thread] Boxes for a collider of the host: a compound, in the body's frame. Costs the bricks of its shapes.
     */
    rubble_result (*get_body_boxes)(rubble_world world, rubble_body body, rubble_body_box* out, uint32_t capacity,
                                    uint32_t* count);
    /* [main-thread] The impulses that edits of the last step gave to free bodies, as explosions and apply_impulse()
     * do, in their order. A physics of the world's own has applied them; the host's has to. */
    rubble_result (*get_body_impulses)(rubble_world world, rubble_body_impulse* out, uint32_t capacity,
                                       uint32_t* count);
    /* [main-thread] What a step of the host's physics has made of bodies, at once: later reads see it, and undo marks
     * and edits of the next step. `count` rows as get_body_states() gives them; shape_count is not read. Only of free
     * bodies: what is static moves by set_body(). Recordings keep it. RUBBLE_ERROR_UNSUPPORTED: the world has physics
     * of its own. */
    rubble_result (*set_body_states)(rubble_world world, const rubble_body_state* states, uint32_t count);
    /* [main-thread] Hits of the host's physics, at places as the last set_body_states() left them: the next step breaks
     * what they break by strength, impulse and rubble_settings, the hardest first. What has broken through something
     * gets the rest of its momentum back by get_body_impulses(). A hit that lasts for several steps is reported once,
     * and resting contacts not at all. Recordings keep it. RUBBLE_ERROR_UNSUPPORTED: as by set_body_states(). */
    rubble_result (*report_impacts)(rubble_world world, const rubble_impact* impacts, uint32_t count);

    /* ---- files in memory ---- */

    /* [main-thread] As load_level(), of a .rubble or .vox file in memory, which is not read after the call. */
    rubble_result (*load_level_data)(rubble_world world, const void* data, uint64_t size);
    /* [main-thread] As save_game(), into memory: `capacity` is in bytes; *count becomes the size of the file. Capacity
     * 0 asks for that alone and saves nothing; fewer bytes than that: RUBBLE_ERROR_CAPACITY, and nothing is saved.
     * RUBBLE_ERROR_FILE: a file cannot be so large. */
    rubble_result (*save_game_data)(rubble_world world, uint8_t* out, uint64_t capacity, uint64_t* count);
    /* [main-thread] As load_game(), of a saved game in memory, which is not read after the call. */
    rubble_result (*load_game_data)(rubble_world world, const void* data, uint64_t size);
    /* [main-thread] As play_recording(), of a recording in memory. rubble_host.write_file takes recordings into memory.
     */
    rubble_result (*play_recording_data)(rubble_world world, const void* data, uint64_t size, uint64_t* steps);

    /* ---- deltas: a world that follows another ---- */

    /* [main-thread] From now on each step keeps what it changed, for worlds that are equal to this one now, to their
     * handles: those that load save_game_data() of now. One that has come by the same voxels in another way may have
     * given its objects other handles, and is then refused. What was kept before is dropped: take it first. on:
     * RUBBLE_DELTAS_...; RUBBLE_DELTAS_NONE ends it, as loading does, and costs nothing. */
    rubble_result (*keep_deltas)(rubble_world world, uint32_t on);
    /* [main-thread] Takes what steps have kept since the last call that gave it. `capacity` is in bytes; *count becomes
     * the size. Capacity 0 asks for that alone; fewer bytes than that: RUBBLE_ERROR_CAPACITY; nothing is taken either
     * way. RUBBLE_ERROR_ARGUMENT: none are kept. */
    rubble_result (*take_deltas)(rubble_world world, uint8_t* out, uint64_t capacity, uint64_t* count);
    /* [main-thread] Carries out steps of another world: objects, voxels and motion become those, without edits or
     * physics. Each take of the other world is applied once, in their order, from the first after keep_deltas() on;
     * a step() of this world in between ends that. get_events() tells which objects came and went in the last of the
     * steps, also a shape that its leader tells of as changed; what was removed, painted, split and broken only with
     * RUBBLE_DELTAS_EVENTS. get_reports() has the breaks then, and is empty otherwise: nothing tells of contacts,
     * joints, fires, water and footsteps of the other world. It stops a recording, and keep_deltas() of this world.
     * Heat, ropes between their ends, what is still to split and data of the host are left out, see
     * get_resolved_hash(). Of RUBBLE_DELTAS_EDITS, poses, velocities and sleep of free bodies that were there before
     * and of characters are left out too: see get_voxel_hash(). A world with RUBBLE_WORLD_HOST_PHYSICS gets them by
     * set_body_states(), before this call. RUBBLE_ERROR_FILE: the bytes are wrong or steps are missing, and this world
     * is as after the step before; or a step has shown that it was another one. What it makes in steps of its own may
     * get other handles than there. */
    rubble_result (*apply_deltas)(rubble_world world, const void* data, uint64_t size);
    /* [main-thread] A hash of what RUBBLE_DELTAS_ALL keep equal: all objects, voxels, environment, materials, settings
     * and bounds. How many undo marks are kept is not among them. */
    rubble_result (*get_resolved_hash)(rubble_world world, uint64_t* out);

    /* ---- loading in the background ---- */

    /* [main-thread] Begins to read a level, as load_level() does, on a thread of its own; the world plays on. Where
     * there are no threads, as in browsers, it reads it now. A level that is being read already is dropped, when it has
     * been read. */
    rubble_result (*start_loading)(rubble_world world, const char* path, const char* vdb_tool);
    /* [main-thread] How far that is: *out is 0 to 1, by parts of the file; 1: finish_loading() does not wait for it.
     * RUBBLE_ERROR_ARGUMENT: no level is being read. */
    rubble_result (*get_loading_progress)(rubble_world world, double* out);
    /* [main-thread] Replaces the world by that level, as load_level() does. Waits for the rest of it.
     * RUBBLE_ERROR_ARGUMENT: no level is being read. RUBBLE_ERROR_FILE: as by load_level(). */
    rubble_result (*finish_loading)(rubble_world world);

    /* ---- materials ---- */

    /* [main-thread] Replaces rows of the table of materials from the next step on, or adds rows behind its last one:
     * row `first` and those behind it, 1 to 255. All that is of them weighs, breaks, burns and slides as they say. Rows
     * are never removed, because palettes hold their numbers; row 0 is that of no material. */
    rubble_result (*set_materials)(rubble_world world, uint32_t first, const rubble_material* materials,
                                   uint32_t count);
    /* [main-thread] A row of the table. RUBBLE_ERROR_ARGUMENT: there is no such row. */
    rubble_result (*get_material)(rubble_world world, uint32_t index, rubble_material* out);
    /* [main-thread] How many rows the table has, with row 0. */
    rubble_result (*get_material_count)(rubble_world world, uint32_t* count);
    /* [main-thread] The row of a name; of several the first. 0: there is none. */
    rubble_result (*find_material)(rubble_world world, const char* name, uint32_t* index);

    /* ---- properties of bodies and shapes ---- */

    /* [main-thread] Mass, gravity and damping of a body; set_body() changes the last two. */
    rubble_result (*get_body_properties)(rubble_world world, rubble_body body, rubble_body_properties* out);
    /* [main-thread] Changes strength, density, emission, load or anchors of a shape; see rubble_shape_change. */
    rubble_result (*set_shape)(rubble_world world, const rubble_shape_change* change);
    /* [main-thread] What set_shape(), set_collision_filter() and set_collision_shape() set. */
    rubble_result (*get_shape_properties)(rubble_world world, rubble_shape shape, rubble_shape_properties* out);
    /* [main-thread] The boxes of cells that hold a static shape to the world. */
    rubble_result (*get_anchors)(rubble_world world, rubble_shape shape, rubble_cell_box* out, uint32_t capacity,
                                 uint32_t* count);

    /* [main-thread] How many threads physics has from the next step on, with the one that calls step(): 1 to 64, as in
     * rubble_world_settings. No edit: results do not depend on it, and neither saves nor recordings keep it. */
    rubble_result (*set_physics_threads)(rubble_world world, uint32_t threads);

    /* ---- fires at a place ---- */

    /* [main-thread] The fire whose middle is closest to a position; of equals the first of get_fires(). max_distance:
     * metres, 0 to 1e6. None within it: RUBBLE_OK, out->shape 0. Costs what is hot. */
    rubble_result (*find_closest_fire)(rubble_world world, const double position[3], double max_distance,
                                       rubble_fire* out);
    /* [main-thread] How many fires have their middle in a box along the world's axes. Costs what is hot. */
    rubble_result (*count_fires)(rubble_world world, const double low[3], const double high[3], uint32_t* count);

    /* ---- light groups ---- */

    /* [main-thread] Makes a light group, with a handle as by create_body(): for lights, and for entries of palettes
     * whose voxels then count in it. A world keeps its groups for good. */
    rubble_result (*create_light_group)(rubble_world world, const rubble_light_group_settings* settings,
                                        rubble_light_group* out);
    /* [main-thread] Switches a light group, or says what puts it out; see rubble_light_group_change. */
    rubble_result (*set_light_group)(rubble_world world, const rubble_light_group_change* change);
    /* [main-thread] One light group; get_objects() lists them. */
    rubble_result (*get_light_group)(rubble_world world, rubble_light_group group, rubble_light_group_state* out);

    /* ---- reports for sound and score ---- */

    /* [main-thread] What get_reports() lists from the next step on, until this is called again; see
     * rubble_report_filter. It belongs to the host, not to the game: levels, saves and recordings do not have it.
     * RUBBLE_ERROR_UNSUPPORTED: contacts, water and footsteps in a world with RUBBLE_WORLD_HOST_PHYSICS, whose host
     * knows of them. */
    rubble_result (*set_report_filter)(rubble_world world, const rubble_report_filter* filter);
    /* [main-thread] What happened in the last step of what the host has asked for, without copying: the arrays live as
     * long as those of get_events(). It is empty after a load; see apply_deltas(). */
    rubble_result (*get_reports)(rubble_world world, rubble_reports* out);

    /* ---- meshes and data of bricks ---- */

    /* [main-thread] The bricks of a shape that changed after a version, by z, then y, then x. *version becomes that of
     * now: what the host copies before the next step() is of it. From the first such call on, steps note what changes.
     * RUBBLE_ERROR_STALE: the shape is gone, or has another grid since that version: drop the copy and ask with version
     * 0. */
    rubble_result (*get_changed_bricks)(rubble_world world, const rubble_brick_changes* changes, uint64_t* version,
                                        rubble_brick* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] The faces of a brick that are seen, as rectangles: four vertices each, RUBBLE_MAX_BRICK_VERTICES at
     * most. Opaque voxels hide the faces of opaque ones, all voxels hide those of transparent ones. The rectangles of
     * all bricks cover each such face once. Their corners may lie on edges of others (T-junctions): transform equal
     * positions alike. brick: x, y, z; of one outside the grid, and of an empty one, there are none. */
    rubble_result (*mesh_brick)(rubble_world world, rubble_shape shape, const int32_t brick[3], rubble_mesh_vertex* out,
                                uint32_t capacity, uint32_t* count);
    /* [main-thread] Copies palette indices and paint of bricks of a shape, RUBBLE_BRICK_BYTES each, in the order of
     * `bricks`, whose is_empty is not read. All are 0 where there is no brick. `capacity` is in bytes; *count becomes
     * the number of bytes. Capacity 0 asks for that alone; fewer: RUBBLE_ERROR_CAPACITY, and nothing is written. */
    rubble_result (*read_bricks)(rubble_world world, rubble_shape shape, const rubble_brick* bricks,
                                 uint32_t brick_count, uint8_t* out, uint64_t capacity, uint64_t* count);
    /* [main-thread] The bricks of the shadow volume that changed after a version, by z, then y, then x; 0: all with
     * cells. *version becomes that of now, which may be some steps behind; see rubble_step_stats.shadow_lag.
     * RUBBLE_ERROR_STALE: all has been replaced since that version, as by a level: drop the copy and ask with 0.
     * RUBBLE_ERROR_ARGUMENT: the world was created without RUBBLE_WORLD_SHADOW_DATA. */
    rubble_result (*get_shadow_bricks)(rubble_world world, uint64_t since, uint64_t* version, rubble_shadow_brick* out,
                                       uint32_t capacity, uint32_t* count);

    /* ---- particles ---- */

    /* [main-thread] Throws particles into the air at once; they move from the next step on. They are only drawn:
     * recordings and saves do not have them. RUBBLE_ERROR_ARGUMENT, here and below: the world was created with
     * RUBBLE_WORLD_NO_RENDERER and without RUBBLE_WORLD_PARTICLES. */
    rubble_result (*spawn_particles)(rubble_world world, const rubble_particle_burst* burst);
    /* [main-thread] All that is in the air, the oldest first: dust, smoke, flames and what the host has added. A load
     * takes all of it away, and so does the step of an undo() or redo(). */
    rubble_result (*get_particles)(rubble_world world, rubble_particle* out, uint32_t capacity, uint32_t* count);

    /* ---- ropes ---- */

    /* [main-thread] The points of all ropes, one rope after the other, for hosts that draw them. */
    rubble_result (*get_ropes)(rubble_world world, rubble_rope_point* out, uint32_t capacity, uint32_t* count);

    /* ---- one object by its handle ---- */

    /* [main-thread] One shape: where a piece is that get_events() has named. */
    rubble_result (*get_shape_state)(rubble_world world, rubble_shape shape, rubble_shape_state* out);
    /* [main-thread] One character. */
    rubble_result (*get_character_state)(rubble_world world, rubble_character character, rubble_character_state* out);

    /* ---- deltas without motion ---- */

    /* [main-thread] A hash of what RUBBLE_DELTAS_EDITS keep equal: voxels, their palettes and paint, and light groups.
     * Poses are not in it: it is the same on every machine. */
    rubble_result (*get_voxel_hash)(rubble_world world, uint64_t* out);

    /* ---- edits: commands for the next step ---- */

    /* [main-thread] How many voxels that carve() would remove from the world as the last step left it. Nothing is
     * queued, and edits that wait are not counted; nor is what would come off and is too small to be a piece. Costs
     * what the carve costs. */
    rubble_result (*count_carve)(rubble_world world, const rubble_carve* carve, uint64_t* count);

    /* ---- edits: joints, wheels and grabbing ---- */

    /* [main-thread] Holds the velocity of a body in the next step; see rubble_body_constraint. Wakes both bodies. */
    rubble_result (*constrain_bodies)(rubble_world world, const rubble_body_constraint* constraint);
    /* [main-thread] One joint. */
    rubble_result (*get_joint_state)(rubble_world world, rubble_joint joint, rubble_joint_state* out);
    /* [main-thread] Limits, motor and spring of a joint, and where its free motion is. */
    rubble_result (*get_joint_properties)(rubble_world world, rubble_joint joint, rubble_joint_properties* out);

    /* ---- places, scripts and data that a game carries ---- */

    /* [main-thread] The named places of the level. Saves keep them. */
    rubble_result (*get_locations)(rubble_world world, rubble_location* out, uint32_t capacity, uint32_t* count);
    /* [main-thread] The scripts of the level, then those of the prefabs that were placed, as the last step left them.
     * Saves keep them. */
    rubble_result (*get_level_scripts)(rubble_world world, rubble_level_script* out, uint32_t capacity,
                                       uint32_t* count);
    /* [main-thread] Keeps bytes under a name with the game, at once: saves have them, and the start of a recording.
     * They are no part of the state hash. name: UTF-8, 1 to 4096 bytes. size: at most 16 MiB; 0: forgets them. A level
     * that is loaded forgets all. RUBBLE_ERROR_CAPACITY: there are 1000 other names already. */
    rubble_result (*set_host_data)(rubble_world world, const char* name, const uint8_t* data, uint64_t size);
    /* [main-thread] Copies such bytes. *count becomes their number, 0 where there are none. Capacity 0 asks for that
     * alone; fewer: RUBBLE_ERROR_CAPACITY, and nothing is written. */
    rubble_result (*get_host_data)(rubble_world world, const char* name, uint8_t* out, uint64_t capacity,
                                   uint64_t* count);

    /* ---- an overlay: text, boxes, images and lines over the image ---- */

    /* [render-thread] What draw() draws over the image from now on, in this order; count 0: nothing, which costs
     * nothing. The items are copied. All have the struct_size of the first one; 65536 at most. The first draw() with an
     * overlay builds its program. RUBBLE_ERROR_FILE: a font cannot be read. RUBBLE_ERROR_ARGUMENT: an image is not
     * there, among others. Then the items are as before. */
    rubble_result (*set_overlay)(rubble_renderer renderer, const rubble_overlay_item* items, uint32_t count);
    /* [render-thread] Gives an image a name for items, or replaces it. The pixels are copied. RUBBLE_ERROR_CAPACITY:
     * there would be more than 4096 images of this renderer, or more than 1 GiB of pixels. */
    rubble_result (*set_overlay_image)(rubble_renderer renderer, const rubble_overlay_image* image);
    /* [any-thread] Width and height of a text as set_overlay() draws it, of which text, font, font_size and size[0]
     * are read. RUBBLE_ERROR_FILE: the font cannot be read. */
    rubble_result (*measure_text)(const rubble_overlay_item* item, double out[2]);

    /* ---- for editors of levels ---- */

    /* [main-thread] Carries out the edits that wait and nothing else, as a step() in which no time passes: nothing
     * moves, comes off, burns or breaks under load, and no dust rises; particles stay where they are. What is made
     * counts as brought by the level, what is taken as never there: parts that touch nothing stay until a later step()
     * cuts their shape, and no light group begins to fail. The next step() begins with physics rebuilt from the world,
     * as of a loaded game. What impacts of the step before break waits for it. get_reports() is empty after
     * apply_edits(). RUBBLE_ERROR_ARGUMENT: a recording runs. */
    rubble_result (*apply_edits)(rubble_world world);
    /* [main-thread] Writes the world as the last step left it as a level, whole or not at all: a .rubble, .vdb or .vox
     * file, as the ending of the UTF-8 path says. vdb_tool: as in load_level(). Names and tags are those that edits
     * have given; what joints, lights and light groups need to find each other gets a name. Left out are settings,
     * fires, the motion of ropes, user values, and what the host keeps with the game. A .vox file holds shapes with one
     * palette; what else it leaves out is logged as warnings. RUBBLE_ERROR_FILE: it cannot be written. */
    rubble_result (*save_level)(rubble_world world, const char* path, const char* vdb_tool);
    /* [main-thread] Whether steps have changed the world since its last undo mark, undo or redo: 1 if
     * get_resolved_hash() is another one than it was then, else 0. Costs the objects that changed since.
     * RUBBLE_ERROR_ARGUMENT: no marks are kept; see set_undo_limit(). */
    rubble_result (*has_changed)(rubble_world world, uint32_t* out);
    /* [main-thread] Names the scripts of the level, in place of those that get_level_scripts() lists: a command for the
     * next step, as edits are. Levels, saves, deltas and undo have them. Texts are copied; `parameters` may be null.
     * count: at most 10,000; 0: the level names none. A path has 1 to 4096 bytes, parameters at most 65,536. */
    rubble_result (*set_level_scripts)(rubble_world world, const rubble_level_script* scripts, uint32_t count);
    /* [main-thread] A hash of what save_level() writes of the world: one that is written and loaded has the same. Costs
     * a pass over the objects of the world. */
    rubble_result (*get_level_hash)(rubble_world world, uint64_t* out);
} rubble_api;

/* [any-thread] The one exported function: stores the table of this version of the interface. Any other version:
 * null and RUBBLE_ERROR_VERSION. */
RUBBLE_EXPORT rubble_result rubble_get_api(uint32_t version, const rubble_api** table);

#ifdef __cplusplus
}
#endif
#endif
