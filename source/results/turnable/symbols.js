// Symbols of supports and what they are drawn with, for model.js. A shape is in units of the pipe's outer radius; its z
// points from the ground into the pipe, its x along the pipe. Nothing here knows a result.
const makeModelSymbols = () => {
  const part = (geometry, x, y, z) => geometry.translate(x, y, z);
  const box = (lx, ly, lz, x, y, z) => part(new THREE.BoxBufferGeometry(lx, ly, lz), x, y, z);
  const tube = (top, bottom, length, z, sides = 12) =>
    part(new THREE.CylinderBufferGeometry(top, bottom, length, sides).rotateX(Math.PI / 2), 0, 0, z);
  const ball = (radius, z) => part(new THREE.SphereBufferGeometry(radius, 10, 8), 0, 0, z);
  const coil = (radius, from, to) => [0, 1, 2, 3, 4].map(i => part(
    new THREE.TorusBufferGeometry(radius, 0.22, 6, 12), 0, 0, from + (to - from) * (i + 0.5) / 5));

  function merged(parts) {
    const shape = {position: [], normal: [], index: [], first: 0}; // first: indices of the first part
    for (const geometry of parts) {
      const first = shape.position.length / 3;
      shape.position.push(...geometry.attributes.position.array);
      shape.normal.push(...geometry.attributes.normal.array);
      shape.index.push(...Array.from(geometry.index.array, i => i + first));
      shape.first = shape.first || shape.index.length;
    }
    return shape;
  }

  // What stands around the pipe, and not on one side of it, is marked so.
  const makers = {
    rest: () => [part(new THREE.ConeBufferGeometry(2, 3, 4, 1).rotateY(Math.PI / 4).rotateX(Math.PI / 2), 0, 0, -1.5),
                 box(4, 4, 0.35, 0, 0, -3.2)],
    guide: () => [box(3, 3, 0.4, 0, 0, -1.25), box(0.5, 2, 1.6, 0.9, 0, -2.2), box(0.5, 2, 1.6, -0.9, 0, -2.2)],
    stop: () => [-1, 1].flatMap(side => [
      part(new THREE.ConeBufferGeometry(0.9, 2.4, 10).rotateX(Math.PI / 2), 0, 2.1 * side, -1.2),
      box(2.2, 2.2, 0.35, 0, 2.1 * side, -2.6)]),
    collar: () => [part(new THREE.TorusBufferGeometry(1.5, 0.35, 6, 20), 0, 0, 0)],
    rod: () => [ball(0.7, 1.2), tube(0.22, 0.22, 7, 4.7, 8), box(2.6, 2.6, 0.35, 0, 0, 8.3)],
    hanger: () => [tube(0.25, 0.25, 3, 2.5, 8), ...coil(0.9, 4, 7), tube(0.25, 0.25, 1, 7.6, 8), box(3, 3, 0.35, 0, 0, 8.3)],
    constant: () => [tube(0.25, 0.25, 3, 2.5, 8), box(1.8, 1.8, 3, 0, 0, 5.5), tube(0.25, 0.25, 1, 7.6, 8),
                     box(3, 3, 0.35, 0, 0, 8.3)],
    spring: () => [...coil(0.9, -1.3, -4.5), box(3, 3, 0.35, 0, 0, -4.9)],
    snubber: () => [ball(0.5, -1.2), tube(0.35, 0.35, 2.2, -2.2), tube(0.85, 0.85, 2.6, -4.3), box(2.6, 2.6, 0.35, 0, 0, -5.8)],
    holds: () => [part(new THREE.ConeBufferGeometry(1, 2.2, 12).rotateX(Math.PI / 2), 0, 0, -2.1), box(2.4, 2.4, 0.35, 0, 0, -3.4)],
    anchor: () => [box(1, 4.2, 4.2, 0, 0, 0), box(2.2, 2.6, 2.6, 0, 0, 0)],
    other: () => [ball(1.6, 0)],
    arrow: () => [tube(0.35, 0.35, 0.75, -0.625, 8),
                  part(new THREE.ConeBufferGeometry(1, 0.25, 10).rotateX(Math.PI / 2), 0, 0, -0.125)]
  };
  const coarse = new Set(['rest', 'guide']); // drawn by their first part where there are many and they move
  const made = {};
  const shape = name => made[name] = made[name] || Object.assign(merged(makers[name]()), coarse.has(name) ? {} : {first: Infinity});

  const ofKind = {rest: 'rest', friction: 'rest', guide: 'guide', 'line stop': 'stop', stop: 'stop', rod: 'rod', snubber: 'snubber',
                  spring: 'spring', 'spring hanger': 'hanger', 'constant hanger': 'constant', anchor: 'anchor'};
  const around = new Set(['stop', 'anchor', 'other', 'collar']), above = new Set(['rod', 'hanger', 'constant']);

  // Vertices of many symbols, or of pipes, drawn in one go. Each vertex knows its centre, which moves with the line, and its
  // way from there, which is widened so that nothing gets thinner than some pixels.
  class Batch {
    constructor() {
      this.lists = {position: [], offset: [], normal: [], size: [], tint: [], index: [], coarse: []};
      this.stations = []; // whose displacement each vertex has
    }
    get count() { return this.stations.length; }
    vertex(centre, offset, normal, size, tint, station) {
      const lists = this.lists;
      lists.position.push(centre.x, centre.y, centre.z);
      lists.offset.push(offset.x, offset.y, offset.z);
      lists.normal.push(normal.x, normal.y, normal.z);
      lists.size.push(size);
      lists.tint.push(...tint);
      this.stations.push(station);
    }
    // Axes are three vectors, by whose lengths the shape is stretched. Returns the range of its vertices.
    add(shape, centre, axes, size, shift, tint, station) {
      const first = this.count, [x, y, z] = axes, v = new THREE.Vector3(), n = new THREE.Vector3();
      const lengths = axes.map(axis => axis.length());
      const mix = (to, list, i, scale) => to.set(0, 0, 0).addScaledVector(x, list[i] * scale[0])
        .addScaledVector(y, list[i + 1] * scale[1]).addScaledVector(z, list[i + 2] * scale[2]);
      for (let i = 0; i < shape.position.length; i += 3) {
        mix(v, shape.position, i, [1, 1, 1]).add(shift);
        mix(n, shape.normal, i, lengths.map(l => l > 0 ? 1 / (l * l) : 0)).normalize();
        this.vertex(centre, v, n, size, tint, station);
      }
      shape.index.forEach((i, k) => { this.lists.index.push(first + i); if (k < shape.first) this.lists.coarse.push(first + i); });
      return [first, this.count];
    }
    mesh(material) {
      const geometry = new THREE.BufferGeometry();
      const put = (name, list, n) => geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(list), n));
      for (const name of ['position', 'offset', 'normal', 'tint']) put(name, this.lists[name], 3);
      put('size', this.lists.size, 1);
      for (const name of ['u0', 'u1']) put(name, new Float32Array(3 * this.count), 3);
      put('value', new Float32Array(2 * this.count), 2);
      const indices = list => new THREE.BufferAttribute(new Uint32Array(list), 1);
      this.indices = [indices(this.lists.index), indices(this.lists.coarse)];
      geometry.setIndex(this.indices[0]);
      this.lists = null;
      const mesh = new THREE.Mesh(geometry, material);
      mesh.frustumCulled = false; // the shader moves it
      this.geometry = geometry;
      return mesh;
    }
    // With fewer vertices, for what moves.
    simplify(is) { if (this.indices[1].count) this.geometry.setIndex(this.indices[is ? 1 : 0]); }
    // Displacements of all stations at the beginning (u0) and the end (u1) of a motion.
    move(name, u) {
      const attribute = this.geometry.attributes[name], to = attribute.array;
      for (let i = 0, k = 0; i < this.stations.length; ++i)
        for (let j = 3 * this.stations[i], d = 0; d < 3; ++d) to[k++] = u[j + d];
      attribute.needsUpdate = true;
    }
  }

  // Lit from the eye. With a palette, by value, parts of 1 of the range, below 0 where there is none; else by tint.
  const material = (palette, uniforms, leastPixels) => new THREE.ShaderMaterial({
    side: THREE.DoubleSide,
    uniforms: {...uniforms, palette: {value: palette}, leastPixels: {value: leastPixels}, plain: {value: palette ? 0 : 1}},
    vertexShader: `
      attribute vec3 offset, u0, u1, tint; attribute float size; attribute vec2 value;
      uniform float scale, blend, pixel, leastPixels;
      varying vec3 shownNormal, eye, shownTint; varying float part;
      void main() {
        vec3 centre = position + scale * mix(u0, u1, blend);
        vec4 seen = modelViewMatrix * vec4(centre, 1.0);
        float widened = max(1.0, leastPixels * pixel * -seen.z / size);
        seen = modelViewMatrix * vec4(centre + widened * offset, 1.0);
        shownNormal = normalMatrix * normal; eye = -seen.xyz; shownTint = tint; part = mix(value.x, value.y, blend);
        gl_Position = projectionMatrix * seen;
      }`,
    fragmentShader: `
      uniform sampler2D palette; uniform float plain;
      varying vec3 shownNormal, eye, shownTint; varying float part;
      void main() {
        vec3 colour = plain > 0.5 ? shownTint : part < -0.001 ? vec3(0.72) : texture2D(palette, vec2(clamp(part, 0.002, 0.998), 0.5)).rgb;
        float light = abs(dot(normalize(shownNormal), normalize(eye)));
        gl_FragColor = vec4(colour * (0.5 + 0.5 * light) + 0.08 * pow(light, 24.0), 1.0);
      }`
  });

  return {shape, Batch, material, around, above,
          of: kind => ofKind[kind] || null};
};
