// Supports and restraints of the model: each item has a shape, a place and axes; at one place those that would cover each
// other are moved along the pipe.
const placeModelSupports = (data, symbols, tangents, radii, size, tint) => {
  const items = [];
  const axesFor = (z, i) => {
    let x = tangents[i].clone().addScaledVector(z, -tangents[i].dot(z));
    if (x.length() < 0.1) x = Math.abs(z.z) < 0.9 ? new THREE.Vector3(0, 0, 1).cross(z) : new THREE.Vector3(1, 0, 0);
    x.normalize();
    return [x, z.clone().cross(x).normalize(), z];
  };
  data.supports.forEach((support, k) => {
    const z = new THREE.Vector3(...support.n), lateral = Math.abs(z.dot(tangents[support.station])) > 0.8;
    const name = symbols.of(support.kind) || (lateral ? 'stop' : 'rest');
    items.push({type: 'support', k, ...support, parts: [[lateral && name === 'guide' ? 'stop' : name, axesFor(z, support.station)]]});
  });
  data.restraints.forEach((restraint, k) => {
    const t = tangents[restraint.station], known = symbols.of(restraint.kind), up = new THREE.Vector3(0, 0, 1);
    const ways = restraint.ways.map(way => new THREE.Vector3(...way).normalize());
    const facing = name => ways.map(way => [name, axesFor(way, restraint.station)]);
    const parts = restraint.kind === 'anchor' || (known === null && ways.length === 3) ? [['anchor', axesFor(Math.abs(t.z) < 0.9 ? up : new THREE.Vector3(0, 1, 0), restraint.station)]]
      : known === 'hanger' || known === 'constant' || known === 'rod' ? [[known, axesFor(up, restraint.station)]]
      : known === 'guide' ? ways.flatMap(way => [1, -1].map(s => ['guide', axesFor(way.clone().multiplyScalar(s), restraint.station)]))
      : known === 'stop' || known === 'spring' ? facing(known)
      : ways.length > 0 ? facing('holds') : [['collar', [t.clone().cross(up).lengthSq() > 0.01 ? up.clone().cross(t).normalize() : new THREE.Vector3(1, 0, 0), up, t.clone()]]];
    items.push({type: 'restraint', k, ...restraint, parts: parts.length ? parts : [['other', axesFor(up, restraint.station)]]});
  });
  // No larger than their neighbours leave room for.
  const order = [...items].sort((a, b) => a.station - b.station), place = item => new THREE.Vector3(...item.at);
  const apart = new Map(items.map(item => [item, Infinity]));
  for (let i = 1, before = null; i < order.length; ++i) {
    if (order[i].station !== order[i - 1].station) before = order[i - 1];
    const far = before ? place(order[i]).distanceTo(place(before)) : 0;
    if (far > 1e-6 * size) for (const one of [before, order[i]]) apart.set(one, Math.min(apart.get(one), far));
  }
  const batch = new symbols.Batch(), taken = new Map();
  for (const item of items) {
    const key = item.at.map(x => Math.round(x / size * 1e6)).join(), others = taken.get(key) || [];
    const covers = other => { // those that face each other do not
      const facing = other.parts[0][1][2].dot(item.parts[0][1][2]);
      return facing > -0.9 && (facing > 0.5 || symbols.around.has(other.parts[0][0]) || symbols.around.has(item.parts[0][0]));
    };
    const slots = others.filter(covers).map(other => other.slot);
    item.slot = [0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5].find(slot => !slots.includes(slot)) || 0;
    taken.set(key, [...others, item]);
    const whole = radii[item.station], r = item.radius = symbols.around.has(item.parts[0][0]) ? whole : Math.min(whole, Math.max(apart.get(item) / 4.4, 0.2 * whole));
    const shift = tangents[item.station].clone().multiplyScalar(4.4 * r * item.slot);
    item.centre = new THREE.Vector3(...item.at);
    item.middle = shift.clone().addScaledVector(item.parts[0][1][2], r * ({rest: -2, guide: -2, snubber: -3.5, spring: -3, holds: -2.5, hanger: 5, constant: 5, rod: 5}[item.parts[0][0]] || 0));
    item.middle.addScaledVector(item.parts[0][1][2], symbols.above.has(item.parts[0][0]) ? whole - r : r - whole);
    item.ranges = item.parts.map(([name, axes]) => batch.add(symbols.shape(name), item.centre,
      axes.map(axis => axis.clone().multiplyScalar(r)), r, shift.clone().addScaledVector(axes[2], symbols.above.has(name) ? whole - r : r - whole), tint(item.type === 'support' ? '#999999' : '#3b3f46'), item.station));
  }
  return {items, batch, axesFor};
};
