"""Reads rubble.h into plain data, for what is generated from it.

describe(text) returns a dict, in the order of the header:
  "version": int
  "handles": [{name, type, doc}]
  "constants": [{name, value, doc, group}]       group: the number of their enum; its doc is in "groups"
  "defines": [{name, value, doc, section}]
  "groups": [{doc, section}]
  "structs": [{name, doc, section, fields: [{name, type, array, doc}]}]
  "functions": [{name, doc, section, thread, result, arguments: [{name, type, array}]}]
A type is as C writes it, without the name; array is the number of rows of a field, or 0. thread: "main", "render" or
"any". A member of the table is in "functions", a pointer to a host's function in a struct is a field.
"""

import re

COMMENT = re.compile(r"/\*(.*?)\*/", re.S)
NAMED = {"UINT64_MAX": 2**64 - 1}
SECTION = re.compile(r"/\* ---- (.*?) ---- \*/")


def plain(comment):
    """The text of a comment in one paragraph."""
    text = re.sub(r"\n\s*\*? ?", " ", comment.strip())
    return re.sub(r"\s+", " ", text).strip()


def tokens(text, separator):
    """Yields ("comment", text, line) and ("code", text, line), a code token up to and with its separator."""
    position = 0
    while position < len(text):
        comment = COMMENT.match(text, position)
        line = text.count("\n", 0, position)
        if comment:
            yield "comment", comment.group(1), line
            position = comment.end()
            continue
        end, depth = position, 0
        while end < len(text) and not text.startswith("/*", end):
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
            if text[end - 1] == separator and depth == 0:
                break
        if text[position:end].strip():
            yield "code", text[position:end].strip(), text.count("\n", 0, end)
        position = end


def members(body, separator=";"):
    """Returns (code, doc, section) for each member of a struct or enum: a comment stands above it, or behind it on its
    last line."""
    found, above, section = [], "", ""
    for kind, text, line in tokens(body, separator):
        if kind == "code":
            found.append([text, above, section, line])
            above = ""
        elif re.match(r" ---- .* ---- $", text):
            section, above = text.strip(" -"), ""
        elif found and found[-1][3] == line and not above:
            found[-1][1] = (found[-1][1] + " " + plain(text)).strip()
        else:
            above = plain(text)
    return [(code.rstrip(",;").strip(), doc, section) for code, doc, section, _ in found]


def declarators(code):
    """Yields (type, name, array) of a declaration such as `double low[3], high[3]`."""
    first, *others = code.split(",")
    kind, name, array = re.match(r"(.*?[\s*])(\w+)\s*(?:\[(\w+)\])?$", first.strip(), re.S).groups()
    kind = re.sub(r"\s+", " ", kind).strip()
    yield kind, name, int(array or 0)
    for other in others:
        name, array = re.match(r"\s*(\w+)\s*(?:\[(\w+)\])?$", other).groups()
        yield kind, name, int(array or 0)


def struct_of(name, doc, section, body):
    """A struct with its fields."""
    fields = []
    for code, field_doc, _ in members(body):
        pointer = re.match(r"(.*?)\(\*(\w+)\)\((.*)\)$", code, re.S)
        if pointer:
            kind = re.sub(r"\s+", " ", f"{pointer.group(1)}(*)({pointer.group(3)})")
            fields.append({"name": pointer.group(2), "type": kind, "array": 0, "doc": field_doc})
            continue
        for kind, field, array in declarators(code):
            fields.append({"name": field, "type": kind, "array": array, "doc": field_doc})
    return {"name": name, "doc": doc, "section": section, "fields": fields}


def function_of(result, name, arguments, doc, section):
    """A function of the table, or rubble_get_api()."""
    thread = re.match(r"\[(\w+)-thread\] ", doc)
    found = []
    for argument in arguments.split(","):
        if argument.strip() != "void":
            kind, argument_name, array = next(declarators(argument))
            found.append({"name": argument_name, "type": kind, "array": array})
    return {
        "name": name,
        "doc": doc[thread.end():] if thread else doc,
        "section": section,
        "thread": thread.group(1) if thread else "",
        "result": re.sub(r"\s+", " ", result).strip(),
        "arguments": found,
    }


def describe(text):
    """The whole header; see the head of this file."""
    description = {"version": int(re.search(r"#define RUBBLE_VERSION (\d+)u", text).group(1)),
                   "handles": [], "constants": [], "groups": [], "defines": [], "structs": [],
                   "functions": []}
    start = text.index("/* Handles.")
    section, doc, last = "", "", ""
    item = re.compile(r"/\*(.*?)\*/|typedef struct (\w+) \{(.*?)\n\} \2;|typedef (\w+) (\w+);|enum \{(.*?)\};|"
                      r"RUBBLE_EXPORT (\w+) (\w+)\((.*?)\);|#define (RUBBLE_\w+) (\w+)\n", re.S)
    for match in item.finditer(text, start):
        comment, struct, body, handle_type, handle, enum, result, function, arguments, macro, given = match.groups()
        title = SECTION.match(match.group(0))
        if title:
            section, doc = title.group(1), ""
        elif comment is not None:
            doc = plain(comment)
            previous = text.rfind("\n", 0, match.start())
            if text[previous:match.start()].strip():  # behind something, a handle or nothing to describe
                if last == "handle":
                    description["handles"][-1]["doc"] = doc
                doc = ""
        elif handle:
            description["handles"].append({"name": handle, "type": handle_type, "doc": doc})
            doc, last = "", "handle"
        elif enum is not None:
            last = "enum"
            value = -1
            for code, constant_doc, _ in members(enum, ","):
                name, _, given = code.partition("=")
                value = int(given) if given.strip() else value + 1
                description["constants"].append({"name": name.strip(), "value": value, "doc": constant_doc,
                                                 "group": len(description["groups"])})
            description["groups"].append({"doc": doc, "section": section})
            doc = ""
        elif macro:
            value = NAMED[given] if given in NAMED else int(given.rstrip("u"))
            description["defines"].append({"name": macro, "value": value, "doc": doc, "section": section})
            doc = ""
        elif struct == "rubble_api":
            above = ""
            for code, member_doc, member_section in members(body):
                pointer = re.match(r"(.*?)\(\*(\w+)\)\((.*)\)$", code, re.S)
                if pointer:
                    above = member_doc or above  # one comment may stand above several functions
                    description["functions"].append(function_of(*pointer.groups(), above, member_section))
        elif struct:
            description["structs"].append(struct_of(struct, doc, section, body))
            doc = ""
        else:
            description["functions"].append(function_of(result, function, arguments, doc, ""))
    return description
