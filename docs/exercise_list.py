"""Write the list of exercises in README.md from the sources in `solutions/`.

Run it as `python docs/exercise_list.py [--check]`.
"""

from __future__ import annotations

import sys
from pathlib import Path

from grader.authoring.source import Source, load_source, source_paths

ROOT = Path(__file__).resolve().parents[1]
README = ROOT / "README.md"
BEGIN = "<!-- exercises: written by docs/exercise_list.py -->\n"
END = "<!-- end of exercises -->"
HEAD = "| exercise | | what you hand in |\n|---|---|---|\n"


def readme_with_list(readme: str, sources: list[Source]) -> str:
    """A README with the list of these exercises between its two markers."""
    before, _, rest = readme.partition(BEGIN)
    _, _, after = rest.partition(END)
    return f"{before}{BEGIN}\n{HEAD}{''.join(map(_row, sources))}\n{END}{after}"


def _row(source: Source) -> str:
    definition = source.definition
    names = [f"`{path.rpartition('/')[2]}`" for path in definition.files]
    if definition.answers:
        count = len(definition.answers)
        names.append("one answer" if count == 1 else f"{count} answers")
    link = f"[{definition.title}](exercises/{source.slug}.ipynb)"
    return f"| {definition.id} | {link} | {', '.join(names)} |\n"


def main() -> int:
    """Write the list, or say that it is stale; the exit code is 1 if `--check` finds it so."""
    old = README.read_text(encoding="utf-8")
    new = readme_with_list(old, [load_source(path) for path in source_paths(ROOT)])
    if "--check" in sys.argv[1:]:
        if new != old:
            print("the list of exercises in README.md is stale; run python docs/exercise_list.py")
        return int(new != old)
    README.write_text(new, encoding="utf-8", newline="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
