// Sliders of joints. What they send: {move: joint, to: position}, {press: button}, {duration: seconds}.
function render({ model, el }) {
  const title = made("div", { className: "title" }), rows = made("div"), foot = made("div", { className: "row" });
  const empty = made("div", { textContent: "This robot has no joint to move." });
  const complain = panel({ model, el }, "simkit-sliders", [title, rows, empty, foot]);
  let duration = null, joints = new Map(), buttons = [];

  function row({ name, lower, upper, unit }) {
    const looks = { min: lower, max: upper, step: "any", "aria-label": `${name} in ${unit}`, "data-lm-suppress-shortcuts": "true" };
    const slider = made("input", { type: "range", ...looks }), field = made("input", { type: "number", ...looks });
    const readout = made("span", { className: "readout" }), step = (upper - lower) / 1000;
    let isHeld = false;
    const move = (value) => { field.value = Number(value).toFixed(3); model.send({ move: name, to: Number(value) }); };
    slider.addEventListener("input", () => {
      isHeld = true;
      if (model.get("state").follows) move(slider.value); else field.value = Number(slider.value).toFixed(3);
    });
    slider.addEventListener("change", () => { isHeld = false; move(slider.value); });
    slider.addEventListener("keydown", (event) => {
      const sign = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
      if (!sign || !step) return;
      event.preventDefault();
      slider.value = Number(slider.value) + sign * step;
      move(slider.value);
    });
    field.addEventListener("change", () => { if (field.value !== "") move(Math.min(Math.max(field.value, lower), upper)); });
    rows.append(made("div", { className: "row joint" }, made("label", { textContent: name }), slider, field, readout));
    return {
      controls: [slider, field],
      show({ value, words }) {
        readout.textContent = words;
        slider.setAttribute("aria-valuetext", `${value.toFixed(3)} ${words}`);
        if (isHeld) return;
        slider.value = value;
        if (field !== document.activeElement) field.value = value.toFixed(3);
      },
    };
  }

  function build(state) {
    rows.replaceChildren();
    joints = new Map(state.joints.map((joint) => [joint.name, row(joint)]));
    buttons = state.buttons.map((words) =>
      made("button", { type: "button", textContent: words, onclick: () => model.send({ press: words }) }));
    duration = state.duration === null ? null : made("input", { type: "number", min: 0.01, max: 60, step: 0.1,
      "aria-label": "duration of a motion in seconds", "data-lm-suppress-shortcuts": "true" });
    duration?.addEventListener("change", () => model.send({ duration: Number(duration.value) }));
    foot.replaceChildren(...(duration ? ["duration [s] ", duration] : []), ...buttons);
    empty.hidden = state.joints.length > 0;
  }

  follow(model, (state) => {
    if (joints.size !== state.joints.length || state.joints.some(({ name }) => !joints.has(name)) || !buttons.length) build(state);
    title.textContent = state.title;
    complain(state);
    for (const joint of state.joints) joints.get(joint.name).show(joint);
    if (duration && duration !== document.activeElement) duration.value = state.duration;
    const controls = [...joints.values()].flatMap(({ controls }) => controls);
    for (const control of [...controls, ...buttons]) control.disabled = state.disabled;
  });
}

export default { render };
