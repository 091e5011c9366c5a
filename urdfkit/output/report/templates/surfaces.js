// How the surfaces of a robot look: as in the images of urdfkit render (urdfkit/render/shading.py).
(function () {
  "use strict";
  const DARKEST = 0.012; // of paint, in linear light
  // What the sky adds: more where a surface is seen at a flat angle and mirrors what is above. What
  // is too bright for a screen is bent towards white.
  const GLOSS = `
    vec3 toViewer = normalize(vViewPosition);
    vec3 above = (viewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz;
    float facing = clamp(dot(normal, toViewer), 0.0, 1.0);
    float mirrored = 2.0 * facing * dot(normal, above) - dot(toViewer, above);
    float grazing = 0.04 + 0.96 * pow(1.0 - facing, 5.0);
    outgoingLight += 0.32 * grazing * clamp(0.5 * mirrored + 0.5, 0.0, 1.0);
    vec3 over = max(outgoingLight - 0.72, 0.0);
    outgoingLight = min(outgoingLight, 0.72) + 0.28 * over / (over + 0.28);
  `;
  const OUTPUT = "#include <output_fragment>";

  // Without the model of metals and roughness: a machine without a graphics card draws it, too.
  function painted({ color, map, opacity, transparent, vertexColors }) {
    const [r, g, b] = color.toArray().map((part) => Math.max(part, DARKEST));
    const made = new THREE.MeshPhongMaterial({
      color: new THREE.Color(r, g, b), map, opacity, transparent, vertexColors,
      specular: new THREE.Color(0.029, 0.029, 0.029), shininess: 42, side: THREE.DoubleSide,
    });
    made.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace(OUTPUT, GLOSS + OUTPUT);
    };
    return made;
  }
  function shaded(geometry) { // without normals every face is flat
    if (geometry.attributes.normal) return geometry;
    const flat = geometry.index ? geometry.toNonIndexed() : geometry;
    flat.computeVertexNormals();
    return flat;
  }

  // Makes the meshes of a node a link's: they know the link, the role and how they look.
  window.urdfkit.surface = (node, { link, role }) => {
    node.userData.link = link;
    node.traverse((one) => {
      if (!one.isMesh) return;
      one.geometry = shaded(one.geometry);
      one.material = Array.isArray(one.material) ? one.material.map(painted) : painted(one.material);
      one.userData = { link, role, looks: [one.material].flat().map(({ color, opacity, map, vertexColors }) => (
        { color: color.clone(), opacity, map, vertexColors })) };
      if (role !== "collision") return;
      one.renderOrder = 1; // many lie on their visuals
      for (const material of [one.material].flat()) {
        Object.assign(material, { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 });
      }
    });
    return node;
  };
})();
