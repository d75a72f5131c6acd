// Follows a simulation: its server tells what has moved. See live_news.py.
(() => {
  const ENDED = 4000, LONGEST_WAIT = 5000, place = element("live");
  const say = (words) => { place.textContent = words; };
  let wait = 250, wasOpen = false, told = 0;

  function hear({ scene, news }) {
    if (scene) {
      view.show(scene);
      tell(scene);
    }
    for (const [number, pose] of Object.entries(news.poses || {})) {
      const frame = view.scene.frames[number];
      [frame.p, frame.q] = [pose.slice(0, 3), pose.slice(3)];
    }
    if (news.marks) view.objects?.marks.forEach((marks, i) => marks.show(view.scene.marks[i] = news.marks[i]));
    view.moved();
    if (element("table").open && performance.now() > told + 200) {
      told = performance.now();
      tellNumbers(view.scene.frames);
    }
  }

  function connect() {
    let socket;
    try {
      socket = new WebSocket(address);
    } catch (error) {
      say(unreachable);
      return;
    }
    socket.onopen = () => {
      [wasOpen, wait] = [true, 250];
      say("live: follows the simulation");
    };
    socket.onmessage = (event) => hear(JSON.parse(event.data));
    socket.onclose = (event) => {
      if (event.code >= ENDED) say(`Not live any more: ${event.reason}.`);
      else {
        say(wasOpen ? "Lost the simulation; looking for it again ..." : unreachable);
        wait = Math.min(2 * wait, LONGEST_WAIT);
        setTimeout(connect, wait);
      }
    };
  }

  const address = view.scene.socket;
  const unreachable = "Not live: this browser does not reach the computer where the simulation runs (as on JupyterHub or " +
    "Colab), or the simulation is over. This is how it was when the view was made; " +
    `${view.scene.command} shows how it is now.`;
  connect();
})();
