// The model that one can turn. Data are those of model_data.cc; three.js and they are packed in the page.
(async () => {
  const $ = id => document.getElementById('model-' + id);
  const say = text => { $('message').textContent = text; $('message').hidden = !text; };
  const unpacked = async id => {
    const bytes = Uint8Array.from(atob(document.getElementById(id).textContent), c => c.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).text();
  };
  if (!window.DecompressionStream)
    return say('This browser is too old for the model that one can turn; the drawing below shows the line.');
  const library = document.createElement('script');
  library.textContent = await unpacked('model-three');
  document.head.append(library);
  const data = JSON.parse(await unpacked('model-data'));
  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({canvas: $('canvas'), antialias: true});
  } catch (error) {
    return say('This browser draws no WebGL; the drawing below shows the line.');
  }

  // Numbers at stations come as whole differences.
  const numbers = packed => {
    let level = 0;
    return Float32Array.from(packed.d, d => d === null ? NaN : packed.f * (level += d));
  };
  const [px, py, pz] = data.position.map(numbers), along = numbers(data.s), n = px.length;
  const place = i => new THREE.Vector3(px[i], py[i], pz[i]);
  for (const step of data.steps) {
    const u = step.u.map(numbers);
    step.moves = Float32Array.from({length: 3 * n}, (_, k) => u[k % 3][Math.floor(k / 3)] || 0);
    step.size = Float32Array.from({length: n}, (_, i) => Math.hypot(...u.map(one => one[i])));
    step.values = [step.size, ...(step.fields || []).map(field => field && numbers(field))];
  }
  const fields = [data.displacement, ...data.fields].map((field, k) => {
    field.known = data.steps.filter(step => step.kind !== 'mode' && step.values[k]);
    let low = field.name === 'temperature' ? Infinity : 0, high = low === 0 ? 0 : -Infinity;
    for (const step of field.known)
      for (const value of step.values[k]) { if (value < low) low = value; if (value > high) high = value; }
    if (field.signed) { high = Math.max(high, -low); low = -high; }
    return Object.assign(field, {low, high: high > low ? high : low + 1, any: high > low});
  });
  const shown = (value, digits) => value === null || value === undefined || Number.isNaN(value) ? '\u2013' : String(Number(Number(value).toPrecision(digits)));
  const pipeOf = i => data.pipes.find(pipe => i >= pipe.from && i <= pipe.to);
  const where = i => `${pipeOf(i).name}, s = ${shown(data.length.factor * along[i], 4)} ${data.length.unit}`;

  // Colours in bands: viridis from dark to light; blue, white and red where there are signs.
  const stops = {plain: [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [235, 220, 60]],
                 signed: [[33, 102, 172], [146, 197, 222], [245, 245, 245], [244, 165, 130], [178, 24, 43]]};
  const bands = 12;
  const bandColours = kind => Array.from({length: bands}, (_, b) => {
    const at = 4 * b / (bands - 1), k = Math.min(3, Math.floor(at));
    return stops[kind][k].map((c, d) => Math.round(c + (at - k) * (stops[kind][k + 1][d] - c)));
  });
  const palette = new THREE.DataTexture(new Uint8Array(3 * bands), bands, 1, THREE.RGBFormat);
  palette.magFilter = palette.minFilter = THREE.NearestFilter;
  const statusColours = {stick: '#0072b2', slip: '#d55e00', open: '#f4f4f4', closed: '#009e73', none: '#999999'};
  const tint = colour => new THREE.Color(colour).toArray();

  // Pipes: rings along each, by parallel transport of one normal.
  const symbols = makeModelSymbols();
  const uniforms = {scale: {value: data.scale}, blend: {value: 0}, pixel: {value: 0}};
  const box = new THREE.Box3();
  for (let i = 0; i < n; ++i) box.expandByPoint(place(i));
  for (const one of [...data.supports, ...data.restraints]) box.expandByPoint(new THREE.Vector3(...one.at));
  const size = Math.max(box.getSize(new THREE.Vector3()).length(), 1e-6);
  const tangents = [], radii = [], sides = n > 2500 ? 8 : 12, line = new symbols.Batch(), built = [];
  for (const pipe of data.pipes) {
    const far = (i, step) => { // the next place that is another one
      let k = i + step;
      while (k >= pipe.from && k <= pipe.to && place(k).distanceTo(place(i)) < 1e-9 * size) k += step;
      return k >= pipe.from && k <= pipe.to ? place(k) : place(i);
    };
    let normal = null;
    for (let i = pipe.from; i <= pipe.to; ++i) {
      const t = far(i, 1).sub(far(i, -1)).normalize();
      if (t.length() === 0) t.set(1, 0, 0);
      tangents[i] = t;
      const part = pipe.to > pipe.from ? (along[i] - along[pipe.from]) / (along[pipe.to] - along[pipe.from] || 1) : 0;
      const r = radii[i] = Math.max(pipe.radius + part * (pipe.end_radius - pipe.radius), 1e-4 * size) * (pipe.rigid ? 1.25 : 1);
      if (!normal) normal = Math.abs(t.z) < 0.9 ? new THREE.Vector3(0, 0, 1) : new THREE.Vector3(1, 0, 0);
      normal = normal.clone().addScaledVector(t, -normal.dot(t)).normalize();
      const other = t.clone().cross(normal), first = line.count;
      for (let k = 0; k < sides; ++k) {
        const angle = 2 * Math.PI * k / sides;
        const way = normal.clone().multiplyScalar(Math.cos(angle)).addScaledVector(other, Math.sin(angle));
        line.vertex(place(i), way.clone().multiplyScalar(r), way, r, [0.6, 0.6, 0.6], i);
        if (i > pipe.from) {
          const a = first + k, b = first + (k + 1) % sides;
          line.lists.index.push(a, b, a - sides, b, b - sides, a - sides);
        }
      }
      if (i > pipe.from) built.push(place(i - 1), place(i));
      for (let k = 1; (i === pipe.from || i === pipe.to) && k < sides - 1; ++k)
        line.lists.index.push(first, first + k, first + k + 1);
    }
  }
  const ringsOf = line.stations; // station of each vertex
  const pipeMesh = line.mesh(symbols.material(palette, uniforms, 1.7));

  // Supports and restraints: each item has a shape, a place and axes; at one place those that would cover each other are
  // moved along the pipe.
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
  const batch = new symbols.Batch(), taken = new Map();
  for (const item of items) {
    const key = item.at.map(x => Math.round(x / size * 1e6)).join(), others = taken.get(key) || [];
    const covers = other => symbols.around.has(other.parts[0][0]) || symbols.around.has(item.parts[0][0]) ||
      other.parts[0][1][2].dot(item.parts[0][1][2]) > 0.5;
    const slots = others.filter(covers).map(other => other.slot);
    item.slot = [0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5].find(slot => !slots.includes(slot)) || 0;
    taken.set(key, [...others, item]);
    const r = item.radius = radii[item.station], shift = tangents[item.station].clone().multiplyScalar(4.4 * r * item.slot);
    item.centre = new THREE.Vector3(...item.at);
    item.middle = shift.clone().addScaledVector(item.parts[0][1][2], r * ({rest: -2, guide: -2, snubber: -3.5, spring: -3, holds: -2.5, hanger: 5, constant: 5, rod: 5}[item.parts[0][0]] || 0));
    item.ranges = item.parts.map(([name, axes]) => batch.add(symbols.shape(name), item.centre,
      axes.map(axis => axis.clone().multiplyScalar(r)), r, shift, tint(item.type === 'support' ? '#999999' : '#3b3f46'), item.station));
  }
  const leastOfSymbols = 4;
  const symbolMesh = items.length ? batch.mesh(symbols.material(null, uniforms, leastOfSymbols)) : new THREE.Group();
  const offsets = items.length && symbolMesh.geometry.attributes.offset.array.slice();

  const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(30, 1, size / 100, 100 * size);
  scene.background = new THREE.Color('#ffffff');
  camera.up.set(0, 0, 1);
  const builtLine = new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(built), new THREE.LineBasicMaterial({color: '#b9bec5'}));
  scene.add(builtLine, pipeMesh, symbolMesh);
  let arrows = null;

  // What is shown.
  const state = {from: null, to: null, list: null, field: 0, playing: false, picked: null, began: 0};
  const ends = data.steps.filter(step => step.kind === 'step');
  const choices = new Map(); // of the chooser: lists of states
  const group = (label, entries) => {
    if (!entries.length) return;
    const element = document.createElement('optgroup');
    element.label = label;
    for (const [name, states] of entries) {
      const option = new Option(name, String(choices.size));
      choices.set(option.value, states);
      element.append(option);
    }
    $('step').append(element);
  };
  const ofKind = kind => data.steps.filter(step => step.kind === kind);
  group('at the end of', ends.map(step => [step.name, [step]]));
  group('cases', ofKind('case').map(step => [step.name, [step]]));
  group('over time', [...new Set(ofKind('instant').map(step => step.name))].map(name => [name + ', over time', ofKind('instant').filter(step => step.name === name)]));
  group('modes', ofKind('mode').map(step => [step.name, [step]]));
  fields.forEach((field, k) => { if (k === 0 || field.any) $('field').append(new Option(field.name, k)); });
  if (data.supports.length) $('field').append(new Option('contact status alone', -1));

  const isMode = step => step.kind === 'mode';
  const factorOf = step => isMode(step) ? 0.05 * size / Math.max(...step.size) : step.amplitude ? 0 : data.scale;

  function colour(step, column) {
    const k = state.field, values = k < 0 ? null : isMode(step) ? (k === 0 ? step.size : null) : step.values[k];
    const low = isMode(step) ? 0 : k < 0 ? 0 : fields[k].low, high = isMode(step) ? Math.max(...step.size) : k < 0 ? 1 : fields[k].high;
    const to = pipeMesh.geometry.attributes.value;
    ringsOf.forEach((station, v) => {
      const part = values ? (values[station] - low) / (high - low) : -1;
      to.array[2 * v + column] = Number.isNaN(part) ? -1 : Math.max(part, 0);
    });
    to.needsUpdate = true;
  }

  function drawSupports(step) {
    if (items.length) {
      const tints = symbolMesh.geometry.attributes.tint, moved = symbolMesh.geometry.attributes.offset;
      for (const item of items.filter(one => one.type === 'support')) {
        const status = step.supports ? step.supports[item.k][0] : 'none', apart = status === 'open' ? -0.8 * item.radius : 0;
        const rgb = tint(statusColours[status]), z = item.parts[0][1][2].toArray();
        for (let v = item.ranges[0][0]; v < item.ranges[0][1]; ++v)
          for (let d = 0; d < 3; ++d) {
            tints.array[3 * v + d] = rgb[d];
            moved.array[3 * v + d] = offsets[3 * v + d] + apart * z[d];
          }
      }
      tints.needsUpdate = moved.needsUpdate = true;
    }
    if (arrows) { scene.remove(arrows.mesh); arrows.mesh.geometry.dispose(); arrows = null; }
    if (!$('arrows').checked || !step.supports) return;
    const force = item => {
      const row = item.type === 'support' ? step.supports[item.k] : step.reactions[item.k], f = new THREE.Vector3();
      if (item.type === 'support')
        return f.addScaledVector(new THREE.Vector3(...item.n), row[1]).addScaledVector(new THREE.Vector3(...item.t1), row[2]).addScaledVector(new THREE.Vector3(...item.t2), row[3]);
      return f.set(row[0], row[1], row[2]);
    };
    const forces = items.map(force), most = Math.max(...forces.map(f => f.length()));
    const all = new symbols.Batch();
    items.forEach((item, i) => {
      const f = forces[i].length(), length = 0.09 * size * f / most, thick = Math.min(0.006 * size, 0.12 * length);
      if (!(f > 1e-3 * most)) return;
      const [x, y, z] = axesFor(forces[i].clone().normalize(), item.station);
      all.add(symbols.shape('arrow'), item.centre, [x.multiplyScalar(thick), y.multiplyScalar(thick), z.multiplyScalar(length)],
              size, new THREE.Vector3(), tint('#cc2a86'), item.station);
    });
    if (!all.count) return;
    arrows = {batch: all, mesh: all.mesh(symbols.material(null, uniforms, 0))};
    scene.add(arrows.mesh);
  }

  // From one state to another; the same twice is a picture that stands.
  function show(from, to, blend) {
    if (state.from !== from) {
      for (const one of [line, items.length && batch]) if (one) one.move('u0', from.moves);
      colour(from, 0);
      drawSupports(from);
      if (arrows) { arrows.batch.move('u0', from.moves); arrows.batch.move('u1', to.moves); }
    }
    if (state.to !== to) {
      for (const one of [line, items.length && batch, arrows && arrows.batch]) if (one) one.move('u1', to.moves);
      colour(to, 1);
    }
    const fresh = state.from !== from;
    Object.assign(state, {from, to});
    uniforms.blend.value = blend;
    uniforms.scale.value = factorOf(from) * (isMode(from) || from.amplitude ? 1 : Number($('scale').value) / 100);
    if (fresh) legend();
    draw();
  }
  const stand = step => show(step, step, 0);
  function refresh() { state.from = state.to = null; stand(state.list[Number($('time').value) % state.list.length]); }

  function legend() {
    const step = state.from, k = state.field, field = fields[Math.max(k, 0)], mode = isMode(step);
    $('scale-shown').value = mode ? 'mode' : step.amplitude ? '0' : shown(uniforms.scale.value, 3);
    let text = '';
    if (k >= 0 && !(mode && k > 0) && (mode || step.values[k])) {
      const colours = bandColours(field.signed ? 'signed' : 'plain').map(c => `rgb(${c})`);
      palette.image.data.set(bandColours(field.signed ? 'signed' : 'plain').flat());
      palette.needsUpdate = true;
      const at = part => mode ? shown(part, 2) : shown(field.factor * (field.low + part * (field.high - field.low)), 3);
      text = `<b>${field.name}${mode ? ' of the shape' : field.unit ? ` [${field.unit}]` : ''}</b><div class="band" style="background:linear-gradient(to right,${colours.map((c, b) => `${c} ${100 * b / bands}% ${100 * (b + 1) / bands}%`)})"></div>` +
        `<div class="ticks">${[0, 0.25, 0.5, 0.75, 1].map(part => `<span>${at(part)}</span>`).join('')}</div>`;
      state.most = null;
      if (!mode) {
        let most = -1;
        step.values[k].forEach((value, i) => { if (most < 0 || Math.abs(value) > Math.abs(step.values[k][most])) most = i; });
        if (most >= 0 && step.values[k][most]) {
          text += `<div>most here: ${shown(field.factor * step.values[k][most], 4)} ${field.unit}, ${escaped(where(most))}</div>`;
          state.most = most;
        }
      }
    } else {
      state.most = null;
      if (k >= 0) text = `<b>${field.name}</b><div>not known of ${escaped(step.name)}: grey</div>`;
    }
    if (step.supports && step.supports.length) {
      const count = {};
      for (const row of step.supports) count[row[0]] = (count[row[0]] || 0) + 1;
      text += '<div class="statuses">' + Object.keys(count).map(status => `<span style="--c:${statusColours[status]}">${status} ${count[status]}</span>`).join('') + '</div>';
    }
    $('legend').innerHTML = text;
    const when = step.kind === 'instant' ? `, ${shown(step.time, 5)} s` : '';
    $('status').textContent = step.name + when + (step.amplitude ? ' (sizes of either sign: no shape)' : '');
  }
  const escaped = text => text.replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`);

  // A place on the screen, where the line is now.
  const view = {width: 1, height: 1};
  const screen = (centre, station, offset, radius) => {
    const a = state.from.moves, b = state.to.moves, t = uniforms.blend.value, c = centre.clone();
    ['x', 'y', 'z'].forEach((d, k) => { c[d] += uniforms.scale.value * ((1 - t) * a[3 * station + k] + t * b[3 * station + k]); });
    if (offset) {
      const depth = -c.clone().applyMatrix4(camera.matrixWorldInverse).z;
      c.addScaledVector(offset, Math.max(1, leastOfSymbols * uniforms.pixel.value * depth / radius));
    }
    c.project(camera);
    return {x: (c.x + 1) / 2 * view.width, y: (1 - c.y) / 2 * view.height, seen: Math.abs(c.z) < 1};
  };
  const onScreen = item => item.type === 'pipe' || item.type === 'point' ? screen(place(item.station), item.station)
    : screen(item.centre, item.station, item.middle, item.radius);
  const points = data.points.map((point, k) => ({type: 'point', k, ...point}));
  const pipes = data.pipes.map(pipe => ({type: 'pipe', name: pipe.name, station: Math.floor((pipe.from + pipe.to) / 2)}));

  function overlay() {
    const canvas = $('overlay'), ratio = window.devicePixelRatio || 1, pen = canvas.getContext('2d');
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, view.width, view.height);
    pen.font = '12px system-ui, sans-serif';
    const kinds = {points: [points], supports: [items], pipes: [pipes], all: [points, items, pipes]}[$('names').value] || [];
    const written = [];
    for (const item of kinds.flat()) {
      const at = onScreen(item), wide = pen.measureText(item.name).width;
      const room = [at.x + 6, at.y - 16, at.x + 10 + wide, at.y - 1];
      if (!at.seen || written.length > 300 || written.some(w => room[0] < w[2] && room[2] > w[0] && room[1] < w[3] && room[3] > w[1])) continue;
      written.push(room);
      pen.fillStyle = 'rgba(255,255,255,.8)';
      pen.fillRect(room[0], room[1], room[2] - room[0], room[3] - room[1]);
      pen.fillStyle = item.type === 'pipe' ? '#666' : item.type === 'point' ? '#111' : '#14508a';
      pen.fillText(item.name, at.x + 8, at.y - 4);
    }
    const ring = (at, colour) => { pen.beginPath(); pen.arc(at.x, at.y, 9, 0, 7); pen.lineWidth = 2; pen.strokeStyle = colour; pen.stroke(); };
    if (state.most !== null && state.most !== undefined) ring(screen(place(state.most), state.most), '#111');
    if (state.picked) ring(onScreen(state.picked), '#cc2a86');
    const origin = {x: 38, y: view.height - 38};
    ['x', 'y', 'z'].forEach((name, d) => {
      const way = new THREE.Vector3().setComponent(d, 1).transformDirection(camera.matrixWorldInverse);
      pen.beginPath(); pen.moveTo(origin.x, origin.y); pen.lineTo(origin.x + 24 * way.x, origin.y - 24 * way.y);
      pen.lineWidth = 1.5; pen.strokeStyle = '#444'; pen.stroke();
      pen.fillStyle = '#222'; pen.fillText(name, origin.x + 31 * way.x - 3, origin.y - 31 * way.y + 4);
    });
  }

  let due = false, frames = [], onFrame = null;
  function draw() { if (!due) { due = true; requestAnimationFrame(paint); } }
  function paint(now) {
    due = false;
    if (onFrame) onFrame(now);
    if (state.playing) play(now);
    renderer.render(scene, camera);
    overlay();
    if (!state.playing && !onFrame) { frames = []; return; }
    frames = [...frames.filter(time => now - time < 2000), now]; // the page's own count
    if (frames.length > 5) {
      $('canvas').dataset.fps = ((frames.length - 1) / (now - frames[0]) * 1000).toFixed(1);
      $('status').textContent = $('status').textContent.replace(/ \| .*/, '') + ` | ${Math.round($('canvas').dataset.fps)} frames/s`;
    }
    draw();
  }
  function play(now) {
    const list = state.list.length > 1 ? state.list : isMode(state.list[0]) ? state.list : ends;
    if (isMode(list[0])) {
      uniforms.scale.value = factorOf(list[0]) * Math.sin((now - state.began) / 300);
      return;
    }
    const stay = list === ends ? 1100 : Math.max(40, 8000 / list.length), at = (now - state.began) / stay % list.length;
    const a = Math.floor(at), b = Math.min(a + 1, list.length - 1), part = at - a;
    if (list === ends) $('step').value = [...choices].find(([, states]) => states[0] === list[a])[0]; else $('time').value = a;
    show(list[a], list[b], list === ends ? Math.min(1, Math.max(0, 2 * part - 1)) : part);
  }
  function run(playing) {
    state.playing = playing;
    state.began = performance.now();
    $('play').setAttribute('aria-pressed', playing);
    $('play').textContent = playing ? '\u23f8 pause' : '\u25b6 play';
    if (!playing) { if (isMode(state.list[0])) refresh(); else choose(); }
    draw();
  }

  // The table of what was picked, over all states.
  function pick(item) {
    state.picked = item;
    const states = data.steps.filter(step => step.kind !== 'mode'), unit = name => data.units[name];
    let title = '', head = [], row = null;
    if (item.type === 'support') {
      title = `Support ${item.name}, ${item.kind}`;
      head = ['status', ...['fn', 'ft1', 'ft2'].map(c => [c, unit('N')]), ...['gap', 'slip1', 'slip2'].map(c => [c, unit('m')]), ['friction work', unit('J')], ['mt', unit('N m')]];
      row = step => step.supports[item.k];
    } else if (item.type === 'restraint') {
      title = `${item.kind || 'restraint'} ${item.name}`;
      head = [...['fx', 'fy', 'fz'].map(c => [c, unit('N')]), ...['mx', 'my', 'mz'].map(c => [c, unit('N m')])];
      row = step => step.reactions[item.k];
    } else if (item.type === 'point') {
      title = `Point ${item.name}, ${where(item.station)}`;
      head = [...['ux', 'uy', 'uz'].map(c => [c, unit('m')]), ...['rx', 'ry', 'rz'].map(c => [c, unit('rad')])];
      row = step => step.points[item.k];
    } else {
      const known = fields.map((field, k) => k).filter(k => k === 0 || fields[k].any);
      title = `Pipe ${where(item.station)} (${pipeOf(item.station).section})`;
      head = known.map(k => [fields[k].name, fields[k].unit]);
      row = step => known.map(k => step.values[k] ? fields[k].factor * step.values[k][item.station] : null);
    }
    const digits = item.type === 'pipe' ? 4 : 7, rows = states.map(step => [step, row(step)]).filter(([, cells]) => cells);
    const time = states.some(step => step.kind === 'instant');
    $('table').innerHTML = `<h3>${escaped(title)}</h3><div class="scroll"><table><thead><tr><th>state</th>${time ? '<th class="r">time <small>s</small></th>' : ''}` +
      head.map(h => typeof h === 'string' ? `<th>${h}</th>` : `<th class="r">${h[0]} <small>${h[1]}</small></th>`).join('') + '</tr></thead><tbody>' +
      rows.map(([step, cells]) => `<tr${step === state.from ? ' class="now"' : ''}><td>${escaped(step.name)}${step.kind === 'instant' ? ' (instant)' : ''}</td>${time ? `<td class="r">${shown(step.time, 6)}</td>` : ''}` +
        cells.map(cell => typeof cell === 'string' ? `<td>${cell}</td>` : `<td class="r">${shown(cell, digits)}</td>`).join('') + '</tr>').join('') + '</tbody></table></div>' +
      (item.type === 'pipe' && data.left_out ? '<p class="note">The line is thinned here: values are the largest nearby. The csv files have every station.</p>' : '');
    draw();
  }
  function pickAt(x, y) {
    const nearest = (list, reach) => {
      let best = null, least = reach;
      for (const item of list) {
        const at = onScreen(item), far = Math.hypot(at.x - x, at.y - y);
        if (at.seen && far < least) { least = far; best = item; }
      }
      return best;
    };
    const found = nearest(items, 14) || nearest(points, 7) ||
      nearest(Array.from({length: n}, (_, i) => ({type: 'pipe', name: '', station: i})), 22);
    if (found) pick(found);
  }

  // Camera and controls.
  const controls = new THREE.OrbitControls(camera, $('canvas'));
  controls.enableKeys = controls.enableZoom = false; // the wheel is the page's until the model is clicked
  controls.addEventListener('change', draw);
  $('canvas').addEventListener('focus', () => { controls.enableZoom = true; });
  $('canvas').addEventListener('blur', () => { controls.enableZoom = false; });
  function look(x, y, z) {
    const back = new THREE.Vector3(x, y, z).normalize(), right = new THREE.Vector3(0, 0, 1).cross(back).normalize(), up = back.clone().cross(right);
    const span = [right, up, back].map(axis => {
      let low = Infinity, high = -Infinity;
      const see = p => { const at = p.dot(axis); low = Math.min(low, at); high = Math.max(high, at); };
      for (let i = 0; i < n; ++i) see(place(i));
      for (const item of items) see(item.centre);
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
  function resize() {
    const frame = $('canvas').parentElement, ratio = Math.min(window.devicePixelRatio || 1, 2);
    view.width = frame.clientWidth; view.height = frame.clientHeight;
    renderer.setPixelRatio(ratio);
    renderer.setSize(view.width, view.height, false);
    $('overlay').width = view.width * (window.devicePixelRatio || 1);
    $('overlay').height = view.height * (window.devicePixelRatio || 1);
    camera.aspect = view.width / view.height;
    camera.updateProjectionMatrix();
    uniforms.pixel.value = 2 * Math.tan(camera.fov * Math.PI / 360) / view.height;
    draw();
  }
  function choose() {
    state.list = choices.get($('step').value);
    $('time-label').hidden = state.list.length < 2;
    $('time').max = state.list.length - 1;
    $('time').value = Math.min(Number($('time').value), state.list.length - 1);
    refresh();
    if (state.picked) pick(state.picked);
  }
  let down = null;
  $('canvas').addEventListener('pointerdown', event => { down = event; $('canvas').focus(); });
  $('canvas').addEventListener('pointerup', event => {
    if (down && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < 5) pickAt(event.offsetX, event.offsetY);
  });
  $('canvas').addEventListener('keydown', event => {
    const turn = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]}[event.key];
    const nearer = {'+': 0.85, '-': 1 / 0.85}[event.key];
    if (!turn && !nearer) return;
    event.preventDefault();
    const way = camera.position.clone().sub(controls.target).multiplyScalar(nearer || 1);
    if (turn) {
      const flat = Math.hypot(way.x, way.y), height = Math.min(1.55, Math.max(-1.55, Math.atan2(way.z, flat) - turn[1]));
      const angle = Math.atan2(way.y, way.x) + turn[0], far = way.length();
      way.set(Math.cos(angle) * Math.cos(height), Math.sin(angle) * Math.cos(height), Math.sin(height)).multiplyScalar(far);
    }
    camera.position.copy(controls.target).add(way);
    controls.update();
  });
  $('step').onchange = () => { $('time').value = 0; if (state.playing) run(false); else choose(); };
  $('time').oninput = () => { if (state.playing) run(false); else refresh(); };
  $('field').onchange = () => { state.field = Number($('field').value); refresh(); };
  $('scale').oninput = () => { if (!state.playing) refresh(); };
  $('names').onchange = draw;
  $('arrows').onchange = refresh;
  $('built').onchange = () => { builtLine.visible = $('built').checked; draw(); };
  $('play').onclick = () => run(!state.playing);
  for (const button of document.querySelectorAll('[data-view]'))
    button.onclick = () => look(...button.dataset.view.split(' ').map(Number));
  new ResizeObserver(resize).observe($('canvas').parentElement);

  resize();
  $('step').value = [...choices].find(([, states]) => states[0] === (ends[ends.length - 1] || data.steps[0]))[0];
  choose();
  look(1, -1, 0.82);
  say('');
  const model = document.getElementById('model');
  model.locate = name => { // where on the page a part is, for tests
    const item = [...items, ...points].find(one => one.name === name), at = onScreen(item), frame = $('canvas').getBoundingClientRect();
    return [frame.left + at.x, frame.top + at.y];
  };
  model.dataset.ready = 'yes';
  if (/fps/.test(location.search + location.hash)) { // turn for some seconds and count
    const began = performance.now(), start = camera.position.clone().sub(controls.target);
    onFrame = now => {
      camera.position.copy(controls.target).add(start.clone().applyAxisAngle(camera.up, (now - began) / 1500));
      controls.update();
      if (now - began > 4000) { onFrame = null; model.dataset.counted = $('canvas').dataset.fps; }
    };
    draw();
  }
})();
