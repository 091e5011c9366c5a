// A filter above the tables of all rules: words of their code, name or text, and the severity.
document.addEventListener("DOMContentLoaded", () => {
  const tables = [...document.querySelectorAll("table")].filter(
    (table) => table.tHead?.innerText.trim().toLowerCase().startsWith("code"),
  );
  if (!document.location.pathname.endsWith("/rules/") || tables.length === 0) return;
  const form = document.createElement("form");
  form.innerHTML =
    '<input class="md-input" type="search" placeholder="Filter rules" aria-label="Filter rules">' +
    '<select class="md-input" aria-label="Severity"><option value="">any severity</option>' +
    "<option>error</option><option>warning</option><option>info</option></select> <output></output>";
  const [words, severity, count] = form.elements;
  const show = () => {
    const wanted = words.value.toLowerCase().split(/\s+/);
    let shown = 0;
    for (const table of tables) {
      let any = false;
      for (const row of table.tBodies[0].rows) {
        const text = row.innerText.toLowerCase();
        const fits = wanted.every((word) => text.includes(word));
        const isOfSeverity = !severity.value || row.cells[2].innerText === severity.value;
        row.hidden = !(fits && isOfSeverity);
        any ||= !row.hidden;
        shown += !row.hidden;
      }
      const block = table.closest(".md-typeset__scrollwrap") ?? table;
      block.hidden = !any;
      if (block.previousElementSibling) block.previousElementSibling.hidden = !any;
    }
    count.value = `${shown} rules`;
  };
  form.addEventListener("input", show);
  form.addEventListener("submit", (event) => event.preventDefault());
  (tables[0].closest(".md-typeset__scrollwrap") ?? tables[0]).previousElementSibling.before(form);
  show();
});
