// Plays what turtles did. Data: see TurtleReplay in turtlesim/replay.py; values are x, y, heading.
(() => {
  const tape = JSON.parse(document.getElementById("data").textContent);
  const [paper, trails] = ["paper", "trails"].map((id) => document.getElementById(id));
  const bodies = [...document.querySelectorAll(".turtle")];
  const cells = [...document.querySelectorAll("#poses tr")].slice(1).map((row) => [...row.cells].slice(1));
  let now = tape.duration, shown = -1, lines = [];

  function showSheet(index) {
    if (index === shown) return;
    shown = index;
    const sheet = tape.sheets[index];
    paper.setAttribute("fill", sheet.color);
    lines = sheet.trails.map((trail) => {
      const line = document.createElementNS("http://www.w3.org/2000/svg", "polyline");
      line.setAttribute("stroke", trail.color);
      line.setAttribute("stroke-width", trail.width);
      return { line, rows: trail.rows, drawn: -2 };
    });
    trails.replaceChildren(...lines.map(({ line }) => line));
  }

  function showTrail(item) {
    const index = rowAt(item.rows, now);
    const isDone = index === item.rows.length - 1;
    if (index === item.drawn && (isDone || index < 0)) return;
    item.drawn = index;
    const points = item.rows.slice(0, index + 1);
    if (index >= 0 && !isDone) points.push(between(item.rows, index, now));
    item.line.setAttribute("points", points.map((row) => `${row[1].toFixed(2)},${row[2].toFixed(2)}`).join(" "));
  }

  function showTurtle(turtle, number) {
    const values = valuesAt(turtle, now);
    bodies[number].style.display = values ? "" : "none";
    if (!values) {
      cells[number].forEach((cell) => { cell.textContent = ""; });
      return;
    }
    const [x, y, heading] = values;
    const [body, name] = bodies[number].children;
    body.setAttribute("transform", `translate(${x} ${y}) rotate(${-heading})`);
    const half = name.getBBox ? name.getBBox().width / 2 + 4 : 0;
    const inside = Math.min(Math.max(x, half), 500 - half);
    name.setAttribute("transform", `translate(${inside} ${y})`);
    name.setAttribute("y", y + 38 < 496 ? 38 : -28);
    const turned = heading - 360 * Math.floor((heading + 180) / 360);
    const readings = [(x - 0.5) / tape.metre, tape.side - (y - 0.5) / tape.metre, turned];
    cells[number].forEach((cell, i) => { cell.textContent = readings[i].toFixed(i < 2 ? 2 : 0); });
  }

  new Player(tape.duration, (time) => {
    now = time;
    const later = tape.sheets.findIndex((sheet) => sheet.since > now);
    showSheet((later < 0 ? tape.sheets.length : Math.max(later, 1)) - 1);
    lines.forEach(showTrail);
    tape.turtles.forEach(showTurtle);
  });
})();
