"""`<rosparam command file param ns subst_value>`: many parameters at once, from YAML."""

from __future__ import annotations

from pathlib import Path

from simkit.launch.plan import ParameterStep
from simkit.launch.refusal import Elsewhere, Kind, Lesson, Refused, ours
from simkit.launch.rules import ATTRIBUTE, FILE, YAML
from simkit.launch.scope import Scope, joined, tidy
from simkit.launch.tag import Tag
from simkit.launch.yaml_text import load_yaml
from simkit.xml import Span

_ATTRIBUTES = ("command", "ns", "file", "param", "subst_value")


def take_rosparam(tag: Tag, scope: Scope) -> None:
    """Load, delete or dump parameters.

    Raises:
        Refused: It makes no sense.
    """
    if not tag.applies(scope):
        return
    try:
        _take(tag, scope)
    except Refused as refused:
        refused.at(tag.place)
        if refused.kind is not Kind.VALUE:
            raise
        words = f"error loading <rosparam> tag: \n\t{refused.text}\nXML is {tag.xml}"
        raise refused.worded(Kind.LOAD, words) from None


def _take(tag: Tag, scope: Scope) -> None:
    tag.check_attributes(_ATTRIBUTES)
    command, namespace, file, name, replaced = (tag.get(key, scope) for key in _ATTRIBUTES)
    replace = tag.flag("subst_value", replaced)
    command = command or "load"
    name = joined(namespace or "", name or "")
    full = joined(scope.namespace, name) if name else scope.namespace
    if command == "load":
        _load(tag, scope, file, full, named=bool(name), replace=replace)
    elif command == "dump":
        if tag.state.files.confined:
            what, remedy = "a launch file writes no files here", "Remove this tag."
            raise ours(FILE, what, remedy).at(tag.place_of("file"))
        tag.state.steps.append(ParameterStep(command="dump", name=tidy(full), file=file))
    elif command == "delete":
        if file is not None:
            words = "'file' attribute is invalid with 'delete' command."
            raise _wrong(words, "file", "Remove it.").at(tag.place_of("file"))
        tag.state.steps.append(ParameterStep(command="delete", name=tidy(full)))
    else:
        words = "command must be 'load', 'dump', or 'delete'"
        raise _wrong(words, "command", "Leave it out to load.").at(tag.place_of("command"))


def _load(
    tag: Tag, scope: Scope, file: str | None, full: str, *, named: bool, replace: bool
) -> None:
    text = tag.element.text if file is None else _text_of(tag, file)
    if replace:
        text = _replaced(tag, scope, file, text)
    tag.state.budget.yaml(len(text))
    try:
        value = load_yaml(text, file=file)
    except Refused as refused:
        raise _with_place(refused, tag, file, text) from None
    if not named and not isinstance(value, dict):
        raise Refused(
            Kind.VALUE,
            "'param' attribute must be set for non-dictionary values",
            _no_mapping(value),
        )
    tag.state.add_tree(full, value, tag.place, Path(file) if file else None)


def _no_mapping(value: object) -> Lesson:
    """What to say of a value without a name; of `speed:1`, which is one word, too."""
    what = "this YAML is no mapping of names to values, so its value has no name"
    remedy = 'Write `name: value`, or give the name by param="...".'
    name, colon, rest = value.partition(":") if isinstance(value, str) else ("", "", "")
    if colon and name and rest:
        what = "this YAML is one word, for there is no blank behind the colon"
        remedy = f"Write {name}: {rest.strip()}".split("\n")[0][:80]
    return Lesson(rule=YAML, what=what, remedy=remedy)


def _text_of(tag: Tag, file: str) -> str:
    files = tag.state.files
    try:
        if files.may_read(file) and not Path(file).is_file():
            lesson = files.missing(file)
            raise Refused(Kind.VALUE, f"file does not exist [{file}]", lesson)
        return files.read_text(file)
    except Refused as refused:
        raise refused.at(tag.place_of("file")) from None


def _replaced(tag: Tag, scope: Scope, file: str | None, text: str) -> str:
    """The text with every `$(...)` replaced; one that cannot be is named with its line."""
    resolve = tag.state.substitution.resolve
    try:
        return resolve(text, scope)
    except Refused as refused:
        for number, line in enumerate(text.split("\n"), 1):
            try:
                resolve(line, scope)
            except Refused:
                refused.mark = (number, line.index("$(") + 1)
                break
        raise _with_place(refused, tag, file, text) from None


def _with_place(refused: Refused, tag: Tag, file: str | None, text: str) -> Refused:
    """A fault in YAML, with its place in the file, or in the launch file that the YAML stands in."""
    if refused.mark is None:
        return refused
    line, column = refused.mark
    if file is not None:
        lines = text.split("\n")
        source = lines[line - 1] if line <= len(lines) else ""
        span = Span(line, column)
        shown = tag.state.files.shown(file)
        refused.elsewhere = Elsewhere(file=shown, span=span, source=source)
        return refused.at(tag.place_of("file"))
    begin = tag.element.text_span
    if begin is not None:
        before = text[: len(text) - len(text.lstrip())]
        first = begin.line - before.count("\n")
        offset = begin.column - 1 - len(before) if line == 1 else 0
        place = tag.place
        refused.at(type(place)(sheet=tag.sheet, span=Span(first + line - 1, column + offset)))
    return refused


def _wrong(words: str, attribute: str, remedy: str) -> Refused:
    lesson = Lesson(rule=ATTRIBUTE, what=f"{attribute}= of <rosparam> is wrong", remedy=remedy)
    return Refused(Kind.VALUE, words, lesson)
