#include "runtime/world/stages/note_edits.h"

#include <algorithm>
#include <string>

#include "runtime/core/log.h"
#include "runtime/world/queries/notes.h"

namespace rubble {
namespace {

/// The note of an object, a new one if it has none; null, and logged, if there is no such object.
Note* openNote(EditContext& context, const AnyObject& object, const char* edit) {
    if (!isAlive(context.world, object)) {
        context.warnStale(std::string(edit) + ": the handle of its object is stale; nothing was changed");
        return nullptr;
    }
    const auto known = context.world.noteOf.find(bitsOf(object));
    Note made;
    made.object = object;
    const NoteHandle note = known != context.world.noteOf.end() ? known->second : context.world.addNote(made);
    context.changes.notes.push_back(note);
    return &context.world.notes.at(note);
}

/// The tags of an object, to change them: those that its level gave it are copied into its note.
std::vector<std::string>* openTags(EditContext& context, const AnyObject& object, const char* edit) {
    Note* note = openNote(context, object, edit);
    if (!note) return nullptr;
    if (!note->setsTags) note->tags = tagsOf(context.world, object);
    note->setsTags = true;
    return &note->tags;
}

template <class Handle>
void dropNote(EditContext& context, Handle object) {
    const auto known = context.world.noteOf.find(object.bits);
    if (known == context.world.noteOf.end() || mapOf<Handle>(context.world).find(object)) return;
    context.world.notes.erase(known->second);
    context.changes.notes.push_back(known->second);
    context.world.noteOf.erase(known);
}

}  // namespace

void apply(EditContext& context, const SetNameEdit& edit) {
    if (Note* note = openNote(context, edit.object, "set_name")) note->setsName = true, note->name = edit.name;
}

void apply(EditContext& context, const SetTagEdit& edit) {
    std::vector<std::string>* tags = openTags(context, edit.object, "set_tag");
    if (!tags) return;
    const auto found = findTag(*tags, edit.tag);
    std::string text = edit.value.empty() ? edit.tag : edit.tag + "=" + edit.value;
    if (found == tags->end())
        tags->push_back(std::move(text));
    else
        (*tags)[size_t(found - tags->begin())] = std::move(text);
}

void apply(EditContext& context, const RemoveTagEdit& edit) {
    if (std::vector<std::string>* tags = openTags(context, edit.object, "remove_tag"))
        std::erase_if(*tags, [&](const std::string& tag) { return tagName(tag) == edit.tag; });
}

void apply(EditContext& context, const SetUserValueEdit& edit) {
    if (Note* note = openNote(context, edit.object, "set_user_value")) note->userValue = edit.value;
}

void apply(EditContext& context, const SetScriptsEdit& edit) {
    std::vector<LevelScript>& scripts = context.world.scripts;
    std::vector<LevelScript> wanted = edit.adds ? scripts : std::vector<LevelScript>();
    wanted.insert(wanted.end(), edit.scripts.begin(), edit.scripts.end());
    context.changes.scriptsChanged |= wanted != scripts;
    scripts = std::move(wanted);
}

void inheritNote(EditContext& context, ShapeHandle from, ShapeHandle piece) {
    const Note* known = context.world.findNote(from.bits);
    if (!known && !context.world.settings.keepOrigins) return;
    Note note = known ? *known : Note{};
    note.object = piece;
    note.parent = from;
    if (!note.root) note.root = from;
    context.changes.notes.push_back(context.world.addNote(std::move(note)));
}

void dropNotes(EditContext& context) {
    if (context.world.noteOf.empty()) return;
    const FrameChanges& changes = context.changes;
    for (const BodyHandle body : changes.bodiesDestroyed) dropNote(context, body);
    for (const ShapeHandle shape : changes.shapesDestroyed) dropNote(context, shape);
    for (const LightHandle light : changes.lights) dropNote(context, light);
    for (const WaterHandle water : changes.waters) dropNote(context, water);
    for (const TriggerHandle trigger : changes.triggers) dropNote(context, trigger);
    for (const CharacterHandle character : changes.characters) dropNote(context, character);
    for (const JointBroken& broken : changes.jointsBroken) dropNote(context, broken.joint);
}

}  // namespace rubble
