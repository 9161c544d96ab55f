#include "render/passes/gbuffer_pass.h"

namespace rubble {

GBufferPass::GBufferPass(ShaderLibrary&) {}

void GBufferPass::draw(const FrameContext& frame) {
    TargetPool& targets = frame.targets;
    const Texture& albedo = targets.target("albedo", GL_RGBA8);
    const Texture& normal = targets.target("normal", GL_RGBA16F);
    const Texture& material = targets.target("material", GL_RGBA8);
    const Texture& motion = targets.target("motion", GL_RG16F);
    const Texture& depth = targets.target("depth", GL_R32F);
    const Texture& depthBuffer = targets.target("depthBuffer", GL_DEPTH_COMPONENT32F);
    targets.framebuffer({&albedo, &normal, &material, &motion, &depth}, &depthBuffer).begin();
    const float zero[4] = {0, 0, 0, 0}, sky[4] = {65000, 0, 0, 0};
    for (int i = 0; i < 4; ++i) glClearBufferfv(GL_COLOR, i, zero);
    glClearBufferfv(GL_COLOR, 4, sky);
    glClearBufferfi(GL_DEPTH, 0, 1.0f, 0);
}

void GBufferPass::bind(const Program& program, const TargetPool& targets) {
    program.set("uAlbedo", targets.at("albedo"));
    program.set("uNormal", targets.at("normal"));
    program.set("uMaterial", targets.at("material"));
    program.set("uMotion", targets.at("motion"));
    program.set("uDepth", targets.at("depth"));
}

}  // namespace rubble
