// The bodies of a robot, from the files in the worker. Nothing that a file names is fetched.
import { ColladaLoader } from "three/examples/jsm/loaders/ColladaLoader.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { MTLLoader } from "three/examples/jsm/loaders/MTLLoader.js";
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";
import { PLYLoader } from "three/examples/jsm/loaders/PLYLoader.js";
import { STLLoader } from "three/examples/jsm/loaders/STLLoader.js";
import { ask } from "./python.js";

// As in the images: what says nothing about its material, a missing mesh, a collision.
const PLAIN = [0.72, 0.74, 0.77, 1], MISSING = [1, 0.48, 0, 1], COLLISION = [0.93, 0.42, 0.12, 0.45];
const WHITE = "data:image/gif;base64,R0lGODlhAQABAIAAAP///wAAACwAAAAAAQABAAACAkQBADs=";

const text = (bytes) => new TextDecoder().decode(bytes);
const plain = (object) => Object.assign(object, { userData: { isPlain: true } }); // without materials
const LOADERS = {
  stl: (bytes) => plain(new THREE.Mesh(new STLLoader().parse(bytes.buffer))),
  ply: (bytes) => plain(new THREE.Mesh(new PLYLoader().parse(bytes.buffer))),
  dae: (bytes, manager) => {
    const { scene } = new ColladaLoader(manager).parse(text(bytes), "");
    scene.rotation.set(0, 0, 0); // robots ignore <up_axis>, as RViz does
    return scene;
  },
  obj: (bytes, manager, files) => {
    const written = [...files].filter(([name]) => name.toLowerCase().endsWith(".mtl"));
    if (!written.length) return plain(new OBJLoader().parse(text(bytes)));
    const materials = new MTLLoader(manager).parse(written.map(([, own]) => text(own)).join("\n"), "");
    return new OBJLoader().setMaterials(materials).parse(text(bytes));
  },
  glb: async (bytes, manager) => (await new GLTFLoader(manager).parseAsync(bytes.buffer, "")).scene,
  gltf: async (bytes, manager) => (await new GLTFLoader(manager).parseAsync(text(bytes), "")).scene,
};
const upright = (geometry) => new THREE.Mesh(geometry.rotateX(Math.PI / 2)); // along z, not y
const SHAPES = {
  box: ({ size }) => new THREE.Mesh(new THREE.BoxGeometry(...size)),
  missing: ({ size }) => new THREE.Mesh(new THREE.BoxGeometry(...size)),
  sphere: ({ radius }) => new THREE.Mesh(new THREE.SphereGeometry(radius, 32, 20)),
  cylinder: ({ radius, length }) => upright(new THREE.CylinderGeometry(radius, radius, length, 40)),
  capsule: ({ radius, length }) => upright(new THREE.CapsuleGeometry(radius, length, 12, 40)),
};

// Addresses of files that are here; of what is not, a white image.
function manager(files) {
  const addresses = new Map([...files].map(([name, bytes]) => [name, URL.createObjectURL(new Blob([bytes]))]));
  const made = new THREE.LoadingManager(() => {
    for (const address of addresses.values()) URL.revokeObjectURL(address);
    urdfkit.repaint?.();
  });
  const known = (name) => addresses.get(name) ?? addresses.get(decodeURIComponent(name));
  return made.setURLModifier((name) => (/^(data|blob):/.test(name) ? name : known(name) ?? WHITE));
}
// Meshes alone: lamps and cameras of a file are not of the robot.
function onlyMeshes(object) {
  const others = [];
  object.traverse((one) => { if (one.isLight || one.isCamera || one.isLine || one.isPoints) others.push(one); });
  for (const one of others) one.removeFromParent();
  return object;
}
function material([r, g, b, opacity = 1], map = null) {
  const color = new THREE.Color(r, g, b).convertSRGBToLinear();
  return new THREE.MeshBasicMaterial({ color, map, opacity, transparent: opacity < 1 });
}

let meshes = new Map(); // each is read once
async function parsed(path) {
  const { bytes, files } = await ask("mesh", { path });
  const named = new Map(Object.entries(files));
  const object = await LOADERS[path.split(".").at(-1).toLowerCase()](bytes, manager(named), named);
  return onlyMeshes(object);
}
async function mesh(path) {
  if (!meshes.has(path)) meshes.set(path, parsed(path));
  return (await meshes.get(path)).clone();
}
async function image(path) {
  const { bytes } = await ask("mesh", { path });
  const map = new THREE.TextureLoader(manager(new Map([[path, bytes]]))).load(path);
  map.encoding = THREE.sRGBEncoding;
  return map;
}

// A material of the URDF replaces those of a mesh, as in RViz; one of Gazebo counts without both.
async function paint({ role, kind, rgba, texture, gazebo }, made) {
  if (role === "collision") return material(COLLISION);
  if (kind === "missing") return material(MISSING);
  if (texture) return material(rgba ?? [1, 1, 1, 1], await image(texture));
  if (rgba) return material(rgba);
  if (kind === "mesh" && !made.userData.isPlain) return null;
  const colored = made.geometry?.attributes.color;
  return Object.assign(material(colored ? [1, 1, 1, 1] : gazebo ?? PLAIN), { vertexColors: Boolean(colored) });
}
async function body(described) {
  const { kind, path, matrix, scale } = described;
  let made;
  try {
    made = kind === "mesh" ? await mesh(path) : SHAPES[kind](described);
  } catch {
    return null; // a shape that nobody draws; the findings say why
  }
  const own = await paint(described, made);
  if (own) made.traverse((one) => { if (one.isMesh) one.material = own; });
  if (scale) made.applyMatrix4(new THREE.Matrix4().makeScale(...scale));
  const group = new THREE.Group();
  group.applyMatrix4(new THREE.Matrix4().fromArray(matrix));
  return urdfkit.surface(group.add(made), described);
}

urdfkit.surfaces = async (bodies) => (await Promise.all([...bodies].map(body))).filter(Boolean);
urdfkit.forget = () => { meshes = new Map(); };
