#pragma once
#include <OgreMovableObject.h>
#include <OgreRenderQueueListener.h>
#include <OgreViewport.h>

#include <string>

#include "samples/hosts/ogre/rubble_ogre.h"

namespace rubble_ogre {

/// What "RubbleWorld" makes: a world, and a renderer that draws it between the queues of its scene. [main-thread]
class DrawnWorld final : public WorldObject, public Ogre::RenderQueueListener {
public:
    /// Makes the world; an Ogre::Exception says why it cannot. Parameters as in rubble_ogre.h; may be null.
    DrawnWorld(const Ogre::String& name, const Ogre::NameValuePairList* parameters);
    ~DrawnWorld() override;
    const rubble_api& api() const override { return *m_api; }
    rubble_world world() const override { return m_world; }
    uint64_t changedState() const override { return m_changedState; }

    // What Ogre asks and tells.
    const Ogre::String& getMovableType() const override;
    const Ogre::AxisAlignedBox& getBoundingBox() const override { return m_box; }
    Ogre::Real getBoundingRadius() const override { return 0; }
    void visitRenderables(Ogre::Renderable::Visitor*, bool) override {}
    void _updateRenderQueue(Ogre::RenderQueue*) override {}
    void _notifyManager(Ogre::SceneManager* scene) override;
    void renderQueueEnded(Ogre::uint8 queue, const Ogre::String& invocation, bool& repeat) override;

private:
    void check(rubble_result result, const char* what) const;
    void createRenderer();
    void draw(Ogre::Viewport& viewport);

    Ogre::AxisAlignedBox m_box{Ogre::AxisAlignedBox::BOX_INFINITE};
    std::string m_preset = "fast";
    bool m_checksState = false;
    const rubble_api* m_api = nullptr;
    rubble_world m_world = 0;
    rubble_renderer m_renderer = 0;
    uint64_t m_changedState = 0;
};

/// Makes them for scenes.
class WorldFactory final : public Ogre::MovableObjectFactory {
public:
    const Ogre::String& getType() const override;

protected:
    Ogre::MovableObject* createInstanceImpl(const Ogre::String& name,
                                            const Ogre::NameValuePairList* parameters) override;
};

}  // namespace rubble_ogre
