#!/usr/bin/env python3
"""Reads the examples of the reference, samples/reference/*.c.

An example is `EXAMPLE(FUNCTION) { ... }`, together with what stands above it without an empty line between.

examples.py OUT.c   writes a C file that has all of them, and a table `examples` of their names and functions
"""

import pathlib
import re
import sys
import textwrap

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "samples/reference"
EXAMPLE = re.compile(r"((?:^[^\n]+\n)*)^EXAMPLE\((\w+)\) \{\n(.*?)^\}\n", re.M | re.S)


def read():
    """{function: code as a page shows it} of all examples."""
    found = {}
    for path in sorted(FOLDER.glob("*.c")):
        for above, function, body in EXAMPLE.findall(path.read_text(encoding="utf-8")):
            if function in found:
                sys.exit(f"{path}: expected one example of {function}, found two")
            found[function] = (above and above + "\n") + textwrap.dedent(body)
    return found


def place_of(function, examples, section):
    """The function whose example shows this one: itself, or the first that calls it, of its section if there is one.
    section: names of functions. None: no example calls it."""
    callers = [other for other, code in examples.items() if f"api->{function}(" in code]
    near = [other for other in callers if other in section]
    return function if function in examples else next(iter(near + callers), None)


def main():
    """See the head of this file."""
    lines = [f'#include "{path}"' for path in sorted(FOLDER.glob("*.c"))]
    lines += ["", "static const struct {", "    const char* function;", "    void (*run)(void);", "} examples[] = {"]
    lines += [f'    {{"{function}", example_of_{function}}},' for function in read()]
    pathlib.Path(sys.argv[1]).write_text("\n".join(lines + ["};", ""]), encoding="utf-8")


if __name__ == "__main__":
    main()
