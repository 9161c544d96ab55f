#include "runtime/world/objects/object_errors.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

/// A name that cannot be written into a level or a save.
const std::string kBad = "caf\xe9";

template <class T>
void expectNamed(T object) {
    EXPECT_EQ(objectError(object), "");
    object.name = kBad;
    EXPECT_NE(objectError(object), "");
}

TEST(ObjectErrors, NamesAreUtf8) {
    expectNamed(Body{});
    expectNamed(Shape{});
    expectNamed(LightGroup{});
    Joint joint;
    joint.name = kBad;
    EXPECT_NE(objectError(joint), "");
}

TEST(ObjectErrors, TagsAreUtf8) {
    Body body;
    body.tags = {"ok", kBad};
    EXPECT_NE(objectError(body), "");
    Shape shape;
    shape.tags = {kBad};
    EXPECT_NE(objectError(shape), "");
    Note note;
    note.tags = {kBad};
    EXPECT_NE(objectError(note), "");
}

TEST(ObjectErrors, ANoteHoldsWhatTagsALevelMayGive) {
    const std::vector<std::string> tags = {"", "=", "=value", std::string(5000, 'x')};
    Shape shape;
    shape.tags = tags;
    EXPECT_EQ(objectError(shape), "");
    Note note;
    note.tags = tags;
    EXPECT_EQ(objectError(note), "") << "set_tag copies those of the level";
}

}  // namespace
}  // namespace rubble
