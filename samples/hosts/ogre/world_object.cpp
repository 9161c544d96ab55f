#include "samples/hosts/ogre/world_object.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <OgreCamera.h>
#include <OgreException.h>
#include <OgreLogManager.h>
#include <OgreRenderTarget.h>
#include <OgreSceneManager.h>
#include <dlfcn.h>

#include "samples/hosts/support/gl_state.h"

namespace rubble_ogre {
namespace {

const Ogre::String kType = "RubbleWorld";

void log(void*, int32_t level, const char* message) {
    if (level != RUBBLE_LOG_INFO) Ogre::LogManager::getSingleton().logMessage(std::string("Rubble: ") + message);
}

/// RenderSystem_GL3Plus makes its contexts with GLX.
void* findGl(const char* name) {
    using Finder = void* (*)(const unsigned char*);
    static const auto find = reinterpret_cast<Finder>(dlsym(dlopen("libGL.so.1", RTLD_LAZY), "glXGetProcAddressARB"));
    return find ? find(reinterpret_cast<const unsigned char*>(name)) : nullptr;
}

}  // namespace

DrawnWorld::DrawnWorld(const Ogre::String& name, const Ogre::NameValuePairList* parameters) : WorldObject(name) {
    rubble_host host = {.struct_size = sizeof host};
    rubble_world_settings settings = {.struct_size = sizeof settings};
    host.log = log;
    host.gl_get_proc_address = findGl;
    const auto parameter = [&](const char* key) {
        const auto found = parameters ? parameters->find(key) : Ogre::NameValuePairList::const_iterator{};
        return parameters && found != parameters->end() ? found->second : Ogre::String();
    };
    if (!parameter("preset").empty()) m_preset = parameter("preset");
    if (parameter("wait_for_shadow") == "true") settings.flags = RUBBLE_WORLD_WAIT_FOR_SHADOW;
    m_checksState = parameter("check_gl_state") == "true";
    check(rubble_get_api(RUBBLE_VERSION, &m_api), "rubble_get_api");
    check(m_api->set_host(&host), "set_host");
    check(m_api->create_world(&settings, &m_world), "create_world");
    const Ogre::String level = parameter("level");
    if (!level.empty()) check(m_api->load_level(m_world, level.c_str(), nullptr), "load_level");
}

DrawnWorld::~DrawnWorld() {
    if (mManager) mManager->removeRenderQueueListener(this);
    if (m_renderer) m_api->destroy_renderer(m_renderer);
    m_api->destroy_world(m_world);
}

void DrawnWorld::check(rubble_result result, const char* what) const {
    if (result == RUBBLE_OK) return;
    OGRE_EXCEPT(Ogre::Exception::ERR_RENDERINGAPI_ERROR,
                std::string(what) + ": " + (m_api ? m_api->get_last_error() : "librubble is of another version"),
                "RubbleWorld");
}

const Ogre::String& DrawnWorld::getMovableType() const {
    return kType;
}

void DrawnWorld::_notifyManager(Ogre::SceneManager* scene) {
    if (mManager) mManager->removeRenderQueueListener(this);
    WorldObject::_notifyManager(scene);
    if (scene) scene->addRenderQueueListener(this);
}

void DrawnWorld::renderQueueEnded(Ogre::uint8 queue, const Ogre::String&, bool&) {
    if (queue != Ogre::RENDER_QUEUE_MAIN || !isVisible() || !isInScene()) return;
    if (mManager->_getCurrentRenderStage() == Ogre::SceneManager::IRS_RENDER_TO_TEXTURE) return;  // a shadow map
    if (!m_renderer) createRenderer();
    draw(*mManager->getCurrentViewport());
}

void DrawnWorld::createRenderer() {
    rubble_renderer_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_RENDERER_COMPILE_LATE};
    settings.preset = m_preset.c_str();
    check(m_api->create_renderer(m_world, &settings, &m_renderer), "create_renderer");
}

void DrawnWorld::draw(Ogre::Viewport& viewport) {
    rubble_view view = {.struct_size = sizeof view, .flags = RUBBLE_VIEW_DEPTH};
    const Ogre::Camera& camera = *viewport.getCamera();
    const Ogre::Vector3 position = camera.getDerivedPosition();
    const Ogre::Quaternion rotation = camera.getDerivedOrientation();
    const Ogre::Matrix4 projection = camera.getProjectionMatrix();  // clip depths of -1 to 1
    GLint framebuffer = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    view.framebuffer = uint32_t(framebuffer);
    view.width = uint32_t(viewport.getActualWidth()), view.height = uint32_t(viewport.getActualHeight());
    if (viewport.getTarget()->requiresTextureFlipping()) view.flags |= RUBBLE_VIEW_FLIP_Y;
    view.alpha = 1.0;
    for (size_t i = 0; i < 3; ++i) view.position[i] = position[i];
    view.rotation[0] = rotation.x, view.rotation[1] = rotation.y;
    view.rotation[2] = rotation.z, view.rotation[3] = rotation.w;
    for (size_t row = 0; row < 4; ++row)
        for (size_t column = 0; column < 4; ++column) view.projection[4 * column + row] = projection[row][column];
    gl_state before, after;
    if (m_checksState) read_gl_state(findGl, &before);
    check(m_api->draw(m_renderer, &view), "draw");
    if (!m_checksState) return;
    read_gl_state(findGl, &after);
    m_changedState += uint64_t(compare_gl_states(&before, &after));
}

const Ogre::String& WorldFactory::getType() const {
    return kType;
}

Ogre::MovableObject* WorldFactory::createInstanceImpl(const Ogre::String& name,
                                                      const Ogre::NameValuePairList* parameters) {
    return new DrawnWorld(name, parameters);
}

}  // namespace rubble_ogre
