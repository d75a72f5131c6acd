// What the page says beside the picture, kept up to date: sentences, and the poses as numbers.
function tell(scene) {
  const text = (id, words) => { const place = element(id); place.textContent = words; place.hidden = !words; };
  const list = (id, lines) => {
    element(id).replaceChildren(...lines.map((line) => Object.assign(document.createElement("li"), { textContent: line })));
    element(id).hidden = !lines.length;
  };
  text("error", scene.error);
  text("summary", scene.summary);
  text("scale", scene.scale);
  list("problems", scene.problems);
  list("notes", scene.notes);
  element("fixed").textContent = scene.fixedFrame;
  element("scene").setAttribute("aria-label", `${scene.summary} ${scene.help}`);
  element("table").hidden = !scene.frames.length;
  if (element("table").open) tellNumbers(scene.frames);
}

function tellNumbers(frames) {
  const cell = (words, name) => Object.assign(document.createElement("td"), { textContent: words, className: name });
  const rows = frames.filter((frame) => !frame.isHidden).map((frame) => {
    const row = document.createElement("tr"), parent = frame.parent === null ? "" : frames[frame.parent].label;
    const degrees = rollPitchYaw(frame.q).map((angle) => angle * 180 / Math.PI);
    row.append(cell(frame.label, "name"), cell(parent, "name"));
    row.append(...frame.p.map((value) => cell(fixed(value, 3), "")), ...degrees.map((value) => cell(fixed(value, 1), "")));
    return row;
  });
  const [head, ...old] = element("numbers").rows;
  old.forEach((row) => row.remove());
  head.after(...rows);
}

// Without the minus of a zero.
function fixed(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

// Angles about the fixed axes, as rotation.py.
function rollPitchYaw([x, y, z, w]) {
  const m20 = 2 * (x * z - y * w), pole = Math.abs(m20) >= 1 - 1e-12;
  if (pole) return [Math.atan2(2 * (x * y - z * w) * -Math.sign(m20), 2 * (x * z + y * w) * -Math.sign(m20)), -Math.sign(m20) * Math.PI / 2, 0];
  const [m00, m10] = [1 - 2 * (y * y + z * z), 2 * (x * y + z * w)];
  const [m21, m22] = [2 * (y * z + x * w), 1 - 2 * (x * x + y * y)];
  return [Math.atan2(m21, m22), -Math.asin(m20), Math.atan2(m10, m00)];
}
