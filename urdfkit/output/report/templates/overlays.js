// What explains a robot in the 3D view and is no part of it: frames, axes, masses, inertias.
(function () {
  "use strict";
  const GRID = 0x808890, MASS = 0xd0342c, WHOLE = 0x7a2cd0, INERTIA = 0xb04ad0, AXIS = 0x1a8f4a, FOLLOWER = 0x9a6a00;

  function over(color) { return new THREE.MeshBasicMaterial({ color, depthTest: false, transparent: true, opacity: 0.85 }); }
  function ball(color, radius) {
    const made = new THREE.Mesh(new THREE.SphereGeometry(1, 16, 12), over(color));
    made.scale.setScalar(radius);
    return made;
  }
  function grid(size, height) {
    const edge = Math.max(1, Math.ceil(2 * size));
    const made = new THREE.GridHelper(edge, 2 * edge, GRID, GRID);
    made.rotation.x = Math.PI / 2;
    made.position.z = height;
    Object.assign(made.material, { transparent: true, opacity: 0.25 });
    return made;
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
  function arrow(joint, size, color) {
    const along = new THREE.Vector3().fromArray(joint.axis);
    const made = new THREE.ArrowHelper(along, new THREE.Vector3(), 0.14 * size, color, 0.03 * size, 0.016 * size);
    made.line.material.depthTest = made.cone.material.depthTest = false;
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
      layer("frames", number, new THREE.AxesHelper(0.08 * size));
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
      layer("axes", joint.child, arrow(joint, size, color));
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

  window.urdfkit.overlays = { add, grid, whole };
})();
