"use strict";
// Draws frames on a canvas, with an orbit camera. Data: see FramesView in frames_view.py.
(() => {
  const scene = JSON.parse(document.getElementById("data").textContent);
  const canvas = document.getElementById("scene");
  const paint = canvas.getContext("2d");
  const AXIS_COLORS = ["#e03b3b", "#2ba84a", "#3f82f2"];
  const NEAR = 0.02;
  let camera, size = [1, 1], colors = {}, waiting = false;

  const reset = () => { camera = { ...scene.camera, target: [...scene.camera.target] }; };
  const plus = (a, b, factor = 1) => a.map((value, i) => value + factor * b[i]);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
  const focal = () => Math.min(size[1], size[0] / 1.6) / 2 / Math.tan(scene.fieldOfView / 2);

  function basis() {
    const [sa, ca] = [Math.sin(camera.azimuth), Math.cos(camera.azimuth)];
    const [se, ce] = [Math.sin(camera.elevation), Math.cos(camera.elevation)];
    return [[-sa, ca, 0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]];
  }

  // Right, up, and depth away from the camera [m].
  function seen(point, axes) {
    const d = plus(point, camera.target, -1);
    return [dot(d, axes[0]), dot(d, axes[1]), camera.distance - dot(d, axes[2])];
  }

  const onPaper = (s) => {
    const scale = focal() / s[2];
    return [size[0] / 2 + s[0] * scale, size[1] / 2 - s[1] * scale];
  };

  function line(a, b, color, width) {
    const near = NEAR * camera.distance;
    if (a[2] < near && b[2] < near) return;
    const cut = (p, q) => p[2] >= near ? p : plus(p, plus(q, p, -1), (near - p[2]) / (q[2] - p[2]));
    const [from, to] = [onPaper(cut(a, b)), onPaper(cut(b, a))];
    paint.strokeStyle = color;
    paint.lineWidth = width;
    paint.beginPath();
    paint.moveTo(...from);
    paint.lineTo(...to);
    paint.stroke();
  }

  function drawGrid(axes) {
    const { cell, gridX, gridY } = scene;
    const at = (x, y) => seen([x * cell, y * cell, 0], axes);
    for (let x = gridX[0]; x <= gridX[1]; x++) line(at(x, gridY[0]), at(x, gridY[1]), colors.edge, x ? 1 : 2);
    for (let y = gridY[0]; y <= gridY[1]; y++) line(at(gridX[0], y), at(gridX[1], y), colors.edge, y ? 1 : 2);
  }

  // From a child to its parent, with a head that points to the parent.
  function drawLink(child, parent) {
    line(child, parent, colors.link, 1.4);
    const near = NEAR * camera.distance;
    if (child[2] < near || parent[2] < near) return;
    const [from, to] = [onPaper(child), onPaper(parent)];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (length < 28) return;
    const [ux, uy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    const [x, y] = [(from[0] + to[0]) / 2 + 5 * ux, (from[1] + to[1]) / 2 + 5 * uy];
    paint.fillStyle = colors.link;
    paint.beginPath();
    paint.moveTo(x, y);
    paint.lineTo(x - 10 * ux - 4 * uy, y - 10 * uy + 4 * ux);
    paint.lineTo(x - 10 * ux + 4 * uy, y - 10 * uy - 4 * ux);
    paint.fill();
  }

  // As label_places.py: the first free place near the point.
  function drawNames(items) {
    const taken = [], height = 17;
    paint.textBaseline = "middle";
    for (const { frame, s } of items) {
      if (s[2] < NEAR * camera.distance) continue;
      const [x, y] = onPaper(s);
      if (x < 0 || x > size[0] || y < 0 || y > size[1]) continue;
      paint.font = `${frame.isFixed ? "bold " : ""}13px system-ui, "DejaVu Sans", sans-serif`;
      const width = paint.measureText(frame.label).width;
      const sides = x + 9 + width <= size[0] ? [x + 9, x - 9 - width] : [x - 9 - width, x + 9];
      const tried = [0, -1, 1, -2, 2, -3, 3, -4, 4, 5, 6, 7, 8].flatMap((k) => sides.map((left) => [left, y + 10 + k * height]));
      const isFree = ([l, m]) => taken.every(([ol, om, ow]) => l >= ol + ow || ol >= l + width || Math.abs(m - om) >= height);
      const [left, middle] = tried.find(isFree) || tried[0];
      taken.push([left, middle, width]);
      if (Math.abs(middle - y) > 1.2 * height) {
        paint.strokeStyle = colors.grey;
        paint.lineWidth = 0.8;
        paint.beginPath();
        paint.moveTo(x, y);
        paint.lineTo(left > x ? left - 2 : left + width + 2, middle);
        paint.stroke();
      }
      paint.strokeStyle = colors.paper;
      paint.lineWidth = 3.5;
      paint.lineJoin = "round";
      paint.strokeText(frame.label, left, middle);
      paint.fillStyle = colors.ink;
      paint.fillText(frame.label, left, middle);
    }
  }

  function draw() {
    waiting = false;
    const axes = basis(), ratio = window.devicePixelRatio || 1;
    paint.setTransform(ratio, 0, 0, ratio, 0, 0);
    paint.clearRect(0, 0, ...size);
    paint.lineCap = "round";
    drawGrid(axes);
    const items = scene.frames.map((frame) => ({ frame, s: seen(frame.origin, axes) }));
    for (const { frame, s } of items) if (frame.parent !== null) drawLink(s, items[frame.parent].s);
    const far = [...items].sort((a, b) => b.s[2] - a.s[2]);
    for (const { frame, s } of far) {
      const width = clamp(0.09 * scene.axisLength * focal() / Math.max(s[2], NEAR * camera.distance), 2, 9);
      [0, 1, 2].map((i) => ({ i, tip: seen(plus(frame.origin, frame.axes[i], scene.axisLength), axes) }))
        .sort((a, b) => b.tip[2] - a.tip[2])
        .forEach(({ i, tip }) => line(s, tip, AXIS_COLORS[i], width));
    }
    if (document.getElementById("names").checked) drawNames(items.slice(0, scene.mostNames));
  }

  function redraw() {
    if (!waiting) { waiting = true; requestAnimationFrame(draw); }
  }

  function measure() {
    const style = getComputedStyle(document.documentElement);
    for (const name of ["paper", "ink", "grey", "edge"]) colors[name] = style.getPropertyValue(`--${name}`);
    colors.link = matchMedia("(prefers-color-scheme: dark)").matches ? "#d2a53c" : "#b3801a";
    const ratio = window.devicePixelRatio || 1;
    size = [canvas.clientWidth, canvas.clientHeight];
    [canvas.width, canvas.height] = size.map((value) => Math.round(value * ratio));
    redraw();
  }

  const turn = (dx, dy) => {
    camera.azimuth -= dx;
    camera.elevation = clamp(camera.elevation + dy, -1.57, 1.57);
    redraw();
  };
  const move = (dx, dy) => {
    const [right, up] = basis(), scale = camera.distance / focal();
    camera.target = plus(plus(camera.target, right, -dx * scale), up, dy * scale);
    redraw();
  };
  const zoom = (factor) => {
    camera.distance = clamp(camera.distance * factor, scene.camera.distance / 200, scene.camera.distance * 50);
    redraw();
  };
  const actions = {
    reset: () => { reset(); redraw(); },
    top: () => { reset(); camera.azimuth = -Math.PI / 2; camera.elevation = Math.PI / 2; redraw(); },
  };

  const fingers = new Map();
  canvas.addEventListener("pointerdown", (event) => {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, event);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const [dx, dy] = [event.clientX - before.clientX, event.clientY - before.clientY];
    if (fingers.size === 2) {
      const other = [...fingers.values()].find((finger) => finger.pointerId !== event.pointerId);
      const span = (finger) => Math.hypot(finger.clientX - other.clientX, finger.clientY - other.clientY) || 1;
      move(dx / 2, dy / 2);
      zoom(span(before) / span(event));
    } else if (event.shiftKey || event.buttons > 1) move(dx, dy);
    else turn(dx * 0.008, dy * 0.008);
    fingers.set(event.pointerId, event);
  });
  for (const name of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(name, (event) => fingers.delete(event.pointerId));
  }
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  // Without the focus the wheel scrolls the page, as everywhere else.
  canvas.addEventListener("wheel", (event) => {
    if (document.activeElement !== canvas) return;
    event.preventDefault();
    zoom(Math.exp(clamp(event.deltaY, -200, 200) * 0.0015));
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const arrow = arrows[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (arrow && event.shiftKey) move(-24 * arrow[0], -24 * arrow[1]);
    else if (arrow) turn(-0.1 * arrow[0], -0.1 * arrow[1]);
    else if (event.key === "+" || event.key === "=") zoom(0.85);
    else if (event.key === "-") zoom(1 / 0.85);
    else if (event.key === "Home" || event.key === "0") actions.reset();
    else if (event.key === "t") actions.top();
    else return;
    event.preventDefault();
  });
  for (const name of Object.keys(actions)) document.getElementById(name).addEventListener("click", actions[name]);
  document.getElementById("names").addEventListener("change", redraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", measure);
  // A notebook loads this page before it gives it any room, and tells of no resize when it does.
  new ResizeObserver(() => {
    if (canvas.clientWidth !== size[0] || canvas.clientHeight !== size[1]) measure();
  }).observe(canvas);
  reset();
  measure();
})();
