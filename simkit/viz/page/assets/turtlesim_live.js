// The window of turtlesim as it is now. See turtlesim/view.py.
(() => {
  const [data, place, picture] = ["data", "live", "window"].map((id) => document.getElementById(id));
  follow(JSON.parse(data.textContent).socket, {
    hear: ({ svg }) => picture.replaceChildren(new DOMParser().parseFromString(svg, "image/svg+xml").documentElement),
    say: (words) => { place.textContent = words; },
    unreachable: "Not live: the simulation is over. This is how it was at its beginning.",
  });
})();
