// Python with urdfkit, in a thread of its own. What it is asked: {id, ask, ...}; what it answers:
// {id, answer} or {id, error}. All files are in its memory; it fetches urdfkit, and nothing else.
import { loadPyodide } from "./pyodide/pyodide.mjs";

const fetched = async (name) => {
  const response = await fetch(new URL(name, import.meta.url));
  if (!response.ok) throw new Error(`${name}: ${response.status}`);
  return response.arrayBuffer();
};

const started = (async () => {
  const [python, source] = await Promise.all([loadPyodide(), fetched("python.zip")]);
  python.unpackArchive(source, "zip", { extractDir: "/urdfkit" });
  return python.runPython("import sys; sys.path.append('/urdfkit'); import browser; browser");
})();

const answers = {
  // A package: the URL or the bytes of a zip, or the text of one file. Returns its text files.
  async open(browser, { url, zip, path, text }) {
    browser.clear();
    if (path) browser.write(path, text);
    else browser.unpack(zip ?? (await fetched(url)));
    return JSON.parse(browser.texts());
  },
  // The findings with these texts, by path, and what xacro makes of the file that is shown.
  check(browser, { texts, shown }) {
    for (const [path, text] of Object.entries(texts)) browser.write(path, text);
    return { report: JSON.parse(browser.check()), expanded: browser.expand(shown) };
  },
};

self.onmessage = async ({ data: { id, ask, ...words } }) => {
  try {
    self.postMessage({ id, answer: await answers[ask](await started, words) });
  } catch (error) {
    self.postMessage({ id, error: error.message.trim().split("\n").at(-1) });
  }
};
