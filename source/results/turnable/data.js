// The data of model_data.cc as numbers: stations, states, fields to colour by, envelopes.
const readModelData = data => {
  // Numbers at stations come as whole differences.
  const numbers = packed => {
    let level = 0;
    return Float32Array.from(packed.d, d => d === null ? NaN : packed.f * (level += d));
  };
  const [px, py, pz] = data.position.map(numbers), along = numbers(data.s), n = px.length;
  for (const step of data.steps) {
    const u = step.u.map(numbers);
    step.moves = Float32Array.from({length: 3 * n}, (_, k) => u[k % 3][Math.floor(k / 3)] || 0);
    step.size = Float32Array.from({length: n}, (_, i) => Math.hypot(...u.map(one => one[i])));
    step.values = [step.size, ...(step.fields || []).map(field => field && numbers(field))];
  }

  // Of a transient step, a state that is no shape: at each station the value of larger size, and its instant.
  const places = {'axial force N': 0, 'torsional moment Mx': 3};
  for (const envelope of data.envelopes) {
    if (!envelope.least) continue;
    for (const name of ['least', 'least_at', 'largest', 'largest_at']) envelope[name] = envelope[name].map(numbers);
    const end = data.steps.find(step => step.kind === 'step' && step.name === envelope.name);
    const state = {name: envelope.name, kind: 'envelope', amplitude: true, moves: new Float32Array(3 * n), size: null, values: [null], at: [null]};
    data.fields.forEach((field, k) => {
      const c = places[field.name], high = c === undefined ? [] : Array.from(envelope.largest[c], (value, i) => !(Math.abs(envelope.least[c][i]) > Math.abs(value)));
      const choose = (largest, least) => Float32Array.from(high, (is, i) => is ? largest[i] : least[i]);
      state.values.push(c !== undefined ? choose(envelope.largest[c], envelope.least[c]) : /code/.test(field.name) && end ? end.values[k + 1] : null);
      state.at.push(c !== undefined ? choose(envelope.largest_at[c], envelope.least_at[c]) : null);
    });
    data.steps.push(state);
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
  return {
    n, along, fields, shown, pipeOf,
    place: i => new THREE.Vector3(px[i], py[i], pz[i]),
    where: i => `${pipeOf(i).name}, s = ${shown(data.length.factor * along[i], 4)} ${data.length.unit}`,
    ofKind: kind => data.steps.filter(step => step.kind === kind),
    escaped: text => text.replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`)
  };
};

// Colours in bands: viridis from dark to light; blue, white and red where there are signs.
const modelColours = (() => {
  const stops = {plain: [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [235, 220, 60]],
                 signed: [[33, 102, 172], [146, 197, 222], [245, 245, 245], [244, 165, 130], [178, 24, 43]]};
  const bands = 12;
  const bandColours = kind => Array.from({length: bands}, (_, b) => {
    const at = 4 * b / (bands - 1), k = Math.min(3, Math.floor(at));
    return stops[kind][k].map((c, d) => Math.round(c + (at - k) * (stops[kind][k + 1][d] - c)));
  });
  return {bands, bandColours};
})();
