// The things of a scene as objects of three.js. Data: see scene_data.py.
const INNER = ["centre", "joint"];  // inside of other shapes, and seen through them

class SceneObjects {
  constructor(THREE, scene) {
    this.three = THREE;
    this.scene = scene;
    this.root = new THREE.Scene();
    this.made = [];
    this.grid = this._grid();
    this.frames = new THREE.Group();
    this.roles = Object.fromEntries(ROLES.map((role) => [role, new THREE.Group()]));
    this._solids();
    this.marks = scene.marks.map((marks) => new MarkObjects(THREE, scene, marks));
    this._rods();
    this.light = new THREE.DirectionalLight(0xffffff, 1 - scene.style.ambient);
    this.root.add(this.grid, this.frames, ...Object.values(this.roles), ...this.marks.map(({ group }) => group));
    this.root.add(this.light, new THREE.AmbientLight(0xffffff, scene.style.ambient));
    this.place();
  }

  // Puts everything where the frames are now.
  place() {
    const { frames, stage } = this.scene, length = stage.axisLength;
    for (const { object, frame } of this.solids) {
      const { p, q, isHidden } = frame === null ? { p: [0, 0, 0], q: [0, 0, 0, 1] } : frames[frame];
      object.visible = !isHidden;
      object.position.fromArray(p);
      object.quaternion.fromArray(q);
    }
    frames.forEach((frame, i) => {
      const isSeen = !frame.isHidden;
      const pose = this._pose(frame.p, frame.q, isSeen ? [length, length, length] : [0, 0, 0]);
      for (const rods of [...this.axes, ...this.ghosts]) rods.setMatrixAt(i, pose);
      this._placeArrow(i, isSeen && frame.parent !== null && !frames[frame.parent].isHidden);
    });
    for (const rods of [...this.axes, ...this.ghosts, this.shafts, this.heads]) {
      rods.instanceMatrix.needsUpdate = true;
    }
  }

  dispose() {
    for (const thing of [...this.made, ...this.marks]) thing.dispose();
  }

  _keep(thing) {
    this.made.push(thing);
    return thing;
  }

  _pose(p, q, scale) {
    const { Matrix4, Vector3, Quaternion } = this.three;
    return new Matrix4().compose(new Vector3(...p), new Quaternion(...q), new Vector3(...scale));
  }

  _grid() {
    const { cell, gridX, gridY } = this.scene.stage, points = [], strong = [];
    for (let x = gridX[0]; x <= gridX[1]; x++) (x ? points : strong).push([x, gridY[0], 0], [x, gridY[1], 0]);
    for (let y = gridY[0]; y <= gridY[1]; y++) (y ? points : strong).push([gridX[0], y, 0], [gridX[1], y, 0]);
    const group = new this.three.Group();
    group.scale.setScalar(cell);
    for (const lines of [points, strong]) {
      const geometry = this._keep(new this.three.BufferGeometry());
      geometry.setAttribute("position", new this.three.Float32BufferAttribute(lines.flat(), 3));
      group.add(new this.three.LineSegments(geometry, this._keep(new this.three.LineBasicMaterial())));
    }
    return group;
  }

  recolor(colors) {
    this.grid.children[0].material.color.set(colors.line);
    this.grid.children[1].material.color.set(colors.zero);
  }

  // Axes, and arrows to the parents. They are drawn after the robot, first what of the axes is inside of it.
  _rods() {
    const { style, frames } = this.scene;
    const rod = (radius, top) => this._keep(new this.three.CylinderGeometry(top, radius, 1, 12));
    const axis = () => rod(style.axisRadius, style.axisRadius).translate(0, 0.5, 0);
    const shapes = [axis().rotateZ(-Math.PI / 2), axis(), axis().rotateX(Math.PI / 2)];
    const many = (geometry, color, order, more = {}) => {
      const material = this._keep(new this.three.MeshLambertMaterial({ color, transparent: true, ...more }));
      const rods = this._keep(new this.three.InstancedMesh(geometry, material, frames.length));
      rods.frustumCulled = false;
      rods.renderOrder = order;
      this.frames.add(rods);
      return rods;
    };
    const hidden = { opacity: style.ghost, depthFunc: this.three.GreaterDepth, depthWrite: false };
    this.ghosts = shapes.map((shape, i) => many(shape, style.axisColors[i], 1, hidden));
    this.axes = shapes.map((shape, i) => many(shape, style.axisColors[i], 2));
    this.shafts = many(rod(style.arrowRadius, style.arrowRadius), style.arrowColor, 2);
    this.heads = many(rod(style.headRadius, 0), style.arrowColor, 2);
  }

  _placeArrow(i, isSeen) {
    const { frames, stage, style } = this.scene, { Vector3, Quaternion } = this.three;
    const start = new Vector3(...frames[i].p);
    const way = isSeen ? new Vector3(...frames[frames[i].parent].p).sub(start) : new Vector3();
    const length = way.length(), size = stage.axisLength;
    const middle = start.addScaledVector(way, 0.5).toArray();
    const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), way.normalize()).toArray();
    const long = length > 2 * style.headLength * size ? size : 0;
    this.shafts.setMatrixAt(i, this._pose(middle, turn, length ? [size, length, size] : [0, 0, 0]));
    this.heads.setMatrixAt(i, this._pose(middle, turn, [long, style.headLength * long, long]));
  }

  // Each shape of the robot hangs in a group that stands where its frame is.
  _solids() {
    const meshes = this.scene.meshes.map((mesh) => this._mesh(mesh));
    this.solids = this.scene.solids.map((solid) => {
      const isClear = solid.alpha < 1, isTouched = solid.role === "collision", isInner = INNER.includes(solid.role);
      const material = this._keep(new this.three.MeshLambertMaterial({
        color: solid.color, opacity: solid.alpha, transparent: isClear || isInner, depthWrite: !isClear,
        polygonOffset: isTouched, polygonOffsetFactor: -1, polygonOffsetUnits: -1, depthTest: !isInner,
      }));
      const body = new this.three.Mesh(this._geometry(solid, meshes), material);
      body.renderOrder = isInner ? 5 : isClear ? 3 : 0;
      body.position.fromArray(solid.p);
      body.quaternion.fromArray(solid.q);
      const object = new this.three.Group();
      object.add(body);
      this.roles[solid.role].add(object);
      return { object, frame: solid.frame, body, solid };
    });
  }

  // Lets one see through what is seen of the links, or not.
  makeClear(isClear) {
    for (const { body, solid } of this.solids) {
      if (solid.role !== "visual" || body.isClear === isClear) continue;
      const alpha = solid.alpha * (isClear ? this.scene.style.clear : 1), { material } = body;
      Object.assign(material, { opacity: alpha, transparent: alpha < 1, depthWrite: alpha === 1, needsUpdate: true });
      Object.assign(body, { isClear, renderOrder: alpha < 1 ? 3 : 0 });
    }
  }

  _geometry({ kind, size }, meshes) {
    const { BoxGeometry, CylinderGeometry, SphereGeometry } = this.three;
    if (kind === "mesh") return meshes[size[0]];
    if (kind === "box") return this._keep(new BoxGeometry(...size));
    if (kind === "sphere") return this._keep(new SphereGeometry(size[0], 40, 20));
    // three.js lays a cylinder along y, URDF along z.
    return this._keep(new CylinderGeometry(size[0], size[0], size[1], 40).rotateX(Math.PI / 2));
  }

  _mesh({ vertices, triangles }) {
    const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
    const shared = this._keep(new this.three.BufferGeometry());
    shared.setAttribute("position", new this.three.BufferAttribute(new Float32Array(bytes(vertices)), 3));
    shared.setIndex(new this.three.BufferAttribute(new Uint32Array(bytes(triangles)), 1));
    const flat = this._keep(shared.toNonIndexed());
    flat.computeVertexNormals();
    return flat;
  }
}
