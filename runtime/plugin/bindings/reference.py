"""Writes the reference of rubble.h: a page for each group of functions, with an example of each function, and with the
structs and constants they use."""

import re

from examples import place_of

GENERATED = "<!-- Generated from rubble.h and samples/reference by runtime/plugin/bindings/generate.py: change those. -->"
# The table's order never changes; a reader wants pages in the order of use. Those that are not here come last.
READING_ORDER = {
    "Begin": ["start", "worlds", "loading-in-the-background", "bounds", "settings"],
    "Make and change": ["making-things", "edits-of-bodies-and-voxels", "edits-and-reads-of-whole-shapes",
                        "properties-of-bodies-and-shapes", "palettes", "materials"],
    "Break and burn": ["commands-for-the-next-step", "fire", "fires-at-a-place"],
    "Move": ["joints-wheels-and-grabbing", "collision-layers-water-triggers-and-characters", "collision-shapes"],
    "Look and hear": ["state", "queries-of-the-world-as-the-last-step-left-it", "reports-for-sound-and-score",
                      "lists-of-objects", "names-tags-and-values-of-objects"],
    "Light and draw": ["renderer", "environment-and-lights", "a-model-of-the-sky", "light-groups",
                       "meshes-and-data-of-bricks", "ropes", "particles"],
    "Save, replay, follow": ["undo", "saved-games-and-recordings", "files-in-memory",
                             "handles-of-saved-games-rows-of-later-versions", "deltas"],
    "With other physics": ["layers-and-worlds-that-the-host-s-physics-moves"],
    "More": [],
}


def slug(section):
    """The name of a section's page."""
    short = section.split(";")[0].removeprefix("edits: ")
    return re.sub(r"[^a-z]+", "-", short.split(":")[0].lower()).strip("-")


def title(section):
    """The heading of a section."""
    return section.split(";")[0][0].upper() + section.split(";")[0][1:]


def linked(text):
    """Text with names of code in code font."""
    names = r"(?<![\w`])((?:RUBBLE_[A-Z_]+\w|rubble_\w+)(?:\.\.\.)?|\w+\(\))(?!\w|`)"
    return re.sub(names, r"`\1`", text).replace("|", "\\|")


def prototype(function):
    """A function as C calls it through the table."""
    arguments = ", ".join(f"{a['type']} {a['name']}" + (f"[{a['array']}]" if a["array"] else "")
                          for a in function["arguments"])
    owner = "" if function["name"] == "rubble_get_api" else "api->"
    return f"{function['result']} {owner}{function['name']}({arguments or 'void'});"


def used_structs(functions, structs):
    """The structs that functions take or give, with those inside them, in the order of the header."""
    wanted = {re.sub(r"const |\*", "", a["type"]).strip() for f in functions for a in f["arguments"]}
    grown = True
    while grown:
        inner = {re.sub(r"const |\*", "", field["type"]).strip() for struct in structs if struct["name"] in wanted
                 for field in struct["fields"]}
        grown = not inner <= wanted
        wanted |= inner
    return [struct for struct in structs if struct["name"] in wanted]


def constants_of(structs, description):
    """The groups of constants whose names the comments of structs begin with, as RUBBLE_BRUSH_..."""
    text = " ".join(field["doc"] for struct in structs for field in struct["fields"])
    prefixes = set(re.findall(r"(RUBBLE_[A-Z]+_)(?:\.\.\.|[A-Z_]+)", text))
    groups = {c["group"] for c in description["constants"] if any(c["name"].startswith(p) for p in prefixes)}
    return sorted(groups)


def struct_table(struct):
    """A struct as a table of its fields."""
    lines = [f"### {struct['name']}", "", linked(struct["doc"]), ""] if struct["doc"] else [f"### {struct['name']}", ""]
    lines += ["| field | type | meaning |", "| --- | --- | --- |"]
    for field in struct["fields"]:
        rows = f"[{field['array']}]" if field["array"] else ""
        meaning = {"struct_size": f"sizeof({struct['name']})", "reserved": "0"}.get(field["name"], linked(field["doc"]))
        kind = field["type"].replace("|", "\\|")
        lines.append(f"| `{field['name']}{rows}` | `{kind}` | {meaning} |")
    return lines + [""]


def group_table(number, description):
    """A group of constants as a table."""
    doc = description["groups"][number]["doc"]
    lines = [linked(doc), ""] if doc else []
    lines += ["| constant | value | meaning |", "| --- | --- | --- |"]
    for constant in description["constants"]:
        if constant["group"] == number:
            lines.append(f"| `{constant['name']}` | {constant['value']} | {linked(constant['doc'])} |")
    return lines + [""]


def example_of(function, pages_of, examples):
    """The example of a function, or a link to that which shows it. pages_of: {function: its page}."""
    section = [name for name, page_name in pages_of.items() if page_name == pages_of[function]]
    place = place_of(function, examples, section)
    if place == function:
        return ["```c", *examples[function].rstrip("\n").split("\n"), "```", ""]
    file = "" if pages_of[place] == pages_of[function] else pages_of[place]
    return [f"Example: at [{place}]({file}#{place}).", ""]


def page(section, functions, description, pages_of, examples):
    """The page of one section."""
    lines = [GENERATED, "", f"# {title(section)}", "",
             "The [first page](README.md) says what `world`, `wall`, `crate` and `OK` of the examples are.", ""]
    for function in functions:
        lines += [f"## {function['name']}", "", "```c", prototype(function), "```", "",
                  f"{linked(function['doc'])} *({function['thread']} thread)*", ""]
        lines += example_of(function["name"], pages_of, examples)
    structs = [s for s in used_structs(functions, description["structs"]) if s["name"] != "rubble_api"]
    if structs:
        lines += ["## Structs", ""]
        for struct in structs:
            lines += struct_table(struct)
    groups = constants_of(structs, description)
    if groups:
        lines += ["## Constants", ""]
        for number in groups:
            lines += group_table(number, description)
    return "\n".join(lines).rstrip("\n") + "\n"


def contents(sections, description):
    """The first page: what the others hold, handles and results."""
    lines = [GENERATED, "", "# Reference of rubble.h", "",
             "The rules that hold for every function stand at the head of `rubble/rubble.h`. [rubble.json](rubble.json) is the",
             "same as data, for bindings to other languages; `rubble/rubble.hpp` is the interface as C++ classes.", "",
             "The examples are from [samples/reference](../../samples/reference); tests compile and run them all. Each begins",
             "with the world of [example.h](../../samples/reference/example.h): a floor, a `wall` of brick, a wooden `crate`",
             "before it. `OK(call)` ends the program, with the last error, if a call is refused, and `require(what, why)` if",
             "something does not hold; these, `steps()`, `make_body()`, `make_box()`, `state_of()` and `voxels_gone()` are a",
             "few lines each in [cookbook.h](../../samples/cookbook/cookbook.h).", ""]
    left = {slug(section): section for section in sections}
    for heading, names in READING_ORDER.items():
        here = [left.pop(name) for name in names] if names else list(left.values())
        lines += [f"## {heading}", ""] if here else []
        for section in here:
            file = f"{slug(section)}.md"
            functions = ", ".join(f"[{f['name']}]({file}#{f['name']})" for f in sections[section])
            lines.append(f"* [{title(section)}]({file}): {functions}")
        lines += [""] if here else []
    lines += ["## Handles", "", "| handle | names |", "| --- | --- |"]
    lines += [f"| `{h['name']}` | {linked(h['doc'])} |" for h in description["handles"]
              if h["name"] != "rubble_result"]
    lines += ["", "## Results", ""] + group_table(0, description)
    return "\n".join(lines).rstrip("\n") + "\n"


def pages(description, examples):
    """{file name: text} of the whole reference. examples: {function: code}, some for several functions."""
    sections = {}
    for function in description["functions"]:
        sections.setdefault(function["section"] or "start", []).append(function)
    pages_of = {f["name"]: f"{slug(section)}.md" for section, functions in sections.items() for f in functions}
    files = {f"{slug(section)}.md": page(section, functions, description, pages_of, examples)
             for section, functions in sections.items()}
    files["README.md"] = contents(sections, description)
    return files
