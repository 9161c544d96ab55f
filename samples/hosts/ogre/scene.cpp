#include "samples/hosts/ogre/scene.h"

#include <OgreEntity.h>
#include <OgreHighLevelGpuProgram.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreMaterialManager.h>
#include <OgreTechnique.h>
#include <OgreViewport.h>

namespace rubble_ogre {
namespace {

const char kVertexProgram[] =
    "#version 330\n"
    "uniform mat4 world, viewProjection;\n"
    "in vec4 vertex; in vec3 normal; out vec3 facing;\n"
    "void main() { facing = mat3(world) * normal; gl_Position = viewProjection * world * vertex; }\n";
const char kFragmentProgram[] =
    "#version 330\n"
    "uniform vec4 sun;\n"
    "in vec3 facing; out vec4 color;\n"
    "void main() {\n"
    "    float light = 0.55 + 0.45 * max(dot(normalize(facing), normalize(sun.xyz)), 0.0);\n"
    "    color = vec4(light, 0.0, light, 1.0);\n"
    "}\n";

Ogre::HighLevelGpuProgramPtr makeProgram(const char* name, Ogre::GpuProgramType type, const char* source) {
    auto program =
        Ogre::HighLevelGpuProgramManager::getSingleton().createProgram(name, Ogre::RGN_DEFAULT, "glsl", type);
    program->setSource(source);
    program->load();
    return program;
}

/// A material of magenta, by programs of GLSL: RenderSystem_GL3Plus has no fixed functions.
Ogre::MaterialPtr makeMaterial() {
    using Parameters = Ogre::GpuProgramParameters;
    makeProgram("own_vertices", Ogre::GPT_VERTEX_PROGRAM, kVertexProgram);
    makeProgram("own_fragments", Ogre::GPT_FRAGMENT_PROGRAM, kFragmentProgram);
    const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().create("own", Ogre::RGN_DEFAULT);
    Ogre::Pass* const pass = material->getTechnique(0)->getPass(0);
    pass->setVertexProgram("own_vertices");
    pass->setFragmentProgram("own_fragments");
    const auto vertices = pass->getVertexProgramParameters();
    vertices->setNamedAutoConstant("world", Parameters::ACT_WORLD_MATRIX);
    vertices->setNamedAutoConstant("viewProjection", Parameters::ACT_VIEWPROJ_MATRIX);
    pass->getFragmentProgramParameters()->setNamedConstant("sun", Ogre::Vector4(0.5f, 0.8f, 0.4f, 0.0f));
    return material;
}

void addMeshes(Scene& scene) {
    const Ogre::MaterialPtr material = makeMaterial();
    Ogre::SceneNode* const root = scene.manager->getRootSceneNode();
    Ogre::Entity* const ball = scene.manager->createEntity(Ogre::SceneManager::PT_SPHERE);  // 100 units wide
    Ogre::Entity* const cube = scene.manager->createEntity(Ogre::SceneManager::PT_CUBE);    // the same
    ball->setMaterial(material), cube->setMaterial(material);
    Ogre::SceneNode* const place = root->createChildSceneNode(Ogre::Vector3(0.4f, 0.5f, 0.8f));
    place->setScale(Ogre::Vector3(0.01f));
    place->attachObject(ball);
    scene.cube = root->createChildSceneNode(Ogre::Vector3(1.75f, 0.8f, -0.95f));  // it reaches through the wall
    scene.cube->setScale(Ogre::Vector3(0.009f));
    scene.cube->attachObject(cube);
}

}  // namespace

Scene makeScene(const std::string& plugin, const std::string& parent, unsigned width, unsigned height) {
    Scene scene;
    scene.root = std::make_unique<Ogre::Root>("", "", "");
    scene.root->loadPlugin(RUBBLE_OGRE_PLUGINS "/RenderSystem_GL3Plus");
    scene.root->loadPlugin(plugin);
    scene.root->setRenderSystem(scene.root->getAvailableRenderers().at(0));
    scene.root->initialise(false);
    Ogre::NameValuePairList options;
    if (!parent.empty()) options["parentWindowHandle"] = parent;
    scene.window = scene.root->createRenderWindow("Rubble in Ogre", width, height, false, &options);
    scene.manager = scene.root->createSceneManager();
    scene.camera = scene.manager->createCamera("eyes");
    scene.camera->setNearClipDistance(0.1f), scene.camera->setFarClipDistance(200.0f);
    scene.camera->setFOVy(Ogre::Radian(1.05f)), scene.camera->setAutoAspectRatio(true);
    scene.eyes = scene.manager->getRootSceneNode()->createChildSceneNode();
    scene.eyes->attachObject(scene.camera);
    scene.window->addViewport(scene.camera)->setBackgroundColour(Ogre::ColourValue(0.4f, 0.5f, 0.6f));
    addMeshes(scene);
    const Ogre::NameValuePairList world = {{"wait_for_shadow", "true"}, {"check_gl_state", "true"}};
    scene.world = static_cast<WorldObject*>(scene.manager->createMovableObject("RubbleWorld", &world));
    scene.manager->getRootSceneNode()->attachObject(scene.world);
    return scene;
}

void destroyScene(Scene& scene) {
    scene.manager->destroyMovableObject(scene.world);
    scene.root.reset();
}

}  // namespace rubble_ogre
