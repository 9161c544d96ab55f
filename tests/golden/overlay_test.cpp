// Text, boxes, images and lines over the image. RUBBLE_IMAGES=FOLDER writes an image of all of them.
#include "render/overlay/overlay.h"

#include <algorithm>
#include <cstdlib>

#include "render/overlay/glyph_atlas.h"
#include "render/overlay/text_layout.h"
#include "tests/golden/drawing.h"
#include "tests/render/gl_calls.h"

namespace rubble {
namespace {

using Kind = OverlayItem::Kind;

constexpr glm::ivec2 kSize(160, 90);
constexpr glm::vec4 kRed(1, 0, 0, 1), kGreen(0, 1, 0, 1);

OverlayItem boxAt(glm::vec2 low, glm::vec2 size, glm::vec4 color) {
    OverlayItem item;
    item.transform[2] = low, item.size = size, item.color = color;
    return item;
}

OverlayItem textAt(glm::vec2 low, const std::string& text, float size, glm::vec4 color) {
    OverlayItem item = boxAt(low, {0, 0}, color);
    item.kind = Kind::Text, item.text = text, item.fontSize = size;
    return item;
}

/// A stone wall six metres before the camera, which looks along -z.
LitScene wallScene() {
    auto palette = std::make_shared<Palette>();
    (*palette)[1].red = (*palette)[1].green = (*palette)[1].blue = 120;
    LitScene scene(palette);
    scene.add({100, 60, 2}, {{-5.0, -1.0, -6.0}, {1, 0, 0, 0}}, [](glm::ivec3) { return uint8_t(1); });
    return scene;
}

Camera camera() {
    Camera camera;
    camera.position = {0.0, 1.0, 0.0};
    return camera;
}

class OverlayDrawing : public Drawing {
protected:
    void SetUp() override {
        Drawing::SetUp();
        RenderSettings settings = RenderSettings::preset("draft");
        start(wallScene(), kSize, settings);
    }
    /// The colour of a pixel from the left upper corner after a draw of these items.
    Image drawWith(std::vector<OverlayItem> items) {
        const auto set = renderer->overlay().set(std::move(items));
        EXPECT_TRUE(set) << set.error();
        return draw(camera());
    }
    static glm::ivec3 at(const Image& image, int x, int y) {
        const uint8_t* rgb = &image.rgb[(size_t(y) * size_t(image.width) + size_t(x)) * 3];
        return {rgb[0], rgb[1], rgb[2]};
    }
    static bool isRed(glm::ivec3 rgb) { return rgb.r > 250 && rgb.g < 5 && rgb.b < 5; }
};

TEST_F(OverlayDrawing, ABoxHasItsPixelsAndNoOthers) {
    const Image without = draw(camera()), with = drawWith({boxAt({10, 20}, {30, 8}, kRed)});
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const bool isInside = x >= 10 && x < 40 && y >= 20 && y < 28;
            ASSERT_EQ(isRed(at(with, x, y)), isInside) << x << " " << y;
        }
    const glm::ivec3 difference = at(with, 100, 80) - at(without, 100, 80);
    EXPECT_LT(std::max({std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)}), 12);
}

TEST_F(OverlayDrawing, ACircleABorderAndAClipLeaveTheRestOpen) {
    OverlayItem circle = boxAt({40, 40}, {40, 40}, kRed);
    circle.align = {0.5f, 0.5f}, circle.radius = 20;
    OverlayItem border = boxAt({70, 20}, {40, 40}, kRed);
    border.stroke = 3;
    OverlayItem clipped = boxAt({120, 20}, {30, 30}, kRed);
    clipped.clip = glm::vec4(130, 0, 140, 90);
    const Image image = drawWith({circle, border, clipped});
    EXPECT_TRUE(isRed(at(image, 40, 40)) && isRed(at(image, 40, 22)));
    EXPECT_FALSE(isRed(at(image, 22, 22))) << "a corner of the circle's square";
    EXPECT_TRUE(isRed(at(image, 71, 40)));
    EXPECT_FALSE(isRed(at(image, 75, 40))) << "within the border";
    EXPECT_TRUE(isRed(at(image, 135, 30)));
    EXPECT_FALSE(isRed(at(image, 128, 30)) || isRed(at(image, 142, 30))) << "outside of the clip rectangle";
}

TEST_F(OverlayDrawing, TransformsTurnAndScale) {
    OverlayItem item = boxAt({80, 45}, {30, 4}, kRed);
    item.transform[0] = {0, 1}, item.transform[1] = {-2, 0};  // a quarter turn; twice as thick
    const Image image = drawWith({item});
    EXPECT_TRUE(isRed(at(image, 75, 60)));
    EXPECT_FALSE(isRed(at(image, 95, 47)));
}

TEST_F(OverlayDrawing, AnImageHasItsColoursAndItsPart) {
    OverlayImage halves{{2, 1}, {255, 0, 0, 255, 0, 255, 0, 255}};
    ASSERT_TRUE(renderer->overlay().setImage("halves", halves));
    OverlayItem item = boxAt({10, 10}, {40, 20}, glm::vec4(1.0f));
    item.kind = Kind::Image, item.text = "halves";
    OverlayItem part = item;
    part.transform[2] = {60, 10}, part.source = {0.75f, 0.0f, 1.0f, 1.0f};
    const Image image = drawWith({item, part});
    EXPECT_TRUE(isRed(at(image, 12, 20)));
    EXPECT_GT(at(image, 48, 20).g, 250);
    EXPECT_GT(at(image, 62, 20).g, 250) << "the right part alone";
    ASSERT_TRUE(renderer->overlay().setImage("halves", {}));
    EXPECT_FALSE(isRed(at(draw(camera()), 12, 20))) << "an image that is taken away takes its items along";
}

TEST_F(OverlayDrawing, TextHasLettersOutlineAndShadow) {
    const auto reds = [&](const OverlayItem& item) {
        const Image image = drawWith({item});
        int count = 0;
        for (int i = 0; i < kSize.x * kSize.y; ++i) count += isRed(at(image, i % kSize.x, i / kSize.x));
        return count;
    };
    OverlayItem text = textAt({10, 10}, "HIH", 48, kRed);
    const int plain = reds(text);
    EXPECT_GT(plain, 400);
    EXPECT_LT(plain, 2500);
    text.outline = 3, text.outlineColor = kRed;
    const int outlined = reds(text);
    EXPECT_GT(outlined, plain * 13 / 10);
    text.outline = 0, text.shadowColor = kRed, text.shadowOffset = {2, 2};
    EXPECT_GT(reds(text), plain * 11 / 10);
}

TEST_F(OverlayDrawing, InTheWorldItIsWhereItsPlaceIsAndVoxelsHideIt) {
    OverlayItem item = boxAt({0, 0}, {100, 100}, kRed);  // a metre
    item.align = {0.5f, 0.5f};
    item.plane = OverlayItem::Plane{.position = {0.0, 1.0, -3.0}};
    EXPECT_TRUE(isRed(at(drawWith({item}), 80, 45)));
    item.plane->position.z = -9.0, item.plane->isOccluded = true;
    EXPECT_FALSE(isRed(at(drawWith({item}), 80, 45))) << "behind the wall";
    item.plane->isOccluded = false;
    EXPECT_TRUE(isRed(at(drawWith({item}), 80, 45))) << "behind the wall, but not to be hidden";
    item.plane->position.z = 5.0;
    EXPECT_FALSE(isRed(at(drawWith({item}), 80, 45))) << "behind the camera";
    OverlayItem line;
    line.kind = Kind::WorldLine, line.color = kRed, line.stroke = 3;
    line.plane = OverlayItem::Plane{.position = {-1.0, 1.0, -3.0}, .isOccluded = true};
    line.end = {1.0, 1.0, 4.0};  // behind the camera
    EXPECT_TRUE(isRed(at(drawWith({line}), 50, 45)));
}

/// What a draw() asks of the GL.
struct Asked {
    int programs = 0, textures = 0, draws = 0;
    bool operator==(const Asked&) const = default;
};

TEST_F(OverlayDrawing, WhoDrawsNothingPaysNothing) {
    const auto asked = [&] {
        const GlCalls<&glad_glLinkProgram> programs;
        const GlCalls<&glad_glTexImage2D> textures;
        draw(camera());
        return Asked{programs.count(), textures.count(), renderer->stats().drawCalls};
    };
    draw(camera(), 2);
    const Asked never = asked();
    const uint64_t bytes = renderer->stats().textureBytes;
    const size_t passes = renderer->stats().passes.size();
    EXPECT_TRUE(renderer->overlay().set({}));
    EXPECT_EQ(asked(), never);
    EXPECT_TRUE(renderer->overlay().set(
        {textAt({5, 5}, "text", 20, kRed), boxAt({5, 5}, {9, 9}, kRed), textAt({5, 50}, "more", 9, kGreen)}));
    EXPECT_EQ(asked(), (Asked{never.programs + 1, never.textures + 2, never.draws + 1}))
        << "letters and boxes are drawn by one call; textures: the letters, and a texel in place of an image";
    EXPECT_GT(renderer->stats().textureBytes, bytes);
    EXPECT_TRUE(renderer->overlay().set({}));
    EXPECT_EQ(asked(), never);
    EXPECT_EQ(renderer->stats().passes.size(), passes);
}

TEST_F(OverlayDrawing, ErrorsNameTheItem) {
    EXPECT_TRUE(renderer->overlay().set({boxAt({10, 20}, {30, 8}, kRed)}));
    OverlayItem text = textAt({0, 0}, "x", 10, kRed);
    text.font = "/nowhere/font.ttf";
    const auto noFont = renderer->overlay().set({boxAt({0, 0}, {1, 1}, kRed), text});
    ASSERT_FALSE(noFont);
    EXPECT_NE(noFont.error().find("items[1].font: /nowhere/font.ttf"), std::string::npos) << noFont.error();
    OverlayItem image = boxAt({0, 0}, {1, 1}, kRed);
    image.kind = Kind::Image, image.text = "missing";
    const auto noImage = renderer->overlay().set({image});
    ASSERT_FALSE(noImage);
    EXPECT_NE(noImage.error().find("\"missing\""), std::string::npos) << noImage.error();
    EXPECT_TRUE(isRed(at(draw(camera()), 20, 24))) << "a refused overlay leaves the one before";
}

TEST_F(OverlayDrawing, TheSoftShadowOfAWideOutlineHasNoEdges) {
    OverlayItem text = textAt({70, 20}, "I", 40, glm::vec4(0.0f));
    text.outline = 20, text.outlineColor.a = 0.0f;
    text.shadowColor = kRed, text.shadowBlur = 20;
    const Image plain = drawWith({}), shown = drawWith({text});
    int strongest = 0, largestJump = 0;
    for (int x = 1; x < kSize.x; ++x) {
        const auto red = [&](int column) { return at(shown, column, 45).r - at(plain, column, 45).r; };
        strongest = std::max(strongest, red(x));
        largestJump = std::max(largestJump, std::abs(red(x) - red(x - 1)));
    }
    EXPECT_GT(strongest, 40);
    EXPECT_LE(largestJump, 30);
}

TEST_F(OverlayDrawing, AllOfItInAnImage) {
    const char* folder = std::getenv("RUBBLE_IMAGES");
    if (!folder) GTEST_SKIP() << "RUBBLE_IMAGES=FOLDER writes the image";
    target = std::make_unique<Offscreen>(glm::ivec2(960, 540));
    std::vector<OverlayItem> items;
    float y = 10;
    for (const float size : {10.0f, 14.0f, 20.0f, 32.0f, 64.0f}) {
        items.push_back(textAt({20, y}, "Größe — Ω жук 1234", size, glm::vec4(1.0f)));
        y += size * 1.2f;
    }
    OverlayItem text = textAt({20, 230}, "Outline", 60, {1.0f, 0.8f, 0.2f, 1.0f});
    text.font = "bold", text.outline = 4;
    items.push_back(text);
    text.transform[2] = {330, 230}, text.text = "Shadow", text.outline = 0;
    text.shadowColor = {0, 0, 0, 0.9f}, text.shadowOffset = {4, 4}, text.shadowBlur = 8;
    items.push_back(text);
    OverlayItem wrapped = textAt({700, 20}, "A text that is broken into lines between its words.", 18, glm::vec4(1.0f));
    wrapped.size.x = 220, wrapped.align = {0.0f, 0.0f};
    OverlayItem panel = boxAt({690, 12}, {240, 90}, {0, 0, 0, 0.6f});
    panel.radius = 10;
    items.push_back(panel);
    items.push_back(wrapped);
    OverlayItem circle = boxAt({740, 300}, {60, 60}, {0.2f, 0.7f, 1.0f, 0.8f});
    circle.radius = 30;
    items.push_back(circle);
    circle.transform[2].x += 80, circle.stroke = 5;
    items.push_back(circle);
    OverlayItem turned = textAt({760, 250}, "turned", 30, glm::vec4(1.0f));
    turned.transform[0] = {0.87f, -0.5f}, turned.transform[1] = {0.5f, 0.87f};
    items.push_back(turned);
    OverlayItem label = textAt({0, 0}, "in the world", 40, kGreen);
    label.plane = OverlayItem::Plane{
        .position = {-1.5, 0.2, -4.0}, .rotation = glm::angleAxis(0.8, glm::dvec3(0, 1, 0)), .isOccluded = true};
    label.outline = 2;
    items.push_back(label);
    OverlayItem line;
    line.kind = Kind::WorldLine, line.color = kRed, line.stroke = 2;
    line.plane = OverlayItem::Plane{.position = {-3, 0, -5}};
    line.end = {3, 3, -5};
    items.push_back(line);
    ASSERT_TRUE(renderer->overlay().set(items));
    ASSERT_TRUE(writePng(std::string(folder) + "/overlay.png", draw(camera(), 8)));
}

TEST(TextLayout, DecodesUtf8) {
    EXPECT_EQ(charactersOf("a\xC3\xB6\xE2\x82\xAC\xF0\x9F\x98\x80"),
              (std::vector<char32_t>{'a', 0xF6, 0x20AC, 0x1F600}));
    EXPECT_EQ(charactersOf("\xEF\xBF\xBD!"), (std::vector<char32_t>{0xFFFD, '!'}));
    EXPECT_EQ(charactersOf("\xC3"), std::vector<char32_t>{0xFFFD}) << "cut off";
    EXPECT_EQ(charactersOf("\xC0\x80"), (std::vector<char32_t>{0xFFFD, 0xFFFD})) << "longer than it need be";
    EXPECT_EQ(charactersOf("\xED\xA0\x80").front(), char32_t(0xFFFD)) << "half of a UTF-16 pair";
}

TEST(TextLayout, BreaksLinesBetweenWords) {
    Fonts fonts;
    const auto font = fonts.find("");
    ASSERT_TRUE(font) << font.error();
    const TextLayout whole = layOut(**font, "one two three", {20.0f, 0.0f, 0.0f});
    const TextLayout broken = layOut(**font, "one two three", {20.0f, whole.size.x * 0.7f, 0.0f});
    EXPECT_LE(broken.size.x, whole.size.x * 0.7f);
    EXPECT_FLOAT_EQ(broken.size.y, whole.size.y * 2.0f);
    const TextLayout fed = layOut(**font, "one\n\ntwo", {20.0f, 0.0f, 1.0f});
    EXPECT_FLOAT_EQ(fed.size.y, whole.size.y * 3.0f);
    EXPECT_GT(fed.glyphs[0].pen.x + fed.glyphs[3].pen.x, 0.0f);
    const TextLayout narrow = layOut(**font, "wide", {20.0f, 1.0f, 0.0f});
    EXPECT_FLOAT_EQ(narrow.size.y, whole.size.y * 4.0f) << "a letter a line, where not even one fits";
    EXPECT_FLOAT_EQ(layOut(**font, "one  ", {20.0f, 0.0f, 0.0f}).size.x,
                    layOut(**font, "one", {20.0f, 0.0f, 0.0f}).size.x);
    EXPECT_EQ(layOut(**font, "", {20.0f, 0.0f, 0.0f}).size.x, 0.0f);
}

TEST(GlyphAtlas, SaysWhenItIsFullAndBeginsAnew) {
    Fonts fonts;
    const auto font = fonts.find("");
    ASSERT_TRUE(font) << font.error();
    GlyphAtlas atlas(128);
    int placed = 0;
    for (char32_t letter = 'a'; letter <= 'z'; ++letter)
        placed += atlas.find(**font, (*font)->glyphOf(letter)) != nullptr;
    EXPECT_GE(placed, 3);
    EXPECT_LT(placed, 26);
    atlas.clear();
    EXPECT_TRUE(atlas.find(**font, (*font)->glyphOf('z')));
}

}  // namespace
}  // namespace rubble
