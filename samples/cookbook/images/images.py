#!/usr/bin/env python3
"""Draws the recipes of the cookbook: images.py BUILD_FOLDER [RECIPE...]

Runs each recipe with the camera (camera.cpp) and writes docs/cookbook/RECIPE.jpg: two images side by side, before and
after, small enough for a repository. Needs python3-pil and the target cookbook_images.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs/cookbook"
QUALITY = 82
GAP = 6  # pixels between two images
LARGEST = 30 << 10  # bytes of an image
# Two images of each recipe: after which step, where the camera is and what it looks at, in metres.
SHOTS = {
    "bomb": [(60, (5, 3.2, -5), (0.2, 0.8, 0.2)), (75, (5, 3.2, -5), (0.2, 0.8, 0.2))],
    "breakable_light": [(2, (0.9, 2.5, -1.2), (0.15, 1.95, 0.15)), (8, (0.9, 2.5, -1.2), (0.15, 1.95, 0.15))],
    "bridge_collapse": [(2, (1.5, 3.4, -9), (0, 1, 0.5)), (40, (1.5, 3.4, -9), (0, 1, 0.5))],
    "build": [(2, (3, 1.8, -2), (0.5, 0.5, 0.2)), (22, (3, 1.8, -2), (0.5, 0.5, 0.2))],
    "bullet_hole": [(2, (0.5, 1.9, -2.2), (0, 1.45, 0)), (3, (0.5, 1.9, -2.2), (0, 1.45, 0))],
    "car": [(60, (8, 3.5, 0.5), (0, 0.3, -1.6)), (140, (8, 3.5, 0.5), (0, 0.3, -1.6))],
    "door": [(2, (2, 1.9, 3.6), (0.4, 1.1, 0.2)), (40, (2, 1.9, 3.6), (0.4, 1.1, 0.2))],
    "elevator": [(50, (5, 3, -4), (0.7, 1.8, 0.8)), (299, (5, 3, -4), (0.7, 1.8, 0.8))],
    "fire": [(60, (3.5, 2.4, -3), (0.8, 1, 0.8)), (500, (3.5, 2.4, -3), (0.8, 1, 0.8))],
    "glass_pane": [(4, (4, 1.6, -3.6), (1, 1, 0)), (16, (4, 1.6, -3.6), (1, 1, 0))],
    "own_physics": [(84, (3.5, 2, -5), (0.4, 1.3, 0.4)), (105, (3.5, 2, -5), (0.4, 1.3, 0.4))],
    "pick_up": [(149, (5.5, 2, -2), (0, 1.1, 0)), (170, (5.5, 2, -2), (0, 1.1, 0))],
    "pressure_plate": [(20, (2.2, 1.6, -2.2), (0, 0.5, 0)), (80, (2.2, 1.6, -2.2), (0, 0.5, 0))],
    "raft": [(20, (5, 5, -6), (0.5, 1.4, 0)), (200, (5, 5, -6), (0.5, 1.4, 0))],
    "replay": [(2, (4, 2.6, -4.6), (0, 0.9, 0)), (20, (4, 2.6, -4.6), (0, 0.9, 0))],
    "save": [(2, (4, 2.6, -4.6), (0, 0.9, 0)), (60, (4, 2.6, -4.6), (0, 0.9, 0))],
    "score": [(2, (1.8, 1.8, -3.4), (0, 0.7, 0)), (22, (1.8, 1.8, -3.4), (0, 0.7, 0))],
    "undo": [(3, (3, 2.2, -3.8), (0, 1, 0)), (4, (3, 2.2, -3.8), (0, 1, 0))],
    "walk": [(15, (5.5, 2.6, -4), (0, 0.8, -0.3)), (150, (5.5, 2.6, -4), (0, 0.8, 1.5))],
    "wrecking_ball": [(20, (8, 4, -6), (0, 2.8, -1.6)), (96, (8, 4, -6), (0, 2.8, -1.6))],
}
SUNS = {"breakable_light": "0.3 -0.05 0.9", "fire": "0.5 0.05 0.8"}  # where the light of the recipe is to be seen


def draw(build, recipe, folder):
    """Runs a recipe with the camera; returns its images in `folder`."""
    files, lines = [], []
    for number, (step, eye, target) in enumerate(SHOTS[recipe]):
        files.append(folder / f"{recipe}{number}.png")
        lines.append(" ".join(map(str, (files[-1], step, *eye, *target))))
    subprocess.run([build / f"bin/cookbook_{recipe}"], check=True, cwd=folder, stdout=subprocess.DEVNULL,
                   env={**os.environ, "LD_PRELOAD": str(build / "bin/libcookbook_camera.so"),
                        "RUBBLE_SHOTS": "\n".join(lines)} | ({"RUBBLE_SUN": SUNS[recipe]} if recipe in SUNS else {}))
    return files


def pack(files, out):
    """Writes images side by side, in a third of their width, as one JPEG."""
    parts = [Image.open(file) for file in files]
    width, height = parts[0].width // 3, parts[0].height // 3
    row = Image.new("RGB", (len(parts) * (width + GAP) - GAP, height), "white")
    for number, part in enumerate(parts):
        row.paste(part.resize((width, height), Image.Resampling.BOX), (number * (width + GAP), 0))
    row.save(out, quality=QUALITY, optimize=True)
    size = out.stat().st_size
    print(f"{out.name}: {size / 1024:.1f} KiB")
    if size > LARGEST:
        sys.exit(f"{out}: expected at most {LARGEST} bytes, found {size}")


def main():
    """See the head of this file."""
    build = pathlib.Path(sys.argv[1]).resolve()
    for recipe in sys.argv[2:] or SHOTS:
        with tempfile.TemporaryDirectory() as folder:
            pack(draw(build, recipe, pathlib.Path(folder)), PAGE / f"{recipe}.jpg")


if __name__ == "__main__":
    main()
