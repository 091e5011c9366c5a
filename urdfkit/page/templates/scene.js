// The robot in three dimensions. Links are placed by the same rule as urdfkit.mechanics.kinematics.frames:
// world(child) = world(parent) * origin * motion(position), parents before children.
(function () {
  "use strict";
  const page = window.urdfkit;
  const stage = document.getElementById("stage");
  const picked = document.getElementById("picked");
  const { position } = page.joints;
  const layers = {};
  for (const box of document.querySelectorAll("[data-layer]")) layers[box.dataset.layer] = box.checked;

  const DARKEST = 0.02; // of paint, in linear light

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
  const canvas = renderer.domElement;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application");
  canvas.setAttribute("aria-label", page.word("3D view: arrow keys turn, + and - zoom, Shift and arrow keys move, Home shows all"));
  stage.append(canvas);

  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(40, 1, 0.01, 100);
  camera.up.set(0, 0, 1);
  const sky = new THREE.HemisphereLight(0xffffff, 0x6a6f78, 0.5);
  sky.position.set(0, 0, 1);
  const sun = new THREE.DirectionalLight(0xfff8ec, 0.4);
  const lamp = new THREE.DirectionalLight(0xffffff, 0.16); // goes with the camera
  scene.add(sky, sun, lamp, lamp.target, sun.target);
  const world = new THREE.Group();
  scene.add(world);

  let robot = null; // links and joints
  let groups = []; // of each link
  let surfaces = []; // meshes that can be picked
  let tags = [];
  let size = 1; // of the robot, in m
  let chosen = new Set();
  let worst = new Map(); // severity of the findings of a link

  // --- joints

  const motion = new THREE.Matrix4();
  const axis = new THREE.Vector3();
  function pose() {
    for (const joint of robot.joints) {
      const value = position(joint);
      axis.fromArray(joint.axis);
      if (joint.type === "prismatic") motion.makeTranslation(axis.x * value, axis.y * value, axis.z * value);
      else motion.makeRotationAxis(axis, value);
      const matrix = groups[joint.child].matrix;
      matrix.multiplyMatrices(groups[joint.parent].matrix, joint.local);
      if (value !== 0) matrix.multiply(motion);
      groups[joint.child].matrixWorldNeedsUpdate = true;
    }
    const whole = world.getObjectByName("whole");
    if (whole) placeWhole(whole);
    draw();
  }

  // --- the model

  async function unpack(text) {
    const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
  }
  function parsed(buffer) {
    return new Promise((resolve, reject) => new THREE.GLTFLoader().parse(buffer, "", resolve, reject));
  }
  async function show(described, packed, stays) {
    const gltf = await parsed(await unpack(packed));
    world.clear();
    for (const tag of tags) tag.remove();
    robot = described;
    surfaces = [];
    tags = [];
    groups = robot.links.map((link) => {
      const group = new THREE.Group();
      group.matrixAutoUpdate = false;
      group.name = link.name;
      world.add(group);
      return group;
    });
    for (const joint of robot.joints) joint.local = new THREE.Matrix4().fromArray(joint.origin);
    const numbers = new Map(robot.links.map((link, number) => [link.name, number]));
    for (const node of [...gltf.scene.children]) {
      const number = numbers.get(node.userData.link);
      if (number === undefined) continue;
      node.traverse((one) => {
        if (!one.isMesh) return;
        one.geometry = shaded(widen(one.geometry));
        one.material = plain(one.material);
        one.userData = { ...node.userData, number, color: one.material.color.clone(), opacity: one.material.opacity };
        if (one.userData.role === "collision") { Object.assign(one.material, { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 }); one.renderOrder = 1; }
        surfaces.push(one);
      });
      groups[number].add(node);
    }
    pose();
    world.updateMatrixWorld(true);
    measure();
    helpers();
    page.joints.show(robot.joints, pose);
    readFindings();
    if (!stays) home();
    select([...chosen].map((number) => robot.links[number] && robot.links[number].name).filter(Boolean), true);
    pose();
  }
  // Without the model of metals and roughness: a machine without a graphics card draws it, too.
  // No paint is blacker than coal, and it shines: black parts are told apart from one another.
  function plain({ color, map, opacity, transparent, vertexColors }) {
    const [r, g, b] = color.toArray().map((part) => Math.max(part, DARKEST));
    return new THREE.MeshPhongMaterial({
      color: new THREE.Color(r, g, b), map, opacity, transparent, vertexColors,
      specular: 0x2c2e32, shininess: 28, side: THREE.DoubleSide,
    });
  }
  function shaded(geometry) { // without normals every face is flat
    if (geometry.attributes.normal) return geometry;
    const flat = geometry.toNonIndexed();
    flat.computeVertexNormals();
    return flat;
  }
  // This three.js finds what is under the pointer only where positions are plain numbers.
  function widen(geometry) {
    const { array, normalized, isInterleavedBufferAttribute, count } = geometry.attributes.position;
    if (!normalized) return geometry;
    const stride = isInterleavedBufferAttribute ? geometry.attributes.position.data.stride : 3;
    const plain = new Float32Array(3 * count);
    for (let i = 0; i < 3 * count; i++) plain[i] = array[Math.floor(i / 3) * stride + (i % 3)] / 65535;
    geometry.setAttribute("position", new THREE.BufferAttribute(plain, 3));
    return geometry;
  }
  function measure() {
    const box = new THREE.Box3();
    for (const mesh of surfaces) box.expandByObject(mesh);
    for (const group of groups) box.expandByPoint(new THREE.Vector3().setFromMatrixPosition(group.matrix));
    const edge = box.getSize(new THREE.Vector3()).length();
    size = edge > 0 && Number.isFinite(edge) ? edge : 1;
    camera.userData.box = box;
  }

  // --- what is drawn besides

  function helpers() {
    const grid = new THREE.GridHelper(Math.max(1, Math.ceil(2 * size)), 2 * Math.max(1, Math.ceil(2 * size)), 0x808890, 0x808890);
    grid.rotation.x = Math.PI / 2;
    grid.position.z = Math.min(0, camera.userData.box.min.z);
    grid.material.transparent = true;
    grid.material.opacity = 0.25;
    world.add(grid);
    robot.links.forEach((link, number) => {
      layer("frames", number, new THREE.AxesHelper(0.08 * size));
      const tag = document.createElement("span");
      tag.className = "tag";
      tag.textContent = link.name;
      stage.append(tag);
      tags.push(tag);
      if (!link.mass) return;
      const ball = new THREE.Mesh(new THREE.SphereGeometry(1, 16, 12), over(0xd0342c));
      ball.scale.setScalar(Math.cbrt(link.mass / heaviest()) * 0.018 * size);
      ball.position.fromArray(link.center);
      layer("mass", number, ball);
      const box = inertiaBox(link);
      if (box) layer("inertia", number, box);
    });
    for (const joint of robot.joints) {
      if (joint.leader === undefined) continue;
      const color = joint.leader === joint.name ? 0x1a8f4a : 0x9a6a00;
      const arrow = new THREE.ArrowHelper(new THREE.Vector3().fromArray(joint.axis), new THREE.Vector3(), 0.14 * size, color, 0.03 * size, 0.016 * size);
      arrow.line.material.depthTest = arrow.cone.material.depthTest = false;
      layer("axes", joint.child, arrow);
      if (joint.limits && joint.type === "revolute") layer("axes", joint.child, arc(joint, color));
    }
    const whole = new THREE.Mesh(new THREE.SphereGeometry(0.014 * size, 16, 12), over(0x7a2cd0));
    whole.name = "whole";
    whole.userData.layer = "mass";
    world.add(whole);
    refresh();
  }
  function heaviest() { return Math.max(...robot.links.map((link) => link.mass || 0)); }
  function over(color) { return new THREE.MeshBasicMaterial({ color, depthTest: false, transparent: true, opacity: 0.85 }); }
  function layer(name, number, object) {
    object.userData.layer = name;
    object.renderOrder = 2;
    groups[number].add(object);
  }
  // The range of a revolute joint, in the frame of its child at zero: it must not turn with it.
  function arc(joint, color) {
    const along = new THREE.Vector3().fromArray(joint.axis);
    const start = new THREE.Vector3(Math.abs(along.x) > 0.9 ? 0 : 1, Math.abs(along.x) > 0.9 ? 1 : 0, 0).cross(along).normalize();
    const [low, high] = joint.limits;
    const span = Math.min(high - low, 2 * Math.PI);
    const points = [];
    for (let step = 0; step <= 48; step++) {
      points.push(start.clone().applyAxisAngle(along, low + (span * step) / 48).multiplyScalar(0.07 * size));
    }
    const line = new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), new THREE.LineBasicMaterial({ color, depthTest: false, transparent: true }));
    line.userData.still = joint;
    line.matrixAutoUpdate = false;
    return line;
  }
  function inertiaBox(link) {
    if (!link.box || Math.max(...link.box.edges) > 1000 * size) return null;
    const edges = link.box.edges.map((edge) => Math.max(edge, 1e-4 * size));
    const box = new THREE.Mesh(new THREE.BoxGeometry(...edges), new THREE.MeshBasicMaterial({ color: 0xb04ad0, transparent: true, opacity: 0.3, depthWrite: false }));
    box.matrixAutoUpdate = false;
    box.matrix.fromArray(link.box.matrix);
    return box;
  }
  function placeWhole(ball) {
    const center = new THREE.Vector3();
    let mass = 0;
    robot.links.forEach((link, number) => {
      if (!link.mass) return;
      center.addScaledVector(new THREE.Vector3().fromArray(link.center).applyMatrix4(groups[number].matrix), link.mass);
      mass += link.mass;
    });
    ball.userData.empty = mass === 0;
    if (mass > 0) ball.position.copy(center.multiplyScalar(1 / mass));
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
    const accent = new THREE.Color(0x1f7cf2);
    const colors = { error: new THREE.Color(0xe0392f), warning: new THREE.Color(0xf0a818) };
    world.traverse((one) => {
      const name = one.userData.layer;
      if (name) one.visible = layers[name] && !one.userData.empty;
    });
    for (const mesh of surfaces) {
      const { role, number, color, opacity } = mesh.userData;
      const name = robot.links[number].name;
      const marked = layers.findings && colors[worst.get(name)];
      const isChosen = chosen.has(number);
      mesh.visible = layers[role];
      mesh.material.color.copy(marked || color);
      mesh.material.emissive.copy(isChosen ? accent : new THREE.Color(0));
      mesh.material.emissiveIntensity = isChosen ? 0.55 : 0;
      const faint = (chosen.size && !isChosen) || (layers.collision && role === "visual");
      mesh.material.opacity = faint ? Math.min(opacity, chosen.size && !isChosen ? 0.3 : 0.6) : opacity;
      mesh.material.transparent = mesh.material.opacity < 1;
      mesh.material.depthWrite = role !== "collision" && !(chosen.size && !isChosen);
      mesh.material.needsUpdate = true;
    }
    draw();
  }
  function select(names, quiet) {
    const wanted = new Set(names);
    chosen = new Set();
    if (robot) robot.links.forEach((link, number) => { if (wanted.has(link.name)) chosen.add(number); });
    picked.textContent = chosen.size ? [...chosen].slice(0, 8).map((number) => robot.links[number].name).join(", ") : "";
    if (!quiet && chosen.size === 1) {
      const number = [...chosen][0];
      const joint = robot.joints.find((one) => one.child === number);
      if (joint) picked.textContent += ` ← ${joint.name} (${joint.type})`;
    }
    refresh();
  }
  page.select = (names) => select(names);
  page.selectJoint = (name) => {
    const joint = robot.joints.find((one) => one.name === name);
    if (!joint) return;
    select([robot.links[joint.child].name]);
    page.joints.reveal(name);
  };
  document.querySelector(".layers").addEventListener("change", (event) => {
    layers[event.target.dataset.layer] = event.target.checked;
    refresh();
  });

  // --- the camera: turns about the vertical, so that up stays up

  const target = new THREE.Vector3();
  const orbit = { azimuth: 0.8, elevation: 0.4, distance: 3 };
  const VIEWS = { iso: [0.8, 0.4], front: [0, 0], left: [Math.PI / 2, 0], top: [0, Math.PI / 2] };
  function home() {
    const box = camera.userData.box;
    if (!box || box.isEmpty()) return;
    box.getCenter(target);
    camera.aspect = stage.clientWidth / (stage.clientHeight || 1) || 1;
    const half = Math.min(camera.fov, 2 * Math.atan(Math.tan((camera.fov * Math.PI) / 360) * camera.aspect) * (180 / Math.PI));
    orbit.distance = (0.5 * size) / Math.sin((half * Math.PI) / 360);
    draw();
  }
  function turn(by, up) {
    orbit.azimuth += by;
    orbit.elevation = Math.min(Math.max(orbit.elevation + up, -Math.PI / 2), Math.PI / 2);
    draw();
  }
  function zoom(factor) {
    orbit.distance = Math.min(Math.max(orbit.distance * factor, 0.02 * size), 30 * size);
    draw();
  }
  function shift(right, up) {
    const [x, y] = [new THREE.Vector3(), new THREE.Vector3()];
    camera.matrix.extractBasis(x, y, new THREE.Vector3());
    target.addScaledVector(x, -right * orbit.distance).addScaledVector(y, up * orbit.distance);
    draw();
  }
  for (const button of document.querySelectorAll("[data-view]")) {
    button.addEventListener("click", () => { [orbit.azimuth, orbit.elevation] = VIEWS[button.dataset.view]; home(); });
  }
  canvas.addEventListener("keydown", (event) => {
    const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] || [0, 0];
    if (x || y) { if (event.shiftKey) shift(-0.05 * x, -0.05 * -y); else turn(0.1 * x, 0.1 * y); }
    else if (event.key === "+" || event.key === "=") zoom(0.9);
    else if (event.key === "-") zoom(1 / 0.9);
    else if (event.key === "Home") home();
    else if (event.key === "Escape") { select([]); page.showLink(null); }
    else return;
    event.preventDefault();
  });
  const fingers = new Map();
  let pressed = null;
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    pressed = fingers.size === 1 ? { x: event.clientX, y: event.clientY, moved: false } : null;
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const [dx, dy] = [event.clientX - before[0], event.clientY - before[1]];
    if (pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > 4) pressed.moved = true;
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
      const apart = (at) => Math.hypot(at[0] - other[0], at[1] - other[1]) || 1;
      zoom(apart(before) / apart([event.clientX, event.clientY]));
      shift(dx / stage.clientHeight / 2, dy / stage.clientHeight / 2);
    } else if (event.buttons & 6 || event.shiftKey) shift(dx / stage.clientHeight, dy / stage.clientHeight);
    else turn(-dx * 0.008, dy * 0.008);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  for (const kind of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(kind, (event) => {
      fingers.delete(event.pointerId);
      if (kind === "pointerup" && pressed && !pressed.moved && event.button === 0) pick(event);
      pressed = null;
    });
  }
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY), 100) * 0.0015));
  }, { passive: false });

  const ray = new THREE.Raycaster();
  function hit(x, y) { // the link at a place of the canvas, in parts of its width and height
    ray.setFromCamera({ x: 2 * x - 1, y: 1 - 2 * y }, camera);
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
    if (!robot) return;
    const [width, height] = [stage.clientWidth, stage.clientHeight];
    if (!width || !height) return;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.near = Math.max(orbit.distance - 4 * size, 0.002 * orbit.distance);
    camera.far = orbit.distance + 8 * size;
    camera.updateProjectionMatrix();
    const [c, s] = [Math.cos(orbit.elevation), Math.sin(orbit.elevation)];
    camera.position.set(Math.cos(orbit.azimuth) * c, Math.sin(orbit.azimuth) * c, s).multiplyScalar(orbit.distance).add(target);
    // Straight from above, x of the robot points up.
    camera.up.set(0, 0, 1);
    if (c < 1e-6) camera.up.set(-Math.cos(orbit.azimuth) * Math.sign(s), -Math.sin(orbit.azimuth) * Math.sign(s), 0);
    camera.lookAt(target);
    camera.updateMatrixWorld();
    lamp.position.copy(camera.position);
    lamp.target.position.copy(target);
    sun.target.position.copy(target);
    sun.position.copy(target).add(new THREE.Vector3(0.6, -0.8, 1.6).multiplyScalar(size));
    world.traverse((one) => {
      const joint = one.userData.still;
      if (joint) one.matrix.makeRotationAxis(axis.fromArray(joint.axis), -position(joint));
    });
    renderer.render(scene, camera);
    const at = new THREE.Vector3();
    tags.forEach((tag, number) => {
      tag.hidden = !layers.names;
      if (tag.hidden) return;
      at.setFromMatrixPosition(groups[number].matrix).project(camera);
      tag.style.left = `${(50 * at.x + 50).toFixed(2)}%`;
      tag.style.top = `${(50 - 50 * at.y).toFixed(2)}%`;
    });
  }
  new ResizeObserver(draw).observe(stage);
  window.addEventListener("beforeprint", paint);
  page.repaint = draw;

  // --- for what drives the page from outside

  page.show = show;
  page.readFindings = readFindings;
  page.move = (name, value) => { page.joints.set(name, value); pose(); };
  page.positions = page.joints.positions;
  page.hit = hit;
  page.frame = (name) => groups[robot.links.findIndex((link) => link.name === name)].matrix.toArray();
  page.chosen = () => [...chosen].map((number) => robot.links[number].name);
  page.project = (name) => { // where the origin of a link is on the canvas, in parts of its size
    const at = new THREE.Vector3().setFromMatrixPosition(groups[robot.links.findIndex((link) => link.name === name)].matrix).project(camera);
    return [(at.x + 1) / 2, (1 - at.y) / 2];
  };
  page.ready = show(
    JSON.parse(document.getElementById("robot").textContent),
    document.getElementById("model").textContent,
  ).then(() => { paint(); return true; });
})();
