// The 3D view of the report (urdfkit/output/report/templates), with the meshes of the worker.
import "./engine.js";
import "./surfaces.js";
import "./joints.js";
import "./overlays.js";
import "./camera.js";
import "./meshes.js";
import "./scene.js";

export const view = globalThis.urdfkit;
