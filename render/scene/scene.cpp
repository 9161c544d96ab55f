#include "render/scene/scene.h"

namespace rubble {

Scene::Scene() = default;
Scene::~Scene() = default;

void Scene::apply(FrameSnapshot&& snapshot) {
    if (snapshot.lightsChanged) m_lights = std::move(snapshot.lights);
    if (snapshot.environmentChanged) m_environment = snapshot.environment;
}

void Scene::bindShadow(const Program&) const {}

}  // namespace rubble
