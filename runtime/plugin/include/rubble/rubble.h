/* Rubble: voxel worlds that break, behind a C interface (C99, C++ and anything that can call C).
 *
 *     const rubble_api* api;
 *     if (rubble_get_api(RUBBLE_VERSION, &api) != RUBBLE_OK) ...;
 *     rubble_world world;
 *     api->create_world(NULL, &world);
 *     api->load_level(world, "town.rubble", NULL);
 *     for (;;) { api->explode(world, &explosion); api->step(world); api->events(world, &events); ... }
 *
 * Rules, for every function and struct:
 *  - One export. The table only grows at its end: a function f is there if api->struct_size > offsetof(rubble_api, f).
 *  - A struct that has `struct_size` first is filled in by the host: struct_size = sizeof, everything else zero or set.
 *    Zero means default. Such a struct may grow at its end; what the plugin does not know must be zero.
 *    Rows of arrays have no struct_size and never change.
 *  - Handles are values. 0 is nothing. A handle of something that is gone is reported (RUBBLE_ERROR_STALE), never
 * followed.
 *  - Nothing but RUBBLE_OK means that nothing was done; get_last_error() says what was expected and what was found.
 *  - Edits are commands: they wait in a queue and happen in the next step(), in the order given.
 *  - Reads copy out, except events(): its arrays live until the next step(), load_level() or destroy_world() of that
 * world.
 *  - Threads: [main-thread] one thread per world at a time; [render-thread] the thread with the GL context, one at a
 * time, may run beside the main thread; [any-thread] any. Destroy a world only while its renderer is not drawing.
 *  - Lengths are metres, masses kilograms, times seconds, angles radians; y is up; world positions are double.
 *    Rotations are quaternions x, y, z, w; all zero means no rotation.
 *  - The plugin opens no window, makes no GL context, opens no file that the host did not name, and restores the GL
 * state that it touches.
 *
 * What it does not do: network, sound, input, textures on triangles, threads of the host's job system, the host's
 * allocator. */
#ifndef RUBBLE_RUBBLE_H
#define RUBBLE_RUBBLE_H
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define RUBBLE_VERSION 1u

#if defined(_WIN32)
#define RUBBLE_EXPORT
#else
#define RUBBLE_EXPORT __attribute__((visibility("default")))
#endif

typedef uint64_t rubble_world;
typedef uint64_t rubble_renderer;
typedef uint64_t rubble_body;        /* a rigid body: a frame that shapes are fixed to */
typedef uint64_t rubble_shape;       /* a grid of voxels on a body */
typedef uint64_t rubble_joint;       /* holds two shapes together, or one to the world */
typedef uint64_t rubble_light;       /* what shines, on a shape or in the world */
typedef uint64_t rubble_light_group; /* lights that go out together */
typedef uint64_t rubble_water;       /* a body of water */
typedef uint64_t rubble_trigger;     /* a region that reports who enters and leaves it */
typedef uint64_t rubble_character;   /* one who walks */

typedef int32_t rubble_result;
enum {
    RUBBLE_OK = 0,
    RUBBLE_ERROR_NULL = 1,    /* a pointer that must not be null is */
    RUBBLE_ERROR_VERSION = 2, /* the plugin does not speak the version asked for */
    RUBBLE_ERROR_STRUCT_SIZE =
        3,                     /* struct_size is smaller than version 1's, or names fields the plugin does not know */
    RUBBLE_ERROR_STALE = 4,    /* the handle names nothing, or nothing any more, or something of another world */
    RUBBLE_ERROR_ARGUMENT = 5, /* a value is out of range */
    RUBBLE_ERROR_CAPACITY = 6, /* the array given is too short; the count says how long it must be */
    RUBBLE_ERROR_FILE = 7,     /* the file is missing, damaged or of an unknown kind */
    RUBBLE_ERROR_GL = 8,       /* something of OpenGL is missing, or a shader does not compile */
    RUBBLE_ERROR_MEMORY = 9,
    RUBBLE_ERROR_INTERNAL = 10 /* a fault of the plugin: please report get_last_error() */
};

enum { RUBBLE_LOG_INFO = 0, RUBBLE_LOG_WARNING = 1, RUBBLE_LOG_ERROR = 2 };

/* Services of the host, for the whole process. */
typedef struct rubble_host {
    uint32_t struct_size;
    uint32_t reserved;
    void* user;
    /* Called from any thread, one message at a time. Null: standard error. */
    void (*log)(void* user, int32_t level, const char* message);
    /* Looks up a GL function in the current context. Null: no renderer can be made. */
    void* (*gl_get_proc_address)(const char* name);
} rubble_host;

enum {
    RUBBLE_WORLD_NO_RENDERER =
        1, /* for servers and for hosts that draw themselves: nothing is prepared for a renderer */
    RUBBLE_WORLD_SHADOW_INLINE = 2,  /* keeps the shadow volume up to date inside step(), without a thread */
    RUBBLE_WORLD_WAIT_FOR_SHADOW = 4 /* step() waits for the shadow volume: pictures that do not depend on timing */
};

typedef struct rubble_world_settings {
    uint32_t struct_size;
    uint32_t flags; /* RUBBLE_WORLD_... */
} rubble_world_settings;

/* ---- edits ---- */

enum { RUBBLE_BRUSH_SPHERE = 0, RUBBLE_BRUSH_BOX = 1, RUBBLE_BRUSH_CAPSULE = 2 };
/* A material says which tools break it. RUBBLE_TOOL_ANY breaks all that can be broken. */
enum {
    RUBBLE_TOOL_ANY = 0,
    RUBBLE_TOOL_SLEDGE = 1,
    RUBBLE_TOOL_TORCH = 2,
    RUBBLE_TOOL_GUN = 3,
    RUBBLE_TOOL_EXPLOSIVE = 4
};
enum { RUBBLE_HARDNESS_DEFAULT = 0, RUBBLE_HARDNESS_SOFT = 1, RUBBLE_HARDNESS_MEDIUM = 2, RUBBLE_HARDNESS_HARD = 3 };

/* Removes the voxels inside, by the hardness of their material. */
typedef struct rubble_carve {
    uint32_t struct_size;
    uint32_t brush;      /* RUBBLE_BRUSH_... */
    double position[3];  /* sphere and box: centre; capsule: one end */
    double end[3];       /* capsule: other end */
    double half_size[3]; /* box */
    double rotation[4];  /* box */
    double radii[3];     /* sphere, capsule: for soft, medium and hard materials; each at most the one before */
    uint32_t hardness;   /* box: the hardest that it removes; default: hard */
    uint32_t tool;       /* RUBBLE_TOOL_... */
    rubble_shape shape;  /* only this one; 0: all */
} rubble_carve;

/* Breaks what is inside a sphere out, as fragments and dust in the style of each material. Glass goes by the whole
 * pane. */
typedef struct rubble_break {
    uint32_t struct_size;
    uint32_t tool; /* RUBBLE_TOOL_... */
    double position[3];
    double radii[3]; /* for soft, medium and hard materials; each at most the one before */
    uint32_t seed;   /* of where the cracks run */
    uint32_t reserved;
    rubble_shape shape; /* only this one; 0: all */
} rubble_break;

/* How a joint holds. Its axis is x of its frame. */
enum {
    RUBBLE_JOINT_BALL,      /* one point in common */
    RUBBLE_JOINT_HINGE,     /* turns about the axis */
    RUBBLE_JOINT_PRISMATIC, /* slides along the axis */
    RUBBLE_JOINT_CONE,      /* one point in common, the axes at most `high` radians apart */
    RUBBLE_JOINT_FIXED,
    RUBBLE_JOINT_ROPE,
    RUBBLE_JOINT_WHEEL /* shapes[0]: chassis, shapes[1]: wheel; travels along y, spins about x */
};
enum { RUBBLE_MOTOR_OFF, RUBBLE_MOTOR_SPEED, RUBBLE_MOTOR_POSITION };
enum {
    RUBBLE_JOINT_COLLIDES = 1, /* the two shapes touch each other */
    RUBBLE_JOINT_LIMITED = 2   /* low and high count */
};

/* A joint between two shapes as they are now. It holds on to a voxel of each, and goes with it or breaks with it. */
typedef struct rubble_joint_settings {
    uint32_t struct_size;
    uint32_t kind;                             /* RUBBLE_JOINT_BALL ... */
    rubble_shape shapes[2];                    /* 0: the world */
    double position[3];                        /* world; of a rope: its first end */
    double rotation[4];                        /* world */
    double radius;                             /* metres within which a voxel must be; 0: 0.2 */
    uint32_t flags;                            /* RUBBLE_JOINT_COLLIDES ... */
    uint32_t motor;                            /* RUBBLE_MOTOR_...; of a rope: a winch */
    double motor_target;                       /* rad/s or m/s; radians or metres */
    double motor_max_force;                    /* N m or N */
    double low, high;                          /* radians or metres */
    double spring_hertz, spring_damping_ratio; /* 0 hertz: none, or rigid */
    double friction;                           /* N m or N; a wheel's brake */
    double break_force, break_torque;          /* N, N m; 0: never */
    double rope_end[3];                        /* world: its second end */
    double rope_length, rope_radius;           /* metres; 0: as far as its ends are apart; 0.03 */
    double rope_stretch;                       /* share of its length under 10 kN */
    double rope_strength;                      /* N; 0: never breaks */
    double drive_torque, brake_torque;         /* N m of a wheel at full throttle and brake, see drive() */
    double max_spin;                           /* rad/s forward, half of it back; 0: 60 */
    double max_steer_angle, steer_rate;        /* radians either way; rad/s at which it turns there; 0: 2 */
} rubble_joint_settings;

/* What drives and brakes a joint from now on. */
typedef struct rubble_joint_motor {
    uint32_t struct_size;
    uint32_t motor; /* RUBBLE_MOTOR_... */
    rubble_joint joint;
    double motor_target, motor_max_force;
    double friction;
    double steer; /* of a wheel: radians */
} rubble_joint_motor;

/* Drives, steers and brakes all wheels of a body, until the next such command. */
typedef struct rubble_drive {
    uint32_t struct_size;
    uint32_t reserved;
    rubble_body body; /* the chassis: shapes[0] of its wheels' joints is on it */
    double throttle;  /* -1 (back) to 1 */
    double steer;     /* -1 (right) to 1 */
    double brake;     /* 0 to 1 */
} rubble_drive;

typedef struct rubble_joint_state {
    rubble_joint joint;
    uint32_t kind, rope_points;
    rubble_shape shapes[2];
    double first[3], second[3]; /* its ends, world */
    double rope_length;
} rubble_joint_state;

/* Pulls a body toward a place. A hand holds one body; the same call with another target moves it. */
typedef struct rubble_grab {
    uint32_t struct_size;
    uint32_t hand;
    rubble_body body;
    double point[3];  /* world: where it is taken hold of */
    double target[3]; /* world */
    double force;     /* N at most; 0: 1000 */
    double hertz;     /* how stiffly; 0: 4 */
} rubble_grab;

/* Lets go of what a hand holds, and throws it. */
typedef struct rubble_release {
    uint32_t struct_size;
    uint32_t hand;
    double impulse[3]; /* N s */
} rubble_release;

/* Breaks a sphere and pushes what is near away from it. */
typedef struct rubble_explosion {
    uint32_t struct_size;
    uint32_t reserved;
    double position[3];
    double size;    /* 0.5 to 4; 0: 1. Soft, medium and hard voxels within 1.0, 0.7 and 0.4 of it in metres break out */
    double impulse; /* N s on a body at the centre; 0: size decides */
} rubble_explosion;

/* Blends the colours of voxels toward a paint, a step a call. Materials stay. */
typedef struct rubble_paint {
    uint32_t struct_size;
    uint8_t color[4]; /* sRGB; the fourth is not read */
    double position[3];
    double radius;        /* 0: 0.5 */
    uint32_t strength;    /* share of the way to the paint, 1 to 255 of 255; 0: 64 */
    uint32_t probability; /* share of the voxels touched at the rim, 1 to 255 of 255; 0: 255 */
    uint32_t seed;        /* of which voxels they are */
    uint32_t reserved;
} rubble_paint;

typedef struct rubble_impulse {
    uint32_t struct_size;
    uint32_t reserved;
    rubble_body body;
    double position[3]; /* world */
    double impulse[3];  /* N s */
} rubble_impulse;

/* ---- events: what the last step did ---- */

/* Voxels of one colour that were removed from one shape. */
typedef struct rubble_removed_voxels {
    rubble_shape shape;
    uint64_t count;
    uint8_t color[3]; /* sRGB */
    uint8_t material; /* index into the level's materials */
    uint32_t entry;   /* of the shape's palette */
} rubble_removed_voxels;

/* A piece came off: one row a piece. `cell` of the parent is where the piece's cell 0 lies. */
typedef struct rubble_shape_split {
    rubble_shape parent;
    rubble_shape piece;
    int32_t cell[3];
    uint32_t reserved;
} rubble_shape_split;

/* Voxels of one colour that are no more and where they were: what particles are made of. Each is in one row. */
typedef struct rubble_dust_cloud {
    double position[3]; /* the middle of them, world */
    double radius;
    double velocity[3]; /* of what they were part of */
    uint64_t count;
    uint8_t color[3]; /* sRGB */
    uint8_t material;
    uint32_t reserved;
} rubble_dust_cloud;

typedef struct rubble_events {
    uint32_t struct_size;
    uint32_t level_loaded; /* 1: a level was loaded; everything before is gone, ask for get_body_states() */
    uint64_t step;
    uint64_t painted_voxels;
    const rubble_removed_voxels* removed;
    const rubble_shape_split* splits;
    const rubble_body* bodies_created;
    const rubble_body* bodies_destroyed;
    const rubble_shape* shapes_created;
    const rubble_shape* shapes_destroyed;
    const rubble_light_group* light_groups_out;
    uint32_t removed_count;
    uint32_t split_count;
    uint32_t bodies_created_count;
    uint32_t bodies_destroyed_count;
    uint32_t shapes_created_count;
    uint32_t shapes_destroyed_count;
    uint32_t light_groups_out_count;
    uint32_t dust_count;
    const rubble_dust_cloud* dust;
    const rubble_body* bodies_broken; /* lost voxels for the first time */
    const rubble_body*
        bodies_settled; /* debris that has come to rest for good: only what breaks or moves near it wakes it */
    const rubble_body* bodies_unsettled; /* settled debris that something has woken */
    uint32_t bodies_broken_count;
    uint32_t bodies_settled_count;
    uint32_t bodies_unsettled_count;
    uint32_t reserved;
} rubble_events;

/* ---- reads ---- */

enum { RUBBLE_BODY_STATIC = 1, RUBBLE_BODY_ASLEEP = 2 };

typedef struct rubble_body_state {
    rubble_body body;
    double position[3]; /* of its frame, which is not its centre of mass */
    double rotation[4];
    double velocity[3]; /* of the centre of mass */
    double angular_velocity[3];
    uint32_t flags; /* RUBBLE_BODY_... */
    uint32_t shape_count;
} rubble_body_state;

typedef struct rubble_shape_state {
    rubble_shape shape;
    rubble_body body;
    double position[3]; /* of the grid's corner, in the world */
    double rotation[4];
    double voxel_size;
    int32_t size[3]; /* of the grid, in voxels */
    uint32_t reserved;
    uint64_t voxels; /* that are not empty */
} rubble_shape_state;

typedef struct rubble_hit {
    uint32_t struct_size;
    uint32_t hit; /* 0: nothing within max_distance, and nothing below is set */
    double distance;
    double position[3];
    double normal[3];
    rubble_shape shape;
    rubble_body body;
    int32_t cell[3]; /* of the shape's grid */
    uint32_t entry;  /* of its palette */
} rubble_hit;

/* Where every voxel of the level is: imported = standing + in_pieces + removed. */
typedef struct rubble_voxel_accounting {
    uint32_t struct_size;
    uint32_t reserved;
    uint64_t imported;
    uint64_t standing;
    uint64_t in_pieces;
    uint64_t removed;
} rubble_voxel_accounting;

/* What the last step cost. */
typedef struct rubble_step_stats {
    uint32_t struct_size;
    uint32_t bodies;
    uint32_t bodies_awake;
    uint32_t contacts;
    uint64_t step;
    uint64_t shadow_lag; /* steps by which the shadow volume is behind */
    double edits_ms;
    double physics_ms;
    double poses_ms;
    double impacts_ms;
    double shadow_ms;
    double publish_ms;
} rubble_step_stats;

/* ---- collision layers, water, triggers, characters ---- */

enum { RUBBLE_COLLISION_NONE = 256 /* as a mask: touches nothing; as a layer: is touched by nothing */ };

/* Two shapes touch if each one's layer is in the other's mask. */
typedef struct rubble_collision_filter {
    uint32_t struct_size;
    uint32_t layer; /* 8 bits; 0: 1 */
    uint32_t mask;  /* 8 bits; 0: 255 */
    uint32_t reserved;
    rubble_shape shape;
} rubble_collision_filter;

typedef struct rubble_water_settings {
    uint32_t struct_size;
    uint32_t outline_count; /* corners, at least 3 */
    const double* outline;  /* x and z of each corner, world; copied */
    double surface;         /* height */
    double depth;           /* below the surface; 0: 1 */
    double density;         /* kg/m3; 0: 1000 */
    double linear_drag;     /* 1/s: how fast as much water as a body displaces takes it along; 0: 1.5 */
    double angular_drag;    /* 1/s; 0: 1.5 */
    double flow[3];         /* m/s */
} rubble_water_settings;

enum { RUBBLE_TRIGGER_SPHERE = 0, RUBBLE_TRIGGER_BOX = 1, RUBBLE_TRIGGER_POLYGON = 2 };
typedef struct rubble_trigger_settings {
    uint32_t struct_size;
    uint32_t kind;         /* RUBBLE_TRIGGER_... */
    double position[3];    /* sphere and box: middle; polygon: its origin */
    double rotation[4];    /* box */
    double radius;         /* sphere */
    double half_size[3];   /* box */
    double height;         /* polygon: upward from the position */
    const double* outline; /* polygon: x and z of each corner, from the position; copied */
    uint32_t outline_count;
    uint32_t layers; /* only shapes with a collision layer in this mask count; 0: all */
} rubble_trigger_settings;

/* A body has come into a trigger, or left it. */
typedef struct rubble_trigger_event {
    rubble_trigger trigger;
    rubble_body body;
    uint32_t entered; /* 0: left */
    uint32_t reserved;
} rubble_trigger_event;

typedef struct rubble_character_settings {
    uint32_t struct_size;
    uint32_t reserved;
    double position[3];     /* of the feet */
    double radius;          /* 0: 0.3 */
    double height;          /* 0: 1.8 */
    double crouched_height; /* 0: 1.1 */
    double step_height;     /* that it climbs without a jump; 0: 0.45 */
    double steepest;        /* slope that it can stand on, rise over run; 0: 1 */
    double mass;            /* 0: 80 */
    double walk_speed;      /* m/s; 0: 4 */
    double jump_speed;      /* 0: 4.5 */
    double swim_speed;      /* 0: 2 */
    double push_force;      /* N, on bodies in its way; 0: 400 */
} rubble_character_settings;

enum { RUBBLE_MOVE_JUMP = 1, RUBBLE_MOVE_CROUCH = 2 };
/* What a character wants from now on; a jump only in the next step. */
typedef struct rubble_character_move {
    uint32_t struct_size;
    uint32_t flags; /* RUBBLE_MOVE_... */
    rubble_character character;
    double wish[3]; /* m/s, world; the vertical part counts in water only */
} rubble_character_move;

/* Puts a character somewhere else. */
typedef struct rubble_character_teleport {
    uint32_t struct_size;
    uint32_t reserved;
    rubble_character character;
    double position[3]; /* of the feet */
    double velocity[3];
} rubble_character_teleport;

enum { RUBBLE_CHARACTER_GROUNDED = 1, RUBBLE_CHARACTER_CROUCHED = 2, RUBBLE_CHARACTER_SWIMMING = 4 };
typedef struct rubble_character_state {
    rubble_character character;
    double position[3]; /* of the feet */
    double velocity[3];
    rubble_body ground; /* what it stands on; 0: nothing */
    uint32_t flags;     /* RUBBLE_CHARACTER_... */
    uint32_t reserved;
} rubble_character_state;

/* ---- queries ---- */

enum {
    RUBBLE_FILTER_REJECT_STATIC = 1,
    RUBBLE_FILTER_REJECT_DYNAMIC = 2,
    RUBBLE_FILTER_REJECT_TRANSPARENT = 4,
    RUBBLE_FILTER_REJECT_UNPHYSICAL = 8
};
typedef struct rubble_query_filter {
    uint32_t struct_size;
    uint32_t flags;  /* RUBBLE_FILTER_... */
    uint32_t layers; /* only shapes with a collision layer in this mask; 0: all */
    uint32_t rejected_body_count;
    uint32_t rejected_shape_count;
    uint32_t reserved;
    const rubble_body* rejected_bodies;
    const rubble_shape* rejected_shapes;
} rubble_query_filter;

typedef struct rubble_ray {
    double origin[3];
    double direction[3]; /* need not be normalised */
    double max_distance;
    double radius; /* > 0: a ball is cast */
} rubble_ray;

enum { RUBBLE_QUERY_SPHERE = 0, RUBBLE_QUERY_CAPSULE = 1, RUBBLE_QUERY_BOX = 2 };
typedef struct rubble_query_shape {
    uint32_t kind; /* RUBBLE_REGION_... */
    uint32_t reserved;
    double position[3];  /* sphere and box: middle; capsule: one end */
    double end[3];       /* capsule: the other end */
    double radius;       /* sphere and capsule */
    double half_size[3]; /* box */
    double rotation[4];  /* box */
} rubble_query_shape;

typedef struct rubble_shape_cast {
    rubble_query_shape shape;
    double direction[3]; /* need not be normalised */
    double max_distance;
} rubble_shape_cast;

typedef struct rubble_touch {
    uint32_t hit;   /* 0: nothing, and nothing below is set */
    uint32_t entry; /* of the shape's palette */
    double distance;
    double position[3];
    double normal[3]; /* from the voxel */
    rubble_shape shape;
    rubble_body body;
    int32_t cell[3]; /* of the shape's grid */
    uint32_t reserved;
} rubble_touch;

/* ---- sky, sun, air and lights ---- */

/* Every field counts, zeros too: read environment(), change what is to change, set it. Colours are linear. */
typedef struct rubble_environment {
    uint32_t struct_size;
    uint32_t reserved;
    double sun_direction[3]; /* towards the sun, any length */
    double sun_color[3];     /* irradiance on a face turned to it */
    double sun_angle;        /* angular radius */
    double sky_color[3];     /* radiance overhead */
    double horizon_color[3];
    double ground_color[3]; /* light from below the horizon */
    double fog_color[3];
    double fog_distance; /* metres at which the haze takes half */
    double fog_density;  /* of fog that lights throw shafts into: share of light it takes in a metre at fog_base; 0:
                            none, and nothing is paid */
    double fog_base;     /* height */
    double fog_height;   /* metres over fog_base at which it is 1/e as thick */
    double fog_forward;  /* how much it scatters forward, -0.9 to 0.9 */
    double fog_tint[3];
    double clouds; /* 0: a clear sky, 1: overcast */
    double stars;
    double exposure;
    double wetness;    /* 0 dry, 0.5 dark and smooth, 1 with puddles */
    double gravity[3]; /* m/s2 */
} rubble_environment;

enum {
    RUBBLE_LIGHT_SPHERE = 0,
    RUBBLE_LIGHT_CONE = 1,
    RUBBLE_LIGHT_CAPSULE = 2,
    RUBBLE_LIGHT_AREA = 3,
    RUBBLE_LIGHT_SCREEN = 4
};
enum { RUBBLE_LIGHT_ENABLED = 1, RUBBLE_LIGHT_TWO_SIDED = 2 };

/* A light as it is, and as it is to be: every field counts, zeros too. set_light() keeps the picture of a screen; one
 * that is added is white. Refused: colours above 1e6, radius, width and height above 1e3 m, reach above 1e5 m, half
 * angles above 3.15, and less than 0. */
typedef struct rubble_light_state {
    uint32_t struct_size;
    uint32_t kind;            /* RUBBLE_LIGHT_SPHERE... */
    rubble_light light;       /* not read by add_light() */
    rubble_shape shape;       /* whose frame position and rotation are in; 0: the world's */
    rubble_light_group group; /* while it is out its lights stay dark */
    uint32_t flags;           /* RUBBLE_LIGHT_ENABLED... */
    uint32_t reserved;
    double position[3]; /* cones, areas and screens look along -z */
    double rotation[4];
    double color[3];   /* linear radiant intensity */
    double radius;     /* of the glowing ball */
    double reach;      /* metres beyond which it lights nothing */
    double cone_inner; /* half angles */
    double cone_outer;
    double width; /* of capsules, areas and screens, along x */
    double height;
} rubble_light_state;

/* ---- renderer ---- */

typedef struct rubble_renderer_settings {
    uint32_t struct_size;
    uint32_t reserved;
    const char* shader_folder; /* where the project's folder shaders/ is */
    const char* preset;        /* "fast", "balanced" or "accurate"; null: "balanced" */
} rubble_renderer_settings;

enum { RUBBLE_VIEW_CUT = 1 /* the camera jumped: forget what was accumulated */ };

typedef struct rubble_view {
    uint32_t struct_size;
    uint32_t flags;       /* RUBBLE_VIEW_... */
    uint32_t framebuffer; /* GL name of the target; 0: the window's */
    uint32_t width;       /* pixels */
    uint32_t height;
    uint32_t reserved;
    double position[3]; /* of the camera, which looks along -z with y up */
    double rotation[4];
    double vertical_fov; /* 0: 1.05 */
    double alpha;        /* 0 to 1: how far between the last two steps */
} rubble_view;

/* What the last draw cost. */
typedef struct rubble_draw_stats {
    uint32_t struct_size;
    uint32_t draw_calls;
    uint32_t shapes;
    uint32_t bricks;
    uint64_t upload_bytes;
    uint64_t texture_bytes; /* held now */
    double apply_ms;
    double draw_ms; /* of this thread; the GPU may take longer */
} rubble_draw_stats;

/* ---- the table ---- */

typedef struct rubble_api {
    uint32_t struct_size;
    uint32_t version;

    /* [any-thread] Why the calling thread's last failed call failed; lives until its next call that fails. Never null.
     */
    const char* (*get_last_error)(void);
    /* [main-thread] Copies the host's services. Null: the defaults. Call it before anything else, not while worlds
     * step. */
    rubble_result (*set_host)(const rubble_host* host);

    /* [main-thread] An empty world. settings may be null. At most 255 worlds at a time. */
    rubble_result (*create_world)(const rubble_world_settings* settings, rubble_world* out);
    rubble_result (*destroy_world)(rubble_world world);
    /* [main-thread] Replaces everything by a level: a .rubble, .vdb or .vox file, by the name's ending (UTF-8).
     * vdb_tool: the program rubble-vdb, run as a child for .vdb; may be null otherwise. On an error the world is as it
     * was. */
    rubble_result (*load_level)(rubble_world world, const char* path, const char* vdb_tool);
    /* [main-thread] 1/60 s: queued edits, then physics. The host decides how many. */
    rubble_result (*step)(rubble_world world);

    /* [main-thread] Commands for the next step. */
    rubble_result (*carve)(rubble_world world, const rubble_carve* carve);
    rubble_result (*explode)(rubble_world world, const rubble_explosion* explosion);
    rubble_result (*paint)(rubble_world world, const rubble_paint* paint);
    rubble_result (*apply_impulse)(rubble_world world, const rubble_impulse* impulse);

    /* [main-thread] */
    rubble_result (*get_events)(rubble_world world, rubble_events* out);
    /* [main-thread] All bodies in a fixed order. Writes up to `capacity` rows and the number there are to *count, which
     * may be more (RUBBLE_ERROR_CAPACITY). With capacity 0, out may be null: only *count is written, and it is
     * RUBBLE_OK. */
    rubble_result (*get_body_states)(rubble_world world, rubble_body_state* out, uint32_t capacity, uint32_t* count);
    rubble_result (*get_body_state)(rubble_world world, rubble_body body, rubble_body_state* out);
    /* [main-thread] Like get_body_states(), for the shapes of one body, or of all with body 0. */
    rubble_result (*get_shape_states)(rubble_world world, rubble_body body, rubble_shape_state* out, uint32_t capacity,
                                      uint32_t* count);
    /* [main-thread] The first voxel that a ray meets. The direction need not be normalised. */
    rubble_result (*raycast)(rubble_world world, const double origin[3], const double direction[3], double max_distance,
                             rubble_hit* out);
    /* [main-thread] Of all that decides what happens next: equal worlds have equal hashes. */
    rubble_result (*get_state_hash)(rubble_world world, uint64_t* out);
    rubble_result (*get_voxel_accounting)(rubble_world world, rubble_voxel_accounting* out);
    rubble_result (*get_step_stats)(rubble_world world, rubble_step_stats* out);

    /* [render-thread] All with the same GL context current (3.3 core or later). A world has one renderer in its life.
     * Destroy it while its context is current. */
    rubble_result (*create_renderer)(rubble_world world, const rubble_renderer_settings* settings,
                                     rubble_renderer* out);
    rubble_result (*draw)(rubble_renderer renderer, const rubble_view* view);
    /* [render-thread] Which intermediate picture is drawn, for looking into the renderer; null or "final": the picture.
     */
    rubble_result (*set_debug_view)(rubble_renderer renderer, const char* name);
    rubble_result (*get_draw_stats)(rubble_renderer renderer, rubble_draw_stats* out);
    rubble_result (*destroy_renderer)(rubble_renderer renderer);

    /* [main-thread] Writes the game as it is between two steps, whole or not at all; goes on from there. Saving is an
     * event: the next step begins with physics made anew, in the running game too, so that going on and loading are the
     * same. */
    rubble_result (*save_game)(rubble_world world, const char* path);
    /* [main-thread] On an error the world is as it was. Handles of objects are those of the world that was saved. */
    rubble_result (*load_game)(rubble_world world, const char* path);
    /* [main-thread] Records every step from here on, beginning with a save; stop_recording() gives the file its name.
     */
    rubble_result (*start_recording)(rubble_world world, const char* path);
    rubble_result (*stop_recording)(rubble_world world);
    /* [main-thread] Begins a recording and steps through all of it. *steps (may be null): how many had the hash that
     * was recorded; fewer than there are is RUBBLE_ERROR_FILE: it was made by another build of the plugin or of its
     * physics. */
    rubble_result (*play_recording)(rubble_world world, const char* path, uint64_t* steps);
    /* [main-thread] Commands for the next step, at most one undo or redo each. set_undo_limit: how many marks are kept;
     * 0, the default: none, and nothing is paid. undo() takes back all that has happened since the last mark, redo()
     * what undo() did. */
    rubble_result (*set_undo_limit)(rubble_world world, uint32_t marks);
    rubble_result (*add_undo_mark)(rubble_world world);
    rubble_result (*undo)(rubble_world world);
    rubble_result (*redo)(rubble_world world);
    /* [main-thread] A command for the next step. */
    rubble_result (*break_voxels)(rubble_world world, const rubble_break* edit);
    /* [main-thread] Commands for the next step. Where no voxel holds an end, no joint is made and the log says so. */
    rubble_result (*add_joint)(rubble_world world, const rubble_joint_settings* settings);
    rubble_result (*remove_joint)(rubble_world world, rubble_joint joint);
    rubble_result (*set_joint_motor)(rubble_world world, const rubble_joint_motor* motor);
    rubble_result (*grab_body)(rubble_world world, const rubble_grab* grab);
    rubble_result (*release_body)(rubble_world world, const rubble_release* release);
    /* [main-thread] All joints in the order of their slots; the points of a rope, three numbers each, from its first
     * end on. */
    rubble_result (*get_joint_states)(rubble_world world, rubble_joint_state* out, uint32_t capacity, uint32_t* count);
    rubble_result (*get_rope_points)(rubble_world world, rubble_joint joint, double* out, uint32_t capacity,
                                     uint32_t* count);

    /* [main-thread] Commands for the next step. */
    rubble_result (*set_collision_filter)(rubble_world world, const rubble_collision_filter* edit);
    rubble_result (*add_water)(rubble_world world, const rubble_water_settings* water);
    rubble_result (*remove_water)(rubble_world world, rubble_water water);
    rubble_result (*add_trigger)(rubble_world world, const rubble_trigger_settings* trigger);
    rubble_result (*remove_trigger)(rubble_world world, rubble_trigger trigger);
    rubble_result (*add_character)(rubble_world world, const rubble_character_settings* character);
    rubble_result (*remove_character)(rubble_world world, rubble_character character);
    rubble_result (*move_character)(rubble_world world, const rubble_character_move* move);
    rubble_result (*teleport_character)(rubble_world world, const rubble_character_teleport* place);
    /* [main-thread] All of them in a fixed order, with capacity and count as in get_body_states(); a new one is the
     * last but where an older one was removed. */
    rubble_result (*get_waters)(rubble_world world, rubble_water* out, uint32_t capacity, uint32_t* count);
    rubble_result (*get_triggers)(rubble_world world, rubble_trigger* out, uint32_t capacity, uint32_t* count);
    rubble_result (*get_character_states)(rubble_world world, rubble_character_state* out, uint32_t capacity,
                                          uint32_t* count);
    /* [main-thread] Who came into triggers and left them in the last step; the bodies with a voxel in one now. */
    rubble_result (*get_trigger_events)(rubble_world world, rubble_trigger_event* out, uint32_t capacity,
                                        uint32_t* count);
    rubble_result (*get_trigger_bodies)(rubble_world world, rubble_trigger trigger, rubble_body* out, uint32_t capacity,
                                        uint32_t* count);

    /* [main-thread] Queries; filter may be null. out[i] answers rays[i], or casts[i]; a cast shape moves without
     * turning. */
    rubble_result (*cast_rays)(rubble_world world, const rubble_ray* rays, uint32_t count,
                               const rubble_query_filter* filter, rubble_touch* out);
    rubble_result (*cast_shapes)(rubble_world world, const rubble_shape_cast* casts, uint32_t count,
                                 const rubble_query_filter* filter, rubble_touch* out);
    /* [main-thread] Bodies, or shapes, with a voxel in a region, in a fixed order; capacity and count as in
     * get_body_states(). */
    rubble_result (*overlap_bodies)(rubble_world world, const rubble_query_shape* region,
                                    const rubble_query_filter* filter, rubble_body* out, uint32_t capacity,
                                    uint32_t* count);
    rubble_result (*overlap_shapes)(rubble_world world, const rubble_query_shape* region,
                                    const rubble_query_filter* filter, rubble_shape* out, uint32_t capacity,
                                    uint32_t* count);
    /* [main-thread] The point of a voxel that is closest to a point; distance 0 inside a voxel. */
    rubble_result (*find_closest_point)(rubble_world world, const double position[3], double max_distance,
                                        const rubble_query_filter* filter, rubble_touch* out);

    /* [main-thread] A command for the next step. */
    rubble_result (*drive_wheels)(rubble_world world, const rubble_drive* edit);

    /* [main-thread] Sky, sun, air, exposure and gravity; set_environment is a command for the next step. */
    rubble_result (*get_environment)(rubble_world world, rubble_environment* out);
    rubble_result (*set_environment)(rubble_world world, const rubble_environment* environment);
    /* [any-thread] Sets the colours of sun, sky, haze and ground light, and the stars, in a struct that is filled in:
     * from where the sun stands (below the horizon: twilight, then night) and its clouds. */
    rubble_result (*compute_sky)(rubble_environment* environment, const double to_sun[3]);
    /* [main-thread] All lights, with capacity and count as in get_body_states(); one of them; a command for the next
     * step. */
    rubble_result (*get_lights)(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count);
    rubble_result (*get_light_state)(rubble_world world, rubble_light light, rubble_light_state* out);
    rubble_result (*set_light)(rubble_world world, const rubble_light_state* light);
    /* [main-thread] Commands for the next step. A light on a shape moves with it, and stays where it was, dark, when
     * the shape is gone. None is added to a world that has 65,536. */
    rubble_result (*add_light)(rubble_world world, const rubble_light_state* light);
    rubble_result (*remove_light)(rubble_world world, rubble_light light);
    /* [main-thread] The lights that the last step made, one for each add_light() in the order of the calls, with
     * capacity and count as in get_body_states(); 0 for one that the step refused. */
    rubble_result (*get_added_lights)(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count);
} rubble_api;

/* [any-thread] The one export: the plugin's table for this version of the interface, or RUBBLE_ERROR_VERSION and null.
 */
RUBBLE_EXPORT rubble_result rubble_get_api(uint32_t version, const rubble_api** table);

#ifdef __cplusplus
}
#endif
#endif
