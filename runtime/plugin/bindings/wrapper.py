"""Writes rubble.hpp: rubble.h as C++ classes, one method a function, generated so that none is missing."""

import re
import textwrap

HEAD = '''/* Generated from rubble.h by runtime/plugin/bindings/generate.py: change that, not this.
 *
 * rubble.h for C++17: worlds and renderers that destroy themselves, values that are returned, errors that are thrown.
 * Names, units, threads and meanings are those of rubble.h. struct_size is set here.
 *
 *     rubble::World world;
 *     world.load_level("model.vox");
 *     rubble_explosion explosion{};
 *     explosion.position[1] = 1.0;
 *     world.explode(explosion);
 *     world.step();
 *     for (const rubble_body_state& body : world.get_body_states()) draw(body.position, body.rotation); */
#ifndef RUBBLE_RUBBLE_HPP
#define RUBBLE_RUBBLE_HPP
#include <rubble/rubble.h>

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace rubble {
inline namespace wrapper {  // apart from the library's own classes, for programs that link its parts too

/** What a call that failed throws: what() is get_last_error(). */
class Error : public std::runtime_error {
public:
    Error(rubble_result result, const char* text) : std::runtime_error(text), m_result(result) {}
    rubble_result result() const noexcept { return m_result; }

private:
    rubble_result m_result;
};

/** The table of the library that is linked. Throws Error if that is of another version than rubble.h. */
inline const rubble_api& api() {
    static const rubble_api* const table = [] {
        const rubble_api* found = nullptr;
        if (const rubble_result result = rubble_get_api(RUBBLE_VERSION, &found); result != RUBBLE_OK)
            throw Error(result, "librubble is of another version than rubble.h");
        return found;
    }();
    return *table;
}

/** Throws Error unless `result` is RUBBLE_OK. */
inline void check(rubble_result result) {
    if (result != RUBBLE_OK) throw Error(result, api().get_last_error());
}

/** The rows of a list. read: a call with (rows, capacity, count), as lists of rubble.h take them. */
template <class Row, class Count, class Read>
std::vector<Row> rows(Read&& read) {
    Count count = 0;
    check(read(nullptr, Count(0), &count));
    std::vector<Row> all(count);
    if (count > 0) check(read(all.data(), count, &count));
    all.resize(count);
    return all;
}

/** rubble.h's set_host(): call it before the first world is made. */
inline void set_host(rubble_host host) {
    host.struct_size = sizeof host;
    check(api().set_host(&host));
}

/** rubble.h's apply_sky_model(). */
inline rubble_environment apply_sky_model(rubble_environment environment, const double (&sun_direction)[3]) {
    environment.struct_size = sizeof environment;
    check(api().apply_sky_model(&environment, sun_direction));
    return environment;
}

/** rubble.h's get_layers(). */
inline uint32_t get_layers() {
    uint32_t layers = 0;
    check(api().get_layers(&layers));
    return layers;
}

/** rubble.h's measure_text(): width and height in `out`. */
inline void measure_text(rubble_overlay_item item, double (&out)[2]) {
    item.struct_size = sizeof item;
    check(api().measure_text(&item, out));
}
'''

CLASS = '''
/** {doc} Moves, but is not copied. */
class {name} {{
public:
    explicit {name}({made_of}) {{
{settings}        check(api().create_{handle}({made_with}&m_handle));
    }}
    ~{name}() {{ release(); }}
    {name}({name}&& other) noexcept : m_handle(std::exchange(other.m_handle, 0)) {{}}
    {name}& operator=({name}&& other) noexcept {{
        if (this != &other) release(), m_handle = std::exchange(other.m_handle, 0);
        return *this;
    }}
    /** Its handle, for calls of rubble.h. */
    rubble_{handle} handle() const noexcept {{ return m_handle; }}

{methods}private:
    void release() noexcept {{
        if (m_handle) api().destroy_{handle}(std::exchange(m_handle, 0));
    }}
    rubble_{handle} m_handle = 0;
}};
'''

READS = ("get_", "cast_", "find_", "overlap_", "read_", "translate_")
BY_HAND = {"destroy_world", "create_renderer", "destroy_renderer"}
ARRAYS = {"entries", "bricks"}  # arguments of several rows, whose number stands elsewhere
OPTIONAL = {"vdb_tool"}  # arguments that may be null, where a name alone tells


def wrapped(text, indent, more="    "):
    """Text in lines of at most 120 columns."""
    return textwrap.fill(text, 120, initial_indent=indent, subsequent_indent=indent + more, break_long_words=False,
                         break_on_hyphens=False)


def pointee(kind):
    """The type that a pointer points to, without const."""
    return re.sub(r"^const |\*$", "", kind).strip()


def row_kinds(description):
    """The constant RUBBLE_ROWS_... of each struct that read_rows() lists and no other function lists under events."""
    kinds = {}
    for constant in description["constants"]:
        row = re.match(r"rubble_\w+", constant["doc"])
        if constant["name"].startswith("RUBBLE_ROWS_") and row:
            kinds[row.group(0)] = constant["name"]
    return kinds


def list_method(function, given, row, count, passed, kinds):
    """The body of a method that returns a list: with rows of this header's size where read_rows() has them."""
    if row in kinds and function["name"].startswith("get_"):
        lines = ["rubble_row_list list{};", f"list.kind = {kinds[row]};"]
        lines += [f"list.{argument['name']} = {argument['name']};" for argument in given]
        return "\n".join(lines + [f"return read_rows<{row}>(list);"])
    inner = ", ".join(passed + ["out", "capacity", "count"])
    return (f"return rows<{row}, {count}>([&]({row}* out, {count} capacity, {count}* count) {{\n"
            f"    return api().{function['name']}({inner});\n}});")


def method(function, sized, kinds):
    """A function of the table as a method. sized: structs with a struct_size; kinds: see row_kinds()."""
    arguments = function["arguments"][1:]
    names = [argument["name"] for argument in arguments]
    taken, passed, before = [], ["m_handle"], []
    result, after = "void", None
    is_list = names[-3:] == ["out", "capacity", "count"]
    fills = arguments[-1]["type"] if arguments else ""
    is_read = not is_list and fills.endswith("*") and not fills.startswith("const")
    given = arguments[:-3] if is_list else arguments[:-1] if is_read else arguments
    # an array in, and perhaps one row out for each of its rows
    counted = not is_list and any(argument["name"] == "count" for argument in given)
    sized_rows = [first["name"] for first, second in zip(given, given[1:])
                  if second["name"] == "count" and pointee(first["type"]) in sized]
    for argument in given:
        kind, name = argument["type"], argument["name"]
        passed.append(name)
        if name in sized_rows:
            taken.append((False, f"std::vector<{pointee(kind)}> {name}"))
            before.append(f"for ({pointee(kind)}& row : {name}) row.struct_size = sizeof row;")
            passed[-1:] = [f"{name}.data()", f"uint32_t({name}.size())"]
        elif sized_rows and name == "count":
            passed.pop()
        elif argument["array"]:
            taken.append((False, f"{kind} (&{name})[{argument['array']}]"))
        elif kind == "const rubble_query_filter*":
            taken.append((True, "rubble_query_filter filter = {}"))
            before += ["filter.struct_size = sizeof filter;", "filter.hit_size = sizeof(rubble_hit);"]
            if "casts" in names or "rays" in names:
                before.append(f"filter.query_size = sizeof({pointee(arguments[0]['type'])});")
            passed[-1] = "&filter"
        elif kind.startswith("const rubble_") and not counted and name not in ARRAYS:
            if pointee(kind) in sized:
                taken.append((False, f"{pointee(kind)} {name}"))
                before.append(f"{name}.struct_size = sizeof {name};")
                if pointee(kind) == "rubble_palette_range":
                    before.append(f"{name}.entry_size = sizeof(rubble_palette_entry);")
            else:
                taken.append((False, f"const {pointee(kind)}& {name}"))
            passed[-1] = f"&{name}"
        else:
            taken.append((name in OPTIONAL, f"{kind} {name}" + (" = nullptr" if name in OPTIONAL else "")))
    row = pointee(arguments[-3]["type"]) if is_list else pointee(fills) if is_read else ""
    if is_list:
        count = arguments[-2]["type"]
        result = f"std::vector<{row}>"
        after = list_method(function, given, row, count, passed, kinds)
    elif is_read and (counted or row == "rubble_palette_entry"):
        result = f"std::vector<{row}>"
        before.append(f"std::vector<{row}> out({'count' if counted else 'range.count < 256 ? range.count : 255'});")
        after = f"check(api().{function['name']}({', '.join(passed + ['out.data()'])}));\nreturn out;"
    elif is_read:
        result = row
        before.append(f"{row} out{{}};")
        if row in sized:
            before.append("out.struct_size = sizeof out;")
        after = f"check(api().{function['name']}({', '.join(passed + ['&out'])}));\nreturn out;"
    else:
        after = f"check(api().{function['name']}({', '.join(passed)}));"
    constant = " const" if function["name"].startswith(READS) else ""
    lines = [line for part in before + [after] for line in part.split("\n")]
    head = f"{result} {function['name']}({', '.join(text for _, text in taken)}){constant} {{"
    body = "\n".join(wrapped(line.strip(), "            " if line.startswith(" ") else "        ") for line in lines)
    return f"{wrapped(head, '    ')}\n{body}\n    }}\n"


READ_ROWS = '''    template <class Row>
    std::vector<Row> read_rows(rubble_row_list list) const {
        list.struct_size = sizeof list;
        list.row_size = sizeof(Row);
        return rows<Row, uint32_t>([&](void* out, uint32_t capacity, uint32_t* count) {
            return api().read_rows(m_handle, &list, out, capacity, count);
        });
    }
'''


def wrapper(description):
    """The text of rubble.hpp."""
    sized = {struct["name"] for struct in description["structs"]
             if struct["fields"] and struct["fields"][0]["name"] == "struct_size"}
    kinds = row_kinds(description)
    methods = {"rubble_world": "", "rubble_renderer": ""}
    for function in description["functions"]:
        owner = function["arguments"][0]["type"] if function["arguments"] else ""
        if owner not in methods or function["name"] in BY_HAND:
            continue
        text = READ_ROWS if function["name"] == "read_rows" else method(function, sized, kinds)
        methods[owner] += wrapped(f"/** {function['doc']} */", "    ", " * ") + f"\n{text}"
    set_size = "        settings.struct_size = sizeof settings;\n"
    world = CLASS.format(name="World", handle="world", doc="A world, destroyed at the end of its life.",
                         made_of="rubble_world_settings settings = {}", made_with="&settings, ", settings=set_size,
                         methods=methods["rubble_world"])
    renderer = CLASS.format(name="Renderer", handle="renderer",
                            doc="The renderer of a world; its GL context is current wherever it is used and destroyed.",
                            made_of="const World& world, rubble_renderer_settings settings = {}",
                            made_with="world.handle(), &settings, ", settings=set_size,
                            methods=methods["rubble_renderer"])
    tail = "\n}  // namespace wrapper\n}  // namespace rubble\n\n#endif\n"
    return HEAD + world + renderer + tail
