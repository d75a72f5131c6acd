// Points and lines that are others at each moment, as boxes and rods of three.js. Data: see parts.py.
class MarkObjects {
  constructor(THREE, scene, marks) {
    this.three = THREE;
    this.name = marks.name;
    this.group = new THREE.Group();
    const { pointSize, lineWidth } = scene.style, far = scene.stage.camera.distance;
    [this.size, this.width] = [pointSize * far, lineWidth * far];
    const more = marks.through ? { depthTest: false, transparent: true } : {};
    // Two materials: of one with colours of its own three.js makes another program.
    this.isMany = marks.isMany;
    const material = (color) => new THREE.MeshBasicMaterial({ color, ...more });
    this.materials = { box: material(marks.isMany ? "#ffffff" : marks.color), rod: material(marks.color) };
    this.box = new THREE.BoxGeometry(1, 1, 1);
    this.rod = new THREE.CylinderGeometry(0.5, 0.5, 1, 6);
    this.order = marks.through ? 6 : 0;
    this.many = {};
    this.show(marks);
  }

  // Coordinates one after the other, those of each line in a list of their own.
  show({ points, lines, palette, colors }) {
    const size = [this.size, this.size, this.size], boxes = [], rods = [];
    for (let i = 0; i < points.length; i += 3) boxes.push(this._pose(points.slice(i, i + 3), [0, 0, 0, 1], size));
    for (const line of lines) {
      for (let i = 3; i < line.length; i += 3) rods.push(this._rod(line.slice(i - 3, i), line.slice(i, i + 3)));
    }
    this._place("box", boxes);
    if (colors) this._paint(this.many.box, palette.map((color) => new this.three.Color(color)), colors);
    this._place("rod", rods);
  }

  dispose() {
    const made = [this.materials, this.many].flatMap((things) => Object.values(things));
    for (const thing of [this.box, this.rod, ...made]) thing.dispose();
  }

  // Gives each point the colour of the palette that its number says.
  _paint(boxes, palette, numbers) {
    if (!numbers.length) return;
    numbers.forEach((number, i) => boxes.setColorAt(i, palette[number]));
    boxes.instanceColor.needsUpdate = true;
  }

  _rod(start, end) {
    const { Vector3, Quaternion } = this.three;
    const way = new Vector3(...plus(end, start, -1)), length = way.length();
    const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), way.normalize()).toArray();
    return this._pose(plus(start, plus(end, start, -1), 0.5), turn, [this.width, length, this.width]);
  }

  _pose(p, q, scale) {
    const { Matrix4, Vector3, Quaternion } = this.three;
    return new Matrix4().compose(new Vector3(...p), new Quaternion(...q), new Vector3(...scale));
  }

  _place(kind, poses) {
    let things = this.many[kind];
    if (!things || things.room < poses.length) {
      if (things) {
        this.group.remove(things);
        things.dispose();
      }
      const room = Math.max(16, 2 * poses.length);
      things = new this.three.InstancedMesh(this[kind], this.materials[kind], room);
      if (this.isMany && kind === "box") things.setColorAt(0, new this.three.Color());
      Object.assign(things, { room, frustumCulled: false, renderOrder: this.order });
      this.many[kind] = things;
      this.group.add(things);
    }
    poses.forEach((pose, i) => things.setMatrixAt(i, pose));
    things.count = poses.length;
    things.instanceMatrix.needsUpdate = true;
  }
}
