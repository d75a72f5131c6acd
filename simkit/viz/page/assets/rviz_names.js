// Names of frames beside their origins, on a canvas over the picture, as label_places.py and the still picture.
function drawNames(paper, camera, frames, colors) {
  const paint = paper.getContext("2d"), taken = [], height = 17;
  const ratio = window.devicePixelRatio || 1;
  [paper.width, paper.height] = camera.size.map((length) => Math.round(length * ratio));
  paint.scale(ratio, ratio);
  paint.textBaseline = "middle";
  paint.lineJoin = "round";
  for (const frame of frames) {
    const at = camera.onPaper(frame.p);
    if (!at || at[0] < 0 || at[0] > camera.size[0] || at[1] < 0 || at[1] > camera.size[1]) continue;
    const [x, y] = at;
    paint.font = `${frame.isFixed ? "bold " : ""}13px system-ui, "DejaVu Sans", sans-serif`;
    const width = paint.measureText(frame.label).width;
    const place = freePlace(x, y, width, height, taken, camera.size);
    if (!place) continue;  // nobody can read names on top of each other; nearer there is room
    const [left, middle] = place;
    taken.push([left, middle, width]);
    if (Math.abs(middle - y) > 1.2 * height) {
      paint.strokeStyle = colors.grey;
      paint.lineWidth = 0.8;
      paint.beginPath();
      paint.moveTo(x, y);
      paint.lineTo(left > x ? left - 2 : left + width + 2, middle);
      paint.stroke();
    }
    paint.strokeStyle = colors.sky;
    paint.lineWidth = 3.5;
    paint.strokeText(frame.label, left, middle);
    paint.fillStyle = colors.ink;
    paint.fillText(frame.label, left, middle);
  }
}

function freePlace(x, y, width, height, taken, size) {
  const sides = x + 9 + width <= size[0] ? [x + 9, x - 9 - width] : [x - 9 - width, x + 9];
  const steps = [0, -1, 1, -2, 2, -3, 3, -4, 4, 5, 6, 7, 8];
  const tried = steps.flatMap((step) => sides.map((left) => [left, y + 10 + step * height]));
  const isFree = ([left, middle]) => middle >= height / 2 && middle <= size[1] - height / 2 &&
    taken.every(([l, m, w]) => left >= l + w || l >= left + width || Math.abs(middle - m) >= height);
  return tried.find(isFree);
}
