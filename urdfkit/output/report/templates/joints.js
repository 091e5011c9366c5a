// The positions of the joints, and the sliders that set them.
(function () {
  "use strict";
  const page = window.urdfkit;
  const PRESETS = {
    Zero: (joint) => (joint.limits ? Math.min(Math.max(0, range(joint)[0]), range(joint)[1]) : 0),
    Lower: (joint) => (joint.limits ? range(joint)[0] : 0),
    Middle: (joint) => (joint.limits ? (range(joint)[0] + range(joint)[1]) / 2 : 0),
    Upper: (joint) => (joint.limits ? range(joint)[1] : 0),
    Random: (joint) => range(joint)[0] + Math.random() * (range(joint)[1] - range(joint)[0]),
  };
  const positions = Object.create(null); // of joints that follow none, by name, even __proto__
  const rows = new Map(); // the slider, the field and the unit of each of them
  const box = document.querySelector(".sliders");
  let inDegrees = false;

  function range(joint) {
    const [low, high] = joint.limits || (joint.type === "prismatic" ? [-1, 1] : [-Math.PI, Math.PI]);
    return low < high ? [low, high] : [Math.min(low, high) - 1e-6, Math.max(low, high) + 1e-6];
  }
  function unit(joint) {
    if (joint.type === "prismatic") return { name: "m", size: 1 };
    return inDegrees ? { name: "°", size: Math.PI / 180 } : { name: "rad", size: 1 };
  }
  function button(text, act) {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = page.word(text);
    made.addEventListener("click", () => act(made));
    return made;
  }

  // Where a joint stands; one that follows another is where that says.
  function position(joint) {
    if (joint.leader === undefined) return 0;
    const value = joint.factor * (positions[joint.leader] || 0) + joint.shift;
    return Number.isFinite(value) ? value : 0;
  }
  function set(name, value, by) {
    positions[name] = value;
    const row = rows.get(name);
    if (!row) return;
    if (row.slide !== by) row.slide.value = String(value);
    if (row.field !== by) row.field.value = String(Number((value / unit(row.joint).size).toFixed(5)));
  }
  function measure() {
    for (const { joint, field, of } of rows.values()) {
      of.textContent = unit(joint).name;
      field.setAttribute("aria-label", `${joint.name} / ${unit(joint).name}`);
      set(joint.name, positions[joint.name] || 0);
    }
  }

  function show(joints, moved) {
    box.textContent = "";
    rows.clear();
    const free = joints.filter((joint) => joint.leader === joint.name).sort((a, b) => a.order - b.order);
    if (!free.length) return;
    const buttons = document.createElement("div");
    buttons.className = "buttons";
    for (const [name, preset] of Object.entries(PRESETS)) {
      buttons.append(button(name, () => {
        for (const joint of free) set(joint.name, preset(joint));
        moved();
      }));
    }
    if (free.some((joint) => joint.type !== "prismatic")) {
      const degrees = button("Degrees", () => {
        inDegrees = !inDegrees;
        degrees.setAttribute("aria-pressed", String(inDegrees));
        measure();
      });
      degrees.setAttribute("aria-pressed", String(inDegrees));
      buttons.append(degrees);
    }
    box.append(buttons);
    for (const joint of free) box.append(row(joint, joints, moved));
    measure();
  }
  function row(joint, joints, moved) {
    const made = document.createElement("div");
    made.className = "row";
    made.innerHTML = '<label></label><input type="range" step="any"><input type="number" step="any"><span></span>';
    const [label, slide, field, of] = made.children;
    const after = joints.filter((one) => one.leader === joint.name && one !== joint).map((one) => one.name);
    label.textContent = joint.name;
    label.title = after.length ? `${joint.name} → ${after.join(", ")}` : joint.name;
    [slide.min, slide.max] = range(joint);
    slide.dataset.joint = joint.name;
    slide.setAttribute("aria-label", joint.name);
    for (const input of [slide, field]) {
      input.addEventListener("input", () => {
        const value = Number(input.value) * (input === field ? unit(joint).size : 1);
        if (input.value === "" || !Number.isFinite(value)) return;
        set(joint.name, value, input);
        moved();
      });
    }
    rows.set(joint.name, { joint, slide, field, of });
    return made;
  }

  page.joints = {
    positions,
    position,
    set,
    show,
    reveal: (name) => { if (rows.has(name)) rows.get(name).slide.scrollIntoView({ block: "nearest" }); },
  };
})();
