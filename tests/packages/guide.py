#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""guide.py PAGE FOLDER: follows a page of lib/guide in FOLDER. A block ```KIND NAME is a file; ```sh is run, line after line, by sh -e; a
```text that follows is what it prints. Exit 1 where a command fails or prints something else."""
import re
import subprocess
import sys


def blocks(text):
    for match in re.finditer(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", text, re.M | re.S):
        yield match.group(1), match.group(2), match.group(3)


def main(page, folder):
    printed, commands = "", 0
    for kind, name, text in blocks(open(page, encoding="utf-8").read()):
        if name:
            with open(f"{folder}/{name}", "w", encoding="utf-8") as out:
                out.write(text)
        elif kind == "sh":
            done = subprocess.run(["sh", "-ec", text], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            printed, commands = done.stdout, commands + 1
            if done.returncode:
                sys.exit(f"{text}exit status {done.returncode}: {printed}")
        elif kind == "text" and text != printed:
            sys.exit(f"the page says:\n{text}and found was:\n{printed}")
    if not commands:
        sys.exit("no command was found")


main(sys.argv[1], sys.argv[2])
