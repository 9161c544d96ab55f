// The uniforms of a frame: the members of `struct FrameBlock` in C++ (render/frame/frame_block.h) and of the uniform
// block in GLSL (lib/frame.glsl). Only vec4, ivec4 and mat4, so that std140 and C++ agree on the layout. World
// positions are metres from the render origin; the previous frame's are from the same origin.
mat4 viewProjection;          // world -> clip, with jitter: what the G-buffer is drawn with
mat4 viewProjectionPlain;     // world -> clip, without jitter
mat4 previousViewProjection;  // world -> clip of the previous frame, without jitter
vec4 cameraPosition;          // xyz world, of an orthographic view the middle of its near plane; w near plane, metres
vec4 cameraRight;             // xyz unit vector; w half the width of what is seen at a depth of 1, metres
vec4 cameraUp;                // xyz unit vector; w half the height of that
vec4 cameraForward;           // xyz unit vector; w far plane, metres
vec4 viewMiddle;              // xyz ray through the middle of the image, as viewRay(): off-centre views look aside; w 1
                              // if the view is orthographic
vec4 previousCameraPosition;  // xyz world
vec4 previousViewMiddle;      // the previous frame's viewMiddle
vec4 previousCameraRight;     // xyz the previous frame's cameraRight times the tangent in its w
vec4 previousCameraUp;        // the same of cameraUp
vec4 targetSize;              // width, height, 1 / width, 1 / height of the traced and lit targets, pixels
vec4 displaySize;             // the same of the displayed image: larger if RenderSettings::resolutionScale is below 1
vec4 jitter;                  // xy this frame, zw previous frame, uv units: sample point = pixel centre + jitter
vec4 noiseOffset;             // xy R2 sequence, z R1 sequence, w golden ratio sequence of the frame number, in [0, 1)
ivec4 counters;               // x frame number, y 1 if history is valid, z lasting lights
vec4 sunDirection;            // xyz unit vector towards the sun; w angular radius, radians
vec4 sunColor;                // rgb irradiance on a surface that faces the sun
vec4 skyColor;                // rgb radiance at the zenith
vec4 horizonColor;            // rgb radiance at the horizon
vec4 groundColor;             // rgb radiance from below; w wetness of what is open to the sky, 0 to 1
vec4 fogColor;                // rgb radiance of the haze; w distance at which the haze takes half the light, metres
vec4 fog;                     // x extinction at the base, 1 / m; y base height; z metres for 1 / e; w mean cosine
vec4 fogTint;                 // rgb single-scattering albedo
vec4 skyCover;                // x clouds: 0.5 some, 1 overcast; y brightness of the stars; z height of the fields
vec4 exposure;                // x exposure of the level
ivec4 shadowDenseFirst;       // xyz first sector of the shadow directory's dense part, from the render origin
ivec4 shadowDenseSize;        // xyz its sectors
vec4 shadowDenseLow;          // xyz low corner of the box of all occupied cells in it, in cells from its first sector
vec4 shadowDenseHigh;         // xyz its high corner
ivec4 shadowPagedFirst;       // the same of its paged part
ivec4 shadowPagedSize;        // w 1 if it holds anything
vec4 shadowPagedLow;
vec4 shadowPagedHigh;
