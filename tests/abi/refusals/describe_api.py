"""Writes C++ that describes every function of rubble.h and every struct: describe_api.py RUBBLE_H BINDINGS OUT_CPP.

BINDINGS is the folder with header.py, which reads the header. What it writes is declared in api_description.h.
"""

import sys


def quoted(text):
    """A string of C++."""
    return '"' + text.replace('"', '\\"') + '"'


def main():
    """Reads the header and writes the description."""
    sys.path.insert(0, sys.argv[2])
    import header  # pylint: disable=import-outside-toplevel

    with open(sys.argv[1], encoding="utf-8") as file:
        api = header.describe(file.read())
    lines = ['#include "tests/abi/refusals/api_description.h"', "", "#include <cstddef>", "", "namespace rubble {", "",
             "const std::vector<FunctionDescription>& describedFunctions() {",
             "    static const std::vector<FunctionDescription> functions = {"]
    for function in api["functions"]:
        if function["result"] != "rubble_result" or function["name"].startswith("rubble_"):
            continue
        arguments = ", ".join(f"{{{quoted(each['type'])}, {quoted(each['name'])}, {each['array']}}}"
                              for each in function["arguments"])
        lines.append(f"        {{{quoted(function['name'])}, {quoted(function['thread'])}, {{{arguments}}},")
        lines.append(f"         &callBySlots<&rubble_api::{function['name']}>}},")
    lines += ["    };", "    return functions;", "}", "",
              "const std::vector<StructDescription>& describedStructs() {",
              "    static const std::vector<StructDescription> structs = {"]
    for struct in api["structs"]:
        lines.append(f"        {{{quoted(struct['name'])}, sizeof({struct['name']}), {{")
        for field in struct["fields"]:
            lines.append(f"            {{{quoted(field['type'])}, {quoted(field['name'])}, "
                         f"offsetof({struct['name']}, {field['name']}), {field['array']}}},")
        lines.append("        }},")
    lines += ["    };", "    return structs;", "}", "", "}  // namespace rubble", ""]
    with open(sys.argv[3], "w", encoding="utf-8") as out:
        out.write("\n".join(lines))


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    main()
