// The surfaces of a robot, as a page carries them: glTF, packed with gzip, in base64.
(function () {
  "use strict";
  const DARKEST = 0.02; // of paint, in linear light

  async function unpacked(text) {
    const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
  }
  function parsed(buffer) {
    return new Promise((resolve, reject) => new THREE.GLTFLoader().parse(buffer, "", resolve, reject));
  }
  // Without the model of metals and roughness: a machine without a graphics card draws it, too.
  // No paint is blacker than coal, and it shines: black parts are told apart from one another.
  function painted({ color, map, opacity, transparent, vertexColors }) {
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
  function widened(geometry) {
    const { array, normalized, isInterleavedBufferAttribute, count } = geometry.attributes.position;
    if (!normalized) return geometry;
    const stride = isInterleavedBufferAttribute ? geometry.attributes.position.data.stride : 3;
    const plain = new Float32Array(3 * count);
    for (let i = 0; i < 3 * count; i++) plain[i] = array[Math.floor(i / 3) * stride + (i % 3)] / 65535;
    geometry.setAttribute("position", new THREE.BufferAttribute(plain, 3));
    return geometry;
  }

  // Nodes in the frames of their links; their meshes know the link, the role and how they look.
  window.urdfkit.surfaces = async (packed) => {
    const nodes = [...(await parsed(await unpacked(packed))).scene.children];
    for (const node of nodes) {
      node.traverse((one) => {
        if (!one.isMesh) return;
        one.geometry = shaded(widened(one.geometry));
        one.material = painted(one.material);
        const { color, opacity, map, vertexColors } = one.material;
        one.userData = { ...node.userData, color: color.clone(), opacity, map, vertexColors };
        if (one.userData.role !== "collision") return;
        one.renderOrder = 1; // many lie on their visuals
        Object.assign(one.material, { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 });
      });
    }
    return nodes;
  };
})();
