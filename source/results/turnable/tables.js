// What is told of a part that was picked: its histories over a transient step, with the value under the cursor, its least and
// largest values there with their instants, and its numbers over all states.
const makeModelTables = (data, model) => {
  const {numberOf, fields, shown, where, pipeOf, ofKind, escaped} = model, unit = name => data.units[name];
  const forces = ['N', 'Vy', 'Vz', 'Mx', 'My', 'Mz'], blue = '#0072b2', red = '#d55e00', green = '#009e73';
  const table = (head, rows, now = -1) => '<div class="scroll"><table><thead><tr>' +
    head.map(h => typeof h === 'string' ? `<th>${h}</th>` : `<th class="r">${h[0]}${h[1] ? ` <small>${h[1]}</small>` : ''}</th>`).join('') + '</tr></thead><tbody>' +
    rows.map((cells, i) => `<tr${i === now ? ' class="now"' : ''}>` + cells.map(cell => typeof cell === 'string' ? `<td>${cell}</td>` : `<td class="r">${shown(...[].concat(cell, 7).slice(0, 2))}</td>`).join('') + '</tr>').join('') + '</tbody></table></div>';

  // Least and largest over a transient step, of rows least, at, largest, at.
  const extremes = (name, entries) => {
    const rows = entries.filter(([, , row]) => row && row[0] !== null && !Number.isNaN(row[0])), most = {};
    for (const [, of, row] of rows) most[of] = Math.max(most[of] || 0, Math.abs(row[0]), Math.abs(row[2]));
    const value = (of, x) => Math.abs(x) > 1e-9 * most[of] ? x : 0; // the rest is rounding
    return rows.length ? `<h4>Over ${escaped(name)}</h4>` + table(['', ['least', ''], ['at', 's'], ['largest', ''], ['at', 's']],
      rows.map(([what, of, row]) => [what + (of ? ` <small>[${of}]</small>` : ''), [value(of, row[0]), 5], [row[1], 4], [value(of, row[2]), 5], [row[3], 4]])) : '';
  };
  function envelope(item, name) {
    const one = data.envelopes.find(other => other.name === name);
    if (!one) return '';
    if (item.type === 'support')
      return extremes(name, ['fn', 'ft', 'gap', 'slip1', 'slip2'].map(key => [key === 'ft' ? '|ft|' : key, unit(key[0] === 'f' ? 'N' : 'm'), one.supports[item.k][key]]));
    if (item.type === 'restraint')
      return extremes(name, data.columns.reactions.map(key => [key, unit(key[0] === 'f' ? 'N' : 'N m'), one.restraints[item.k][key]]));
    if (item.type !== 'pipe') return '';
    if (!one.forces) return '<p class="note">Least and largest section forces over time are in envelope.csv: there are too many for this page.</p>';
    return extremes(name, forces.map(key => {
      const field = data.fields.find(other => other.key === (key[0] === 'M' ? 'Mx' : 'N')), of = one.forces[key], i = item.station; // whose unit it is shown in
      return [key, field.unit, [field.factor * of.least[i], of.least_at[i], field.factor * of.largest[i], of.largest_at[i]]];
    }));
  }

  // Of a support or restraint its forces, of a pipe its section forces, over the instants of a transient step.
  function curvesOf(item, steps, one) {
    const over = (kind, name) => steps.map(step => numberOf(step, kind, item.k, name));
    if (item.type === 'support') {
      const ft2 = over('supports', 'ft2'), least = one && one.supports[item.k];
      return [['fn', blue, over('supports', 'fn'), least && least.fn], ['|ft|', red, over('supports', 'ft1').map((ft1, i) => Math.hypot(ft1, ft2[i])), least && least.ft]];
    }
    if (item.type === 'restraint')
      return ['fx', 'fy', 'fz'].map((key, k) => [key, [blue, red, green][k], over('reactions', key), one && one.restraints[item.k][key]]);
    return [];
  }
  const left = 70, right = 970, top = 15, bottom = 130;
  function history(item, name) {
    const steps = ofKind('instant').filter(step => step.name === name);
    if (steps.length < 3) return null;
    const curves = curvesOf(item, steps, data.envelopes.find(one => one.name === name));
    if (!curves.length) return null;
    const rows = curves.map(curve => curve[3]).filter(row => row && row[0] !== null);
    const values = [...curves.flatMap(curve => curve[2]), ...rows.flatMap(row => [row[0], row[2]])].filter(value => value !== null);
    const low = Math.min(0, ...values), high = Math.max(0, ...values, low + 1e-300);
    const from = Math.min(steps[0].time, ...rows.flatMap(row => [row[1], row[3]])), to = steps[steps.length - 1].time;
    return {name, steps, curves, low, high, from, to,
            x: time => left + (right - left) * (time - from) / (to - from || 1), y: value => bottom - (bottom - top) * (value - low) / (high - low)};
  }
  function drawn(h) {
    const label = (px, py, anchor, text) => `<text x="${px}" y="${py}" text-anchor="${anchor}">${text}</text>`, at = (time, value) => `${h.x(time).toFixed(1)},${h.y(value).toFixed(1)}`;
    const mark = (time, value, colour) => value === null ? '' : `<circle cx="${h.x(time).toFixed(1)}" cy="${h.y(value).toFixed(1)}" r="4" fill="#fff" stroke="${colour}" stroke-width="2"/>`;
    return `<p class="key">${h.curves.map(([c, colour]) => `<span style="--c:${colour}">${c}</span>`).join('')} [${unit('N')}] over ${escaped(h.name)}, at ${h.steps.length} instants; rings: least and largest of all</p>` +
      `<div class="chart"><svg id="model-history" viewBox="0 0 1000 160" role="img" aria-label="forces over time" font-size="13" font-family="sans-serif" fill="#333">` +
      `<path d="M${left},${top}V${bottom}H${right}M${left},${h.y(0)}H${right}" fill="none" stroke="#999"/>${label(64, 20, 'end', shown(h.high, 4))}${label(64, 134, 'end', shown(h.low, 4))}${label(left, 150, 'middle', shown(h.from, 5) + ' s')}${label(right, 150, 'middle', shown(h.to, 5) + ' s')}` +
      h.curves.map(([, colour, list]) => `<polyline fill="none" stroke="${colour}" stroke-width="2" points="${list.map((value, i) => value === null ? '' : at(h.steps[i].time, value)).join(' ')}"/>`).join('') +
      h.curves.map(([, colour, , row]) => row ? mark(row[1], row[0], colour) + mark(row[3], row[2], colour) : '').join('') +
      '<line id="model-history-at" y1="15" y2="130" stroke="#555" stroke-dasharray="4 3"/></svg><div class="tip" hidden></div><div id="model-history-now"></div></div>';
  }
  // The values under the cursor; a click takes the model there.
  function answer(h, take) {
    const svg = document.getElementById('model-history'), tip = svg.nextElementSibling, line = document.getElementById('model-history-at');
    const nearest = event => {
      const at = svg.getBoundingClientRect(), time = h.from + ((event.clientX - at.left) / at.width * 1000 - left) / (right - left) * (h.to - h.from);
      let best = 0;
      h.steps.forEach((step, i) => { if (Math.abs(step.time - time) < Math.abs(h.steps[best].time - time)) best = i; });
      return best;
    };
    svg.onpointermove = event => {
      const i = nearest(event), x = h.x(h.steps[i].time), width = svg.getBoundingClientRect().width;
      line.setAttribute('x1', x); line.setAttribute('x2', x);
      tip.innerHTML = `${shown(h.steps[i].time, 6)} s` + h.curves.map(([name, colour, list]) => `<div style="--c:${colour}">${name}: ${shown(list[i], 5)} ${unit('N')}</div>`).join('');
      tip.hidden = false;
      tip.style.top = '4px';
      tip.style.left = x < 500 ? `${x / 1000 * width + 10}px` : '';
      tip.style.right = x < 500 ? '' : `${width - x / 1000 * width + 10}px`;
    };
    svg.onpointerleave = () => { tip.hidden = true; line.removeAttribute('x1'); line.removeAttribute('x2'); };
    svg.onclick = event => take(h.steps[nearest(event)]);
  }
  let shownHistory = null;

  // Where the model is in the history that is shown.
  function mark(time) {
    const line = shownHistory && document.getElementById('model-history-now');
    if (!line) return;
    line.hidden = time === null;
    if (time !== null) line.style.transform = `translateX(${shownHistory.x(time) / 10}cqw)`; // moved by the compositor: nothing is painted
  }

  /** Fill an element with what is known of an item; take(state) shows a state. */
  function tell(element, item, now, take) {
    let title = '', head = [], row = null;
    if (item.type === 'support') {
      title = `Support ${item.name}, ${item.kind}`;
      const units = {fn: 'N', ft1: 'N', ft2: 'N', work_friction: 'J', mt: 'N m'};
      head = data.columns.supports.map(key => key === 'status' ? key : [key.replace('work_friction', 'friction work'), unit(units[key] || 'm')]);
      row = step => step.supports[item.k];
    } else if (item.type === 'restraint') {
      title = `${item.kind || 'restraint'} ${item.name}`;
      head = data.columns.reactions.map(key => [key, unit(key[0] === 'f' ? 'N' : 'N m')]);
      row = step => step.reactions[item.k];
    } else if (item.type === 'point') {
      title = `Point ${item.name}, ${where(item.station)}`;
      head = data.columns.points.map(key => [key, unit(key[0] === 'u' ? 'm' : 'rad')]);
      row = step => step.points[item.k];
    } else {
      const known = fields.map((field, k) => k).filter(k => fields[k].any);
      title = `Pipe ${where(item.station)} (${pipeOf(item.station).section})`;
      head = known.map(k => [fields[k].name, fields[k].unit]);
      row = step => known.map(k => [step.values[k] ? fields[k].factor * step.values[k][item.station] : null, 4]);
    }
    const states = data.steps.filter(step => step.kind === 'step' || step.kind === 'case' || step.kind === 'instant').filter(step => row(step));
    const time = states.some(step => step.kind === 'instant'), transient = data.envelopes.map(one => one.name);
    const name = transient.includes(now.name) ? now.name : transient[transient.length - 1];
    shownHistory = name ? history(item, name) : null;
    element.innerHTML = `<h3>${escaped(title)}</h3>${shownHistory ? drawn(shownHistory) : ''}${name ? envelope(item, name) : ''}` +
      '<div class="model-states">' + table(['state', ...(time ? [['time', 's']] : []), ...head], states.map(step => [escaped(step.name) + (step.kind === 'instant' ? ' (instant)' : ''), ...(time ? [[step.time, 6]] : []), ...row(step)]), states.indexOf(now)) + '</div>' +
      (item.type === 'pipe' && data.left_out ? '<p class="note">The line is thinned here: values are the largest nearby. The csv files have every station.</p>' : '');
    if (shownHistory) answer(shownHistory, take);
    mark(now.kind === 'instant' && now.name === name ? now.time : null);
  }
  return {tell, mark};
};
