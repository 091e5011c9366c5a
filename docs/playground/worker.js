// Python with urdfkit, in a thread of its own. What it is asked: {id, ask, ...}; what it answers:
// {id, answer} or {id, error}, and before it {id, progress}. All files are in its memory; it fetches
// urdfkit, and nothing else.
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
  // A package: the URL or the bytes of a zip, or texts by path. Returns its text files.
  async open(browser, { url, zip, texts }) {
    browser.clear();
    for (const [path, text] of Object.entries(texts ?? {})) browser.write(path, text);
    if (!texts) browser.unpack(zip ?? (await fetched(url)));
    return JSON.parse(browser.texts());
  },
  // With these texts, by path: the findings, what xacro makes of the file that is shown, the robot.
  check(browser, { texts, shown }, tell) {
    for (const [path, text] of Object.entries(texts)) browser.write(path, text);
    return JSON.parse(browser.check(shown, tell));
  },
  // The bytes of a mesh or an image, and of the files that it names, by name.
  async mesh(browser, { path }) {
    const { FS } = await python;
    const named = Object.entries(JSON.parse(browser.named(path)));
    const files = named.map(([name, place]) => [name, FS.readFile(place)]);
    return { bytes: FS.readFile(path), files: Object.fromEntries(files) };
  },
};

self.onmessage = async ({ data: { id, ask, ...words } }) => {
  const tell = (...progress) => self.postMessage({ id, progress });
  try {
    self.postMessage({ id, answer: await answers[ask](await started, words, tell) });
  } catch (error) {
    self.postMessage({ id, error: error.message.trim().split("\n").at(-1) });
  }
};
