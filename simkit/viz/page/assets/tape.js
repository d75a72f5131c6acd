// Plays a tape: rows are [time, value, ...], straight in between; a button, a slider, a choice of speeds.

// Index of the last row that is not later than a time; -1 before the first.
function rowAt(rows, time) {
  let low = 0, high = rows.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rows[middle][0] <= time) low = middle + 1; else high = middle;
  }
  return low - 1;
}

function between(rows, index, time) {
  const before = rows[index], after = rows[index + 1];
  if (!after || after[0] === before[0]) return before;
  const ratio = (time - before[0]) / (after[0] - before[0]);
  return before.map((value, i) => value + ratio * (after[i] - value));
}

// The values of a track at a time; undefined as long as its thing is not there.
function valuesAt({ rows, until }, time) {
  const index = rowAt(rows, time);
  return index < 0 || (until !== null && time >= until) ? undefined : between(rows, index, time).slice(1);
}

// Calls `show` with each time [s] that is to be seen; begins at the end.
class Player {
  constructor(duration, show) {
    [this.play, this.slider, this.clock, this.speed] =
      ["play", "time", "clock", "speed"].map((id) => document.getElementById(id));
    [this.duration, this.show, this.now, this.isRunning] = [duration, show, duration, false];
    this.play.addEventListener("click", () => this.run(!this.isRunning));
    this.slider.addEventListener("input", () => this.jump(Number(this.slider.value)));
    this.jump(duration);
  }

  jump(time) {
    this.now = time;
    this.show(time);
    this.clock.value = `${time.toFixed(2)} s`;
    this.slider.setAttribute("aria-valuetext", `${time.toFixed(1)} seconds`);
  }

  run(wanted) {
    this.isRunning = wanted;
    this.play.textContent = wanted ? "Pause" : "Play";
    if (!wanted) return;
    if (this.now >= this.duration) this.now = 0;
    this.last = performance.now();
    requestAnimationFrame((time) => this.step(time));
  }

  step(time) {
    if (!this.isRunning) return;
    const passed = (time - this.last) / 1000 * Number(this.speed.value);
    this.last = time;
    this.jump(Math.min(this.now + passed, this.duration));
    this.slider.value = this.now;
    if (this.now >= this.duration) this.run(false); else requestAnimationFrame((next) => this.step(next));
  }
}
