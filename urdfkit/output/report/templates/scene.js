// The robot in three dimensions. Links are placed by the same rule as
// urdfkit.robot.kinematics.frames: world(child) = world(parent) * origin * motion(position),
// parents before children.
(function () {
  "use strict";
  const page = window.urdfkit;
  const stage = document.getElementById("stage");
  const picked = document.getElementById("picked");
  const ACCENT = new THREE.Color(0x1f7cf2), NONE = new THREE.Color(0);
  // As in the images; what has no findings steps back.
  const written = (hex) => new THREE.Color(hex).convertSRGBToLinear();
  const SEVERITIES = { error: written(0xde2121), warning: written(0xff9e0d) };
  const QUIET = written(0xccd1d9);

  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  } catch {
    const note = document.getElementById("no-view");
    note.textContent = page.word("This browser shows no 3D view: it has no WebGL.");
    note.hidden = false;
    page.ready = Promise.resolve(false);
    return;
  }
  renderer.outputEncoding = THREE.sRGBEncoding;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = THREE.VSMShadowMap; // soft edges
  const canvas = renderer.domElement;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application");
  canvas.setAttribute("aria-label", page.word("3D view: arrow keys turn, + and - zoom, Shift and arrow keys move, Home shows all"));
  stage.append(canvas);

  const view = page.orbit(canvas, { changed: draw, pick, release: () => { select([]); page.showLink(null); } });
  const scene = new THREE.Scene();
  // The lamps of the images (urdfkit/render/light.py): they go with the camera.
  const sky = new THREE.HemisphereLight(new THREE.Color(0.5, 0.52, 0.55), new THREE.Color(0.27, 0.265, 0.26), 1);
  sky.position.set(0, 0, 1);
  const sun = new THREE.DirectionalLight(new THREE.Color(1.02, 0.99, 0.94), 1);
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  Object.assign(sun.shadow, { radius: 9, blurSamples: 20, bias: -0.0005 });
  const fillLamp = new THREE.DirectionalLight(new THREE.Color(0.12, 0.125, 0.135), 1);
  const world = new THREE.Group();
  scene.add(sky, sun, fillLamp, sun.target, fillLamp.target, world);

  const layers = {}; // whether each is shown
  for (const box of document.querySelectorAll("[data-layer]")) layers[box.dataset.layer] = box.checked;
  let robot = null; // links and joints
  let groups = []; // of each link
  let surfaces = []; // meshes that can be picked
  let tags = []; // the names of the links
  let whole = null; // the centre of mass of the robot
  let size = 1; // of the robot, in m
  let chosen = new Set(); // numbers of links
  let worst = new Map(); // severity of the findings of a link

  // --- the robot and its pose

  async function show(described, packed, stays) {
    const nodes = await page.surfaces(packed);
    clear();
    robot = described;
    groups = robot.links.map((link) => {
      const group = new THREE.Group();
      group.matrixAutoUpdate = false;
      group.name = link.name;
      world.add(group);
      return group;
    });
    for (const joint of robot.joints) joint.local = new THREE.Matrix4().fromArray(joint.origin);
    fill(nodes);
    pose();
    world.updateMatrixWorld(true);
    const before = size;
    const box = measure();
    view.frame(box, size);
    explain(box);
    page.joints.show(robot.joints, pose);
    readFindings();
    if (!stays || size > 1.5 * before || before > 1.5 * size) view.home();
    select([...chosen].map((number) => robot.links[number] && robot.links[number].name).filter(Boolean), true);
    pose();
  }
  function clear() {
    world.traverse((one) => {
      if (one.geometry) one.geometry.dispose();
      for (const material of [one.material].flat()) if (material) material.dispose();
    });
    world.clear();
    for (const tag of tags) tag.remove();
    whole = null;
    surfaces = [];
    tags = [];
  }
  function fill(nodes) {
    const numbers = new Map(robot.links.map((link, number) => [link.name, number]));
    for (const node of nodes) {
      const number = numbers.get(node.userData.link);
      if (number === undefined) continue;
      node.traverse((one) => {
        if (!one.isMesh) return;
        one.userData.number = number;
        surfaces.push(one);
      });
      groups[number].add(node);
    }
  }
  const motion = new THREE.Matrix4();
  const axis = new THREE.Vector3();
  function pose() {
    for (const joint of robot.joints) {
      const value = page.joints.position(joint);
      axis.fromArray(joint.axis);
      if (joint.type === "prismatic") motion.makeTranslation(axis.x * value, axis.y * value, axis.z * value);
      else motion.makeRotationAxis(axis, value);
      const matrix = groups[joint.child].matrix;
      matrix.multiplyMatrices(groups[joint.parent].matrix, joint.local);
      if (value !== 0) matrix.multiply(motion);
      groups[joint.child].matrixWorldNeedsUpdate = true;
    }
    if (whole) whole.place();
    draw();
  }
  function measure() {
    const box = new THREE.Box3();
    for (const mesh of surfaces) box.expandByObject(mesh);
    for (const group of box.isEmpty() ? groups : []) {
      box.expandByPoint(new THREE.Vector3().setFromMatrixPosition(group.matrix));
    }
    const edge = box.getSize(new THREE.Vector3()).length();
    size = edge > 0 && Number.isFinite(edge) ? edge : 1;
    return box;
  }
  function explain(box) {
    page.overlays.add(robot, groups, size);
    whole = page.overlays.whole(robot, groups, size);
    const ground = page.overlays.ground(size, box.isEmpty() ? 0 : box.min.z);
    world.add(whole.made, ground.made);
    document.getElementById("scale").textContent = `${page.word("grid")} ${Number(ground.step.toPrecision(1))} m`;
    const edges = { left: -size, right: size, bottom: -size, top: size, near: 0.1 * size, far: 5 * size };
    Object.assign(sun.shadow.camera, edges).updateProjectionMatrix();
    tags = robot.links.map((link) => {
      const tag = document.createElement("span");
      tag.className = "tag";
      tag.textContent = link.name;
      return tag;
    });
    stage.append(...tags);
  }

  // --- looks: layers, what is chosen, findings

  function readFindings() {
    worst = new Map();
    for (const severity of ["info", "warning", "error"]) {
      for (const finding of document.querySelectorAll(`.finding.${severity}`)) {
        for (const name of JSON.parse(finding.dataset.links)) worst.set(name, severity);
      }
    }
    refresh();
  }
  function refresh() {
    document.getElementById("legend").hidden = !layers.findings;
    world.traverse((one) => {
      const name = one.userData.layer;
      if (name) one.visible = layers[name] && !one.userData.empty;
    });
    for (const mesh of surfaces) {
      const { material, userData: { role, number, looks } } = mesh;
      const severity = layers.findings && SEVERITIES[worst.get(robot.links[number].name)];
      const marked = layers.findings && (severity || QUIET);
      const isChosen = chosen.has(number);
      const isAside = chosen.size > 0 && !isChosen;
      const isCovered = layers.collision && role === "visual" && !severity;
      mesh.visible = layers[role];
      [material].flat().forEach((paint, part) => {
        const { color, opacity, map, vertexColors } = looks[part];
        paint.color.copy(marked || color);
        paint.map = marked ? null : map;
        paint.vertexColors = !marked && vertexColors;
        paint.emissive.copy(isChosen ? ACCENT : NONE);
        paint.emissiveIntensity = isChosen ? 0.55 : 0;
        paint.opacity = Math.min(opacity, isAside ? 0.3 : isCovered ? 0.6 : 1);
        paint.transparent = paint.opacity < 1;
        paint.depthWrite = role !== "collision" && !isAside;
        paint.needsUpdate = true;
      });
      mesh.castShadow = mesh.receiveShadow = ![material].flat()[0].transparent && !layers.collision;
    }
    draw();
  }
  function select(names, quiet) {
    const wanted = new Set(names);
    chosen = new Set();
    if (robot) robot.links.forEach((link, number) => { if (wanted.has(link.name)) chosen.add(number); });
    picked.textContent = [...chosen].slice(0, 8).map((number) => robot.links[number].name).join(", ");
    if (!quiet && chosen.size === 1) {
      const number = [...chosen][0];
      const joint = robot.joints.find((one) => one.child === number);
      if (joint) picked.textContent += ` ← ${joint.name} (${joint.type})`;
    }
    refresh();
  }
  document.querySelector(".layers").addEventListener("change", (event) => {
    layers[event.target.dataset.layer] = event.target.checked;
    refresh();
  });
  for (const button of document.querySelectorAll("[data-view]")) {
    button.addEventListener("click", () => view.look(button.dataset.view));
  }

  // --- what is under the pointer

  const ray = new THREE.Raycaster();
  function hit(x, y) { // the link at a place of the canvas, in parts of its width and height
    ray.setFromCamera({ x: 2 * x - 1, y: 1 - 2 * y }, view.camera);
    const found = ray.intersectObjects(surfaces.filter((mesh) => mesh.visible), false)[0];
    return found ? robot.links[found.object.userData.number].name : null;
  }
  function pick(event) {
    const box = canvas.getBoundingClientRect();
    const name = hit((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
    select(name === null ? [] : [name]);
    page.showLink(name);
  }

  // --- drawing, when something has changed

  let waits = false;
  function draw() {
    if (waits) return;
    waits = true;
    requestAnimationFrame(paint);
  }
  function paint() {
    waits = false;
    const [width, height] = [stage.clientWidth, stage.clientHeight];
    if (!robot || !width || !height) return;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setSize(width, height, false);
    view.place(width, height);
    light();
    world.traverse((one) => { // ranges of joints do not turn with them
      const joint = one.userData.still;
      if (joint) one.matrix.makeRotationAxis(axis.fromArray(joint.axis), -page.joints.position(joint));
    });
    renderer.render(scene, view.camera);
    placeTags(width, height);
  }
  function light() {
    const [right, up, back] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
    view.camera.matrixWorld.extractBasis(right, up, back);
    const lamps = [[sun, up.z > -0.2 ? 1 : 0, -0.55, 0.12, 0.62], [fillLamp, 0.25, 0.9, 0, 0.45]];
    for (const [lamp, above, x, y, z] of lamps) {
      lamp.position.set(0, 0, above).addScaledVector(right, x).addScaledVector(up, y).addScaledVector(back, z);
      lamp.position.setLength(2 * size).add(view.target);
      lamp.target.position.copy(view.target);
    }
  }
  // Where names would cover one another, those of chosen and of near links are shown.
  function placeTags(width, height) {
    for (const tag of tags) tag.hidden = !layers.names;
    if (!layers.names) return;
    const sizes = tags.map((tag) => [tag.offsetWidth, tag.offsetHeight]);
    const places = tags.map((_, number) => onCanvas(number));
    const order = tags.map((_, number) => number);
    order.sort((a, b) => chosen.has(b) - chosen.has(a) || places[a].depth - places[b].depth);
    const taken = [];
    for (const number of order) {
      const { x, y } = places[number];
      const [wide, high] = sizes[number];
      const [left, top] = [x * width - wide / 2, y * height - high / 2];
      const box = { left, top, right: left + wide, bottom: top + high };
      tags[number].hidden = taken.some((other) => box.left < other.right && other.left < box.right
        && box.top < other.bottom && other.top < box.bottom);
      if (tags[number].hidden) continue;
      taken.push(box);
      tags[number].style.left = `${(100 * x).toFixed(2)}%`;
      tags[number].style.top = `${(100 * y).toFixed(2)}%`;
    }
  }
  function onCanvas(number) { // where the origin of a link is, in parts of the canvas
    const at = new THREE.Vector3().setFromMatrixPosition(groups[number].matrix).project(view.camera);
    return { x: (at.x + 1) / 2, y: (1 - at.y) / 2, depth: at.z };
  }
  new ResizeObserver(draw).observe(stage);
  window.addEventListener("beforeprint", paint);

  // --- for the rest of the page, and for what drives it from outside

  const numberOf = (name) => robot.links.findIndex((link) => link.name === name);
  Object.assign(page, {
    show,
    readFindings,
    repaint: draw,
    select: (names) => select(names),
    selectJoint: (name) => {
      const joint = robot.joints.find((one) => one.name === name);
      if (!joint) return;
      select([robot.links[joint.child].name]);
      page.joints.reveal(name);
    },
    move: (name, value) => { page.joints.set(name, value); pose(); },
    positions: page.joints.positions,
    hit,
    frame: (name) => groups[numberOf(name)].matrix.toArray(),
    chosen: () => [...chosen].map((number) => robot.links[number].name),
    project: (name) => { const { x, y } = onCanvas(numberOf(name)); return [x, y]; },
  });
  page.ready = show(
    JSON.parse(document.getElementById("robot").textContent),
    document.getElementById("model").textContent,
  ).then(() => { paint(); return true; });
})();
