from __future__ import annotations

from html.parser import HTMLParser

from simkit.viz.by_hand.drive_keys import PAD_CLASS, DriveKey, button_class, keyboard_html


def test_each_key_has_a_sign_and_a_command():
    assert {key.value: key.shares for key in DriveKey} == {
        "up": (1, 0),
        "down": (-1, 0),
        "left": (0, 1),
        "right": (0, -1),
        "stop": (0, 0),
    }
    assert len({key.sign for key in DriveKey}) == 5
    assert button_class(DriveKey.UP) == f"{PAD_CLASS}-up"


def test_the_field_takes_the_focus_and_keeps_the_keys_of_jupyter_away():
    found = []
    parser = HTMLParser()
    parser.handle_starttag = lambda tag, attributes: found.append((tag, dict(attributes)))
    parser.feed(keyboard_html())
    ((tag, attributes),) = found
    assert tag == "div"
    assert attributes["tabindex"] == "0"
    assert attributes["data-lm-suppress-shortcuts"] == "true"
    for code in ("ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight", "' '"):
        assert code in attributes["onkeydown"]
