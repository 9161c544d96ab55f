#pragma once
#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "editor/core/editor.h"
#include "tests/support/temp_folder.h"

namespace editor {

/// Runs lines, each of which must work.
inline void runAll(Editor& editor, std::initializer_list<const char*> lines) {
    for (const char* line : lines) {
        const Outcome outcome = editor.run(std::string(line));
        ASSERT_TRUE(outcome.isDone) << line << "\n" << outcome.text;
    }
}

/// The first shape of the body with a name.
inline rubble_shape shapeOf(Editor& editor, const char* name) {
    const rubble_body body = editor.world().find_by_name(RUBBLE_KIND_BODY, name).at(0);
    return editor.world().get_objects_of(body, RUBBLE_KIND_SHAPE).at(0);
}

/// Fills a level with what the examples of all commands work on.
inline void makeTestLevel(Editor& editor) {
    runAll(editor, {"create 40,25,3 0,0,2 index=7 name=wall static=yes",
                    "create 8,8,8 0,0,0 name=crate",
                    "create 12,12,12 -3,0,0 form=sphere name=ball",
                    "resize -2,-2,-2 16,16,16 ball",
                    "create 12,4,4 -3,0,3 name=parts",
                    "box 4,0,0 7,3,3 erase shape=parts",
                    "create 8,2,8 5,0,0 name=chest",
                    "add_shape chest 8,6,8 -0.4,0.2,-0.4 name=box",
                    "add_shape chest 8,2,8 -0.4,0.8,-0.4 name=lid",
                    "create 2,20,2 -5,0,0 static=yes name=post",
                    "resize 0,-2,0 2,22,2 post",
                    "box 0,0,0 1,0,1 shape=post",
                    "create 4,4,4 -6,0,3 name=painted",
                    "entry 5 color=#112233 shape=painted",
                    "create 8,20,1 8,0,2 name=door",
                    "joint hinge door world 7.65,1,2 0,1,0 name=door_hinge",
                    "light sphere 0,3,-2 name=glow",
                    "light_group street",
                    "tag old x wall",
                    "script_add door.lua",
                    "create 4,4,4 -9,0,0 name=locked",
                    "lock locked",
                    "create 4,4,4 -9,0,3 index=30 name=striped",
                    "box 0,0,0 3,1,3 paint 31 shape=striped",
                    "entry 30 color=#808080 material=wood shape=striped",
                    "entry 31 color=#808080 material=wood shape=striped",
                    "create 4,4,4 -12,2,0 name=floating",
                    "create 8,3,20 14,0.2,0 name=cart",
                    "create 2,6,6 14.5,0,0.7 form=cylinder_x name=front",
                    "create 2,6,6 14.5,0,-0.7 form=cylinder_x name=rear",
                    "wheel cart front steer=30 name=front_wheel",
                    "select_box 0,0,0 3,3,3 crate",
                    "copy",
                    "select crate"});
}

/// Makes a folder of journals as an editor leaves it that ends without a word.
inline void leaveJournal(const std::string& folder) {
    Editor editor({.journals = folder + "-living"});
    runAll(editor, {"create 4,4,4 name=cube"});
    std::filesystem::copy(folder + "-living", folder, std::filesystem::copy_options::recursive);
}

/// Writes an image, rows from above, four bytes a pixel.
inline void writePng(const std::string& path, uint32_t width, uint32_t height, const std::vector<uint8_t>& pixels) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.format = PNG_FORMAT_RGBA;
    png.width = width, png.height = height;
    ASSERT_TRUE(png_image_write_to_file(&png, path.c_str(), 0, pixels.data(), 0, nullptr)) << png.message;
}

/// Writes an image of 16 bits a value, gray or, with two channels, gray with opacity; gamma 0: of none.
inline void writeDeepPng(const std::string& path, uint32_t width, uint32_t height, int channels,
                         const std::vector<uint16_t>& values, double gamma = 0.0) {
    const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "wb"), &std::fclose);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file.get());
    png_set_IHDR(png, info, width, height, 16, channels == 2 ? PNG_COLOR_TYPE_GRAY_ALPHA : PNG_COLOR_TYPE_GRAY,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (gamma > 0.0) png_set_gAMA(png, info, gamma);
    png_write_info(png, info);
    png_set_swap(png);
    for (uint32_t y = 0; y < height; ++y)
        png_write_row(png, reinterpret_cast<png_const_bytep>(values.data() + size_t(y) * width * size_t(channels)));
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
}

/// Where the examples find their files: the folder in which a test runs, until it ends.
class ExampleFolder {
public:
    /// Makes them.
    ExampleFolder() : m_before(std::filesystem::current_path()) {
        std::filesystem::current_path(m_folder.path());
        Editor editor;
        runAll(editor, {"create 4,4,4 name=cube", "save model.rubble"});
        writePng("image.png", 2, 1, {0, 0, 0, 255, 250, 120, 60, 255});
        std::ofstream("commands.txt") << "-- a comment\ncreate 3,3,3 0,5,0 name=\"made by a script\"\n";
    }
    ~ExampleFolder() { std::filesystem::current_path(m_before); }
    ExampleFolder(const ExampleFolder&) = delete;
    ExampleFolder& operator=(const ExampleFolder&) = delete;

private:
    rubble::TempFolder m_folder;
    std::filesystem::path m_before;
};

}  // namespace editor
