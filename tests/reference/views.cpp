#include "tests/reference/views.h"

#include "samples/scenes/town.h"
#include "samples/support/camera.h"
#include "tests/golden/lit_scene.h"
#include "tests/support/level_snapshot.h"

namespace rubble::reference {
namespace {

View lookingAt(glm::dvec3 from, glm::dvec3 at, float verticalFov) {
    Camera camera;
    camera.position = from;
    camera.verticalFov = verticalFov;
    camera.lookAt(at);
    return camera.view({0, 0}, 0);
}

}  // namespace

FrameSnapshot townSnapshot() {
    return levelSnapshot(makeTown(1));
}

std::vector<SceneView> tuningViews(bool withTown) {
    std::vector<SceneView> views{{"street front", streetScene().snapshot(), streetCamera(0).view({0, 0}, 0)},
                                 {"street room", streetScene().snapshot(), streetCamera(2).view({0, 0}, 0)}};
    if (!withTown) return views;
    const FrameSnapshot town = townSnapshot();
    views.push_back({"town corner", town, lookingAt({9.0, 4.2, 43.0}, {20.5, 3.2, 36.0}, 0.9f)});
    views.push_back({"town roofs", town, lookingAt({52, 15, 14}, {28, 1, 34}, 0.8f)});
    views.push_back({"street above", streetScene().snapshot(), streetCamera(3).view({0, 0}, 0)});
    views.push_back({"town street", town, lookingAt({13.0, 1.7, 58.0}, {25.0, 3.0, 36.0}, 0.9f)});
    views.push_back({"town from the air", town, lookingAt({6, 16, 60}, {28, 1, 34}, 0.8f)});
    views.push_back({"town shop", town, lookingAt({46.0, 1.7, 56.0}, {39.0, 2.6, 34.0}, 0.9f)});
    views.push_back({"town crossing", town, lookingAt({3, 6, 60}, {32.0, 1.5, 46.0}, 0.9f)});
    views.push_back({"town garden", town, lookingAt({12, 6, 20}, {24, 2, 33}, 0.8f)});
    views.push_back({"town yard", town, lookingAt({41.0, 1.7, 22.0}, {25.0, 2.2, 31.0}, 0.95f)});
    return views;
}

std::vector<SceneView> heldOutViews() {
    const FrameSnapshot town = townSnapshot();
    return {{"town lane", town, lookingAt({4.5, 1.7, 13.0}, {15.0, 2.5, 36.0}, 0.95f)},
            {"town across", town, lookingAt({58.0, 8.0, 57.0}, {36.0, 2.0, 38.0}, 0.95f)},
            {"town pavement", town, lookingAt({40.0, 1.7, 44.5}, {22.0, 2.2, 38.0}, 0.95f)}};
}

RenderSettings comparedSettings() {
    RenderSettings settings;
    settings.refraction = settings.detail = false;  // the reference has neither
    settings.skyRays = 1;
    settings.sunRays = 1;
    settings.bevel = settings.fog = settings.glare = false;
    return settings;
}

}  // namespace rubble::reference
