#!/usr/bin/env python3
"""Rules of the sources that can be counted; prints FILE:LINE: what is wrong, and fails if anything is.

    source_rules.py [--root ROOT] [--summary] [PATH...]     only files under these paths; --summary: numbers alone
"""

import argparse
import re
import shutil
import subprocess
import sys
from collections import Counter
from pathlib import Path

import cpp_scan

MAX_COLUMNS = 120
MAX_FUNCTION_LINES = 60
MAX_LONG_FUNCTIONS = 0.005  # share of all functions that may be longer
MAX_FILE_LINES = 500
MAX_PUBLIC_METHODS = 25
MAX_DECISION_WORDS = 100
GENERATED = 'Generated from rubble.h'  # what it is generated from is checked, and that it follows from that
LONG_FILES = {'runtime/plugin/include/rubble/rubble.h',  # one page for hosts
              'tests/abi/first_release/rubble/rubble.h'}
HEADERS = ('.h', '.hh', '.hpp', '.hxx', '.inl', '.ipp')
SHADERS = ('.glsl', '.frag', '.vert', '.comp', '.geom', '.tesc', '.tese')
SOURCES = HEADERS + SHADERS + ('.c', '.cc', '.cpp', '.cxx')
TEXTS = SOURCES + ('.md', '.txt', '.py', '.sh', '.json', '.cmake', '.in')

# Words that are not the field's, each with what to write instead. A letter in brackets keeps a pattern from matching itself.
REFUSED = {
    r'k(?:M[o]st|F[e]west|L[e]ast)[A-Z]\w*': 'kMax, kMin',
    r'\w+A(?:S[t]ep|B[o]dy)\b': '...PerStep, ...PerBody',
    r'(?i:\w*t[r]uths?)\b': 'reference',
    r'(?i:[a-z_]*p[i]ctures?)(?![a-z])': 'frame, image',
    r'(?i:(?<![a-z])l[a]mps?)(?![a-z])': 'light',
    r'(?i:\ba[n]ew\b)': 'again, rebuild',
    r'(?i:reference g[a]me)': 'Teardown',
    r'(?i:w[a]ys?_?out)': 'depenetration, exit face',
    r'\bw[i]denGap\b': 'refineSeparatingAxis',
    r'\bf[i]ndKnocked\b': 'secondary sweep',
    r'\bcontact_r[e]use\b|\bContactR[e]use\b': 'contact_cache',
    r'\bs[o]lver_strips\b|\bS[o]lverStrips\b': 'island partition',
    r'\bdropU[n]balanced\b': 'rejectWarmStart',
    r'\bfindB[e]arers\b|\bb[e]arers?\b': 'load-bearing, support',
    r'\bH[e]ldJoint\b': 'JointProxy',
    r'\bl[o]ad_(?:analysis|cuts|flight|graph|multigrid|solver)\b|\bL[o]adSettings\b': 'stress_...',
    r'\bS[t]rikeEdit\b': 'ImpactLoad',
    r'\bw[e]ighShapes\b': 'runStressAnalysis',
    r'\bstays_w[h]ole\b|\bhang_t[o]gether\b|\bstaysW[h]ole\b|\bhangT[o]gether\b': 'connectivity test',
    r'\bn[o]thingLoose\b|\bisA[d]rift\b': 'known connected, unanchored',
    r'\br[e]home\b': 'detachToNewBody',
    r'\bforgetS[t]illborn\b|(?i:\bs[t]illborn\b)': 'dropTransient',
    r'\bturnToD[u]st\b': 'despawn',
    r'\bB[r]ickShare\b': 'BrickSubset',
    r'(?i:\bq[u]ench)': 'extinguish',
    r'(?i:\bl[e]dger\b)': 'VoxelAccounting',
    r'\bempty_c[u]bes\b|\bEmptyC[u]bes\b': 'skip distances by octant',
    r'\bchanged_p[l]aces\b|\bChangedP[l]aces\b': 'dirty regions',
    r'\bS[h]adowMirror\b|\bshadow_m[i]rror\b': 'GpuShadowVolume',
    r'\bM[i]rroredBuffer\b|\bm[i]rrored_buffer\b': 'staged buffer',
    r'(?i:\bm[a]tte\b)': 'diffuse fraction',
    r'(?i:n[e]arness)': 'hit proximity',
    r'\bl[i]ghtTrusted\b': 'history confidence',
    r'\bd[r]awMade\b': 'draw lazily',
    r'\buL[o]ngest\b': 'maxHistory',
    r'\bflat_u[n]iforms\b|\bFlatU[n]iforms\b': 'uniforms as varyings',
    r'\bt[r]ouble\(\)': 'lastError()',
    r'(?i:h[a]lvings)': 'downscale',
    r'(?<![\d.])3\.1415\d*': 'kPi of runtime/core/constants.h',
}
# Words that are good English in a sentence, but no names in code.
REFUSED_NAMES = {
    r'\bF[o]ur\b': 'Float4',
    r'\bP[r]obe[r]?\b': 'FeatureQuery, FeatureCollider',
    r'\bL[a]ttice\b': 'CellTransform',
    r'\bS[e]ttling\b': 'SleepTimer',
}
# Precompiled headers would hide that a header includes too little, so these names want their own include.
STANDARD = {
    'algorithm': 'sort stable_sort min_element max_element any_of all_of none_of find_if lower_bound upper_bound clamp fill',
    'array': 'array', 'bit': 'popcount countr_zero countl_zero bit_cast bit_width', 'cmath': 'sqrt floor ceil sin cos pow',
    'deque': 'deque', 'functional': 'function', 'map': 'map multimap', 'memory': 'unique_ptr shared_ptr make_unique make_shared',
    'optional': 'optional nullopt', 'span': 'span', 'string': 'string to_string', 'string_view': 'string_view',
    'unordered_map': 'unordered_map', 'variant': 'variant visit get_if', 'vector': 'vector',
}
LITERALS = {}  # of patterns: see literals_of()
_HEADER_OF = {name: header for header, names in STANDARD.items() for name in names.split()}


def literals_of(word):
    """Texts in lower case of which a match of the pattern has one; empty: none is known."""
    plain = re.sub(r'\[(\w)\]', r'\1', re.sub(r'\\[bdw]', ' ', word))
    plain = re.sub(r'\w[?*]', ' ', plain)
    longest = [max(re.findall(r'\w+', part), key=len, default='') for part in plain.split('|')]
    return [text.lower() for text in longest] if all(len(text) > 2 for text in longest) else []


def check_words(name, lines, refused):
    # Most files have none of the texts: looking for these first is quicker than the patterns.
    text = '\n'.join(lines).lower()
    words = {}
    for word, advice in refused.items():
        literals = LITERALS.setdefault(word, literals_of(word))
        if not literals or any(literal in text for literal in literals):
            words[word] = advice
    if not words:
        return
    pattern = re.compile('|'.join(f'(?P<w{i}>{word})' for i, word in enumerate(words)))
    for number, line in enumerate(lines, 1):
        for match in pattern.finditer(line):
            advice = list(words.values())[int(match.lastgroup[1:])]
            yield name, number, 'word', f'"{match.group(0)}" is not a word of ours or the field\'s: write {advice}'


def check_layout(name, lines):
    for number, line in enumerate(lines, 1):
        if len(line) > MAX_COLUMNS:
            yield name, number, 'column', f'{len(line)} columns, at most {MAX_COLUMNS}'
    if len(lines) > MAX_FILE_LINES and name not in LONG_FILES:
        yield name, len(lines), 'file', f'{len(lines)} lines, at most {MAX_FILE_LINES} in a file'


def check_loops(name, text):
    """Loops of shaders, which a software GL unrolls or runs a step too often: see loopBegin() in shaders/lib/frame.glsl."""
    plain = cpp_scan.blank(text)
    known = r'for \((int \w+ = (\d+|k[A-Z]\w*))?; \w+ < (\d+|k[A-Z][\w.]*);|for \([^;]*;;'
    for match in re.finditer(r'\bfor \([^;]*;[^;]*;|(?<!\})\s\bwhile \(', plain):
        if not re.fullmatch(known, match.group(0)):
            yield name, plain.count('\n', 0, match.end()) + 1, 'loop', 'a loop of unknown length is do {...} while (...)'
    arrays = '|'.join(re.findall(r'\buniform \w+ (\w+)\[', plain))
    lines = plain.split('\n')
    for function in cpp_scan.scan(text)[0] if arrays else ():
        body = '\n'.join(lines[function.first_line - 1:function.last_line])
        if re.search(rf'\b(?:{arrays})\[[a-z]', body) and 'loopBegin()' not in body:
            yield name, function.first_line, 'loop', 'a loop over an array of uniforms begins with loopBegin()'


def check_includes(name, text):
    """A header includes the standard header of each name of STANDARD that it uses, and opens no namespace for its users."""
    included = set(re.findall(r'^[ \t]*#[ \t]*include[ \t]*<([\w/.]+)>', cpp_scan.blank_comments(text), re.M))
    plain, seen = cpp_scan.blank(text), set()
    for match in re.finditer(r'\bstd::(\w+)|\busing\s+namespace\b', plain):
        line = plain.count('\n', 0, match.start()) + 1
        header = _HEADER_OF.get(match.group(1))
        if not match.group(1):
            yield name, line, 'include', 'a header uses no namespace for all who include it'
        elif header and header not in included and header not in seen:
            seen.add(header)
            yield name, line, 'include', f'std::{match.group(1)} wants #include <{header}>'


def check_code(name, text, long_functions, counts):
    """Docstrings and sizes of classes; functions that are too long go into `long_functions`."""
    functions, classes = cpp_scan.scan(text)
    for function in functions:
        length = function.last_line - function.first_line + 1
        counts['functions'] += function.is_definition
        if function.is_definition and length > MAX_FUNCTION_LINES:
            long_functions.append((name, function.first_line, 'function', f'{function.name} has {length} lines'))
        if name.endswith(HEADERS) and function.is_public and not function.is_exempt:
            counts['public functions in headers'] += 1
            if not function.is_documented:
                owner = function.owner + '::' if function.owner else ''
                yield name, function.first_line, 'docstring', f'{owner}{function.name} has no docstring'
    for each in classes:
        if each.public_methods > MAX_PUBLIC_METHODS:
            yield name, each.line, 'class', f'{each.name} has {each.public_methods} public methods, at most {MAX_PUBLIC_METHODS}'


def check_decisions(name, lines):
    """docs/decisions: a decision is a heading of level 3 and at most MAX_DECISION_WORDS words."""
    heading, words = 0, 0
    for number, line in enumerate(lines + ['### '], 1):
        if line.startswith('#'):
            if heading and words > MAX_DECISION_WORDS:
                yield name, heading, 'decision', f'{words} words, at most {MAX_DECISION_WORDS} in a decision'
            heading, words = (number if line.startswith('### ') else 0), 0
        else:
            words += len(line.split())


def tracked_files(root):
    command = ['git', 'ls-files', '-z', '--cached', '--others', '--exclude-standard']
    listed = shutil.which('git') and subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    if listed and listed.returncode == 0:
        names = listed.stdout.split('\0')
    else:  # not a checkout: all but what builds and runs leave behind
        names = [str(path.relative_to(root)) for path in root.rglob('*') if path.is_file()]
        names = [name for name in names if name.split('/')[0] not in ('build', 'out')]
    return sorted({name for name in names if name and (root / name).is_file()})


def check(root, paths=()):
    """All that breaks a rule under `root`, as (file, line, kind, text), and counts of what was looked at."""
    found, long_functions, counts = [], [], Counter()
    for name in tracked_files(root):
        if paths and not any(name == path or name.startswith(path + '/') for path in paths):
            continue
        if not (name.endswith(TEXTS) or '.' not in Path(name).name or name.startswith('.ci/')):
            continue
        text = (root / name).read_text(encoding='utf-8', errors='replace')
        if GENERATED in text[:200]:
            continue
        lines = text.removesuffix('\n').split('\n')
        counts['files'] += 1
        if name != 'CHANGELOG.md':
            found += check_words(name, [name], REFUSED)
            found += check_words(name, lines, REFUSED)
        if name.endswith('_test.cpp') and not (root / name).with_name('CMakeLists.txt').exists():
            found.append((name, 1, 'test', 'is never built: its folder has no CMakeLists.txt'))
        if name.endswith(SOURCES):
            found += check_layout(name, lines)
            found += check_words(name, cpp_scan.blank(text).split('\n'), REFUSED_NAMES)
            found += check_code(name, text, long_functions, counts)
        if name.startswith('shaders/'):
            found += check_loops(name, text)
        if name.endswith(HEADERS):
            found += check_includes(name, text)
        if name.startswith('docs/decisions/'):
            found += check_decisions(name, lines)
    if paths or len(long_functions) > MAX_LONG_FUNCTIONS * counts['functions']:
        found += long_functions
    counts['functions over %d lines' % MAX_FUNCTION_LINES] = len(long_functions)
    return sorted(found), counts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--root', type=Path, default=Path(__file__).resolve().parents[2])
    parser.add_argument('--summary', action='store_true')
    parser.add_argument('paths', nargs='*', type=Path)
    options = parser.parse_args()
    root = options.root.resolve()
    if not root.is_dir():
        parser.error(f'--root {options.root}: expected a folder, found none')
    paths = []
    for path in options.paths:  # from here, or from the root
        full = next((full for full in (path.resolve(), root / path) if full.exists() and full.is_relative_to(root)), None)
        if not full:
            parser.error(f'{path}: expected a file or folder under {root}, found none')
        paths.append(full.relative_to(root).as_posix())
    found, counts = check(root, [] if '.' in paths else paths)
    if not options.summary:
        for name, line, _, text in found:
            print(f'{name}:{line}: {text}')
    print('looked at ' + ', '.join(f'{count} {what}' for what, count in counts.items()))
    for kind, count in Counter(kind for _, _, kind, _ in found).items():
        print(f'{count} faults of kind "{kind}"')
    return 1 if found or not counts['files'] else 0


if __name__ == '__main__':
    sys.exit(main())
