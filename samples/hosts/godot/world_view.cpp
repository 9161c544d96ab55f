#include "samples/hosts/godot/world_view.h"

#include <cmath>

#include "samples/hosts/godot/host_services.h"
#include "samples/hosts/godot/spatial_math.h"
#include "samples/hosts/godot/voxel_world.h"
#include "samples/hosts/support/gl_state.h"

namespace rubble_godot {
namespace {

const Method kGetViewport{"Node", "get_viewport"}, kGetSize{"Viewport", "get_size"},
    kGetCamera{"Viewport", "get_camera"}, kGetPlace{"Camera", "get_camera_transform"}, kGetFov{"Camera", "get_fov"},
    kGetNear{"Camera", "get_znear"}, kGetFar{"Camera", "get_zfar"}, kGetWorld{"Spatial", "get_world"},
    kGetScenario{"World", "get_scenario"}, kIsVisible{"Spatial", "is_visible_in_tree"};
const Method kTextureCreate{"VisualServer", "texture_create"}, kTextureAllocate{"VisualServer", "texture_allocate"},
    kTextureName{"VisualServer", "texture_get_texid"}, kShaderCreate{"VisualServer", "shader_create"},
    kShaderSetCode{"VisualServer", "shader_set_code"}, kMaterialCreate{"VisualServer", "material_create"},
    kMaterialSetShader{"VisualServer", "material_set_shader"}, kMaterialSetParam{"VisualServer", "material_set_param"},
    kMeshCreate{"VisualServer", "mesh_create"}, kMeshAddSurface{"VisualServer", "mesh_add_surface_from_arrays"},
    kInstanceCreate{"VisualServer", "instance_create2"}, kInstanceSetVisible{"VisualServer", "instance_set_visible"},
    kInstanceSetMargin{"VisualServer", "instance_set_extra_visibility_margin"},
    kInstanceSetMaterial{"VisualServer", "instance_geometry_set_material_override"},
    kInstanceSetShadows{"VisualServer", "instance_geometry_set_cast_shadows_setting"},
    kFree{"VisualServer", "free_rid"};

constexpr int32_t kFormatFloat = 8, kFormatRgbaHalf = 15;  // Image.FORMAT_RF, FORMAT_RGBAH
constexpr int32_t kTexture2d = 0, kNoFilter = 0, kTriangles = 4, kShadowsOff = 0;

// Depths are as Godot's own camera makes them, so that Godot can test them.
const char kCode[] =
    "shader_type spatial;\n"
    "render_mode unshaded, cull_disabled, shadows_disabled;\n"
    "uniform sampler2D colors; uniform sampler2D depths; uniform bool sky; uniform float brightness;\n"
    "void vertex() { POSITION = vec4(VERTEX.xy, 0.0, 1.0); }\n"
    "void fragment() {\n"
    "    float depth = texture(depths, SCREEN_UV).r;\n"
    "    if (!sky && depth >= 1.0) discard;\n"
    "    ALBEDO = brightness * texture(colors, SCREEN_UV).rgb;\n"
    "    DEPTH = depth;\n"
    "}\n";

}  // namespace

WorldView::~WorldView() {
    gd::Object* const server = singleton("VisualServer");
    if (m_renderer) m_owner.check(m_owner.api().destroy_renderer(m_renderer), "destroy_renderer");
    m_target.reset();
    for (const Variant* rid : {&m_instance, &m_mesh, &m_material, &m_shader, &m_colors, &m_depths})
        if (rid->ridKey()) kFree(server, *rid);
}

bool WorldView::open() {
    rubble_renderer_settings settings = {.struct_size = sizeof settings};
    settings.flags = RUBBLE_RENDERER_COMPILE_LATE;
    settings.preset = m_owner.preset.c_str();
    if (!m_owner.check(m_owner.api().create_renderer(m_owner.world(), &settings, &m_renderer), "create_renderer")) {
        m_failed = true;  // said once
        return false;
    }
    m_target = std::make_unique<GlTarget>();
    addRectangle();
    return true;
}

void WorldView::addRectangle() {
    gd::Object* const server = singleton("VisualServer");
    const std::vector<Vec3> corners = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    std::vector<Variant> arrays(9);  // Mesh.ARRAY_MAX: vertices first, indices last
    arrays[0] = Variant::pool(corners);
    arrays[8] = Variant::pool(std::vector<int32_t>{0, 1, 2, 0, 2, 3});
    m_colors = kTextureCreate(server), m_depths = kTextureCreate(server);
    m_shader = kShaderCreate(server), m_material = kMaterialCreate(server), m_mesh = kMeshCreate(server);
    kShaderSetCode(server, m_shader, kCode);
    kMaterialSetShader(server, m_material, m_shader);
    kMeshAddSurface(server, m_mesh, kTriangles, Variant::array(arrays));
    const Variant world = kGetWorld(m_owner.node());
    m_instance = kInstanceCreate(server, m_mesh, kGetScenario(world.as<gd::Object*>()));
    kInstanceSetMargin(server, m_instance, 16384.0);  // it is in each frame, wherever the camera is
    kInstanceSetShadows(server, m_instance, kShadowsOff);
    kInstanceSetMaterial(server, m_instance, m_material);
}

void WorldView::resize(std::array<int32_t, 2> size) {
    gd::Object* const server = singleton("VisualServer");
    kTextureAllocate(server, m_colors, size[0], size[1], 0, kFormatRgbaHalf, kTexture2d, kNoFilter);
    kTextureAllocate(server, m_depths, size[0], size[1], 0, kFormatFloat, kTexture2d, kNoFilter);
    m_target->attach(uint32_t(kTextureName(server, m_colors).as<int64_t>()),
                     uint32_t(kTextureName(server, m_depths).as<int64_t>()), size[0], size[1]);
    kMaterialSetParam(server, m_material, "colors", m_colors);
    kMaterialSetParam(server, m_material, "depths", m_depths);
    kMaterialSetParam(server, m_material, "sky", m_owner.sky);
    kMaterialSetParam(server, m_material, "brightness", m_owner.brightness);
    m_size = size;
}

rubble_view WorldView::makeView(gd::Object* camera) const {
    rubble_view view = {.struct_size = sizeof view};
    const Transform place = kGetPlace(camera).as<Transform>();
    const double near = kGetNear(camera).as<double>(), far = kGetFar(camera).as<double>();
    const double zoom = 1.0 / std::tan(kGetFov(camera).as<double>() * 0.5 * std::acos(-1.0) / 180.0);
    view.flags = RUBBLE_VIEW_DEPTH | RUBBLE_VIEW_LINEAR;
    view.framebuffer = m_target->name();
    view.width = uint32_t(m_size[0]), view.height = uint32_t(m_size[1]);
    view.alpha = 1.0;
    copy(place.origin, view.position);
    toQuaternion(place, view.rotation);
    view.projection[0] = zoom * m_size[1] / m_size[0];  // Camera.KEEP_HEIGHT
    view.projection[5] = zoom;
    view.projection[10] = -(far + near) / (far - near);
    view.projection[11] = -1.0;
    view.projection[14] = -2.0 * far * near / (far - near);
    return view;
}

void WorldView::draw() {
    if (m_failed || (!m_renderer && !open())) return;
    gd::Object* const viewport = kGetViewport(m_owner.node()).as<gd::Object*>();
    gd::Object* const camera = kGetCamera(viewport).as<gd::Object*>();
    const bool visible = camera && kIsVisible(m_owner.node()).as<bool>();
    kInstanceSetVisible(singleton("VisualServer"), m_instance, visible);
    if (!visible) return;
    const std::array<int32_t, 2> size = kGetSize(viewport).asSize();
    if (size != m_size) resize(size);
    gl_state before, after;
    if (m_owner.checkState) read_gl_state(hostServices().gl_get_proc_address, &before);
    m_target->clear();
    const rubble_view view = makeView(camera);
    m_failed = !m_owner.check(m_owner.api().draw(m_renderer, &view), "draw");
    if (m_owner.checkState) read_gl_state(hostServices().gl_get_proc_address, &after);
    if (m_owner.checkState) m_changedState += compare_gl_states(&before, &after);
}

}  // namespace rubble_godot
