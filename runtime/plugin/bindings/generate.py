#!/usr/bin/env python3
"""Writes what follows from rubble.h and samples/reference: rubble.hpp, docs/api/rubble.json and the pages of docs/api.

generate.py           writes them
generate.py --check   writes nothing; fails, with the command to run, if a file is not what it would write
Both fail if a function has no example.
"""

import json
import pathlib
import sys

import examples
import header
import reference
import wrapper

ROOT = pathlib.Path(__file__).resolve().parents[3]
INCLUDE = ROOT / "runtime/plugin/include/rubble"


def outputs():
    """{path: text} of all that is generated."""
    description = header.describe((INCLUDE / "rubble.h").read_text(encoding="utf-8"))
    shown = examples.read()
    names = [function["name"] for function in description["functions"]]
    missing = [name for name in names if not examples.place_of(name, shown, [])]
    if missing or set(shown) - set(names):
        sys.exit("samples/reference: expected an example of each function and of nothing else; "
                 f"missing {missing}, too many {sorted(set(shown) - set(names))}")
    files = {INCLUDE / "rubble.hpp": wrapper.wrapper(description),
             ROOT / "docs/api/rubble.json": json.dumps(description, indent=1) + "\n"}
    for name, text in reference.pages(description, shown).items():
        files[ROOT / "docs/api" / name] = text
    return files


def main():
    """See the head of this file."""
    files = outputs()
    if "--check" not in sys.argv:
        for path, text in files.items():
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return 0
    present = set((ROOT / "docs/api").glob("*")) | {INCLUDE / "rubble.hpp"}
    wrong = [path for path, text in files.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
    wrong += sorted(present - set(files))
    for path in wrong:
        print(f"{path.relative_to(ROOT)} does not follow from rubble.h and samples/reference: run runtime/plugin/bindings/generate.py")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
