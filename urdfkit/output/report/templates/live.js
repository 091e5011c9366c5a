// The page as a viewer: it asks for the robot again whenever the server says that it has changed.
(function () {
  "use strict";
  const page = window.urdfkit;
  const status = document.getElementById("status");
  const form = document.getElementById("arguments");
  const content = document.getElementById("content");
  const nav = document.querySelector("nav ul");
  const known = new Map(); // the source of each section, as the server sent it
  for (const section of content.children) known.set(section.id, section.outerHTML);
  page.revision = 0;
  let shape = document.getElementById("live").dataset.shape; // the number of the robot in the 3D view

  function tell(text, isBad) {
    status.textContent = text;
    status.classList.toggle("bad", Boolean(isBad));
  }
  let listed = ""; // the arguments that have fields: what is being typed there stays
  function fields(declared) {
    if (listed === JSON.stringify(declared)) return;
    listed = JSON.stringify(declared);
    const names = Object.keys(declared);
    form.hidden = !names.length;
    const box = form.querySelector(".fields");
    const kept = document.activeElement && box.contains(document.activeElement) ? document.activeElement.name : null;
    box.textContent = "";
    for (const name of names) {
      const label = document.createElement("label");
      const input = field(declared[name]);
      input.name = name;
      input.dataset.was = declared[name];
      label.append(name, " ", input);
      box.append(label);
      if (name === kept) input.focus();
    }
  }
  function field(value) {
    const input = document.createElement(/^(true|false)$/i.test(value) ? "select" : "input");
    if (input.tagName === "SELECT") {
      const spelt = value[0] === value[0].toUpperCase() ? ["True", "False"] : ["true", "false"];
      input.append(...spelt.map((word) => new Option(word)));
      input.addEventListener("change", () => form.requestSubmit());
    }
    input.value = value;
    return input;
  }
  // Sections that are as they were stay: what the reader has opened, chosen and scrolled to, too.
  function renew(html) {
    const fresh = document.createElement("template");
    fresh.innerHTML = html;
    const sections = [...fresh.content.children];
    const wanted = new Set(sections.map((section) => section.id));
    for (const old of [...content.children]) if (!wanted.has(old.id)) old.remove();
    sections.forEach((section, number) => {
      const source = section.outerHTML;
      const there = content.children[number];
      if (there && there.id === section.id) {
        if (known.get(section.id) !== source) there.replaceWith(section);
      } else content.insertBefore(section, there || null);
      known.set(section.id, source);
    });
    nav.replaceChildren(...sections.map((section) => {
      const [item, link] = [document.createElement("li"), document.createElement("a")];
      link.href = `#${section.id}`;
      link.textContent = section.querySelector("h2").textContent;
      item.append(link);
      return item;
    }));
  }
  async function refresh() {
    const answer = await fetch(`state?shown=${shape}`, { cache: "no-store" });
    const state = await answer.json();
    if (state.revision === page.revision) return;
    const kept = page.filters();
    renew(state.content);
    page.filters(kept);
    if (state.model && page.show) await page.show(state.robot, state.model, true);
    page.filter();
    if (page.readFindings) page.readFindings();
    shape = state.shape;
    fields(state.declared);
    const time = new Date().toLocaleTimeString();
    if (state.error) tell(state.error, true);
    else if (!state.readable) tell(page.word("The file cannot be read; the 3D view shows the last state."), true);
    else if (!state.whole) tell(`${time} · ${page.word("computing statics, collisions and images")} …`);
    else tell(`${time} · ${page.word("watched files")}: ${state.files}`);
    page.revision = state.revision;
  }
  let turn = Promise.resolve();
  const events = new EventSource("events");
  events.addEventListener("message", () => { turn = turn.then(refresh).catch((error) => tell(String(error), true)); });
  events.addEventListener("error", () => tell(page.word("The viewer has stopped."), true));

  form.addEventListener("submit", async (event) => {
    event.preventDefault();
    const given = {}; // what is not touched keeps its value
    for (const input of form.elements) {
      if (input.name && input.value !== input.dataset.was) given[input.name] = input.value;
    }
    await fetch("arguments", { method: "POST", body: JSON.stringify(given) });
  });
})();
