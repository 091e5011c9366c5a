// What explains a robot in the 3D view and is no part of it: frames, axes, masses, inertias.
(function () {
  "use strict";
  const GRID = 0x808890, MASS = 0xd0342c, WHOLE = 0x7a2cd0, INERTIA = 0xb04ad0, AXIS = 0x1a8f4a, FOLLOWER = 0x9a6a00;

  const AXES = [[[1, 0, 0], 0xe03030], [[0, 1, 0], 0x22ad40], [[0, 0, 1], 0x2f66f0]];

  function over(color) { return new THREE.MeshBasicMaterial({ color, depthTest: false, transparent: true, opacity: 0.85 }); }
  function ball(color, radius) {
    const made = new THREE.Mesh(new THREE.SphereGeometry(1, 16, 12), over(color));
    made.scale.setScalar(radius);
    return made;
  }
  // The ground, which catches shadows, and its grid of squares of 1, 2 or 5 times a power of ten.
  function ground(size, height) {
    const power = 10 ** Math.floor(Math.log10(size / 4));
    const step = power * [5, 2, 1].find((one) => one * power <= size / 4 * (1 + 1e-9));
    const squares = 2 * Math.ceil(1.5 * size / step);
    const grid = new THREE.GridHelper(squares * step, squares, GRID, GRID);
    grid.rotation.x = Math.PI / 2;
    Object.assign(grid.material, { transparent: true, opacity: 0.3, depthWrite: false });
    const shadows = new THREE.Mesh(new THREE.PlaneGeometry(squares * step, squares * step), new THREE.ShadowMaterial({ opacity: 0.22, depthWrite: false }));
    shadows.receiveShadow = true;
    [shadows.renderOrder, grid.renderOrder] = [-2, -1]; // the lines on the shadows
    const made = new THREE.Group();
    made.add(grid, shadows);
    made.position.z = height - 1e-4 * size;
    return { made, step };
  }
  function inertiaBox(link, size) {
    if (!link.box || Math.max(...link.box.edges) > 1000 * size) return null;
    const edges = link.box.edges.map((edge) => Math.max(edge, 1e-4 * size));
    const material = new THREE.MeshBasicMaterial({ color: INERTIA, transparent: true, opacity: 0.3, depthWrite: false });
    const made = new THREE.Mesh(new THREE.BoxGeometry(...edges), material);
    made.matrixAutoUpdate = false;
    made.matrix.fromArray(link.box.matrix);
    return made;
  }
  function arrow(along, length, color) {
    const made = new THREE.ArrowHelper(new THREE.Vector3().fromArray(along), new THREE.Vector3(), length, color, 0.22 * length, 0.12 * length);
    for (const { material } of [made.line, made.cone]) Object.assign(material, { depthTest: false, transparent: true });
    return made;
  }
  function frame(length) {
    const made = new THREE.Group();
    made.add(...AXES.map(([along, color]) => arrow(along, length, color)));
    return made;
  }
  // The range of a revolute joint, in the frame of its child at zero: it must not turn with it.
  function arc(joint, size, color) {
    const along = new THREE.Vector3().fromArray(joint.axis);
    const steep = Math.abs(along.x) > 0.9;
    const start = new THREE.Vector3(steep ? 0 : 1, steep ? 1 : 0, 0).cross(along).normalize();
    const [low, high] = joint.limits;
    const span = Math.min(high - low, 2 * Math.PI);
    const points = [];
    for (let step = 0; step <= 48; step++) {
      points.push(start.clone().applyAxisAngle(along, low + (span * step) / 48).multiplyScalar(0.07 * size));
    }
    const material = new THREE.LineBasicMaterial({ color, depthTest: false, transparent: true });
    const line = new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), material);
    line.userData.still = joint;
    line.matrixAutoUpdate = false;
    return line;
  }

  // Adds all that there is to the groups of the links; `size` is the robot's, in m.
  function add(robot, groups, size) {
    const layer = (name, number, object) => {
      object.userData.layer = name;
      object.renderOrder = 2;
      groups[number].add(object);
    };
    const heaviest = robot.links.reduce((most, link) => Math.max(most, link.mass || 0), 0);
    robot.links.forEach((link, number) => {
      layer("frames", number, frame(0.08 * size));
      if (!link.mass) return;
      const mass = ball(MASS, Math.cbrt(link.mass / heaviest) * 0.018 * size);
      mass.position.fromArray(link.center);
      layer("mass", number, mass);
      const box = inertiaBox(link, size);
      if (box) layer("inertia", number, box);
    });
    for (const joint of robot.joints) {
      if (joint.leader === undefined) continue;
      const color = joint.leader === joint.name ? AXIS : FOLLOWER;
      layer("axes", joint.child, arrow(joint.axis, 0.14 * size, color));
      if (joint.limits && joint.type === "revolute") layer("axes", joint.child, arc(joint, size, color));
    }
  }
  // The centre of mass of the whole robot, which `place` puts where it belongs.
  function whole(robot, groups, size) {
    const made = ball(WHOLE, 0.014 * size);
    made.userData.layer = "mass";
    const place = () => {
      const center = new THREE.Vector3();
      let mass = 0;
      robot.links.forEach((link, number) => {
        if (!link.mass) return;
        center.addScaledVector(new THREE.Vector3().fromArray(link.center).applyMatrix4(groups[number].matrix), link.mass);
        mass += link.mass;
      });
      made.userData.empty = mass === 0;
      if (mass > 0) made.position.copy(center.multiplyScalar(1 / mass));
    };
    return { made, place };
  }

  window.urdfkit.overlays = { add, ground, whole };
})();
