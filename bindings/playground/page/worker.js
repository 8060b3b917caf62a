"use strict";
// Runs one instance of the solver. The first message has the compiled module, and each later message a question.
let solver = null;

function answer(question) {
  const bytes = new TextEncoder().encode(JSON.stringify(question));
  const place = solver.room(bytes.length);
  new Uint8Array(solver.memory.buffer, place, bytes.length).set(bytes);
  const length = solver.ask();
  const told = new Uint8Array(solver.memory.buffer, solver.told(), length);
  return JSON.parse(new TextDecoder().decode(told));
}

onmessage = async ({ data }) => {
  if (data.module) {
    solver = (await WebAssembly.instantiate(data.module, {})).exports;
    postMessage({ id: 0 });
    return;
  }
  try {
    postMessage({ id: data.id, answer: answer(data.question) });
  } catch (error) {
    postMessage({ id: data.id, broken: String(error) });
  }
};
