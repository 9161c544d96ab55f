#!/usr/bin/env python3
"""Follows the recipes of CONTRIBUTING.md: paths exist, and a name in a step occurs in a file of that step.

A recipe is a section of level 2, a step an item of its numbered list. In a step, text in backticks is a path (it
contains a slash), a command (./rubble ...), or a name. NAME stands for the name of what is added: of such a path the
folder must exist.
"""

import re
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RECIPES = ('full-screen pass', 'edit', 'joint kind', 'material', 'light', 'scene', 'option', 'test', 'benchmark')


def steps(text):
    """All (recipe, number of the step, step as one line)."""
    found, recipe = [], ''
    for line in text.split('\n'):
        if line.startswith('## '):
            recipe = line[3:]
        elif match := re.match(r'(\d+)\. (.*)', line):
            found.append([recipe, int(match.group(1)), match.group(2)])
        elif line.startswith('   ') and found and found[-1][0] == recipe:
            found[-1][2] += ' ' + line.strip()
    return found


def contents(root, paths):
    """Text of files; of a folder, of all files in it."""
    text = ''
    for path in paths:
        place = root / path
        for file in [place] if place.is_file() else sorted(place.glob('*')) if place.is_dir() else []:
            if file.is_file():
                text += file.read_text(encoding='utf-8', errors='replace')
    return text


def check_command(root, command):
    launcher = (root / 'rubble').read_text(encoding='utf-8')
    words = command.split()
    if not re.search(rf'^{re.escape(words[1])}(?: \|[^)]*)?\)', launcher, re.MULTILINE):
        yield f'{command}: the launcher has no command "{words[1]}"'
    for option in (word for word in words if word.startswith('--')):
        if option not in launcher + contents(root, ['samples/sandbox']):
            yield f'{command}: no option {option}'


def check_step(root, step):
    quoted = re.findall(r'`([^`]+)`', step)
    commands = [text for text in quoted if text.startswith('./rubble')]
    paths = [text for text in quoted if '/' in text and text not in commands]
    paths += [text for text in quoted if text in ('tests', 'shaders', 'render', 'physics', 'runtime', 'samples')]
    for command in commands:
        yield from check_command(root, command)
    for path in paths:
        there = Path(path).parent if 'NAME' in path else Path(path)
        if not (root / there).exists():
            yield f'{path} does not exist'
    names = [text for text in quoted if text not in commands + paths and 'NAME' not in text and '(' not in text]
    text = contents(root, [path for path in paths if 'NAME' not in path])
    for name in names:
        if not re.search(rf'(?<!\w){re.escape(name)}(?!\w)', text):
            yield f'{name} does not occur in the files of its step'


def check(root, text):
    """Everything that is wrong with the recipes, as "recipe, step: what"."""
    found = steps(text)
    faults = [f'no recipe for "{recipe}"' for recipe in RECIPES if not any(recipe in step[0] for step in found)]
    for recipe, number, step in found:
        faults += [f'{recipe}, step {number}: {fault}' for fault in check_step(root, step)]
    return faults


class Recipes(unittest.TestCase):
    def test_lead_through_the_sources(self):
        self.assertEqual(check(ROOT, (ROOT / 'CONTRIBUTING.md').read_text(encoding='utf-8')), [])

    def test_each_fault_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / 'runtime').mkdir()
            (root / 'runtime/edit.h').write_text('struct HeatEdit {};\n', encoding='utf-8')
            (root / 'rubble').write_text('sandbox)\n    ;;\nhelp | -h) usage ;;\n', encoding='utf-8')
            for step, fault in (
                    ('`HeatEdit` in `runtime/edit.h`, `runtime/NAME.h`, `./rubble sandbox`, `./rubble help`', None),
                    ('`HeatEdit` in\n   `runtime/edit.h`', None),
                    ('`runtime/gone.h`', 'runtime/gone.h does not exist'),
                    ('`gone/NAME.h`', 'gone/NAME.h does not exist'),
                    ('`HeatEdits` in `runtime/edit.h`', 'HeatEdits does not occur in the files of its step'),
                    ('`./rubble dance`', './rubble dance: the launcher has no command "dance"'),
                    ('`./rubble sandbox --dance`', './rubble sandbox --dance: no option --dance')):
                found = [text for text in check(root, '## An edit\n\n1. ' + step + '\n') if 'no recipe' not in text]
                self.assertEqual(found, [f'An edit, step 1: {fault}'] if fault else [], step)
            self.assertIn('no recipe for "material"', check(root, ''))


if __name__ == '__main__':
    sys.exit(unittest.main())
