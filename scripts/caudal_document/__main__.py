# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of the reference and the gallery: scripts/document calls it."""

import argparse
import os
import pathlib
import sys

from . import cases, columns, gallery, messages, page, parameters

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def write_reference(program, output):
    """Writes the page with parameters, output columns and messages."""
    known = parameters.read_parameters(program)
    for trouble in cases.add_cases(known, ROOT):
        print(f"scripts/document: no model has this: {trouble}", file=sys.stderr)
    said = messages.read_messages(ROOT)
    messages.connect(said, known, ROOT)
    text = page.render(known, columns.read_tables(program, ROOT), said)
    temporary = output.with_name(output.name + ".new")
    temporary.write_text(text, encoding="utf-8")
    os.replace(temporary, output)
    print(f"{output}: {len(known)} parameters, {len(said)} messages")


def main(arguments):
    parser = argparse.ArgumentParser(prog="scripts/document")
    parser.add_argument("program", help="the program caudal")
    parser.add_argument("what", choices=("reference", "gallery"))
    parser.add_argument("names", nargs="*", metavar="NAME",
                        help="the page of the reference (doc/reference.html); pictures (all)")
    options = parser.parse_args(arguments)
    if options.what == "gallery":
        return gallery.make(ROOT, options.names)
    output = pathlib.Path(options.names[0]) if options.names else ROOT / "doc" / "reference.html"
    write_reference(options.program, output)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
