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
  for (const envelope of data.envelopes) {
    if (!envelope.forces) continue;
    for (const force of Object.values(envelope.forces)) for (const name in force) force[name] = numbers(force[name]);
    const end = data.steps.find(step => step.kind === 'step' && step.name === envelope.name);
    const state = {name: envelope.name, kind: 'envelope', amplitude: true, moves: new Float32Array(3 * n), size: null, values: [null], at: [null]};
    data.fields.forEach((field, k) => {
      const of = envelope.forces[field.key], high = of ? Array.from(of.largest, (value, i) => !(Math.abs(of.least[i]) > Math.abs(value))) : [];
      const choose = (largest, least) => Float32Array.from(high, (is, i) => is ? largest[i] : least[i]);
      state.values.push(of ? choose(of.largest, of.least) : (field.key === 'stress' || field.key === 'utilization') && end ? end.values[k + 1] : null);
      state.at.push(of ? choose(of.largest_at, of.least_at) : null);
    });
    data.steps.push(state);
  }

  const fields = [data.displacement, ...data.fields].map((field, k) => {
    field.known = data.steps.filter(step => step.kind !== 'mode' && step.values[k]);
    let low = field.key === 'temperature' ? Infinity : 0, high = low === 0 ? 0 : -Infinity;
    for (const step of field.known)
      for (const value of step.values[k]) { if (value < low) low = value; if (value > high) high = value; }
    if (field.signed) { high = Math.max(high, -low); low = -high; }
    return Object.assign(field, {low, high: high > low ? high : low + 1, any: high > low});
  });
  const shown = (value, digits) => value === null || value === undefined || Number.isNaN(value) ? '\u2013' : String(Number(Number(value).toPrecision(digits)));
  const pipeOf = i => data.pipes.find(pipe => i >= pipe.from && i <= pipe.to);
  const column = (kind, name) => data.columns[kind].indexOf(name);
  /** Of a state, a number of a support, restraint or point by its name in the csv file; kind: supports, reactions, points. */
  const numberOf = (step, kind, k, name) => step[kind][k][column(kind, name)];
  return {
    numberOf, n, along, fields, shown, pipeOf,
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
