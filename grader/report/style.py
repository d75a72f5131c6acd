"""How a result looks in a notebook: calm, on light and on dark pages."""

from __future__ import annotations

STYLE = """\
.grader { font: 14px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif;
  max-width: 52rem; color: inherit; margin: .25rem 0 1rem;
  --line: rgba(128,128,128,.35); --tint: rgba(128,128,128,.09);
  --code: ui-monospace, SFMono-Regular, Menlo, Consolas, monospace; }
.grader .head { display: flex; flex-wrap: wrap; gap: .25rem .75rem; align-items: baseline;
  margin: 0 0 .6rem; }
.grader .head strong { font-size: 1.1rem; font-weight: 650; }
.grader .head .sum { opacity: .85; }
section.grader ol.cards { list-style: none; margin: 0; padding: 0; display: grid; gap: .5rem; }
.grader .cards li { border: 1px solid var(--line); border-left: 4px solid var(--hue);
  border-radius: 6px; padding: .5rem .8rem; margin: 0; }
.grader .row { display: flex; gap: .7rem; align-items: baseline; }
.grader .row .title { flex: 1; min-width: 0; overflow-wrap: anywhere; }
.grader .row .points { white-space: nowrap; font-variant-numeric: tabular-nums; opacity: .8; }
.grader .chip { flex: none; width: 9.2rem; box-sizing: border-box; white-space: nowrap;
  border-radius: 1rem; padding: .05rem .6rem .05rem .35rem; font-size: .84rem;
  font-weight: 600; color: #fff; background: var(--hue); }
.grader .chip b { display: inline-block; width: 1.35em; margin-right: .15em;
  font-weight: 700; text-align: center; }
.grader .more { margin: .45rem 0 .15rem 9.9rem; overflow-wrap: anywhere; }
.grader .more p { margin: 0 0 .35rem; white-space: pre-wrap; }
.grader dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem .8rem;
  margin: 0 0 .45rem; padding: .4rem .7rem; background: var(--tint); border-radius: 4px; }
.grader dt { opacity: .75; margin: 0; font-weight: 400; float: none; width: auto; }
.grader dd { margin: 0; font: .92em/1.6 var(--code); overflow-wrap: anywhere; }
.grader details { margin: 0; }
.grader summary { cursor: pointer; font-weight: 600; }
.grader details p { margin: .1rem 0 .2rem; }
.grader .notes { margin: .7rem 0 0; padding: 0 0 0 1.2rem; opacity: .85; }
.grader .notes li { list-style: disc; }
.grader .passed { --hue: #1a7f37; }
.grader .failed, .grader .error { --hue: #b3261e; }
.grader .timeout { --hue: #9a5b00; }
.grader .not-attempted, .grader .skipped { --hue: #5b6470; }
.grader .infrastructure { --hue: #6f4bb0; }
@media (max-width: 36rem) {
  .grader .chip { width: auto; }
  .grader .row { flex-wrap: wrap; }
  .grader .more { margin-left: 0; }
}
"""
"""Scoped by the class `grader`; text keeps the page's own colour, tints let its ground through."""

PAGE_STYLE = """\
:root { color-scheme: light dark; }
body { margin: 2rem auto; padding: 0 1.2rem; max-width: 54rem; }
h1 { font: 650 1.4rem/1.3 system-ui, sans-serif; margin: 0 0 1.2rem; }
"""
"""For a page that holds nothing but results."""
