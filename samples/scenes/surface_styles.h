#pragma once
#include "samples/scenes/palette_builder.h"

/// All surfaces of the scenes. Colours are written nowhere else.
namespace rubble::scenes {

// Masonry and plaster
inline constexpr SurfaceStyle kBrick{"brick", {0x8a4b3a, 0x95543f, 0x7c4234, 0x9c6048}, 225};
inline constexpr SurfaceStyle kBrickJoint{"brick", {0x6f4a3c, 0x7a5646}, 240};
inline constexpr SurfaceStyle kBrickYellow{"brick", {0xa98c5f, 0xb39668, 0x9b7f55}, 225};
inline constexpr SurfaceStyle kBrickGrey{"brick", {0x7d7873, 0x8a847d, 0x726d69}, 225};
inline constexpr SurfaceStyle kPlaster{"plaster", {0xd9cfbd, 0xd4c9b6, 0xdcd3c3}, 240, 0, 10, 255, 3};
inline constexpr SurfaceStyle kRender{"brick", {0xd9cfbd, 0xd4c9b6, 0xdcd3c3}, 240, 0, 10, 255,
                                      3};  // breaks together with the bricks
inline constexpr SurfaceStyle kPlasterBlue{"plaster", {0x93a5ac, 0x8c9fa7}, 240, 0, 10, 255, 4};
inline constexpr SurfaceStyle kPlasterOchre{"plaster", {0xc9a670, 0xc29e68}, 240, 0, 10, 255, 4};
inline constexpr SurfaceStyle kPlasterRose{"plaster", {0xbd8f7e, 0xb68877}, 240, 0, 10, 255, 4};
inline constexpr SurfaceStyle kWallpaperGreen{"plaster", {0x8fa083, 0x8a9b7e}, 240, 0, 10, 255, 3};
inline constexpr SurfaceStyle kWallpaperRose{"plaster", {0xc49a8b, 0xbf9586}, 240, 0, 10, 255, 3};
inline constexpr SurfaceStyle kTileWhite{"plaster", {0xcfd6d4, 0xc6cfce}, 90, 0, 14, 255, 3};
inline constexpr SurfaceStyle kConcrete{"concrete", {0x8f8d86, 0xa09d94, 0x97948c}, 235};
inline constexpr SurfaceStyle kConcreteDark{"concrete", {0x74726c, 0x6b6963}, 235};
inline constexpr SurfaceStyle kRebar{"metal", {0x7a5138, 0x6c4a36}, 190, 120};

inline constexpr SurfaceStyle kLimestone{"brick", {0xb9b09c, 0xc2baa6, 0xaea58f, 0xbbb3a1}, 225, 0, 10, 255, 4};
inline constexpr SurfaceStyle kMarble{"brick", {0xcfcac0, 0xd6d1c8, 0xc4beb3}, 70, 0, 14, 255, 3};
inline constexpr SurfaceStyle kBone{"plaster", {0xd8cfb6, 0xcfc5aa, 0xdfd7c1}, 200, 0, 10, 255, 5};

// Wood
inline constexpr SurfaceStyle kTimber{"wood", {0x7a5a3c, 0x8b6845, 0x6b4c31}, 205};
inline constexpr SurfaceStyle kFloorBoard{"wood", {0x9a6f45, 0x8b6845, 0xa5794c, 0x82603d}, 150, 0, 12};
inline constexpr SurfaceStyle kFloorSeam{"wood", {0x50382a, 0x47331f}, 220};
inline constexpr SurfaceStyle kDarkWood{"wood", {0x59402c, 0x4e3827}, 170};
inline constexpr SurfaceStyle kWhiteWood{"wood", {0xd3cdbf, 0xcbc5b7}, 180, 0, 10, 255, 3};
inline constexpr SurfaceStyle kGreenWood{"wood", {0x3f5f4c, 0x395645}, 170};
inline constexpr SurfaceStyle kRedWood{"wood", {0x8e3b30, 0x84362c}, 160};
inline constexpr SurfaceStyle kBlueWood{"wood", {0x3d5a73, 0x36526a}, 160};
inline constexpr SurfaceStyle kFenceWood{"wood", {0x8d7d68, 0x9a8a74, 0x7c6d5a}, 225};

// Roofs
inline constexpr SurfaceStyle kRoofTile{"brick", {0x4d4f57, 0x565a63, 0x45464d, 0x5a4a45}, 200};
inline constexpr SurfaceStyle kRoofTileRed{"brick", {0x93513c, 0x864834, 0x9e5d45}, 205};
inline constexpr SurfaceStyle kRoofTileBrown{"brick", {0x6a5144, 0x5e473b, 0x735a4b}, 205};
inline constexpr SurfaceStyle kRoofFelt{"plastic", {0x4a4b4d, 0x525355}, 245};

// Ground
inline constexpr SurfaceStyle kAsphalt{"concrete", {0x4a4c4f, 0x525457, 0x46484b}, 225, 0, 10, 255, 7};
inline constexpr SurfaceStyle kAsphaltPatch{"concrete", {0x3e4043, 0x393b3e}, 215};
inline constexpr SurfaceStyle kAsphaltCrack{"concrete", {0x2c2d2f, 0x313234}, 245, 0, 10, 255, 2};
inline constexpr SurfaceStyle kLaneWhite{"concrete", {0xc4c1b6, 0xb3b0a6, 0xcfccc2}, 210, 0, 10, 255, 5};

inline constexpr SurfaceStyle kKerb{"concrete", {0x9a978f, 0xa5a29a, 0x8e8b84}, 230};
inline constexpr SurfaceStyle kPaving{"concrete", {0x8d897f, 0x979389, 0x848076, 0x918a7c}, 232, 0, 10, 255, 5};
inline constexpr SurfaceStyle kPavingJoint{"concrete", {0x66635b, 0x5d5b53}, 245};
inline constexpr SurfaceStyle kMoss{"foliage", {0x5c6b3a, 0x66753f}, 245};
inline constexpr SurfaceStyle kGrass{"foliage", {0x5d7a3a, 0x6d8a45, 0x4f6a33, 0x657f3c}, 240, 0, 10, 255, 8};
inline constexpr SurfaceStyle kGrassDry{"foliage", {0x8a8a4c, 0x7f8647}, 240, 0, 10, 255, 8};
inline constexpr SurfaceStyle kDirt{"dirt", {0x6b5138, 0x5f4832, 0x77593e}, 250};
inline constexpr SurfaceStyle kRock{"rock", {0x67635c, 0x5b5852}, 235};
inline constexpr SurfaceStyle kManhole{"metal", {0x4b4a47, 0x555350}, 140, 200, 40};

// Plants
inline constexpr SurfaceStyle kBark{"wood", {0x5b4634, 0x4e3c2d, 0x66503c}, 245};
inline constexpr SurfaceStyle kLeaves{"foliage", {0x4e7a36, 0x6b9440, 0x5a8639, 0x87a84c}, 225, 0, 10, 255, 9};
inline constexpr SurfaceStyle kLeavesDark{"foliage", {0x3f6330, 0x4a7136, 0x567f3b}, 225, 0, 10, 255, 9};
inline constexpr SurfaceStyle kLeavesAutumn{"foliage", {0xb5802e, 0xc08f38, 0xa66a28, 0xbf9c45}, 225, 0, 10, 255, 8};
inline constexpr SurfaceStyle kHedge{"foliage", {0x3f5f30, 0x496c36, 0x53783b}, 230, 0, 10, 255, 9};
inline constexpr SurfaceStyle kHay{"foliage", {0xbfa050, 0xcab062, 0xb08f42}, 245, 0, 10, 255, 9};
inline constexpr SurfaceStyle kFlowers{"foliage", {0xb9473f, 0xd0a040, 0xc9c2b4, 0x8b5a9a}, 220, 0, 10, 255, 0};

// Metal, glass, plastic, cloth
inline constexpr SurfaceStyle kSteel{"metal", {0x6f7780, 0x78818a, 0x666e77}, 130, 150, 40, 255, 4};
inline constexpr SurfaceStyle kBridgePaint{"metal", {0x5f7f73, 0x67887b, 0x58776b}, 150, 60, 30, 255, 4};
inline constexpr SurfaceStyle kStationRed{"metal", {0xb8352b, 0xb03228}, 90, 20, 30, 255, 2};
inline constexpr SurfaceStyle kTankPaint{"metal", {0x8fa3a6, 0x98abad, 0x869a9e}, 150, 60, 30, 255, 4};
inline constexpr SurfaceStyle kRust{"metal", {0x8a5a3a, 0x7a4a30, 0x96643f}, 230, 60};
inline constexpr SurfaceStyle kDarkSteel{"metal", {0x3d4246, 0x454a4f}, 140, 160, 40};
inline constexpr SurfaceStyle kCastSteel{"heavy metal", {0x4a4d50, 0x54585b, 0x434649}, 110, 160, 40, 255, 4};
inline constexpr SurfaceStyle kRam{
    "hard metal", {0x2c2e31, 0x33363a}, 150, 120, 40, 255, 3};  // harder than what it hits
inline constexpr SurfaceStyle kBallRed{"heavy metal", {0xa8382c, 0xb23f32}, 120, 40, 40, 255, 2};
inline constexpr SurfaceStyle kBallCream{"heavy metal", {0xd3cbb8, 0xcbc3b0}, 120, 40, 40, 255, 2};
inline constexpr SurfaceStyle kCopperPipe{"metal", {0xa86a45, 0x9c6040}, 110, 220, 60};
inline constexpr SurfaceStyle kWire{"plastic", {0x2f2f33}, 180, 0, 10, 255, 0};
inline constexpr SurfaceStyle kGlass{"glass", {0xdfeeee, 0xd6e8e8}, 12, 0, 16, 40, 0};
inline constexpr SurfaceStyle kGlassRed{"glass", {0xd0302a, 0xc42a30}, 12, 0, 16, 60, 3};
inline constexpr SurfaceStyle kGlassBlue{"glass", {0x2a55d0, 0x2f66d8}, 12, 0, 16, 60, 3};
inline constexpr SurfaceStyle kGlassGold{"glass", {0xf0b42c, 0xe8a428}, 12, 0, 16, 50, 3};
inline constexpr SurfaceStyle kGlassGreen{"glass", {0x2fa04a, 0x3aac50}, 12, 0, 16, 60, 3};
inline constexpr SurfaceStyle kGlassViolet{"glass", {0x8a3ab0, 0x7c36a8}, 12, 0, 16, 60, 3};
inline constexpr SurfaceStyle kCable{"wire", {0x2f2f33}, 180, 0, 10, 255, 0};
inline constexpr SurfaceStyle kTyre{"plastic", {0x2b2b2d, 0x303032}, 235, 0, 10, 255, 3};
inline constexpr SurfaceStyle kRubber{"rubber", {0x2b2b2d, 0x303032}, 235, 0, 10, 255, 3};
inline constexpr SurfaceStyle kPlasticBlack{"plastic", {0x2e2f31, 0x343538}, 170, 0, 12, 255, 3};
inline constexpr SurfaceStyle kPlasticGrey{"plastic", {0x7c7f82, 0x85888b}, 170, 0, 12, 255, 3};
inline constexpr SurfaceStyle kPlasticGreen{"plastic", {0x2f6b45, 0x2b633f}, 150, 0, 12, 255, 3};
inline constexpr SurfaceStyle kWhiteEnamel{"plastic", {0xd8dad6, 0xd2d4d0}, 60, 0, 16, 255, 2};
inline constexpr SurfaceStyle kClothRed{"plastic", {0x9a3b35, 0x8f342f}, 250, 0, 8, 255, 5};
inline constexpr SurfaceStyle kClothBlue{"plastic", {0x47617d, 0x405873}, 250, 0, 8, 255, 5};
inline constexpr SurfaceStyle kClothTeal{"plastic", {0x3c7271, 0x356866}, 250, 0, 8, 255, 5};
inline constexpr SurfaceStyle kClothCream{"plastic", {0xd0c4a8, 0xc8bb9e}, 250, 0, 8, 255, 4};
inline constexpr SurfaceStyle kClothOchre{"plastic", {0xb98f43, 0xae853c}, 250, 0, 8, 255, 5};
inline constexpr SurfaceStyle kBooks{"wood", {0x8b3a32, 0x2f5570, 0x3d6b4a, 0xb98d3a}, 200, 0, 10, 255, 12};
inline constexpr SurfaceStyle kGoods{"plastic", {0xc23b2e, 0xe0b040, 0x3f7fb0, 0x5a9a4c}, 150, 0, 12, 255, 10};

// Cars
inline constexpr SurfaceStyle kCarRed{"metal", {0xb23a2e, 0xac372b}, 50, 40, 40, 255, 2};
inline constexpr SurfaceStyle kCarBlue{"metal", {0x2f5d8a, 0x2b5783}, 50, 40, 40, 255, 2};
inline constexpr SurfaceStyle kCarCream{"metal", {0xd9d4c8, 0xd3cec2}, 55, 20, 40, 255, 2};
inline constexpr SurfaceStyle kCarYellow{"metal", {0xc9a227, 0xc29b24}, 50, 20, 40, 255, 2};

// Glowing surfaces. Emission multiplies the linear colour; the colour is dark, so that the surface looks dark when off.
inline constexpr SurfaceStyle kStreetLightGlow{"glass", {0x9a8468}, 120, 0, 10, 255, 0, 44.0f};
inline constexpr SurfaceStyle kBulbGlow{"glass", {0xffd9a8}, 120, 0, 10, 255, 0, 7.0f};
inline constexpr SurfaceStyle kShopGlow{"glass", {0xfff0dc}, 120, 0, 10, 255, 0, 5.0f};
inline constexpr SurfaceStyle kSignGlow{"glass", {0x1a7068}, 120, 0, 10, 255, 0, 28.0f};
inline constexpr SurfaceStyle kSignAmber{"glass", {0x9a6a18}, 120, 0, 10, 255, 0, 14.0f};
inline constexpr SurfaceStyle kHeadlight{"glass", {0xe8e6dc}, 40, 0, 20, 255, 0, 0.6f};
inline constexpr SurfaceStyle kTaillight{"glass", {0xb01810}, 60, 0, 16, 255, 0, 0.4f};

}  // namespace rubble::scenes
