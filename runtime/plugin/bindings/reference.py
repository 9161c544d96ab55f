"""Writes the reference of rubble.h: a page for each group of functions, with the structs and constants they use."""

import re


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


def page(section, functions, description):
    """The page of one section."""
    lines = ["<!-- Generated from rubble.h by runtime/plugin/bindings/generate.py: change that, not this. -->", "",
             f"# {title(section)}", ""]
    for function in functions:
        lines += [f"## {function['name']}", "", "```c", prototype(function), "```", "",
                  f"{linked(function['doc'])} *({function['thread']} thread)*" if function["thread"] != "any" else
                  f"{linked(function['doc'])} *(any thread)*", ""]
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


def pages(description):
    """{file name: text} of the whole reference."""
    sections = {}
    for function in description["functions"]:
        sections.setdefault(function["section"] or "start", []).append(function)
    files = {f"{slug(section)}.md": page(section, functions, description) for section, functions in sections.items()}
    lines = ["<!-- Generated from rubble.h by runtime/plugin/bindings/generate.py: change that, not this. -->", "",
             "# Reference of rubble.h", "",
             "The rules that hold for every function stand at the head of",
             "[rubble.h](../../runtime/plugin/include/rubble/rubble.h).",
             "[rubble.json](rubble.json) is the same as data, for bindings to other languages;",
             "[rubble.hpp](../../runtime/plugin/include/rubble/rubble.hpp) is the interface as C++ classes.", ""]
    for section, functions in sections.items():
        names = ", ".join(f"[{f['name']}]({slug(section)}.md#{f['name']})" for f in functions)
        lines.append(f"* [{title(section)}]({slug(section)}.md): {names}")
    handles = ["", "## Handles", "", "| handle | names |", "| --- | --- |"]
    handles += [f"| `{h['name']}` | {linked(h['doc'])} |" for h in description["handles"]
                if h["name"] != "rubble_result"]
    lines += handles + ["", "## Results", ""] + group_table(0, description)
    files["README.md"] = "\n".join(lines).rstrip("\n") + "\n"
    return files
