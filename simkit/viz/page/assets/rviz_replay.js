// Plays what frames did. Data: see RvizReplay in rviz_replay.py; rows are [time, x, y, z, quaternion].
(() => {
  const { duration, tracks, topics, until = [] } = view.scene.tape, frames = view.scene.frames;
  const shown = topics.map(() => undefined);
  let told = 0;

  function place(frame, rows, now, end) {
    const index = rowAt(rows, now);
    frame.isHidden = index < 0 || (end !== undefined && end !== null && now >= end);
    if (frame.isHidden) return;
    const [, ...pose] = between(rows, index, now), turn = pose.slice(3), length = Math.hypot(...turn);
    frame.p = pose.slice(0, 3);
    frame.q = turn.map((value) => value / length);
  }

  // What a display shows at a time: its last moment, or the newest lines of its trail.
  function showTopic({ keep, moments }, number, now) {
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
    tracks.forEach((rows, i) => place(frames[i], rows, now, until[i]));
    topics.forEach((topic, i) => showTopic(topic, i, now));
    view.moved();
    const wall = performance.now();
    if (element("table").open && (wall > told + 200 || now === duration)) {
      told = wall;
      tellNumbers(frames);
    }
  });
})();
