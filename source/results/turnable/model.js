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
    renderer = new THREE.WebGLRenderer({canvas: $('canvas'), antialias: false});
  } catch (error) {
    return say('This browser draws no WebGL; the drawing below shows the line.');
  }

  const read = readModelData(data), {numberOf, n, along, fields, place, shown, where, ofKind, escaped} = read, tables = makeModelTables(data, read);

  const {bands, bandColours} = modelColours;
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
  const tangents = [], radii = [], sides = n > 1000 ? 8 : 12, line = new symbols.Batch(), built = [];
  for (const pipe of data.pipes) {
    const far = (i, step) => { // the next place that is another one
      let k = i + step;
      while (k >= pipe.from && k <= pipe.to && place(k).distanceTo(place(i)) < 1e-9 * size) k += step;
      return k >= pipe.from && k <= pipe.to ? place(k) : place(i);
    };
    let normal = null, before = line.count;
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
      // While it moves: every other side, and of straight stretches every other station.
      const bends = i > pipe.from && t.distanceTo(tangents[i - 1]) > 1e-3;
      if (i > pipe.from && (bends || i === pipe.to || first - before > sides)) {
        for (let k = 0; k < sides; k += 2) {
          const a = first + k, b = first + (k + 2) % sides, c = before + k, d = before + (k + 2) % sides;
          line.lists.coarse.push(a, b, c, b, d, c);
        }
        before = first;
      }
      if (i > pipe.from) built.push(place(i - 1), place(i));
      for (let k = 1; (i === pipe.from || i === pipe.to) && k < sides - 1; ++k)
        line.lists.index.push(first, first + k, first + k + 1);
    }
  }
  const ringsOf = line.stations; // station of each vertex
  const pipeMesh = line.mesh(symbols.material(palette, uniforms, 1.7));

  const {items, batch, axesFor} = placeModelSupports(data, symbols, tangents, radii, size, tint);
  const leastOfSymbols = $('canvas').clientWidth < 600 ? 2.5 : 4; // px
  const symbolMesh = items.length ? batch.mesh(symbols.material(null, uniforms, leastOfSymbols)) : new THREE.Group();
  const offsets = items.length && symbolMesh.geometry.attributes.offset.array.slice();

  const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(30, 1, size / 100, 100 * size);
  scene.background = new THREE.Color('#ffffff');
  camera.up.set(0, 0, 1);
  const builtLine = new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(built), new THREE.LineBasicMaterial({color: '#b9bec5'}));
  scene.add(builtLine, pipeMesh, symbolMesh);
  let arrows = null;

  // What is shown.
  const state = {from: null, to: null, list: null, field: 0, playing: false, picked: null, began: 0, told: 0};
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
  group('at the end of', ends.map(step => [step.name, [step]]));
  group('cases', ofKind('case').map(step => [step.name, [step]]));
  group('over time', [...new Set(ofKind('instant').map(step => step.name))].map(name => [name + ', over time', ofKind('instant').filter(step => step.name === name)]));
  group('largest over time', ofKind('envelope').map(step => [step.name + ', largest', [step]]));
  group('modes', ofKind('mode').map(step => [step.name, [step]]));
  fields.forEach((field, k) => { if (k === 0 || field.any) $('field').append(new Option(field.name, k)); });
  if (data.supports.length) $('field').append(new Option('contact status alone', -1));

  const isMode = step => step.kind === 'mode';
  const factorOf = step => isMode(step) ? 0.05 * size / Math.max(...step.size) : step.amplitude ? 0 : data.scale;

  function colour(step, column) {
    const k = state.field, values = k < 0 ? null : isMode(step) ? (k === 0 ? step.size : null) : step.values[k];
    const low = isMode(step) ? 0 : k < 0 ? 0 : fields[k].low, high = isMode(step) ? Math.max(...step.size) : k < 0 ? 1 : fields[k].high;
    const to = pipeMesh.geometry.attributes.value;
    for (let v = 0; v < ringsOf.length; ++v) {
      const part = values ? (values[ringsOf[v]] - low) / (high - low) : -1;
      to.array[2 * v + column] = Number.isNaN(part) ? -1 : Math.max(part, 0);
    }
    to.needsUpdate = true;
  }

  function drawSupports(step) {
    if (items.length) {
      const tints = symbolMesh.geometry.attributes.tint, moved = symbolMesh.geometry.attributes.offset;
      for (const item of items.filter(one => one.type === 'support')) {
        const status = step.supports ? numberOf(step, 'supports', item.k, 'status') : 'none', apart = status === 'open' ? -0.8 * item.radius : 0;
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
      const f = new THREE.Vector3();
      if (item.type !== 'support') return f.set(...['fx', 'fy', 'fz'].map(name => numberOf(step, 'reactions', item.k, name)));
      for (const [axis, name] of [['n', 'fn'], ['t1', 'ft1'], ['t2', 'ft2']])
        f.addScaledVector(new THREE.Vector3(...item[axis]), numberOf(step, 'supports', item.k, name));
      return f;
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
    if (fresh && !(state.playing && performance.now() - state.told < 250)) legend();
    draw();
  }
  const stand = step => show(step, step, 0);
  function refresh() { state.from = state.to = null; stand(state.list[Number($('time').value) % state.list.length]); }

  function legend() {
    const step = state.from, k = state.field, field = fields[Math.max(k, 0)], mode = isMode(step);
    state.told = performance.now();
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
          text += `<div>most here: ${shown(field.factor * step.values[k][most], 4)} ${field.unit}, ${escaped(where(most))}${step.at && step.at[k] ? `, at ${shown(step.at[k][most], 4)} s` : ''}</div>`;
          state.most = most;
        }
      }
    } else {
      state.most = null;
      if (k >= 0) text = `<b>${field.name}</b><div>not known of ${escaped(step.name)}: grey</div>`;
    }
    if (step.supports && step.supports.length) {
      const count = {};
      step.supports.forEach((_, k) => { const status = numberOf(step, 'supports', k, 'status'); count[status] = (count[status] || 0) + 1; });
      text += '<div class="statuses">' + Object.keys(count).map(status => `<span style="--c:${statusColours[status]}">${status} ${count[status]}</span>`).join('') + '</div>';
    }
    $('legend').innerHTML = text;
    const when = step.kind === 'instant' ? `, ${shown(step.time, 5)} s` : '';
    $('status').textContent = step.name + when + (step.kind === 'envelope' ? ', largest of all instants (no shape)' : step.amplitude ? ' (sizes of either sign: no shape)' : '');
  }

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

  const paintOver = makeModelOverlay($('overlay'), camera);
  function overlay() {
    const kinds = {points: [points], supports: [items], pipes: [pipes], all: [points, items, pipes]}[$('names').value] || [];
    const named = kinds.flat().map(item => [item, onScreen(item), item.type === 'pipe' ? '#666' : item.type === 'point' ? '#111' : '#14508a']);
    const rings = [];
    if (state.most !== null && state.most !== undefined) rings.push([screen(place(state.most), state.most), '#111']);
    if (state.picked) rings.push([onScreen(state.picked), '#cc2a86']);
    paintOver(view.width, view.height, named, rings);
  }

  // What moves is drawn with one pixel for each of the screen's, and fewer where that is too slow; what stands, with four.
  let due = false, frames = [], onFrame = null, still = 0, fine = 0, coarse = 1;
  function draw() { if (!due) { due = true; requestAnimationFrame(paint); } }
  function fineness(factor) {
    if (fine === factor) return;
    fine = factor;
    renderer.setPixelRatio(factor * Math.min(window.devicePixelRatio || 1, 2));
  }
  function paint(now) {
    due = false;
    const moving = state.playing || onFrame || now - still > 0;
    fineness(moving ? coarse : 2);
    if (n + 10 * items.length > 1000) for (const one of [line, items.length && batch]) if (one) one.simplify(moving);
    clearTimeout(fineness.later);
    if (moving && !state.playing && !onFrame) fineness.later = setTimeout(() => { still = Infinity; draw(); }, 150);
    still = 0;
    if (onFrame) onFrame(now);
    if (state.playing) play(now);
    renderer.render(scene, camera);
    overlay();
    if (!state.playing && !onFrame) { frames = []; return; }
    frames.push(now); // the page's own count, told twice a second
    if (now - frames[0] > 500 && frames.length > 5) {
      const rate = (frames.length - 1) / (now - frames[0]) * 1000;
      if (coarse === 1 && rate < 25) coarse = 0.6;
      $('canvas').dataset.fps = rate.toFixed(1);
      $('status').textContent = $('status').textContent.replace(/ \| .*/, '') + ` | ${Math.round(rate)} frames/s`;
      frames = [now];
    }
    draw();
  }
  const listToPlay = () => state.list.length > 1 || isMode(state.list[0]) ? state.list : ends.length > 1 && ends.includes(state.list[0]) ? ends : null;
  function play(now) {
    const list = listToPlay();
    if (isMode(list[0])) {
      uniforms.scale.value = factorOf(list[0]) * Math.sin((now - state.began) / 300);
      return;
    }
    const stay = list === ends ? 1100 : Math.max(40, 8000 / list.length), at = Math.max(0, now - state.began) / stay % list.length;
    const a = Math.floor(at), b = Math.min(a + 1, list.length - 1), part = at - a;
    if (list === ends) $('step').value = [...choices].find(([, states]) => states[0] === list[a])[0]; else $('time').value = a;
    show(list[a], list[b], list === ends ? Math.min(1, Math.max(0, 2 * part - 1)) : part);
    tables.mark(list[a].kind === 'instant' ? (1 - part) * list[a].time + part * list[b].time : null);
  }
  function run(playing) {
    state.playing = playing;
    state.began = performance.now();
    $('play').setAttribute('aria-pressed', playing);
    $('play').textContent = playing ? '\u23f8 pause' : '\u25b6 play';
    if (!playing) { if (isMode(state.list[0])) refresh(); else choose(); }
    draw();
  }

  // What was picked, and its numbers over all states.
  function pick(item) {
    state.picked = item;
    tables.tell($('table'), item, state.from, instant => {
      const list = [...choices].find(([, states]) => states.length > 1 && states.includes(instant));
      if (!list) return;
      if (state.playing) run(false);
      $('step').value = list[0];
      $('time').max = list[1].length - 1;
      $('time').value = list[1].indexOf(instant);
      choose();
    });
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

  const {controls, look, fit} = makeModelView($('canvas'), camera, size, see => {
    const at = new THREE.Vector3();
    for (let i = 0; i < n; ++i) {
      see(place(i), radii[i]);
      if (state.from) see(place(i).addScaledVector(at.fromArray(state.from.moves, 3 * i), uniforms.scale.value), radii[i]);
    }
    for (const item of items) see(item.centre, radii[item.station] + 3 * item.radius);
  }, draw);
  function resize() {
    const frame = $('canvas').parentElement;
    view.width = frame.clientWidth; view.height = frame.clientHeight;
    renderer.setSize(view.width, view.height, false);
    $('overlay').width = view.width * (window.devicePixelRatio || 1);
    $('overlay').height = view.height * (window.devicePixelRatio || 1);
    camera.aspect = view.width / view.height;
    camera.updateProjectionMatrix();
    uniforms.pixel.value = 2 * Math.tan(camera.fov * Math.PI / 360) / view.height;
    fit();
    draw();
  }
  function choose() {
    state.list = choices.get($('step').value);
    $('time-label').hidden = state.list.length < 2;
    $('play').hidden = !listToPlay();
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
  $('step').onchange = () => { $('time').value = 0; if (state.playing) run(false); else choose(); };
  $('time').oninput = () => { if (state.playing) run(false); else { refresh(); tables.mark(state.from.kind === 'instant' ? state.from.time : null); } };
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
