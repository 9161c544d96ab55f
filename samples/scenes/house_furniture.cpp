#include "samples/scenes/furniture.h"
#include "samples/scenes/house.h"

namespace rubble::scenes {

void addHouseFurniture(Level& level, ivec3 cell) {
    const ivec3 corner = cell - ivec3(kHouseMargin, kFooting, kHouseMargin);
    const auto put = [&](LevelShape shape, int x, int y, int z, Turn turn = Turn::None) {
        addDynamic(level, std::move(shape), corner + ivec3(x, y, z), turn);
    };
    constexpr int kLow = HouseRooms::kGroundFloor, kHigh = HouseRooms::kUpperFloor;

    // Living room
    put(makeSofa("sofa", kClothTeal), 20, kLow, 58);
    put(makeTable("living table"), 24, kLow, 74);
    put(makeChair("chair 1", kClothRed), 26, kLow, 68);
    put(makeChair("chair 2", kClothRed), 34, kLow, 68);
    put(makeChair("chair 3", kClothRed), 26, kLow, 85, Turn::Half);
    put(makeChair("chair 4", kClothRed), 34, kLow, 85, Turn::Half);
    put(makeShelf("bookshelf 1", 5), 57, kLow, 60, Turn::ThreeQuarters);
    put(makeTelevision("television"), 56, kLow, 76 - 8 + 2, Turn::ThreeQuarters);
    put(makePlantPot("plant 1"), 12, kLow, 92);
    addFloorLight(level, "floor light", corner + ivec3(56, kLow, 95));

    // Kitchen
    put(makeCounter("counter", 32), 14, kLow, 12);
    put(makeFridge("fridge"), 48, kLow, 12);
    put(makeTable("kitchen table"), 24, kLow, 32);
    put(makeChair("chair 5", kClothBlue), 29, kLow, 27);
    put(makeChair("chair 6", kClothBlue), 29, kLow, 43, Turn::Half);

    // Bedroom
    put(makeBed("bed", kClothBlue), 14, kHigh, 59);
    put(makeWardrobe("wardrobe"), 55, kHigh, 62, Turn::ThreeQuarters);
    put(makeShelf("bookshelf 2", 9), 30, kHigh, 59);
    put(makeTable("desk"), 30, kHigh, 88);
    put(makeChair("chair 7", kClothOchre), 36, kHigh, 82);
    put(makeCrate("chest"), 14, kHigh, 88);
    put(makePlantPot("plant 2"), 52, kHigh, 90);

    // Bathroom
    put(makeBath("bath"), 13, kHigh, 13);
    put(makeToilet("toilet"), 40, kHigh, 13);
    put(makeCounter("washstand", 13), 48, kHigh, 12);

    // Hall and study
    put(makeShelf("bookshelf 3", 13), 100, kLow, 96, Turn::Half);
    put(makeTable("study table"), 76, kHigh, 84);
    put(makeChair("chair 8", kClothBlue), 82, kHigh, 78);
    put(makeSofa("study sofa", kClothOchre), 80, kHigh, 92 - 1, Turn::Half);
    put(makeShelf("bookshelf 4", 17), 112, kHigh, 70, Turn::ThreeQuarters);

    // Porch
    put(makeBench("porch bench"), 76, kFooting + 2, 104, Turn::Quarter);
    put(makePlantPot("porch plant"), 102, kFooting + 2, 105);
}

}  // namespace rubble::scenes
