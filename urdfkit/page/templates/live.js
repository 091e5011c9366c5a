// The page as a viewer: it asks for the robot again whenever the server says that it has changed.
(function () {
  "use strict";
  const page = window.urdfkit;
  const status = document.getElementById("status");
  const form = document.getElementById("arguments");
  const content = document.getElementById("content");
  page.revision = 0;

  function tell(text, isBad) {
    status.textContent = text;
    status.classList.toggle("bad", Boolean(isBad));
  }
  function fields(declared) {
    const names = Object.keys(declared);
    form.hidden = !names.length;
    const box = form.querySelector(".fields");
    const kept = document.activeElement && box.contains(document.activeElement) ? document.activeElement.name : null;
    box.textContent = "";
    for (const name of names) {
      const label = document.createElement("label");
      const input = document.createElement("input");
      input.name = name;
      input.value = input.defaultValue = declared[name];
      label.append(name, " ", input);
      box.append(label);
      if (name === kept) input.focus();
    }
  }
  async function refresh() {
    const answer = await fetch("state", { cache: "no-store" });
    const state = await answer.json();
    if (state.revision === page.revision) return;
    const first = page.revision === 0;
    if (!first) {
      const kept = page.filters();
      content.innerHTML = state.content;
      page.filters(kept);
      if (state.model && page.show) await page.show(state.robot, state.model, true);
      page.filter();
      if (page.readFindings) page.readFindings();
    }
    fields(state.declared);
    const time = new Date().toLocaleTimeString();
    if (state.error) tell(state.error, true);
    else if (!state.readable) tell(page.word("The file cannot be read; the 3D view shows it as it was."), true);
    else tell(`${time} · ${state.files} ${page.word("files are watched")}`);
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
      if (input.name && input.value !== input.defaultValue) given[input.name] = input.value;
    }
    await fetch("arguments", { method: "POST", body: JSON.stringify(given) });
  });
})();
