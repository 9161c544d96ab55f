// Plugin_Rubble: adds the kind of object "RubbleWorld" to Ogre.
#include <OgrePlugin.h>
#include <OgreRoot.h>

#include "samples/hosts/ogre/world_object.h"

namespace rubble_ogre {
namespace {

class RubblePlugin final : public Ogre::Plugin {
public:
    const Ogre::String& getName() const override {
        static const Ogre::String name = "Rubble";
        return name;
    }
    void install() override { Ogre::Root::getSingleton().addMovableObjectFactory(&m_factory); }
    void initialise() override {}
    void shutdown() override {}
    void uninstall() override { Ogre::Root::getSingleton().removeMovableObjectFactory(&m_factory); }

private:
    WorldFactory m_factory;
};

RubblePlugin* g_plugin = nullptr;

}  // namespace
}  // namespace rubble_ogre

#define EXPORT __attribute__((visibility("default")))

extern "C" {

EXPORT void dllStartPlugin() {
    rubble_ogre::g_plugin = new rubble_ogre::RubblePlugin;
    Ogre::Root::getSingleton().installPlugin(rubble_ogre::g_plugin);
}

EXPORT void dllStopPlugin() {
    Ogre::Root::getSingleton().uninstallPlugin(rubble_ogre::g_plugin);
    delete rubble_ogre::g_plugin;
}
}
