"""Writes a C program that prints the layout of every struct of a rubble.h: layout.py RUBBLE_H OUT_C.

A line of the program's output is "STRUCT SIZE" or "STRUCT.FIELD OFFSET SIZE"; the function table is a struct like the
others. The rows of an array are in the size of its field.
"""

import re
import sys


def structs(text):
    """Yields (name, [field, ...]) for each `typedef struct NAME { ... } NAME;`."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    for match in re.finditer(r"typedef struct (\w+) \{(.*?)\n\} \1;", text, flags=re.S):
        fields = []
        for declaration in match.group(2).split(";"):
            pointer = re.search(r"\(\*(\w+)\)", declaration)
            if pointer:
                fields.append(pointer.group(1))
                continue
            declarators = re.sub(r"\[[^]]*\]", "", declaration).split(",")
            fields += [re.search(r"(\w+)\s*$", declarator).group(1) for declarator in declarators if declarator.strip()]
        yield match.group(1), fields


def main():
    """Reads the header and writes the program."""
    with open(sys.argv[1], encoding="utf-8") as header:
        found = list(structs(header.read()))
    lines = ["#include <rubble/rubble.h>", "#include <stdio.h>", "int main(void) {"]
    for name, fields in found:
        lines.append(f'    printf("{name} %u\\n", (unsigned)sizeof({name}));')
        for field in fields:
            lines.append(f'    printf("{name}.{field} %u %u\\n", (unsigned)offsetof({name}, {field}), '
                         f"(unsigned)sizeof((({name}*)0)->{field}));")
    lines += ["    return 0;", "}", ""]
    with open(sys.argv[2], "w", encoding="utf-8") as out:
        out.write("\n".join(lines))


if __name__ == "__main__":
    main()
