#pragma once
#include <OgreCamera.h>
#include <OgreRenderWindow.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>

#include <memory>
#include <string>

#include "samples/hosts/ogre/rubble_ogre.h"

namespace rubble_ogre {

/// A scene of Ogre: a window, a camera, a light, a ball and a cube of Ogre's own, and a world of Rubble.
struct Scene {
    std::unique_ptr<Ogre::Root> root;
    Ogre::RenderWindow* window = nullptr;
    Ogre::SceneManager* manager = nullptr;
    Ogre::Camera* camera = nullptr;
    Ogre::SceneNode* eyes = nullptr;  ///< of the camera
    Ogre::SceneNode* cube = nullptr;  ///< it turns
    WorldObject* world = nullptr;
};

/// Makes it with the plugins of Ogre and of Rubble. parent: the native window that it is drawn in, by its number; ""
/// for one of its own. An Ogre::Exception says what is missing.
Scene makeScene(const std::string& plugin, const std::string& parent, unsigned width, unsigned height);
/// Lets go of it all, in the right order.
void destroyScene(Scene& scene);

}  // namespace rubble_ogre
