// An orbit camera, z up, the same as camera.py; and how mouse, fingers and keys move it.
const NEAR = 0.02;
const plus = (a, b, factor = 1) => a.map((value, i) => value + factor * b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

class OrbitCamera {
  // Of the stage: a camera, and the angle that the height of a picture covers.
  constructor(stage) {
    this.size = [1, 1];
    this.rest(stage);
    this.reset();
  }

  rest(stage) {
    this.start = stage.camera;
    this.fieldOfView = stage.fieldOfView;
  }

  reset() {
    Object.assign(this, this.start, { target: [...this.start.target], isTouched: false });
  }

  fromAbove() {
    this.reset();
    Object.assign(this, { azimuth: -Math.PI / 2, elevation: Math.PI / 2, isTouched: true });
  }

  get focal() {
    return Math.min(this.size[1], this.size[0] / 1.6) / 2 / Math.tan(this.fieldOfView / 2);
  }

  // Right, up, and towards the camera.
  get basis() {
    const [sa, ca] = [Math.sin(this.azimuth), Math.cos(this.azimuth)];
    const [se, ce] = [Math.sin(this.elevation), Math.cos(this.elevation)];
    return [[-sa, ca, 0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]];
  }

  // Where a point is on paper [px]; null if it is not before the camera.
  onPaper(point) {
    const [right, up, back] = this.basis.map((axis) => dot(plus(point, this.target, -1), axis));
    const depth = this.distance - back;
    if (depth < NEAR * this.distance) return null;
    const scale = this.focal / depth;
    return [this.size[0] / 2 + right * scale, this.size[1] / 2 - up * scale];
  }

  turn(dx, dy) {
    this.azimuth -= dx;
    this.elevation = clamp(this.elevation + dy, -Math.PI / 2, Math.PI / 2);
  }

  move(dx, dy) {
    const [right, up] = this.basis, scale = this.distance / this.focal;
    this.target = plus(plus(this.target, right, -dx * scale), up, dy * scale);
  }

  zoom(factor) {
    this.distance = clamp(this.distance * factor, this.start.distance / 200, this.start.distance * 50);
  }
}

// Lets a person move a camera; `redraw` is called after each move.
function steer(place, camera, redraw) {
  const changed = () => { camera.isTouched = true; redraw(); };
  const fingers = new Map();
  place.addEventListener("pointerdown", (event) => {
    place.focus({ preventScroll: true });
    place.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, event);
  });
  place.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const [dx, dy] = [event.clientX - before.clientX, event.clientY - before.clientY];
    if (fingers.size === 2) {
      const other = [...fingers.values()].find((finger) => finger.pointerId !== event.pointerId);
      const span = (finger) => Math.hypot(finger.clientX - other.clientX, finger.clientY - other.clientY) || 1;
      camera.move(dx / 2, dy / 2);
      camera.zoom(span(before) / span(event));
    } else if (event.shiftKey || event.buttons > 1) camera.move(dx, dy);
    else camera.turn(dx * 0.008, dy * 0.008);
    fingers.set(event.pointerId, event);
    changed();
  });
  for (const name of ["pointerup", "pointercancel"]) {
    place.addEventListener(name, (event) => fingers.delete(event.pointerId));
  }
  place.addEventListener("contextmenu", (event) => event.preventDefault());
  // Without the focus the wheel scrolls the page, as everywhere else.
  place.addEventListener("wheel", (event) => {
    if (document.activeElement !== place) return;
    event.preventDefault();
    camera.zoom(Math.exp(clamp(event.deltaY, -200, 200) * 0.0015));
    changed();
  }, { passive: false });
  place.addEventListener("keydown", (event) => {
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const arrow = arrows[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (arrow && event.shiftKey) camera.move(-24 * arrow[0], -24 * arrow[1]);
    else if (arrow) camera.turn(-0.1 * arrow[0], -0.1 * arrow[1]);
    else if (event.key === "+" || event.key === "=") camera.zoom(0.85);
    else if (event.key === "-") camera.zoom(1 / 0.85);
    else if (event.key === "t") camera.fromAbove();
    else if (event.key !== "Home" && event.key !== "0") return;
    event.preventDefault();
    changed();
    if (event.key === "Home" || event.key === "0") camera.reset();
  });
}
