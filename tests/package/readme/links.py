#!/usr/bin/env python3
"""links.py files...: every relative link in the Markdown files leads to a file that is there, and to a heading of it."""
import pathlib
import re
import sys


def text_of(path):
    """Without blocks of code, where nothing is a link or a heading."""
    return re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)


def anchors(path):
    """Of all headings, made from their words as GitHub does."""
    seen = {}
    for heading in re.findall(r"^#+ +(.*?) *$", text_of(path), flags=re.MULTILINE):
        words = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
        anchor = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        number = seen.setdefault(anchor, 0)
        seen[anchor] += 1
        yield f"{anchor}-{number}" if number else anchor


def broken_links(path):
    for link in re.findall(r"\]\(\s*([^)\s]+)\s*\)", text_of(path)):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, anchor = link.partition("#")
        target = path.parent / name if name else path
        if not target.exists():
            yield f"{path}: there is no {link}"
        elif anchor and target.suffix == ".md" and anchor not in anchors(target):
            yield f"{path}: {name or path.name} has no heading #{anchor}"


broken = [line for name in sys.argv[1:] for line in broken_links(pathlib.Path(name))]
for line in broken:
    print(line)
sys.exit(bool(broken))
