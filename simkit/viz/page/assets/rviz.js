// The view: a scene, a camera, and what a person does with both. See RvizView in rviz_view.py.
const element = (id) => document.getElementById(id);
const ROLES = ["visual", "collision", "centre", "inertia", "joint", "ground"];

class View {
  constructor(scene) {
    this.scene = scene;
    this.camera = new OrbitCamera(scene.stage);
    this.colors = {};
    this.waiting = false;
    this.place = element("scene");
    steer(this.place, this.camera, () => this.redraw());
    element("reset").addEventListener("click", () => { this.camera.reset(); this.redraw(); });
    element("top").addEventListener("click", () => { this.camera.fromAbove(); this.redraw(); });
    element("again").addEventListener("click", () => this.start());
    element("table").addEventListener("toggle", () => tellNumbers(this.scene.frames));
    for (const box of document.querySelectorAll("label > input[type=checkbox]")) {
      box.addEventListener("change", () => this.redraw());
    }
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.measure());
    addEventListener("theme", () => this.measure());
    // A notebook loads this page before it gives it any room, and sends no resize when it does.
    new ResizeObserver(() => this.measure()).observe(this.place);
    this.measure();
  }

  // Begins to draw in 3D; before that, and where it cannot be, the still picture is there.
  start() {
    const canvas = document.createElement("canvas");
    canvas.id = "picture";
    try {
      this.renderer = new MeshCat.THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    } catch (error) {
      this.standStill("This browser draws nothing in 3D here (WebGL is off): the picture stands still.");
      return;
    }
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.renderer = null;
      this.standStill("The browser has taken the 3D picture away, as it does when there are many of them.", true);
    });
    element("picture").replaceWith(canvas);
    this.eye = new MeshCat.THREE.PerspectiveCamera();
    element("still").hidden = true;
    element("notice").hidden = true;
    this.show(this.scene);
  }

  standStill(words, canStartAgain = false) {
    this.place.classList.add("is-still");
    element("still").hidden = false;
    element("picture").hidden = true;
    element("notice").hidden = false;
    element("again").hidden = !canStartAgain;
    element("notice").firstElementChild.textContent = words;
    this.redraw();
  }

  // Takes another scene; the camera stays where a person has moved it.
  show(scene) {
    this.scene = scene;
    this.camera.rest(scene.stage);
    if (!this.camera.isTouched) this.camera.reset();
    if (this.renderer) {
      if (this.objects) this.objects.dispose();
      this.objects = new SceneObjects(MeshCat.THREE, scene);
      this.invite(this.guestCommands || scene.meshcat || []);
      this.place.classList.remove("is-still");
    }
    for (const role of ROLES) {
      element(role).parentElement.hidden = !scene.solids.some((solid) => solid.role === role);
    }
    this.measure();
  }

  // Shows what a person has added by commands of meshcat.
  invite(commands) {
    this.guestCommands = commands;
    if (!commands.length || !this.renderer) return;
    this.guests = new Guests(this.renderer, () => this.redraw());
    this.guests.show(commands);
    if (this.guestRoot) this.guestRoot.removeFromParent();
    this.guestRoot = this.guests.root;
    this.objects.root.add(this.guestRoot);
    this.redraw();
  }

  // The frames of the scene have moved.
  moved() {
    if (this.objects) this.objects.place();
    this.redraw();
  }

  measure() {
    const style = getComputedStyle(document.documentElement);
    for (const name of ["sky", "ink", "grey", "line", "zero"]) {
      this.colors[name] = style.getPropertyValue(`--${name}`).trim();
    }
    this.camera.size = [this.place.clientWidth, this.place.clientHeight];
    if (this.renderer && this.place.clientWidth) {
      this.renderer.setPixelRatio(window.devicePixelRatio || 1);
      this.renderer.setSize(...this.camera.size, false);
      this.objects.recolor(this.colors);
    }
    this.redraw();
  }

  redraw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => { this.waiting = false; this.draw(); });
  }

  draw() {
    if (!this.camera.size[0]) return;
    if (!this.renderer) this.camera.reset();
    const isOn = (name) => element(name).checked;
    if (this.renderer) {
      const { root, grid, frames, roles, marks, light } = this.objects;
      [grid.visible, frames.visible] = [isOn("grid"), isOn("tf")];
      for (const role of ROLES) roles[role].visible = isOn(role);
      for (const one of marks) one.group.visible = isOn(`marks-${one.name}`);
      if (element("clear")) this.objects.makeClear(isOn("clear"));
      this._look(light);
      this.renderer.render(root, this.eye);
    }
    const named = this.scene.frames.slice(0, this.scene.mostNames).filter((frame) => !frame.isHidden);
    drawNames(element("labels"), this.camera, isOn("tf") && isOn("names") ? named : [], this.colors);
  }

  _look(light) {
    const { camera, eye } = this, [right, up, back] = camera.basis;
    const { Vector3, Matrix4 } = MeshCat.THREE;
    const turn = new Matrix4().makeBasis(new Vector3(...right), new Vector3(...up), new Vector3(...back));
    eye.quaternion.setFromRotationMatrix(turn);
    eye.position.fromArray(plus(camera.target, back, camera.distance));
    eye.fov = 2 * Math.atan(camera.size[1] / 2 / camera.focal) * 180 / Math.PI;
    eye.aspect = camera.size[0] / camera.size[1];
    [eye.near, eye.far] = [NEAR * camera.distance, 50 * camera.distance + 50 * camera.start.distance];
    eye.updateProjectionMatrix();
    const [a, b, c] = this.scene.style.light;
    light.position.fromArray(plus(plus(plus([0, 0, 0], right, a), up, b), back, c));
  }
}

// The 3D library is packed into the page; where a browser cannot unpack it, the still picture stays.
async function unpack(id) {
  const packed = Uint8Array.from(atob(element(id).textContent), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const script = document.createElement("script");
  script.textContent = await new Response(stream).text();
  document.head.append(script);
}

const view = new View(JSON.parse(element("data").textContent));
const started = unpack("library").then(
  () => view.start(),
  () => view.standStill("This browser is too old for the 3D picture: it stands still."),
);
