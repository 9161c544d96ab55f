// Names and tags of objects.
#include "editor/core/editor.h"

namespace editor {
namespace {

std::vector<uint64_t> named(Editor& editor, const Arguments& arguments) {
    return editor.objects(arguments, "what",
                          {RUBBLE_KIND_BODY, RUBBLE_KIND_SHAPE, RUBBLE_KIND_LIGHT, RUBBLE_KIND_LIGHT_GROUP,
                           RUBBLE_KIND_WATER, RUBBLE_KIND_TRIGGER, RUBBLE_KIND_CHARACTER, RUBBLE_KIND_JOINT});
}

void setName(Editor& editor, const Arguments& arguments) {
    for (const uint64_t each : named(editor, arguments)) editor.giveName(arguments, each);
}

void setTag(Editor& editor, const Arguments& arguments) {
    for (const uint64_t each : named(editor, arguments))
        editor.world().set_tag(each, arguments.text("tag").c_str(), arguments.text("value").c_str());
}

void removeTag(Editor& editor, const Arguments& arguments) {
    for (const uint64_t each : named(editor, arguments)) editor.world().remove_tag(each, arguments.text("tag").c_str());
}

void setLayer(Editor& editor, const Arguments& arguments) {
    for (const uint64_t each : named(editor, arguments))
        editor.world().set_tag(each, kLayerTag, arguments.text("layer").c_str());
}

void lock(Editor& editor, const Arguments& arguments) {
    for (const uint64_t each : named(editor, arguments)) editor.world().set_tag(each, kLockedTag, "");
}

void unlock(Editor& editor, const Arguments& arguments) {
    for (const uint64_t each : named(editor, arguments)) editor.world().remove_tag(each, kLockedTag);
}

}  // namespace

std::vector<Command> nameCommands() {
    const Parameter what{"what", Type::Objects, "the objects", "selected"};
    const Parameter tag{"tag", Type::Text, "without '='", kRequired};
    return {
        {"name",
         "names",
         Kind::Edit,
         "Gives objects a name.",
         {{"name", Type::Text, "need not be unique", kRequired}, what},
         setName,
         "name box crate"},
        {"tag",
         "names",
         Kind::Edit,
         "Gives objects a tag: tag:NAME then stands for all that have it.",
         {tag, {"value", Type::Text, "of the tag", ""}, what},
         setTag,
         "tag furniture heavy crate"},
        {"untag", "names", Kind::Edit, "Takes a tag away.", {tag, what}, removeTag, "untag old wall"},
        {"layer",
         "names",
         Kind::Edit,
         "Puts objects into a layer: tag:layer=NAME then stands for all in it.",
         {{"layer", Type::Text, "its name", kRequired}, what},
         setLayer,
         "layer furniture crate"},
        {"lock",
         "names",
         Kind::Edit,
         "Keeps objects from edits until unlock: all and tag:NAME leave them out.",
         {what},
         lock,
         "lock wall"},
        {"unlock", "names", Kind::Edit, "Lets objects be edited again.", {what}, unlock, "unlock locked"},
    };
}

}  // namespace editor
