// The camera of the 3D view: it turns about the vertical, so that up stays up.
(function () {
  "use strict";
  const VIEWS = { iso: [0.8, 0.4], front: [0, 0], left: [Math.PI / 2, 0], top: [0, Math.PI / 2] };

  // Moved by pointers, fingers and keys on a canvas; `changed` is called whenever it has moved,
  // `pick` with a click that moves nothing, `release` when Escape is pressed.
  window.urdfkit.orbit = (canvas, { changed, pick, release }) => {
    const camera = new THREE.PerspectiveCamera(40, 1, 0.01, 100);
    const target = new THREE.Vector3();
    const orbit = { azimuth: VIEWS.iso[0], elevation: VIEWS.iso[1], distance: 3 };
    let box = new THREE.Box3(); // what there is to see
    let size = 1; // of it, in m

    function home() {
      if (box.isEmpty()) return;
      box.getCenter(target);
      camera.aspect = canvas.clientWidth / (canvas.clientHeight || 1) || 1;
      const upright = (camera.fov * Math.PI) / 360;
      const half = Math.min(upright, Math.atan(Math.tan(upright) * camera.aspect));
      orbit.distance = (0.5 * size) / Math.sin(half);
      changed();
    }
    function turn(by, up) {
      orbit.azimuth += by;
      orbit.elevation = Math.min(Math.max(orbit.elevation + up, -Math.PI / 2), Math.PI / 2);
      changed();
    }
    function zoom(factor) {
      orbit.distance = Math.min(Math.max(orbit.distance * factor, 0.02 * size), 30 * size);
      changed();
    }
    function shift(right, up) {
      const [x, y] = [new THREE.Vector3(), new THREE.Vector3()];
      camera.matrix.extractBasis(x, y, new THREE.Vector3());
      target.addScaledVector(x, -right * orbit.distance).addScaledVector(y, up * orbit.distance);
      changed();
    }
    function look(name) {
      [orbit.azimuth, orbit.elevation] = VIEWS[name];
      home();
    }
    // Puts the camera where it belongs, for a picture of so many pixels.
    function place(width, height) {
      camera.aspect = width / height;
      camera.near = Math.max(orbit.distance - 4 * size, 0.002 * orbit.distance);
      camera.far = orbit.distance + 8 * size;
      camera.updateProjectionMatrix();
      const [c, s] = [Math.cos(orbit.elevation), Math.sin(orbit.elevation)];
      camera.position.set(Math.cos(orbit.azimuth) * c, Math.sin(orbit.azimuth) * c, s);
      camera.position.multiplyScalar(orbit.distance).add(target);
      // Straight from above, x of the robot points up.
      camera.up.set(0, 0, 1);
      if (c < 1e-6) camera.up.set(-Math.cos(orbit.azimuth) * Math.sign(s), -Math.sin(orbit.azimuth) * Math.sign(s), 0);
      camera.lookAt(target);
      camera.updateMatrixWorld();
    }

    canvas.addEventListener("keydown", (event) => {
      const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] || [0, 0];
      if ((x || y) && event.shiftKey) shift(-0.05 * x, 0.05 * y);
      else if (x || y) turn(0.1 * x, 0.1 * y);
      else if (event.key === "+" || event.key === "=") zoom(0.9);
      else if (event.key === "-") zoom(1 / 0.9);
      else if (event.key === "Home") home();
      else if (event.key === "Escape") release();
      else return;
      event.preventDefault();
    });

    const fingers = new Map(); // where each of them is
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
        shift(dx / canvas.clientHeight / 2, dy / canvas.clientHeight / 2);
      } else if (event.buttons & 6 || event.shiftKey) shift(dx / canvas.clientHeight, dy / canvas.clientHeight);
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

    const frame = (seen, extent) => { box = seen; size = extent; };
    return { camera, target, frame, home, look, place };
  };
})();
