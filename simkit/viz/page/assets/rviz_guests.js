// Objects that a person has added by meshcat's commands: its own viewer keeps them, and our picture shows them.
class Guests {
  constructor(renderer, changed) {
    const room = document.createElement("div"), place = document.createElement("div");
    room.append(place);  // meshcat puts its menu beside the place: into a room that nobody sees
    const load = window.onload;
    this.viewer = new MeshCat.Viewer(place, false, renderer);
    window.onload = load;
    Object.assign(this.viewer, { set_3d_pane_size() {}, set_dirty: changed });
    for (const name of ["Lights", "Grid", "Axes", "Cameras"]) this.viewer.delete_path([name]);
    this.root = this.viewer.scene;
    this.root.background = null;
  }

  show(commands) {
    for (const text of commands) {
      this.viewer.handle_command_bytearray(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)));
    }
  }
}
