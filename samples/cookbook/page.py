#!/usr/bin/env python3
"""Writes docs/cookbook/README.md, which has all recipes of this folder in it.

page.py           writes it
page.py --check   writes nothing; fails, with the command to run, if the page is not what it would write, or if a
                  recipe is longer than 40 lines, in no chapter or without an image
"""

import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
PAGE = FOLDER.parents[1] / "docs/cookbook/README.md"
LONGEST = 40  # lines of a recipe
CHAPTERS = {
    "Break": ["bullet_hole", "bomb", "bridge_collapse", "glass_pane", "wrecking_ball", "fire"],
    "Machines": ["door", "elevator", "car", "pressure_plate", "breakable_light"],
    "Players and water": ["pick_up", "walk", "raft", "score"],
    "Build and edit": ["build", "undo"],
    "Games": ["save", "replay"],
    "Engines": ["own_physics"],
}
HEAD = """# Cookbook

{count} recipes, each a whole program of at most {longest} lines in C99, from [samples/cookbook](../../samples/cookbook). Tests
compile and run them all. In Rubble's sources, `cmake --build build/release --target cookbook` builds them as
`build/release/bin/cookbook_NAME`; beside an installed library, `find_package(rubble)` and a target for each do. This
page is written by `samples/cookbook/page.py`; the images show the recipes themselves, drawn by Rubble's renderer with
colours for the materials: `cmake --build build/release --target cookbook_images`.

All of them include [cookbook.h](../../samples/cookbook/cookbook.h): the function table, a world with a floor, bodies of
boxes.

```c
{shared}```
"""


def recipe(name):
    """The section of a recipe: what its first comment says, then the rest of it."""
    text = (FOLDER / f"{name}.c").read_text(encoding="utf-8")
    if text.count("\n") > LONGEST:
        sys.exit(f"samples/cookbook/{name}.c: expected at most {LONGEST} lines, found {text.count(chr(10))}")
    comment, code = re.match(r"/\* (.*?) \*/\n(.*)", text, re.S).groups()
    comment = re.sub(r"\n \* ", "\n", comment)
    image = PAGE.with_name(f"{name}.jpg")
    if not image.exists():
        sys.exit(f"docs/cookbook/{image.name} is missing: samples/cookbook/images/images.py draws it")
    title = name.replace("_", " ").capitalize()
    return f"\n### {title}\n\n{comment}\n\n![{title}, before and after]({image.name})\n\n```c\n{code}```\n"


def page():
    """The text of the page."""
    named = [name for names in CHAPTERS.values() for name in names]
    present = sorted(path.stem for path in FOLDER.glob("*.c"))
    if sorted(named) != present:
        sys.exit(f"samples/cookbook/page.py: expected the recipes {present} in its chapters, found {sorted(named)}")
    shared = (FOLDER / "cookbook.h").read_text(encoding="utf-8")
    text = HEAD.format(count=len(named), longest=LONGEST, shared=shared)
    for chapter, names in CHAPTERS.items():
        text += f"\n## {chapter}\n" + "".join(recipe(name) for name in names)
    return text


def main():
    """See the head of this file."""
    text = page()
    if "--check" not in sys.argv:
        PAGE.parent.mkdir(parents=True, exist_ok=True)
        PAGE.write_text(text, encoding="utf-8")
        return 0
    if PAGE.exists() and PAGE.read_text(encoding="utf-8") == text:
        return 0
    print("docs/cookbook/README.md is not what its recipes say: run samples/cookbook/page.py")
    return 1


if __name__ == "__main__":
    sys.exit(main())
