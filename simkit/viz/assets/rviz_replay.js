// Plays what frames did. Data: see RvizReplay in rviz_replay.py; rows are [time, x, y, z, quaternion].
(() => {
  const { duration, tracks } = view.scene.tape, frames = view.scene.frames;
  let told = 0;

  function place(frame, rows, now) {
    const index = rowAt(rows, now);
    frame.isHidden = index < 0;
    if (frame.isHidden) return;
    const [, ...pose] = between(rows, index, now), turn = pose.slice(3), length = Math.hypot(...turn);
    frame.p = pose.slice(0, 3);
    frame.q = turn.map((value) => value / length);
  }

  new Player(duration, (now) => {
    tracks.forEach((rows, i) => place(frames[i], rows, now));
    view.moved();
    const wall = performance.now();
    if (element("table").open && (wall > told + 200 || now === duration)) {
      told = wall;
      tellNumbers(frames);
    }
  });
})();
