// Work in small pieces: first what the eye waits for, then the rest, a few milliseconds a frame.
const BUDGET = 6; // ms
const SHARES = new Map(); // name of a task -> generator, in order of urgency
let frame = 0, lastWork = 0;

/** Begin a task anew: a generator that yields wherever it may be interrupted. */
function begin(name, generator) {
  SHARES.delete(name);
  SHARES.set(name, generator);
  wake();
}

function wake() {
  frame ||= requestAnimationFrame(work);
}

let urgent = null;

/** Have `update` called in the next frame, once however often this is asked. */
function soon(update) {
  urgent = update;
  wake();
}

function work() {
  frame = 0;
  const started = performance.now();
  if (urgent) {
    const update = urgent;
    urgent = null;
    update();
  }
  while (SHARES.size && performance.now() - started < BUDGET) {
    const [name, task] = SHARES.entries().next().value;
    if (task.next().done && SHARES.get(name) === task) SHARES.delete(name);
  }
  lastWork = performance.now() - started;
  if (SHARES.size || urgent) wake();
}
