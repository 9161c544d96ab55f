// Constants that C++ (render/frame/shader_constants.h) and GLSL share.
#ifdef __cplusplus
#define SHARED_CONSTANT constexpr
#else
#define SHARED_CONSTANT const
#endif

SHARED_CONSTANT float kSkyDepth = 65000.0;  // linear depth of pixels without a surface, metres; a half float holds it
SHARED_CONSTANT float kFarthestDepthValue = 0.99999994;  // the largest float below 1: of surfaces in a depth buffer
SHARED_CONSTANT float kNearestSurface = 1.0e-3;  // least linear depth of a surface: of a voxel that a ray begins in
SHARED_CONSTANT float kShadowCell = 0.1;         // metres: side of a cell of the shadow volume
SHARED_CONSTANT uint kHasGlass = 1u;             // flags of a shape's layout (lib/bodies.glsl)
SHARED_CONSTANT uint kHasPaint = 2u;
SHARED_CONSTANT float kMaxTilt = 0.3;         // tangent of the largest tilt of a face with a detail map
SHARED_CONSTANT float kFinestBodyCell = 1.6;  // side of a body grid cell at level 0, metres; then four times as large
SHARED_CONSTANT float kWaterPort = 0.1;       // metres before the eye at which a ray begins in water or in air
SHARED_CONSTANT float kMaxHillSlope = 0.16;   // tangent of the elevation below which hills can hide the sky

// The light grid (lib/local_lights.glsl).
SHARED_CONSTANT int kTilePixels = 32;     // side of a tile of the view, pixels
SHARED_CONSTANT int kTexelsPerLight = 7;  // of uLights; the choice among lights reads the first three only
SHARED_CONSTANT int kAlwaysWeighed = 12;  // lights of a cell that each pixel weighs; of the others a random subset
// The shape of a light, in its texels. A cone is a sphere with an angular falloff; from kArea on it is a rectangle.
SHARED_CONSTANT int kSphere = 0;
SHARED_CONSTANT int kCapsule = 1;
SHARED_CONSTANT int kArea = 2;
SHARED_CONSTANT int kScreen = 3;

// Outlines of waters (passes/water.frag).
SHARED_CONSTANT int kOutlineSides = 16;   // sides in a box
SHARED_CONSTANT int kOutlineRuns = 16;    // such boxes in a larger one
SHARED_CONSTANT int kMaxWaterCovers = 4;  // waters that take what a water shares with them

// Lengths of uniform arrays, and the size of a texel of the history confidence in pixels.
SHARED_CONSTANT int kMaxDirtyRegions = 16;
SHARED_CONSTANT int kMaxLightChanges = 16;
SHARED_CONSTANT int kMaxLookChanges = 8;
SHARED_CONSTANT int kMaxMovingBodies = 8;
SHARED_CONSTANT int kVectorsPerMovingBody = 6;
SHARED_CONSTANT int kMaxRipples = 64;  // as Ripples::kMaxRipples in runtime/frame/ripples.h
SHARED_CONSTANT int kConfidenceTile = 4;
