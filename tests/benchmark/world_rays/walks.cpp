#include "tests/benchmark/world_rays/walks.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdlib>

#include "generated/paths.h"
#include "render/gl/framebuffer.h"
#include "render/gl/gl.h"
#include "render/shader_library/uniforms_as_varyings.h"
#include "tests/benchmark/frame_clock.h"

namespace rubble::rays {
namespace {

constexpr int kLevels = 3;
constexpr int kDrawsOnGpu = 32;  ///< of each measurement: one alone is mostly the time of a launch
const std::string kExact = "exact", kCoarseFar = "coarse_far", kSetUp = "set_up", kNoWalk = "no_walk";

bool isEngineWalk(const std::string& walk) {
    return walk == kExact || walk == kCoarseFar || walk == kSetUp;
}

/// A level of the volume of Teardown's walks: a byte holds 2x2x2 cells.
std::vector<uint8_t> packLevel(const WorldBits& bits, int level, glm::ivec3& texels) {
    texels = bits.cells() >> (level + 1);
    std::vector<uint8_t> out(size_t(texels.x) * size_t(texels.y) * size_t(texels.z));
    const glm::ivec3 n = bits.words;
    for (int w = 0; w < n.x * n.y * n.z; ++w)
        for (uint64_t word = bits.bits[size_t(w)]; word; word &= word - 1) {
            const int i = std::countr_zero(word);
            const glm::ivec3 cell =
                glm::ivec3(w % n.x, w / n.x % n.y, w / n.x / n.y) * 4 + glm::ivec3(i & 3, i >> 2 & 3, i >> 4);
            const glm::ivec3 c = cell >> level, t = c >> 1;
            out[(size_t(t.z) * size_t(texels.y) + size_t(t.y)) * size_t(texels.x) + size_t(t.x)] |=
                uint8_t(1 << ((c.x & 1) + (c.y & 1) * 2 + (c.z & 1) * 4));
        }
    return out;
}

ShaderSource sourceOf(const std::string& file) {
    auto source = readShader(RUBBLE_SOURCE_DIR "/shaders", file, "#define NO_PAGED_SHADOWS\n");
    if (!source) {
        fmt::print(stderr, "{}\n", source.error());
        std::abort();
    }
    return std::move(source.value());
}

Program makeProgram(const std::string& walk) {
    ShaderSource vertex = sourceOf("lib/fullscreen.vert"),
                 fragment = sourceOf("../tests/benchmark/world_rays/shaders/" + walk + ".frag");
    fragment.text.insert(fragment.text.find('\n') + 1, "precision highp usampler3D;\n");
    if (isSoftwareGl()) passUniformsAsVaryings(vertex, fragment);  // as the renderer does on this GL
    std::string log;
    bool vertexFailed = false;
    Program program(vertex.text, fragment.text, log, vertexFailed);
    if (!program) {
        fmt::print(stderr, "{}: {}\n", walk, log);
        std::abort();
    }
    return program;
}

}  // namespace

struct Walks::Volumes {
    GlName<TextureKind> texture3d = GlName<TextureKind>::make();
    BufferTexture buffer{GL_R8UI};
    std::array<glm::ivec4, kLevels> levels{};  ///< xyz size in texels, w first texel
    uint64_t bytes = 0;
    Texture origins{GL_RGBA32F, kImageSize}, directions{GL_RGBA32F, kImageSize}, answers{GL_RGBA16F, kImageSize};
    Framebuffer framebuffer{{&answers}};
    VertexArray emptyVertexArray = VertexArray::make();
    GlName<BufferKind> block = GlName<BufferKind>::make();

    explicit Volumes(const WorldBits& bits) {
        std::vector<uint8_t> all;
        glBindTexture(GL_TEXTURE_3D, texture3d.get());
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        for (int level = 0; level < kLevels; ++level) {
            glm::ivec3 n;
            const std::vector<uint8_t> packed = packLevel(bits, level, n);
            glTexImage3D(GL_TEXTURE_3D, level, GL_R8UI, n.x, n.y, n.z, 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                         packed.data());
            levels[size_t(level)] = glm::ivec4(n, int(all.size()));
            all.insert(all.end(), packed.begin(), packed.end());
        }
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, kLevels - 1);
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        bytes = all.size();
        if (!buffer.reserve(bytes)) std::abort();
        buffer.upload(0, std::as_bytes(std::span(all)));
    }
};

void disableGlThreads() {
    setenv("LP_NUM_THREADS", "0", 1);
}

const std::vector<std::string>& Walks::names() {
    static const std::vector<std::string> list = {kExact,      "super_sparse_3d", "super_sparse_buffer",
                                                  "sparse_3d", "sparse_buffer",   kCoarseFar};
    return list;
}

const std::vector<std::string>& Walks::baselines() {
    static const std::vector<std::string> list = {kSetUp, kNoWalk};
    return list;
}

Walks::Walks(const WorldBits& bits, const std::vector<ShadowPatch>& patches)
    : m_volumes(std::make_unique<Volumes>(bits)), m_low(bits.low), m_cells(bits.cells()) {
    for (const auto* list : {&names(), &baselines()})
        for (const std::string& name : *list) m_programs.emplace(name, makeProgram(name));
    apply(patches);
}
Walks::~Walks() = default;

uint64_t Walks::bytes(const std::string& walk) const {
    return isEngineWalk(walk) ? m_scene.shadow().bytes() : m_volumes->bytes;
}

void Walks::apply(std::vector<ShadowPatch> patches) {
    FrameSnapshot snapshot;
    snapshot.shadow = std::move(patches);
    m_scene.apply(std::move(snapshot));
    m_scene.beginFrame(1.0f, {});
}

void Walks::bind(const std::string& walk, const Program& program) {
    program.use();
    program.set("uOrigins", m_volumes->origins);
    program.set("uDirections", m_volumes->directions);
    if (isEngineWalk(walk)) {
        FrameBlock block{};
        m_scene.describe(block);
        glBindBuffer(GL_UNIFORM_BUFFER, m_volumes->block.get());
        glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, m_volumes->block.get());
        return m_scene.bindShadow(program);
    }
    program.set("uCells", m_cells);
    if (walk.ends_with("buffer")) {
        program.set("uVolume", m_volumes->buffer);
        for (int level = 0; level < kLevels; ++level)
            glUniform4iv(glGetUniformLocation(program.name(), fmt::format("uLevel{}", level).c_str()), 1,
                         &m_volumes->levels[size_t(level)].x);
        return;
    }
    constexpr int kUnit = 8;  // beyond those of the two ray textures
    glUniform1i(glGetUniformLocation(program.name(), "uVolume"), kUnit);
    glActiveTexture(GL_TEXTURE0 + kUnit);
    glBindTexture(GL_TEXTURE_3D, m_volumes->texture3d.get());
}

TraceResult Walks::trace(const std::string& walk, const RaySet& set) {
    std::vector<glm::vec4> origins, directions;
    for (const Ray& ray : set.rays) {
        origins.emplace_back(ray.origin + (isEngineWalk(walk) ? glm::vec3(m_low) : glm::vec3(0)), ray.maxDistance);
        directions.emplace_back(ray.direction, 0.0f);
    }
    m_volumes->origins.upload(origins.data());
    m_volumes->directions.upload(directions.data());
    m_volumes->framebuffer.begin();
    bind(walk, m_programs.at(walk));
    glBindVertexArray(m_volumes->emptyVertexArray.get());
    glFinish();
    const int draws = isSoftwareGl() ? 1 : kDrawsOnGpu;
    const double start = bench::frameClockMs();
    for (int i = 0; i < draws; ++i) glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
    TraceResult out{{}, (bench::frameClockMs() - start) / draws};
    std::vector<uint8_t> pixels(set.rays.size() * 4);
    glReadPixels(0, 0, kImageSize.x, kImageSize.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (size_t i = 0; i < set.rays.size(); ++i) out.stopped.push_back(pixels[i * 4] > 127);
    return out;
}

}  // namespace rubble::rays
