// The model of a robot as a page carries it: glTF, packed with gzip, in base64.
(function () {
  "use strict";
  const page = window.urdfkit;

  async function unpacked(text) {
    const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
  }
  function parsed(buffer) {
    return new Promise((resolve, reject) => new THREE.GLTFLoader().parse(buffer, "", resolve, reject));
  }
  // This three.js finds what is under the pointer only where positions are plain numbers.
  function widen(geometry) {
    const { array, normalized, isInterleavedBufferAttribute, count } = geometry.attributes.position;
    if (!normalized) return;
    const stride = isInterleavedBufferAttribute ? geometry.attributes.position.data.stride : 3;
    const plain = new Float32Array(3 * count);
    for (let i = 0; i < 3 * count; i++) plain[i] = array[Math.floor(i / 3) * stride + (i % 3)] / 65535;
    geometry.setAttribute("position", new THREE.BufferAttribute(plain, 3));
  }

  // Nodes in the frames of their links.
  page.surfaces = async (packed) => {
    const nodes = [...(await parsed(await unpacked(packed))).scene.children];
    for (const node of nodes) node.traverse((one) => { if (one.isMesh) widen(one.geometry); });
    return nodes.map((node) => page.surface(node, node.userData));
  };
})();
