#include "tests/reference/exr_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include <filesystem>

#include "runtime/core/hash.h"

namespace rubble::reference {
namespace {

constexpr uint64_t kTracerVersion = 4;  // raise it when the tracer changes, so that no cached file is used
constexpr const char* kNames[6] = {"R", "G", "B", "variance.R", "variance.G", "variance.B"};

/// Slices over the channels. OpenEXR wants the top row first, which is last in memory: the strides are negative.
Imf::FrameBuffer slicesOf(Estimate& estimate) {
    Imf::FrameBuffer slices;
    const glm::ivec2 size = estimate.mean.size;
    for (int i = 0; i < 6; ++i) {
        FloatImage& image = i < 3 ? estimate.mean : estimate.variance;
        char* top = reinterpret_cast<char*>(&image.at(0, size.y - 1)) + sizeof(float) * size_t(i % 3);
        slices.insert(kNames[i],
                      Imf::Slice(Imf::FLOAT, top, sizeof(glm::vec4), size_t(0) - sizeof(glm::vec4) * size_t(size.x)));
    }
    return slices;
}

uint64_t keyOf(const Scene& scene, const View& view, const Settings& s) {
    uint64_t key = hashValue(kTracerVersion, scene.hash());
    const double numbers[] = {view.position.x,     view.position.y,     view.position.z,        view.rotation.w,
                              view.rotation.x,     view.rotation.y,     view.rotation.z,        view.verticalFov,
                              double(view.size.x), double(view.size.y), double(int(s.term)),    double(s.samples),
                              double(s.bounces),   s.maxDistance,       double(s.filterPixels), double(s.lobeSamples),
                              double(s.seed)};
    for (const double number : numbers) key = hashValue(number, key);
    return key;
}

}  // namespace

Result<Done> writeExr(const std::string& path, const Estimate& estimate) {
    try {
        Imf::Header header(estimate.mean.size.x, estimate.mean.size.y);
        for (const char* name : kNames) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        header.insert("samples", Imf::IntAttribute(estimate.samples));
        Imf::OutputFile file(path.c_str(), header);
        Estimate copy = estimate;
        file.setFrameBuffer(slicesOf(copy));
        file.writePixels(estimate.mean.size.y);
    } catch (const std::exception& e) {
        return Error{path + ": " + e.what()};
    }
    return Done{};
}

Result<Estimate> readExr(const std::string& path) {
    try {
        Imf::InputFile file(path.c_str());
        const Imath::Box2i window = file.header().dataWindow();
        const glm::ivec2 size(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
        Estimate estimate{FloatImage(size), FloatImage(size), 0};
        if (const auto* samples = file.header().findTypedAttribute<Imf::IntAttribute>("samples"))
            estimate.samples = samples->value();
        for (glm::vec4& pixel : estimate.mean.pixels) pixel.a = 1.0f;
        file.setFrameBuffer(slicesOf(estimate));
        file.readPixels(window.min.y, window.max.y);
        return estimate;
    } catch (const std::exception& e) {
        return Error{path + ": " + e.what()};
    }
}

Estimate cachedRender(const Scene& scene, const View& view, const Settings& settings, const std::string& folder,
                      const std::string& what) {
    const std::string path = fmt::format("{}/{:016x}.exr", folder, keyOf(scene, view, settings));
    if (std::filesystem::exists(path))
        if (auto found = readExr(path); found && found->mean.size == view.size) return *found;
    Estimate estimate = render(scene, view, settings, what);
    std::filesystem::create_directories(folder);
    // Written under another name first, so that an interrupted run leaves no incomplete file.
    if (writeExr(path + ".part", estimate)) std::filesystem::rename(path + ".part", path);
    return estimate;
}

}  // namespace rubble::reference
