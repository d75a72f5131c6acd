"""Spoils XML texts, in ways in which people and machines spoil them; the same seed spoils them in the same way."""

from __future__ import annotations

import random
import re
from collections.abc import Callable

_TAG = re.compile(r"<[^<>]*>")
_START_TAG = re.compile(r"<\w[^<>]*>")
_ATTRIBUTE = re.compile(r"""\s[\w:.-]+\s*=\s*("[^"]*"|'[^']*')""")
_VALUE = re.compile(r"""=\s*("[^"]*"|'[^']*')""")
_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?(?![\w.])")
_NUMBERS = (
    *("nan", "-nan", "inf", "-inf", "1e999", "-1e999", "1e-999", "-0", "0", "90", "-180", "1e308"),
    *("0, 0", "0,5", "1.2.3", "", " ", "0x10", "1_000", "pi", "${width}", "--1", "+1", ".5", "5."),
    *(
        "\u0661",
        "9" * 400,
        "9" * 5000,
        "0 0",
        "1e",
        "true",
        "1\t2",
        "1\u00a02",
        "\u2212 1",
        "4.9e-324",
    ),
)
_PIECES = (
    *("<", ">", "/", "=", '"', "'", "&", ";", "]]>", "--", "-->", "<!--", "<?", "?>", "<![CDATA["),
    *(
        "</",
        "/>",
        "<!",
        "<>",
        "< ",
        "&lt;",
        "&#0;",
        "&#x20;",
        "&nope;",
        "\\",
        " ",
        "\n",
        "\t",
        "\r",
    ),
    *("\x00", "\x1b[31m", "\u00a0", "\u200b", "\ufeff", "\u202e", "\ufffe", "\U0001f916", "æ", "“"),
    *("<?xml version='1.0'?>", "<!DOCTYPE robot>", "<robot>", "</robot>", "<a/>", "x" * 5000),
    *("$(find nowhere)", "$(arg x)", "$(eval 1/0)", "$(env HOME)", "$(", "package://", "file:///"),
)
_BOMB = """<!DOCTYPE robot [
<!ENTITY a0 "boom">
{entities}
<!ENTITY away SYSTEM "file:///etc/passwd">
]>
"""


def mutated(text: str, rng: random.Random) -> bytes:
    """The text with one to four things spoiled.

    Args:
        text: The text.
        rng: Where chance comes from.
    """
    for _ in range(rng.choice((1, 1, 1, 2, 2, 3, 4))):
        text = rng.choice(_MUTATIONS)(text, rng)
    return _spoil_bytes(text, rng)


def _spoil_bytes(text: str, rng: random.Random) -> bytes:
    """The text in bytes: mostly UTF-8 as it is, now and then in another encoding, or with a bit turned over."""
    dice = rng.random()
    if dice < 0.03:
        return text.encode(rng.choice(("utf-16", "utf-16-be", "latin-1", "utf-8-sig")), "replace")
    data = bytearray(text.encode("utf-8", "replace"))
    for _ in range(rng.randrange(1, 4) if dice < 0.1 and data else 0):
        data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
    return bytes(data)


def _cut_out(pattern: re.Pattern[str]) -> Callable[[str, random.Random], str]:
    def cut_out(text: str, rng: random.Random) -> str:
        start, end = _one(pattern, text, rng)
        return text[:start] + text[end:]

    return cut_out


def _double(pattern: re.Pattern[str]) -> Callable[[str, random.Random], str]:
    def double(text: str, rng: random.Random) -> str:
        start, end = _one(pattern, text, rng)
        return text[:end] + text[start:end] + text[end:]

    return double


def _swap(pattern: re.Pattern[str]) -> Callable[[str, random.Random], str]:
    def swap(text: str, rng: random.Random) -> str:
        (a, b), (c, d) = sorted((_one(pattern, text, rng), _one(pattern, text, rng)))
        return text if b > c else text[:a] + text[c:d] + text[b:c] + text[a:b] + text[d:]

    return swap


def _one(pattern: re.Pattern[str], text: str, rng: random.Random) -> tuple[int, int]:
    """Where one of the places is that look like `pattern`; nowhere if there is none."""
    found = [match.span() for match in pattern.finditer(text)]
    return rng.choice(found) if found else (0, 0)


def _other_number(text: str, rng: random.Random) -> str:
    start, end = _one(_NUMBER, text, rng)
    return text[:start] + rng.choice(_NUMBERS) + text[end:] if end else text


def _other_value(text: str, rng: random.Random) -> str:
    """A value of another attribute in place of one."""
    start, end = _one(_VALUE, text, rng)
    other, behind = _one(_VALUE, text, rng)
    return text[:start] + text[other:behind] + text[end:]


def _no_quotes(text: str, rng: random.Random) -> str:
    start, end = _one(_VALUE, text, rng)
    return text[:start] + text[start:end].replace('"', "", rng.randrange(1, 3)) + text[end:]


def _insert(text: str, rng: random.Random) -> str:
    at = rng.randrange(len(text) + 1)
    return text[:at] + rng.choice(_PIECES) + text[at:]


def _replace_letter(text: str, rng: random.Random) -> str:
    at = rng.randrange(len(text) + 1)
    return text[:at] + rng.choice(_PIECES)[:1] + text[at + 1 :]


def _misspell(text: str, rng: random.Random) -> str:
    """Two neighbouring letters of a tag change places."""
    start, end = _one(_TAG, text, rng)
    if end - start < 4:
        return text
    at = rng.randrange(start + 1, end - 2)
    return text[:at] + text[at + 1] + text[at] + text[at + 2 :]


def _truncate(text: str, rng: random.Random) -> str:
    return text[: rng.randrange(len(text) + 1)]


def _swap_lines(text: str, rng: random.Random) -> str:
    """Two blocks of lines change places."""
    lines = text.split("\n")
    a, b, c, d = sorted(rng.randrange(len(lines) + 1) for _ in range(4))
    return "\n".join(lines[:a] + lines[c:d] + lines[b:c] + lines[a:b] + lines[d:])


def _repeat_lines(text: str, rng: random.Random) -> str:
    lines = text.split("\n")
    a, b = sorted(rng.randrange(len(lines) + 1) for _ in range(2))
    return "\n".join(lines[:b] + lines[a:b] * rng.choice((1, 1, 2, 20)) + lines[b:])


def _entity_bomb(text: str, rng: random.Random) -> str:
    """Entities of entities, that would be gigabytes, used somewhere."""
    levels = rng.choice((3, 9, 30))
    entities = "\n".join(f'<!ENTITY a{n + 1} "{f"&a{n};" * 10}">' for n in range(levels))
    start, _ = _one(_START_TAG, text, rng)
    used = _other_piece(text, rng, f"&a{levels};&away;")
    return used[:start] + _BOMB.format(entities=entities) + used[start:]


def _other_piece(text: str, rng: random.Random, piece: str) -> str:
    start, end = _one(_VALUE, text, rng)
    return text[:start] + f'="{piece}"' + text[end:] if end else text


def _deep(text: str, rng: random.Random) -> str:
    """An element in itself, many times."""
    start, end = _one(_START_TAG, text, rng)
    tag, times = text[start:end].replace("/>", ">"), rng.choice((10, 300, 2000))
    name = tag[1:-1].split(" ")[0].strip("/\n\t")
    ends = f"</{name}>" * rng.choice((0, times, times))
    return text[:start] + tag * times + ends + text[end:]


def _windows(text: str, rng: random.Random) -> str:
    return text.replace("\n", rng.choice(("\r\n", "\r", "\n\n", "")))


_MUTATIONS: tuple[Callable[[str, random.Random], str], ...] = (
    *(_cut_out(_TAG), _double(_TAG), _swap(_TAG)),
    *(_cut_out(_ATTRIBUTE), _double(_ATTRIBUTE), _swap(_ATTRIBUTE)),
    *(_other_number, _other_number, _other_number, _other_value, _no_quotes),
    *(_insert, _insert, _replace_letter, _misspell, _misspell, _truncate),
    *(_swap_lines, _repeat_lines, _windows, _entity_bomb, _deep),
)
