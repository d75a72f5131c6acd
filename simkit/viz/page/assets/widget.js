// A scene as a widget of a notebook: the page in a frame, which hears of each moment. See scene_widget.py.
const NAMES = ["scene", "moment", "meshcat", "status"];
const CLEAR = /^(transparent|rgba\(.*, 0\))$/;

// Whether the ground around a frame is light or dark.
function themeAround(frame) {
  let place = frame.parentElement;
  while (place && CLEAR.test(getComputedStyle(place).backgroundColor)) place = place.parentElement;
  if (!place) return "light";
  const [red, green, blue] = getComputedStyle(place).backgroundColor.match(/[\d.]+/g).map(Number);
  return 0.3 * red + 0.6 * green + 0.1 * blue < 128 ? "dark" : "light";
}

function render({ model, el }) {
  const frame = document.createElement("iframe");
  frame.setAttribute("sandbox", "allow-scripts");
  Object.assign(frame, { srcdoc: model.get("page"), title: model.get("title"), width: "100%" });
  frame.style.cssText = `border:0;display:block;height:${model.get("height")}px`;
  const tell = (words) => frame.contentWindow?.postMessage(words, "*");
  const send = (name) => model.get(name) && tell({ [name]: model.get(name) });
  const all = () => { tell({ theme: themeAround(frame), live: true }); NAMES.forEach(send); };
  const changes = NAMES.map((name) => [`change:${name}`, () => send(name)]);
  for (const [event, act] of changes) model.on(event, act);
  frame.addEventListener("load", all);
  const watcher = new MutationObserver(() => setTimeout(() => tell({ theme: themeAround(frame) }), 300));
  watcher.observe(document.body, { attributes: true });
  el.append(frame);
  return () => {
    watcher.disconnect();
    for (const [event, act] of changes) model.off(event, act);
  };
}

export default { render };
