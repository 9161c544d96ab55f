#!/usr/bin/env python3
"""Lets the game's bot play (samples/sandbox/game/bot_long.lua) and prints what memory it has at each tenth.

long_play.py rubble-game LEVEL OUT [SECONDS [OPTION...]]: OUT gets images of tools and menus. Fails where the bot does,
or where the log has an error.
"""
import pathlib
import re
import subprocess
import sys


def memory(process):
    """Megabytes that are resident, and those of them that no file backs: heap, stacks, buffers."""
    text = pathlib.Path(f"/proc/{process}/smaps_rollup").read_text()
    value = lambda name: int(re.search(rf"^{name}:\s+(\d+)", text, re.M)[1]) / 1024
    return value("Rss"), value("Anonymous")


def main():
    program, level, out = sys.argv[1:4]
    seconds = sys.argv[4] if len(sys.argv) > 4 else "600"
    folder = pathlib.Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.save"):
        old.unlink()
    (folder / "options.txt").write_text(f"options.bot.seconds={seconds}\n")
    command = [program, "--headless", "--preset", "draft", "--level", level, "--bot", "bot_long.lua", "--saves", out,
               "--out", out, *sys.argv[5:]]
    bad = []
    # A terminal's line buffering, so that a line is there when the game has written it.
    with subprocess.Popen(["stdbuf", "-oL", *command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT) as game:
        print("| tenth | resident, MB | of it heap, MB | what is played |\n| ---: | ---: | ---: | --- |")
        for line in game.stdout:
            tenth = re.search(r"tenth (\d+): (.*)", line)
            if tenth:
                resident, heap = memory(game.pid)
                print(f"| {tenth[1]} | {resident:.0f} | {heap:.0f} | {tenth[2].lstrip(', ')} |", flush=True)
            elif "warning" not in line:
                bad.append(line.rstrip())
    for line in bad:
        print(line)
    return 1 if game.returncode or bad else 0


if __name__ == "__main__":
    sys.exit(main())
