// The uniforms of a frame: members of `struct FrameBlock` in C++ (render/frame/frame_context.h) and of the block
// `frame` in GLSL (lib/frame.glsl). vec4, ivec4 and mat4 only, so that std140 and C++ agree. "World" here is relative
// to the render origin.
mat4 viewProjection;          // world -> clip, jittered: what the G-buffer is drawn with
mat4 viewProjectionPlain;     // world -> clip without jitter
mat4 previousViewProjection;  // world -> clip of the frame before, without jitter
vec4 cameraPosition;          // xyz world; w near plane, metres
vec4 cameraRight;             // xyz unit vector; w tan of half the horizontal angle
vec4 cameraUp;                // xyz unit vector; w tan of half the vertical angle
vec4 cameraForward;           // xyz unit vector; w far plane, metres
vec4 previousCameraPosition;  // xyz world
vec4 targetSize;              // width, height, 1 / width, 1 / height of what is traced and lit
vec4 displaySize;             // the same of what is shown: larger where RenderSettings::resolutionScale is below 1
vec4 jitter;                  // xy of this frame, zw of the last, in uv units: sample point = pixel centre + jitter
vec4 noiseOffset;             // xy R2 sequence for the blue noise, zw R1 and golden ratio of the frame, all in [0, 1)
ivec4 counters;     // x frame number, y 1 if the last frame may be reprojected, z number of lights, w 1 for white noise
vec4 sunDirection;  // xyz unit vector towards the sun; w angular radius, radians
vec4 sunColor;      // rgb irradiance on a face turned to it
vec4 skyColor;      // rgb radiance overhead
vec4 horizonColor;  // rgb
vec4 groundColor;   // rgb; w wetness of what lies open to the sky, 0 to 1
vec4 fogColor;      // rgb; w metres at which the haze takes half
vec4 fog;       // x share of light taken in a metre at its base; y height of the base, z metres for 1/e, w mean cosine
vec4 fogTint;   // rgb share of that which is scattered
vec4 skyCover;  // x clouds: 0.5 some, 1 overcast; y brightness of the stars
vec4 exposure;  // x of the level
ivec4 shadowSectorLow;  // xyz first sector of the shadow volume's directory (from the render origin); w 1 if there is a
                        // volume
ivec4 shadowSectorCount;  // xyz sectors of the directory
vec4 shadowLow;           // xyz low corner of the box that holds all occupied cells, in cells from the directory's
vec4 shadowHigh;          // xyz its high corner
