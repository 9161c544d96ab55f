#include "runtime/plugin/c_abi/objects.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "runtime/plugin/c_abi/functions.h"
#include "runtime/world/objects/object_errors.h"
#include "runtime/world/queries/notes.h"

namespace rubble::abi {
namespace {

/// A function about one object: body(HostedWorld&, AnyObject).
template <class F>
rubble_result withObject(const char* function, rubble_world world, uint64_t bits, F&& body,
                         Found which = Found::Present) {
    return inWorld(function, world, [&](HostedWorld& hosted) {
        if (const auto object = readObject(hosted.loop.world(), bits, "object", which)) body(hosted, *object);
    });
}
/// An edit of one object, which may be one that the next step makes.
template <class F>
rubble_result editObject(const char* function, rubble_world world, uint64_t bits, F&& body) {
    return withObject(function, world, bits, body, Found::Reserved);
}

/// A text of the host, once `error` has found nothing wrong with it.
template <class Check>
std::string readChecked(const char* given, const char* name, Check&& error) {
    if (!isGiven(given, name)) return {};
    requireNoError(error(std::string_view(given)));
    return isRefused() ? std::string() : given;
}
std::string readName(const char* given, const char* name) {
    return readChecked(given, name, [&](std::string_view text) { return nameError(name, text); });
}
std::string readTag(const char* given) {
    return readChecked(given, "tag", tagError);
}

/// Bytes for the host: all or none.
void writeText(std::string_view text, char* out, uint32_t capacity, uint32_t* count) {
    if (!isGiven(count, "count")) return;
    *count = 0;
    if (capacity && !isGiven(out, "out")) return;
    writeBytes(text.data(), uint32_t(text.size()), out, capacity, count);
}

rubble_result setName(rubble_world world, uint64_t object, const char* name) {
    return editObject("set_name", world, object, [&](HostedWorld& hosted, const AnyObject& named) {
        push(hosted, SetNameEdit{named, readName(name, "name")});
    });
}

rubble_result getName(rubble_world world, uint64_t object, char* out, uint32_t capacity, uint32_t* count) {
    return withObject("get_name", world, object, [&](HostedWorld& hosted, const AnyObject& named) {
        const std::string& name = nameOf(hosted.loop.world(), named);
        writeText({name.c_str(), name.size() + 1}, out, capacity, count);
    });
}

rubble_result setTag(rubble_world world, uint64_t object, const char* tag, const char* value) {
    return editObject("set_tag", world, object, [&](HostedWorld& hosted, const AnyObject& tagged) {
        push(hosted, SetTagEdit{tagged, readTag(tag), value ? readName(value, "value") : ""});
    });
}

rubble_result removeTag(rubble_world world, uint64_t object, const char* tag) {
    return editObject("remove_tag", world, object, [&](HostedWorld& hosted, const AnyObject& tagged) {
        push(hosted, RemoveTagEdit{tagged, readTag(tag)});
    });
}

rubble_result getTag(rubble_world world, uint64_t object, const char* tag, char* out, uint32_t capacity,
                     uint32_t* count) {
    return withObject("get_tag", world, object, [&](HostedWorld& hosted, const AnyObject& tagged) {
        const std::string wanted = readTag(tag);
        if (isRefused()) return;
        const auto& tags = tagsOf(hosted.loop.world(), tagged);
        const auto found = findTag(tags, wanted);
        if (found == tags.end()) return writeText({}, out, capacity, count);
        const std::string value(tagValue(*found));
        writeText({value.c_str(), value.size() + 1}, out, capacity, count);
    });
}

rubble_result getTags(rubble_world world, uint64_t object, char* out, uint32_t capacity, uint32_t* count) {
    return withObject("get_tags", world, object, [&](HostedWorld& hosted, const AnyObject& tagged) {
        std::string all;
        for (const std::string& tag : tagsOf(hosted.loop.world(), tagged)) all.append(tag).push_back(0);
        writeText(all, out, capacity, count);
    });
}

rubble_result setUserValue(rubble_world world, uint64_t object, uint64_t value) {
    return editObject("set_user_value", world, object, [&](HostedWorld& hosted, const AnyObject& of) {
        push(hosted, SetUserValueEdit{of, value});
    });
}

rubble_result getUserValue(rubble_world world, uint64_t object, uint64_t* out) {
    return withObject("get_user_value", world, object, [&](HostedWorld& hosted, const AnyObject& of) {
        const Note* note = hosted.loop.world().data().findNote(bitsOf(of));
        if (isGiven(out, "out")) *out = note ? note->userValue : 0;
    });
}

/// Lists those objects of a kind that wants(WorldData, handle) wants, unless check() refuses the call.
template <class Check, class F>
rubble_result listObjects(const char* function, rubble_world world, uint32_t kind, uint64_t* out, uint32_t capacity,
                          uint32_t* count, Check&& check, F&& wants) {
    return listRows<uint64_t>(function, world, out, capacity, count, [&](const HostedWorld& hosted, auto& rows) {
        const WorldData& inside = hosted.loop.world();
        uint32_t number = 0;
        readEnum(kind, RUBBLE_KIND_JOINT, "kind");
        check();
        if (isRefused()) return;
        const auto list = [&](const auto& map) {
            if (number++ == kind)
                map.forEach([&](auto handle, const auto&) {
                    if (wants(inside, handle)) rows.add([&] { return handle.bits; });
                });
        };
        list(inside.bodies), list(inside.shapes), list(inside.lights), list(inside.groups), list(inside.waters);
        list(inside.triggers), list(inside.characters), list(inside.joints);
    });
}

rubble_result getObjects(rubble_world world, uint32_t kind, uint64_t* out, uint32_t capacity, uint32_t* count) {
    return listObjects(
        "get_objects", world, kind, out, capacity, count, [] {}, [](const WorldData&, auto) { return true; });
}

rubble_result findByName(rubble_world world, uint32_t kind, const char* name, uint64_t* out, uint32_t capacity,
                         uint32_t* count) {
    return listObjects(
        "find_by_name", world, kind, out, capacity, count, [&] { isGiven(name, "name"); },
        [&](const WorldData& inside, auto handle) { return nameOf(inside, handle) == name; });
}

rubble_result findByTag(rubble_world world, uint32_t kind, const char* tag, const char* value, uint64_t* out,
                        uint32_t capacity, uint32_t* count) {
    return listObjects(
        "find_by_tag", world, kind, out, capacity, count, [&] { isGiven(tag, "tag"); },
        [&](const WorldData& inside, auto handle) {
            const auto& tags = tagsOf(inside, handle);
            const auto found = findTag(tags, tag);
            return found != tags.end() && (!value || tagValue(*found) == value);
        });
}

/// The shapes whose joints and lights belong to a body or shape; none if it is neither.
std::vector<ShapeHandle> shapesOf(const WorldData& world, const AnyObject& owner) {
    if (const auto* body = std::get_if<BodyHandle>(&owner)) return world.bodies.at(*body).shapes;
    const auto* shape = std::get_if<ShapeHandle>(&owner);
    return shape ? std::vector{*shape} : std::vector<ShapeHandle>{};
}

rubble_result getObjectsOf(rubble_world world, uint64_t ownerBits, uint32_t kind, uint64_t* out, uint32_t capacity,
                           uint32_t* count) {
    return listRows<uint64_t>(
        "get_objects_of", world, out, capacity, count, [&](const HostedWorld& hosted, auto& rows) {
            const auto owner = readObject(hosted.loop.world(), ownerBits, "owner");
            readEnum(kind, RUBBLE_KIND_JOINT, "kind");
            if (isRefused()) return;
            const WorldData& inside = hosted.loop.world();
            const std::vector<ShapeHandle> shapes = shapesOf(inside, *owner);
            std::set<uint64_t> found;
            if (kind == RUBBLE_KIND_SHAPE && owner->index() == RUBBLE_KIND_BODY)
                for (const ShapeHandle shape : shapes) found.insert(shape.bits);
            else if (kind == RUBBLE_KIND_JOINT && owner->index() <= RUBBLE_KIND_SHAPE)
                for (const ShapeHandle shape : shapes)
                    for (const JointHandle joint : inside.jointIndex.of(shape)) found.insert(joint.bits);
            else if (kind == RUBBLE_KIND_LIGHT && owner->index() <= RUBBLE_KIND_LIGHT_GROUP &&
                     owner->index() != RUBBLE_KIND_LIGHT)
                inside.lights.forEach([&](LightHandle light, const Light& each) {
                    if (each.group.bits == ownerBits ||
                        std::find(shapes.begin(), shapes.end(), each.shape) != shapes.end())
                        found.insert(light.bits);
                });
            else
                return refuse(RUBBLE_ERROR_ARGUMENT, "kind is {}, expected one that an owner of kind {} has", kind,
                              owner->index());
            for (const uint64_t each : found) rows.add([&] { return each; });
        });
}

rubble_result getOrigin(rubble_world world, rubble_shape shape, rubble_shape* parent, rubble_shape* root) {
    return inWorld("get_origin", world, [&](const HostedWorld& hosted) {
        const World& inside = hosted.loop.world();
        readLiveHandle<HandleType::Shape>(inside.shapes(), shape, "shape");
        if (isRefused() || !isGiven(parent, "parent") || !isGiven(root, "root")) return;
        const Note* note = inside.data().findNote(shape);
        *parent = note ? note->parent.bits : 0;
        *root = note ? note->root.bits : 0;
    });
}

rubble_result getPieces(rubble_world world, rubble_shape shape, rubble_shape* out, uint32_t capacity, uint32_t* count) {
    return listRows<uint64_t>("get_pieces", world, out, capacity, count, [&](const HostedWorld& hosted, auto& rows) {
        const auto from = readHandle<HandleType::Shape>(shape, "shape");
        if (!from) refuse(RUBBLE_ERROR_STALE, "shape is 0");
        if (from && withWorld(shape, hosted.loop.world().id()) != shape)
            refuse(RUBBLE_ERROR_STALE, "shape is of another world");
        if (isRefused()) return;
        std::set<uint64_t> found;
        hosted.loop.world().data().notes.forEach([&](NoteHandle, const Note& note) {
            if (note.parent == from || note.root == from) found.insert(bitsOf(note.object));
        });
        for (const uint64_t each : found) rows.add([&] { return each; });
    });
}

}  // namespace

std::optional<AnyObject> findObject(const World& world, uint64_t bits, Found which) {
    const auto named = [&](auto handle) -> std::optional<AnyObject> {
        const auto& map = mapOf<decltype(handle)>(world.data());
        if (!map.find(handle) && (which == Found::Present || !map.isReserved(handle))) return {};
        return handle;
    };
    switch (Handle<HandleType::None>{bits}.type()) {
        case HandleType::Body:
            return named(BodyHandle{bits});
        case HandleType::Shape:
            return named(ShapeHandle{bits});
        case HandleType::Light:
            return named(LightHandle{bits});
        case HandleType::LightGroup:
            return named(LightGroupHandle{bits});
        case HandleType::Water:
            return named(WaterHandle{bits});
        case HandleType::Trigger:
            return named(TriggerHandle{bits});
        case HandleType::Character:
            return named(CharacterHandle{bits});
        case HandleType::Joint:
            return named(JointHandle{bits});
        default:
            return {};
    }
}

std::optional<AnyObject> readObject(const World& world, uint64_t bits, const char* name, Found which) {
    const std::optional<AnyObject> object = findObject(world, bits, which);
    if (!object)
        refuse(RUBBLE_ERROR_STALE, "{}{}", name, bits ? " is stale, or of no object that has a name" : " is 0");
    return object;
}

void setObjectFunctions(rubble_api& api) {
    api.set_name = setName;
    api.get_name = getName;
    api.set_tag = setTag;
    api.remove_tag = removeTag;
    api.get_tag = getTag;
    api.get_tags = getTags;
    api.set_user_value = setUserValue;
    api.get_user_value = getUserValue;
    api.get_objects = getObjects;
    api.get_objects_of = getObjectsOf;
    api.find_by_name = findByName;
    api.find_by_tag = findByTag;
    api.get_origin = getOrigin;
    api.get_pieces = getPieces;
}

}  // namespace rubble::abi
