// Python with urdfkit, in a thread of its own. What it is asked: {id, ask, ...}; what it answers:
// {id, answer} or {id, error}. All files are in its memory; it fetches urdfkit, and nothing else.
import { loadPyodide } from "./pyodide/pyodide.mjs";

const fetched = async (name) => {
  const response = await fetch(new URL(name, import.meta.url));
  if (!response.ok) throw new Error(`${name}: ${response.status}`);
  return response.arrayBuffer();
};

const python = loadPyodide();
const started = (async () => {
  const source = await fetched("python.zip");
  (await python).unpackArchive(source, "zip", { extractDir: "/urdfkit" });
  const code = "import sys; sys.path.append('/urdfkit'); from docs.playground import browser; browser";
  return (await python).runPython(code);
})();

const answers = {
  // A package: the URL or the bytes of a zip, or the text of one file. Returns its text files.
  async open(browser, { url, zip, path, text }) {
    browser.clear();
    if (path) browser.write(path, text);
    else browser.unpack(zip ?? (await fetched(url)));
    return JSON.parse(browser.texts());
  },
  // With these texts, by path: the findings, what xacro makes of the file that is shown, the robot.
  check(browser, { texts, shown }) {
    for (const [path, text] of Object.entries(texts)) browser.write(path, text);
    return JSON.parse(browser.check(shown));
  },
  // The bytes of a mesh.
  async mesh(_, { path }) {
    return (await python).FS.readFile(path);
  },
};

self.onmessage = async ({ data: { id, ask, ...words } }) => {
  try {
    self.postMessage({ id, answer: await answers[ask](await started, words) });
  } catch (error) {
    self.postMessage({ id, error: error.message.trim().split("\n").at(-1) });
  }
};
