#pragma once
#include <OgreMovableObject.h>
#include <rubble/rubble.h>

#include <cstdint>

namespace rubble_ogre {

/// A world of Rubble in a scene of Ogre. Load Plugin_Rubble, then
///     sceneManager->createMovableObject("RubbleWorld", &parameters)
/// gives one, to attach to a node. Its parameters are "level", a path, and "preset", "fast" at first. It is drawn after
/// the main queue of each viewport of the scene, with the viewport's camera, among Ogre's meshes; not in shadow maps,
/// nor in multisampled targets. The node's transform is not used. What happens in the world is said by rubble.h.
/// [main-thread]
class WorldObject : public Ogre::MovableObject {
public:
    using MovableObject::MovableObject;
    /// The functions of Rubble.
    virtual const rubble_api& api() const = 0;
    /// The world, which the host steps.
    virtual rubble_world world() const = 0;
    /// How many values of the GL's state draws have changed.
    virtual uint64_t changedState() const = 0;
};

}  // namespace rubble_ogre
