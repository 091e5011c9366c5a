// The page without the 3D view: colours, filters, and findings that are chosen.
(function () {
  "use strict";
  const root = document.documentElement;
  const known = JSON.parse(document.getElementById("words").textContent);
  const page = (window.urdfkit = { word: (text) => known[text] || text });

  // --- dark and light: as the system has it, unless the reader says otherwise
  const button = document.getElementById("theme");
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  function paint(isDark) {
    root.dataset.theme = isDark ? "dark" : "light";
    button.setAttribute("aria-pressed", String(isDark));
    if (page.repaint) page.repaint();
  }
  function remembered() {
    try { return window.localStorage.getItem("urdfkit-theme"); } catch { return null; }
  }
  paint(remembered() ? remembered() === "dark" : system.matches);
  system.addEventListener("change", (event) => paint(event.matches));
  button.addEventListener("click", () => {
    const isDark = root.dataset.theme !== "dark";
    paint(isDark);
    try { window.localStorage.setItem("urdfkit-theme", isDark ? "dark" : "light"); } catch { /* a file has no storage */ }
  });

  // --- the width of the 3D view
  const divider = document.getElementById("divider");
  if (divider) {
    const split = (x) => root.style.setProperty("--split", `${Math.round(1000 * x / root.clientWidth) / 10}%`);
    divider.addEventListener("pointerdown", (event) => divider.setPointerCapture(event.pointerId));
    divider.addEventListener("pointermove", (event) => { if (event.buttons) split(event.clientX); });
    divider.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: -20, ArrowRight: 20 }[event.key];
      if (by) split(divider.offsetLeft + by);
    });
  }

  // --- the findings that are shown
  let onlyLink = null;
  const links = (finding) => JSON.parse(finding.dataset.links);
  function filter() {
    const form = document.querySelector(".filter");
    if (!form) return;
    const severities = new Set([...form.elements.severity].filter((box) => box.checked).map((box) => box.value));
    const words = form.elements.words.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const finding of document.querySelectorAll(".finding")) {
      const text = finding.textContent.toLowerCase();
      finding.hidden = !severities.has(finding.dataset.severity) || !words.every((word) => text.includes(word))
        || (onlyLink !== null && !links(finding).includes(onlyLink));
    }
    for (const family of document.querySelectorAll(".family")) {
      family.hidden = !family.querySelector(".finding:not([hidden])");
    }
    document.getElementById("all-links").hidden = onlyLink === null;
  }
  page.showLink = (name) => { // what is told of one link; null is for all
    onlyLink = name !== null && [...document.querySelectorAll(".finding")].some((one) => links(one).includes(name)) ? name : null;
    filter();
    const isBeside = window.matchMedia("(min-width: 1100px)").matches; // else the view would scroll away
    if (onlyLink !== null && isBeside) document.getElementById("findings").scrollIntoView({ behavior: "smooth" });
  };
  page.filter = filter;
  page.filters = (kept) => { // what is filtered now; or filter as it was
    const form = document.querySelector(".filter");
    if (!form) return kept || null;
    const boxes = [...form.elements.severity];
    if (!kept) return { off: boxes.filter((box) => !box.checked).map((box) => box.value), words: form.elements.words.value };
    for (const box of boxes) box.checked = !kept.off.includes(box.value);
    form.elements.words.value = kept.words;
    return kept;
  };
  document.addEventListener("input", (event) => { if (event.target.closest(".filter")) filter(); });
  document.addEventListener("submit", (event) => event.preventDefault());

  // --- a click on a finding or a name leads to the 3D view
  page.choose = (finding) => {
    for (const one of document.querySelectorAll(".finding.chosen")) one.classList.remove("chosen");
    if (finding) finding.classList.add("chosen");
  };
  document.addEventListener("click", (event) => {
    if (event.target.id === "all-links") { page.showLink(null); if (page.select) page.select([]); return; }
    if (!page.select) return;
    const name = event.target.closest("button.link");
    const finding = event.target.closest(".finding");
    if (name) {
      if (name.dataset.link !== undefined) page.select([name.dataset.link]);
      else page.selectJoint(name.dataset.joint);
    } else if (finding && !event.target.closest("summary, a") && !String(window.getSelection())) {
      page.choose(finding);
      page.select(links(finding));
    }
  });
  document.addEventListener("keydown", (event) => {
    const finding = event.target.closest && event.target.matches(".finding") ? event.target : null;
    if (event.key === "Enter" && finding && page.select) { page.choose(finding); page.select(links(finding)); }
  });
})();
