#include "samples/scenes/scene.h"

#include <algorithm>
#include <array>

namespace rubble {

std::span<const Scene> allScenes() {
    using namespace scenes;
    static const std::array list = {towerScene(),     bridgeScene(),    fireScene(),    wallScene(),  paneScene(),
                                    lightShopScene(), dominoesScene(),  cratersScene(), crushScene(), gardenScene(),
                                    craneScene(),     dominoRunScene(), raftScene(),    driveScene(), lightsScene(),
                                    chapelScene(),    mechanicsScene()};
    return list;
}

const Scene* findScene(std::string_view name) {
    const auto all = allScenes();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Scene& scene) { return scene.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace rubble
