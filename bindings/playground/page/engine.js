// Runs a worker with the solver. If a question takes too long, the worker ends, and the next question starts another
// worker.
class Engine {
  constructor(module, patience) {
    this.module = module;
    this.patience = patience;
    this.last = 0;
    this.asked = new Map();
    this.queue = Promise.resolve();
    this.start();
  }

  start() {
    const url = URL.createObjectURL(new Blob([document.getElementById("worker").textContent], { type: "text/javascript" }));
    this.worker = new Worker(url);
    this.ready = new Promise((done) => this.asked.set(0, { done }));
    this.worker.onmessage = ({ data }) => this.told(data);
    this.worker.postMessage({ module: this.module });
    this.ready.then(() => URL.revokeObjectURL(url));
  }

  told({ id, answer, broken }) {
    const asked = this.asked.get(id);
    if (!asked) return;
    this.asked.delete(id);
    clearTimeout(asked.timer);
    if (broken) this.stop();
    asked.done(broken ? { error: `the solver stopped at this scene: ${broken}` } : answer);
  }

  // Ends the worker. Every open question gets an answer.
  stop(reason = "a newer question took the place of this one") {
    this.worker.terminate();
    const open = [...this.asked.values()];
    this.asked.clear();
    this.start();
    for (const asked of open) {
      clearTimeout(asked.timer);
      asked.done({ error: reason, stopped: true });
    }
  }

  // Asks a question after all earlier questions.
  ask(question) {
    const turn = this.queue.then(() => this.now(question));
    this.queue = turn.catch(() => {});
    return turn;
  }

  async now(question) {
    // If this worker has ended before it was ready, another worker has replaced it.
    for (let ready = null; ready !== this.ready; await ready) ready = this.ready;
    const id = ++this.last;
    return new Promise((done) => {
      const seconds = this.patience / 1000;
      const timer = setTimeout(() => this.stop(`this takes more than ${seconds} s in a page; the command frictiongen has no such limit`), this.patience);
      this.asked.set(id, { done, timer });
      this.worker.postMessage({ id, question });
    });
  }
}
