// Follows a simulation: its server, or the widget around the page, sends what has moved. See scene_data.py.
(() => {
  const place = element("live");
  let written = 0;

  function hear({ scene, changes }) {
    if (scene) {
      view.show(scene);
      tell(scene);
    }
    for (const [number, pose] of Object.entries(changes.poses || {})) {
      const frame = view.scene.frames[number];
      [frame.p, frame.q] = [pose.slice(0, 3), pose.slice(3)];
    }
    if (changes.marks) view.objects?.marks.forEach((marks, i) => marks.show(view.scene.marks[i] = changes.marks[i]));
    view.moved();
    if (element("table").open && performance.now() > written + 200) {
      written = performance.now();
      tellNumbers(view.scene.frames);
    }
  }

  const unreachable = "Not live: this browser does not reach the computer where the simulation runs (as on JupyterHub or " +
    "Colab), or the simulation is over. This is how it was when the view was made; " +
    `${view.scene.command} shows how it is now.`;
  const say = (words) => { place.textContent = words; };
  if (view.scene.socket) follow(view.scene.socket, { hear, say, unreachable });
  else listen(say);

  // The widget sends a scene before the moments that belong to it.
  function listen(say) {
    let number = 0;
    addEventListener("message", ({ data, source }) => {
      if (source !== parent) return;
      if (data?.live) say("live: follows the simulation");
      if (data?.scene) {
        const found = JSON.parse(data.scene);
        ({ number } = found);
        hear(found);
      }
      const moment = data?.moment && JSON.parse(data.moment);
      if (moment?.number === number) hear(moment);
      if (data?.meshcat) view.invite(JSON.parse(data.meshcat));
      if (data?.status) say(data.status);
    });
  }
})();
