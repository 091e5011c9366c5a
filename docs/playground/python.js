// The worker, in which Python runs.
const worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
const waiting = new Map();
worker.onmessage = ({ data: { id, answer, error, progress } }) => {
  const { resolve, reject, tell } = waiting.get(id);
  if (progress) return tell?.(...progress);
  waiting.delete(id);
  if (error === undefined) resolve(answer);
  else reject(new Error(error));
};
let asked = 0;

// What the worker answers; `tell` is called with what is done, and of how much.
export const ask = (what, words, tell) =>
  new Promise((resolve, reject) => {
    waiting.set(++asked, { resolve, reject, tell });
    worker.postMessage({ id: asked, ask: what, ...words });
  });
export const failed = (told) => { worker.onerror = ({ message }) => told(message ?? "the worker cannot be loaded"); };
