#!/usr/bin/env python3
"""Writes the fragments of a page of docs/guide, one after the other, as one C file: program.py PAGE.md OUT.c"""

import pathlib
import re
import sys

text = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
fragments = re.findall(r"^```c\n(.*?)^```$", text, re.M | re.S)
pathlib.Path(sys.argv[2]).write_text("\n".join(fragments), encoding="utf-8")
