// The teleop pad. What it sends: {press: key}, {run: whether time passes by itself}, {linear}, {angular}.
const KEYS = { ArrowUp: "up", ArrowDown: "down", ArrowLeft: "left", ArrowRight: "right", " ": "stop" };
const BUTTONS = [null, ["up", "↑", "forward"], null, ["left", "←", "turn left"], ["stop", "Stop", "stop"],
  ["right", "→", "turn right"], null, ["down", "↓", "backward"]];

function render({ model, el }) {
  const run = made("button", { type: "button", textContent: "Run", title: "Let time pass by itself" });
  const arrows = made("div", { className: "arrows" }, ...BUTTONS.map((button) => {
    if (!button) return made("span");
    const [key, sign, words] = button;
    return made("button", { type: "button", className: `simkit-teleop-${key}`, textContent: sign, title: words,
      "aria-label": words, onclick: () => model.send({ press: key }) });
  }), run);
  const hint = made("div", {}, made("span", { className: "off", textContent: "Click here to drive with the arrow keys." }),
    made("span", { className: "on", textContent: "The arrow keys drive; space stops." }));
  const keyboard = made("div", { className: "simkit-teleop-keyboard", tabIndex: 0, "data-lm-suppress-shortcuts": "true",
    role: "group", "aria-label": "Teleop pad: the arrow keys drive, the space bar stops" }, arrows, hint);
  const speeds = [["linear", "m/s"], ["angular", "rad/s"]].map(([name, unit]) => {
    const field = made("input", { type: "number", min: "0", step: "0.1", "aria-label": `${name} speed in ${unit}` });
    field.addEventListener("change", () => model.send({ [name]: Number(field.value) }));
    return [name, field, made("div", { className: "row", "data-lm-suppress-shortcuts": "true" }, `${name} `, field, unit)];
  });
  const lines = made("div", { className: "state" });
  const complain = panel({ model, el }, "simkit-teleop", [keyboard, ...speeds.map(([, , row]) => row), lines]);

  // A click anywhere on the pad leaves it with the keys, whatever the notebook makes of the click.
  keyboard.addEventListener("mousedown", (event) => event.preventDefault());
  keyboard.addEventListener("click", () => keyboard.focus({ preventScroll: true }));
  run.addEventListener("click", () => model.send({ run: run.getAttribute("aria-pressed") !== "true" }));
  keyboard.addEventListener("keydown", (event) => {
    const isButton = event.key === " " && event.target !== keyboard;  // the space bar presses the button that Tab has reached
    if (!KEYS[event.key] || isButton || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    model.send({ press: KEYS[event.key] });
  });

  follow(model, (state) => {
    complain(state);
    lines.replaceChildren(...state.lines.map((line) => made("div", { textContent: line })));
    run.setAttribute("aria-pressed", state.running);
    for (const [name, field] of speeds) if (field !== document.activeElement) field.value = state[name];
  });
}

export default { render };
