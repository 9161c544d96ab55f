#!/usr/bin/env python3
"""Writes the fragments of a page of docs/guide, one after the other, as one C file: program.py PAGE.md OUT.c

program.py rubble.h OUT.c   writes the client that the header begins with
"""

import pathlib
import re
import sys

text = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
if sys.argv[1].endswith(".h"):
    client = re.search(r" \*     #include.*?\n \*     }\n", text, re.S).group()
    fragments = [re.sub(r"^ \*(?:     )?", "", client, flags=re.M)]
else:
    fragments = re.findall(r"^```c\n(.*?)^```$", text, re.M | re.S)
pathlib.Path(sys.argv[2]).write_text("\n".join(fragments), encoding="utf-8")
