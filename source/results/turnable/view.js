// Camera of the model: orbit, pan and zoom by mouse, fingers and keys; views in which all is seen.
const makeModelView = (canvas, camera, size, everyPlace, draw) => {
  const controls = new THREE.OrbitControls(camera, canvas);
  let seen = [1, -1, 0.82], untouched = true; // the view, until somebody turns it
  controls.enableKeys = controls.enableZoom = false; // the wheel is the page's until the model is clicked
  controls.addEventListener('change', draw);
  controls.addEventListener('start', () => { untouched = false; });
  canvas.addEventListener('focus', () => { controls.enableZoom = true; });
  canvas.addEventListener('blur', () => { controls.enableZoom = false; });
  function look(x, y, z) {
    seen = [x, y, z];
    untouched = true;
    const back = new THREE.Vector3(x, y, z).normalize(), right = new THREE.Vector3(0, 0, 1).cross(back).normalize(), up = back.clone().cross(right);
    const span = [right, up, back].map(axis => {
      let low = Infinity, high = -Infinity;
      everyPlace((p, r) => { const at = p.dot(axis); low = Math.min(low, at - r); high = Math.max(high, at + r); });
      return {middle: (low + high) / 2, length: high - low};
    });
    const tan = Math.tan(camera.fov * Math.PI / 360);
    const distance = 1.15 * Math.max(span[1].length / 2 / tan, span[0].length / 2 / tan / camera.aspect, 0.05 * size) + span[2].length / 2;
    controls.target.set(0, 0, 0);
    [right, up, back].forEach((axis, k) => controls.target.addScaledVector(axis, span[k].middle));
    camera.position.copy(controls.target).addScaledVector(back, distance);
    controls.update();
    draw();
  }
  canvas.addEventListener('keydown', event => {
    const turn = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]}[event.key];
    const nearer = {'+': 0.85, '-': 1 / 0.85}[event.key];
    if (!turn && !nearer) return;
    event.preventDefault();
    untouched = false;
    const way = camera.position.clone().sub(controls.target).multiplyScalar(nearer || 1);
    if (turn) {
      const flat = Math.hypot(way.x, way.y), height = Math.min(1.55, Math.max(-1.55, Math.atan2(way.z, flat) - turn[1]));
      const angle = Math.atan2(way.y, way.x) + turn[0], far = way.length();
      way.set(Math.cos(angle) * Math.cos(height), Math.sin(angle) * Math.cos(height), Math.sin(height)).multiplyScalar(far);
    }
    camera.position.copy(controls.target).add(way);
    controls.update();
  });
  return {controls, look, fit: () => { if (untouched) look(...seen); }};
};
