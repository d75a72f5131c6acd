// Plays what frames and displays did. Data: see SceneReplay in tape.py; values are x, y, z, quaternion.
(() => {
  const { duration, tracks, marks } = view.scene.tape, frames = view.scene.frames;
  const shown = marks.map(() => undefined);
  let written = 0;

  function place(frame, track, now) {
    const pose = valuesAt(track, now);
    frame.isHidden = !pose;
    if (!pose) return;
    const turn = pose.slice(3), length = Math.hypot(...turn);
    frame.p = pose.slice(0, 3);
    frame.q = turn.map((value) => value / length);
  }

  // What a display shows at a time: its last moment, or the newest lines of its trail.
  function showMarks({ keep, moments }, number, now) {
    let index = 0;
    while (index < moments.length && moments[index].time <= now) index++;
    if (index === shown[number]) return;
    shown[number] = index;
    const nothing = { points: [], lines: [], palette: [], colors: [] };
    const lines = () => moments.slice(0, index).flatMap((moment) => moment.lines).slice(-keep);
    view.scene.marks[number] = Object.assign(
      {}, view.scene.marks[number], index ? moments[index - 1] : nothing, keep ? { lines: lines() } : {},
    );
    view.objects?.marks[number].show(view.scene.marks[number]);
  }

  new Player(duration, (now) => {
    tracks.forEach((track, i) => place(frames[i], track, now));
    marks.forEach((track, i) => showMarks(track, i, now));
    view.moved();
    const wall = performance.now();
    if (element("table").open && (wall > written + 200 || now === duration)) {
      written = wall;
      tellNumbers(frames);
    }
  });
})();
