// The robot in three dimensions, in its zero configuration: shapes, meshes, findings in colour.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { ColladaLoader } from "three/addons/loaders/ColladaLoader.js";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";

// As in the images of urdfkit render --findings; what has no findings steps back.
const SEVERITIES = { error: 0xde2121, warning: 0xff9e0d };
const QUIET = 0xccd1d9, PLAIN = 0xb8bcc4, MISSING = 0xff7a00;

const text = (bytes) => new TextDecoder().decode(bytes);
const LOADERS = {
  stl: (bytes) => new THREE.Mesh(new STLLoader().parse(bytes.buffer)),
  obj: (bytes) => new OBJLoader().parse(text(bytes)),
  dae: (bytes) => {
    const { scene } = new ColladaLoader().parse(text(bytes), "");
    scene.rotation.set(0, 0, 0); // robots ignore <up_axis>, as RViz does
    return scene;
  },
};
const upright = (geometry) => new THREE.Mesh(geometry.rotateX(Math.PI / 2)); // along z, not y
const SHAPES = {
  box: ({ size }) => new THREE.Mesh(new THREE.BoxGeometry(...size)),
  missing: ({ size }) => new THREE.Mesh(new THREE.BoxGeometry(...size)),
  sphere: ({ radius }) => new THREE.Mesh(new THREE.SphereGeometry(radius, 32, 20)),
  cylinder: ({ radius, length }) => upright(new THREE.CylinderGeometry(radius, radius, length, 40)),
  capsule: ({ radius, length }) => upright(new THREE.CapsuleGeometry(radius, length, 12, 40)),
};

// Draws into an element. `mesh` gives the bytes of a file; `choose` gets the link that is clicked.
export function robotView(place, { mesh, choose }) {
  const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
  const camera = new THREE.PerspectiveCamera(40, 1, 0.01, 100);
  camera.up.set(0, 0, 1);
  const canvas = place.appendChild(renderer.domElement);
  const controls = new OrbitControls(camera, canvas);
  const world = new THREE.Scene();
  const lamp = new THREE.DirectionalLight(0xffffff, 1.6);
  camera.add(lamp);
  world.add(camera, new THREE.HemisphereLight(0xffffff, 0x6a6f78, 1.8));
  let robot = new THREE.Group();
  let file = null; // of the robot that is shown
  let size = 0; // of it, in m
  let isMarked = true;

  const draw = () => renderer.render(world, camera);
  controls.addEventListener("change", draw);
  new ResizeObserver(() => {
    const { clientWidth, clientHeight } = place;
    renderer.setPixelRatio(devicePixelRatio);
    renderer.setSize(clientWidth, clientHeight);
    camera.aspect = clientWidth / (clientHeight || 1);
    camera.updateProjectionMatrix();
    draw();
  }).observe(place);

  async function body(described) {
    const { kind, path, rgba, link, matrix, scale } = described;
    const suffix = path?.split(".").at(-1).toLowerCase();
    let made;
    try {
      made = kind === "mesh" ? LOADERS[suffix](await mesh(path)) : SHAPES[kind](described);
    } catch {
      return null; // a shape that nobody draws; the findings say why
    }
    if (scale) made.applyMatrix4(new THREE.Matrix4().makeScale(...scale));
    const color = rgba && new THREE.Color().setRGB(rgba[0], rgba[1], rgba[2], THREE.SRGBColorSpace);
    made.traverse((one) => {
      if (!one.isMesh) return;
      if (!one.geometry.attributes.normal) one.geometry.computeVertexNormals();
      const own = color ?? (kind === "mesh" && suffix === "dae" && [one.material].flat()[0].color) ?? null;
      const plain = kind === "missing" ? new THREE.Color(MISSING) : own || new THREE.Color(PLAIN);
      const opacity = rgba?.[3] ?? 1;
      one.material = new THREE.MeshLambertMaterial({ side: THREE.DoubleSide, opacity, transparent: opacity < 1 });
      one.userData = { link, plain };
    });
    const group = new THREE.Group();
    group.applyMatrix4(new THREE.Matrix4().fromArray(matrix));
    return group.add(made);
  }

  let worst = new Map(); // severity of the findings of a link
  function paint() {
    robot.traverse((one) => {
      if (!one.userData.link) return;
      const found = SEVERITIES[worst.get(one.userData.link)] ?? QUIET;
      one.material.color.set(isMarked ? found : one.userData.plain);
    });
    draw();
  }

  function ground(box) {
    const step = 10 ** Math.floor(Math.log10(size / 2));
    const cells = 2 * Math.ceil((1.5 * size) / step);
    const grid = new THREE.GridHelper(cells * step, cells, 0x9aa4b0, 0xb4bcc6).rotateX(Math.PI / 2);
    grid.position.z = box.min.z;
    place.querySelector("#scale").textContent = `grid ${Number(step.toPrecision(1))} m`;
    return grid;
  }
  function home(box) {
    const middle = box.getCenter(new THREE.Vector3());
    controls.target.copy(middle);
    camera.position.set(0.64, 0.66, 0.39).multiplyScalar(1.6 * size).add(middle);
    camera.near = size / 100;
    camera.far = size * 20;
    camera.updateProjectionMatrix();
    controls.update();
  }

  let latest = 0;
  async function show(scene, findings) {
    const number = ++latest;
    const made = (await Promise.all((scene?.bodies ?? []).map(body))).filter(Boolean);
    if (number !== latest) return; // there is a newer robot
    worst = new Map();
    for (const severity of ["warning", "error"]) {
      for (const finding of findings) {
        if (finding.severity === severity) for (const link of finding.links) worst.set(link, severity);
      }
    }
    robot.traverse((one) => one.geometry?.dispose());
    robot.removeFromParent();
    robot = new THREE.Group();
    if (made.length) robot.add(...made);
    const box = new THREE.Box3().setFromObject(robot);
    const before = size;
    size = made.length ? box.getSize(new THREE.Vector3()).length() : 0;
    if (Number.isFinite(size) && size > 0) {
      robot.add(ground(box));
      if (scene.file !== file || size > 1.5 * before || before > 1.5 * size) home(box);
    }
    file = scene?.file ?? null;
    world.add(robot);
    paint();
  }

  const pointer = new THREE.Raycaster();
  let pressed = null;
  canvas.addEventListener("pointerdown", ({ clientX, clientY }) => (pressed = [clientX, clientY]));
  canvas.addEventListener("click", ({ clientX, clientY }) => {
    if (pressed && Math.hypot(clientX - pressed[0], clientY - pressed[1]) > 4) return; // it was turned
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const at = new THREE.Vector2((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height);
    pointer.setFromCamera(at, camera);
    const hit = pointer.intersectObject(robot).find(({ object }) => object.userData.link);
    if (hit) choose(hit.object.userData.link);
  });

  return {
    show,
    mark(flag) {
      isMarked = flag;
      paint();
    },
  };
}
