// The page: an editor with the findings of urdfkit. Nothing that is opened leaves the browser.
import { xml } from "@codemirror/lang-xml";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { basicSetup, EditorView } from "codemirror";
import { ask, failed } from "./python.js";
import { view } from "./view.js";

const EXAMPLES = ["gazebo_pkg", "mobile_base", "two_link_arm"];
const PAUSE = 400; // ms without a key before the robot is checked
const LONGEST = 100_000; // letters of a link

const element = (id) => document.getElementById(id);
const status = (text) => (element("status").textContent = text);
status("loading Python (8 MB)");

failed(status);

// --- the files: their texts by path, and the one in the editor

let texts = {};
let shown = "";
let report = { diagnostics: [] };
let checked = {}; // the texts that the report is about
let robot; // the file of the robot that is drawn
let drawing = Promise.resolve(); // of one robot after the other

const editor = new EditorView({
  parent: element("editor"),
  extensions: [
    basicSetup,
    xml(),
    lintGutter(),
    EditorView.updateListener.of((update) => {
      if (!update.docChanged || !shown) return;
      texts[shown] = update.state.doc.toString();
      clearTimeout(pause);
      pause = setTimeout(check, PAUSE);
    }),
  ],
});
let pause;

function show(path) {
  shown = ""; // no key was pressed
  editor.dispatch({ changes: { from: 0, to: editor.state.doc.length, insert: texts[path] ?? "" } });
  shown = path;
  element("file").value = path;
  underline();
}

async function open(words) {
  clearTimeout(pause);
  texts = await ask("open", words);
  view.forget();
  const paths = Object.keys(texts);
  if (!paths.length) throw new Error("the file holds no robot");
  element("file").replaceChildren(...paths.map((path) => new Option(path)));
  report = { diagnostics: [] };
  show(words.shown ?? paths.find((path) => /\.(urdf|xacro)$/.test(path)) ?? paths[0]);
  await check();
  if (!words.shown && robot in texts && !report.summary.files.includes(shown)) await turnTo(robot);
}

function turnTo(path) {
  show(path);
  return check();
}

async function check() {
  status("checking");
  const before = { ...texts };
  const path = shown;
  const started = performance.now();
  const tell = (done, all) => path === shown && status(`checking: ${done} of ${all}`);
  const { report: found, expanded, scene } = await ask("check", { texts: before, shown }, tell);
  if (path !== shown) return;
  element("expanded").textContent = expanded;
  if (Object.entries(before).some(([path, text]) => texts[path] !== text)) return; // there is newer text
  report = found;
  report.diagnostics.forEach((finding, number) => (finding.links = scene?.findings[number] ?? []));
  checked = before;
  list();
  draw(scene);
  underline();
  const { error, warning, info } = report.summary;
  const seconds = ((performance.now() - started) / 1000).toFixed(1);
  status(`errors: ${error}, warnings: ${warning}, infos: ${info} (${seconds} s)`);
}

// The robot with its findings; the view stays for one that was there before.
function draw(scene) {
  const stays = scene?.file === robot;
  robot = scene?.file;
  const found = report;
  const { links, joints } = scene?.robot ?? { links: [], joints: [] };
  drawing = drawing.then(() => found === report && view.show?.({ links, joints }, scene?.bodies ?? [], stays)).catch(fails);
}

// --- the findings

// The position of a line and a column in a text; urdfkit counts characters, the editor UTF-16.
function position(doc, line, column) {
  const { from, text } = doc.line(Math.min(line, doc.lines));
  return from + [...text].slice(0, column - 1).join("").length;
}
const range = (doc, place) => ({
  from: position(doc, place.line, place.column),
  to: position(doc, place.end_line, place.end_column),
});

function underline() {
  const { doc } = editor.state;
  const marks = report.diagnostics
    .filter(({ path }) => path === shown)
    .map((finding) => ({
      ...range(doc, finding),
      severity: finding.severity,
      source: finding.code,
      message: finding.help ? `${finding.message}\n${finding.help}` : finding.message,
      actions: finding.fix
        ? [{ name: finding.fix.safe ? "Fix" : "Fix (unsafe)", apply: () => apply(finding.fix) }]
        : [],
    }));
  editor.dispatch(setDiagnostics(editor.state, marks));
}

const SEVERITIES = ["error", "warning", "info"];
function list() { // errors first, as on the command line
  const rank = ({ severity }) => SEVERITIES.indexOf(severity);
  const sorted = [...report.diagnostics].sort((one, other) => rank(one) - rank(other));
  const items = sorted.map((finding) => {
    const item = document.createElement("li");
    item.className = `finding ${finding.severity}`;
    item.dataset.links = JSON.stringify(finding.links);
    const place = document.createElement("small");
    place.textContent = `${finding.path}:${finding.line} ${finding.severity} ${finding.code}`;
    const help = document.createElement("small");
    help.textContent = finding.help;
    item.append(place, finding.message, help);
    item.onclick = () => {
      go(finding);
      if (finding.links.length) view.select?.(finding.links);
    };
    if (finding.fix) {
      const button = document.createElement("button");
      button.textContent = `${finding.fix.safe ? "Fix" : "Fix (unsafe)"}: ${finding.fix.title}`;
      button.onclick = (event) => {
        event.stopPropagation();
        apply(finding.fix);
      };
      item.append(button);
    }
    return item;
  });
  element("findings").replaceChildren(...items);
}

function go(finding) {
  if (!(finding.path in texts)) return;
  if (finding.path !== shown) turnTo(finding.path).catch(fails);
  const { from } = range(editor.state.doc, finding);
  editor.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
  editor.focus();
}

function apply(fix) {
  if (fix.edits.some(({ path }) => texts[path] !== checked[path])) return; // its places have moved
  for (const path of new Set(fix.edits.map((edit) => edit.path))) {
    if (path !== shown) show(path);
    const { doc } = editor.state;
    const edits = fix.edits.filter((edit) => edit.path === path);
    editor.dispatch({ changes: edits.map((edit) => ({ ...range(doc, edit), insert: edit.text })) });
  }
}

document.querySelector("[data-layer=findings]").click();
// The findings of a link that is clicked: the first comes into view; null is no link.
view.showLink = (link) => {
  const items = [...element("findings").children];
  for (const item of items) item.classList.toggle("chosen", JSON.parse(item.dataset.links).includes(link));
  items.find((item) => item.classList.contains("chosen"))?.scrollIntoView({ block: "nearest" });
};

// --- a model in the fragment of the URL, which no server sees: deflated, in base64url

async function piped(bytes, through) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(through)).arrayBuffer());
}
async function packed(model) {
  const text = new TextEncoder().encode(JSON.stringify(model));
  const bytes = await piped(text, new CompressionStream("deflate-raw"));
  const letters = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  return letters.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}
async function unpacked(word) {
  const letters = atob(word.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(await piped(bytes, new DecompressionStream("deflate-raw"))));
}

// --- what a person does

const fails = (error) => status(error.message);
const openExample = (name) => open({ url: `examples/${name}.zip` }).catch(fails);

async function openFile(file) {
  const words = file.name.endsWith(".zip")
    ? { zip: await file.arrayBuffer() }
    : { texts: { [file.name]: await file.text() } };
  await open(words);
}

async function openLink() {
  const word = location.hash.slice(1);
  if (!word) return openExample(EXAMPLES[0]);
  return open(await unpacked(word));
}

element("example").append(...EXAMPLES.map((name) => new Option(name)));
element("example").onchange = ({ target }) => openExample(target.value);
element("file").onchange = ({ target }) => turnTo(target.value).catch(fails);
element("open").onchange = ({ target }) => openFile(target.files[0]).catch(fails);
element("link").onclick = async () => {
  const count = Object.keys(texts).length;
  const whole = await packed({ texts, shown });
  const isWhole = count > 1 && whole.length <= LONGEST;
  const word = isWhole ? whole : await packed({ texts: { [shown.split("/").at(-1)]: texts[shown] } });
  history.replaceState(null, "", `#${word}`);
  await navigator.clipboard?.writeText(location.href).catch(() => {});
  status(`link in the address bar, with ${isWhole ? `${count} texts, without meshes` : "this file alone"}`);
};
document.body.ondragover = (event) => {
  event.preventDefault();
  document.body.classList.add("dragged");
};
document.body.ondragleave = () => document.body.classList.remove("dragged");
document.body.ondrop = (event) => {
  event.preventDefault();
  document.body.classList.remove("dragged");
  if (event.dataTransfer.files.length) openFile(event.dataTransfer.files[0]).catch(fails);
};
window.onhashchange = () => openLink().catch(fails);
openLink().catch(fails);
