// A filter above the tables of all rules: words of their code, name or text, the severity, and the
// target, for which a rule may have another severity or say nothing. The address holds the filter.
document.addEventListener("DOMContentLoaded", () => {
  const data = document.querySelector("script#targets");
  if (!data) return;
  const targets = JSON.parse(data.textContent);
  const tables = [...document.querySelectorAll("table")];
  for (const row of tables.flatMap((table) => [...table.tBodies[0].rows])) {
    row.dataset.severity = row.cells[2].textContent;
  }
  const blockOf = (table) => table.closest(".md-typeset__scrollwrap") ?? table;

  const choice = (name, any, words) =>
    `<select class="md-input" name="${name}" aria-label="${name}"><option value="">${any}</option>` +
    `${words.map((word) => `<option>${word}</option>`).join("")}</select> `;
  const form = document.createElement("form");
  form.id = "filter";
  form.innerHTML =
    '<input class="md-input" name="text" type="search" placeholder="Filter rules" aria-label="text"> ' +
    choice("severity", "any severity", ["error", "warning", "info"]) +
    choice("target", "any target", Object.keys(targets)) +
    "<output></output>";

  const show = () => {
    const { text, severity, target } = form.elements;
    const words = text.value.toLowerCase().split(/\s+/);
    const severities = targets[target.value] ?? {};
    let shown = 0;
    for (const table of tables) {
      let any = false;
      for (const row of table.tBodies[0].rows) {
        const own = severities[row.cells[0].textContent] ?? row.dataset.severity;
        row.cells[2].textContent = own;
        const line = row.textContent.toLowerCase();
        const fits = words.every((word) => line.includes(word));
        row.hidden = !(own && fits && (!severity.value || own === severity.value));
        any ||= !row.hidden;
        shown += !row.hidden;
      }
      blockOf(table).hidden = !any;
      blockOf(table).previousElementSibling.hidden = !any;
    }
    form.querySelector("output").value = `${shown} rules`;
  };

  const keep = () => {
    const chosen = [...new FormData(form)].filter(([, value]) => value);
    const query = new URLSearchParams(chosen).toString();
    history.replaceState(null, "", query ? `?${query}` : location.pathname);
  };

  for (const [name, value] of new URLSearchParams(location.search)) {
    if (form.elements[name]) form.elements[name].value = value;
  }
  form.addEventListener("input", () => {
    show();
    keep();
  });
  form.addEventListener("submit", (event) => event.preventDefault());
  blockOf(tables[0]).previousElementSibling.before(form);
  show();
});
