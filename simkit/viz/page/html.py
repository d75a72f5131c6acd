"""One self-contained HTML file: style, body, data and script inside, nothing from elsewhere."""

from __future__ import annotations

import base64
import html
import json
from collections.abc import Sequence
from importlib import resources

from simkit.viz.draw.letters import printable

_POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:"
"The browser itself refuses anything from the network."


def html_page(
    *,
    title: str,
    name: str,
    body: str,
    data: object,
    scripts: Sequence[str] = (),
    connects_to: str = "",
) -> str:
    """A page that needs no network.

    Args:
        title: Its title, as plain text.
        name: Which style of this package it has, `<name>.css`, and which script if there are no other names.
        body: HTML of its body.
        data: What the script finds as JSON in the element `data`; finite numbers only.
        scripts: Names of its scripts, in their order; they are one to the browser.
        connects_to: The one address that it may talk to; none if empty.
    """
    # In JSON these letters occur in strings only, where their codes mean the same.
    text = json.dumps(data, allow_nan=False, separators=(",", ":"))
    for letter in "<>&":
        text = text.replace(letter, f"\\u{ord(letter):04x}")
    policy = _POLICY + (f"; connect-src {connects_to}" if connects_to else "")
    script = "".join(_asset(f"{script}.js") for script in ("theme", *(scripts or (name,))))
    return (
        "<!DOCTYPE html>\n"
        '<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escaped(title)}</title>\n"
        f"<style>\n{_asset('page.css')}{_asset(f'{name}.css')}</style>\n</head>\n<body>\n"
        f"{body}\n"
        f'<script type="application/json" id="data">{text}</script>\n'
        f'<script>\n"use strict";\n{script}</script>\n</body>\n</html>\n'
    )


def escaped(text: str) -> str:
    """Any text as HTML, between tags or between quotes."""
    return html.escape(printable(text))


def inline_frame(page: str, *, title: str, height: int, still: str = "") -> str:
    """A page as part of another, e.g. of a notebook, with scripts that reach nothing around it.

    A script beside it tells it whether it is light or dark around it. Where such scripts may not
    run, the page is as the browser prefers.

    Args:
        page: The whole HTML.
        title: What it shows, for screen readers.
        height: Its height [px]; it is as wide as its surroundings.
        still: HTML of a picture that lies under the page, and is seen where frames are left out of
            notebooks, as on the web pages of repositories; empty if there is none.
    """
    return (
        f'<div style="position:relative;min-height:{height}px;overflow:hidden">{still}'
        f'<iframe srcdoc="{html.escape(page)}" title="{escaped(title)}" '
        f'sandbox="allow-scripts" width="100%" height="{height}" '
        'style="border:0;display:block;position:absolute;top:0;left:0;background:canvas"></iframe></div>'
        f"<script>\n{_asset('around.js')}</script>"
    )


def png_image(data: bytes, words: str, *, style: str = "max-width:100%") -> str:
    """A PNG file as an element of HTML.

    Args:
        data: The file.
        words: What it shows, for those who do not see it.
        style: How it is laid out.
    """
    text = base64.b64encode(data).decode("ascii")
    return f'<img alt="{escaped(words)}" src="data:image/png;base64,{text}" style="{style}">'


def _asset(name: str) -> str:
    return resources.files(__package__).joinpath("assets", name).read_text(encoding="utf-8")
