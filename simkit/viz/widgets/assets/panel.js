// What the widgets share: elements, a picture beside the controls, and a line for what went wrong.
function made(tag, looks = {}, ...children) {
  const one = document.createElement(tag);
  for (const [key, value] of Object.entries(looks)) {
    if (key in one && !key.startsWith("aria-")) one[key] = value; else one.setAttribute(key, value);
  }
  one.append(...children);
  return one;
}

function panel({ model, el }, name, controls) {
  const beside = made("div", { className: "beside" }), message = made("div", { className: "message" });
  message.setAttribute("role", "alert");
  el.append(made("div", { className: `simkit-panel ${name}` }, made("div", { className: "controls" }, ...controls, message), beside));
  const draw = () => {
    const { svg, png, words } = model.get("picture");
    if (svg) beside.innerHTML = svg;
    else if (png) (beside.firstElementChild || beside.appendChild(made("img"))).src = `data:image/png;base64,${png}`;
    if (png) beside.firstElementChild.alt = words;
    beside.hidden = !svg && !png;
  };
  model.on("change:picture", draw);
  draw();
  return (state) => { message.textContent = state.message; message.hidden = !state.message; };
}

// Calls `show` with the state of the kernel's side, now and whenever it is another one.
function follow(model, show) {
  const changed = () => show(model.get("state"));
  model.on("change:state", changed);
  changed();
}
