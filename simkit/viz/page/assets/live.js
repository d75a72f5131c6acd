// Follows a simulation by a web socket: `hear` gets each message, `say` gets what there is to tell the person.
function follow(address, { hear, say, unreachable }) {
  const ENDED = 4000, LONGEST_WAIT = 5000;
  let wait = 250, wasOpen = false;

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

  connect();
}
