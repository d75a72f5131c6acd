"""Make the pictures of the documentation, or say which ones are stale.

Run it as `python docs/pictures/make_pictures.py [--check]`. `turtles.svg` is what the program in
README.md draws; the others are drawn by the scripts beside this one.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from pathlib import Path

import grade
import lockstep
import message
import parts

FOLDER = Path(__file__).resolve().parent
README = FOLDER.parents[1] / "README.md"


def pictures() -> dict[str, str]:
    """File name -> SVG of every picture."""
    return {
        "parts.svg": parts.draw(),
        "message.svg": message.draw(),
        "lockstep.svg": lockstep.draw(),
        "grade.svg": grade.draw(),
        "turtles.svg": turtles(),
    }


def turtles() -> str:
    """What the first Python program in README.md saves as `turtles.svg`."""
    program = re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)[0]
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-c", program]
        subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
        return Path(folder, "turtles.svg").read_text(encoding="utf-8")


def main() -> int:
    """Write what is stale, or name it; the exit code is 1 if `--check` names anything."""
    stale = {
        name: text
        for name, text in pictures().items()
        if not (FOLDER / name).is_file() or (FOLDER / name).read_text(encoding="utf-8") != text
    }
    if "--check" in sys.argv[1:]:
        for name in stale:
            print(f"docs/pictures/{name} is stale; run python docs/pictures/make_pictures.py")
        return 1 if stale else 0
    for name, text in stale.items():
        (FOLDER / name).write_text(text, encoding="utf-8", newline="\n")
        print(f"wrote docs/pictures/{name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
