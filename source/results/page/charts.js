// Charts that answer the mouse: the values of all curves under the cursor; a drag zooms, a double click shows all again.
// The curves are read back from the drawing, to its 0.05 px: what is shown has three digits. Axes come with it as data-axes.
for (const svg of document.querySelectorAll('svg[data-axes]')) {
  const axes = svg.dataset.axes.trim().split(' '), ranges = axes.slice(0, 4).map(Number);
  const logs = [axes.includes('logx'), axes.includes('logy')];
  const points = path => [...path.getAttribute('d').matchAll(/([ML])\s*(-?[\d.]+),(-?[\d.]+)/g)].map(m => [Number(m[2]), Number(m[3]), m[1]]);
  const frame = [...svg.querySelectorAll('path')].map(points).find(p => p.length > 4 && p[0][0] === p[1][0] && p[1][1] === p[2][1] && p[3][2] === 'M');
  const groups = [...svg.querySelectorAll('g[id*="_plot_"]')];
  if (!frame || ranges.length < 4 || ranges.some(Number.isNaN) || !groups.length)
    continue;
  const [left, top] = frame[0], [right, bottom] = frame[2], box = [left, right, bottom, top];
  const full = ranges.map((value, k) => logs[k >> 1] ? Math.log10(value) : value);
  let seen = [...full]; // what is in the frame, logarithms on such axes
  const value = (axis, at, of) => of[2 * axis] + (at - box[2 * axis]) / (box[2 * axis + 1] - box[2 * axis]) * (of[2 * axis + 1] - of[2 * axis]);
  const pixel = (axis, at, of) => box[2 * axis] + (at - of[2 * axis]) / (of[2 * axis + 1] - of[2 * axis]) * (box[2 * axis + 1] - box[2 * axis]);
  // Three digits, and none below the drawing's own 0.05 px: what is 0 is shown as 0.
  const least = [0, 1].map(axis => 10 ** Math.floor(Math.log10(0.05 * Math.abs((full[2 * axis + 1] - full[2 * axis]) / (box[2 * axis + 1] - box[2 * axis])))));
  const text = (axis, at) => String(Number((logs[axis] ? 10 ** at : Math.round(at / least[axis]) * least[axis]).toPrecision(3)));

  // Names: of the drawing's own key, or of the key of colours above the charts; of two dashed ones the least comes first.
  const plainColour = colour => { const probe = document.createElement('i'); probe.style.color = colour; return probe.style.color; };
  const keys = [...((svg.closest('.charts') || svg).previousElementSibling || svg).querySelectorAll('span[style]')]
    .map(span => [plainColour(span.style.getPropertyValue('--c')), span.textContent]);
  const dashes = {};
  const curves = groups.map(group => {
    const paths = [...group.querySelectorAll('path')].filter(path => path.getAttribute('d'));
    const colour = paths.length ? plainColour(paths[0].getAttribute('stroke') || '') : '#000';
    const title = (group.querySelector('title') || {}).textContent || '';
    let name = /_plot_\d+$/.test(title) ? (keys.find(key => key[0] === colour) || [0, ''])[1] : title;
    if (/_plot_\d+$/.test(title) && paths.length && paths[0].getAttribute('stroke-dasharray'))
      name += (dashes[colour] = (dashes[colour] || 0) + 1) === 1 ? ', least' : ', largest';
    const runs = paths.flatMap(points).map(([x, y, kind]) => [value(0, x, full), value(1, y, full), kind]);
    return {group, paths, colour, name, runs, rising: runs.every((p, k) => k === 0 || p[2] === 'M' || p[0] >= runs[k - 1][0] - 1e-12)};
  }).filter(curve => curve.runs.length);

  const make = (kind, attributes, parent) => {
    const element = document.createElementNS(svg.namespaceURI, kind);
    for (const name in attributes) element.setAttribute(name, attributes[name]);
    parent.append(element);
    return element;
  };
  const front = make('g', {class: 'answer'}, svg), tip = document.createElement('div');
  tip.className = 'tip';
  tip.hidden = true;
  svg.parentElement.classList.add('chart');
  svg.parentElement.append(tip);
  const place = event => {
    const rect = svg.getBoundingClientRect(), size = svg.viewBox.baseVal;
    return [(event.clientX - rect.left) / rect.width * size.width, (event.clientY - rect.top) / rect.height * size.height];
  };

  // Of a curve over x its value there; of one that runs back and forth, its nearest corner.
  function at(curve, x, y) {
    let best = null, least = 900; // 30 px
    curve.runs.forEach((p, k) => {
      const before = curve.runs[k - 1];
      if (curve.rising) {
        if (k > 0 && p[2] === 'L' && before[0] <= x && x <= p[0])
          best = [x, p[0] > before[0] ? before[1] + (x - before[0]) / (p[0] - before[0]) * (p[1] - before[1]) : p[1]];
        return;
      }
      const far = (pixel(0, p[0], seen) - pixel(0, x, seen)) ** 2 + (pixel(1, p[1], seen) - pixel(1, y, seen)) ** 2;
      if (far < least) { least = far; best = p; }
    });
    return best;
  }

  let from = null;
  svg.onpointermove = event => {
    const [px, py] = place(event);
    front.textContent = '';
    tip.hidden = px < left || px > right || py < top || py > bottom;
    if (tip.hidden) return;
    if (from) {
      make('rect', {x: Math.min(px, from[0]), y: top, width: Math.abs(px - from[0]), height: bottom - top, fill: '#0072b2', 'fill-opacity': 0.15}, front);
      tip.hidden = true;
      return;
    }
    const x = value(0, px, seen), y = value(1, py, seen), rows = [];
    make('line', {x1: px, x2: px, y1: top, y2: bottom, stroke: '#555', 'stroke-width': 0.7, 'stroke-dasharray': '3 2'}, front);
    for (const curve of curves) {
      const found = at(curve, x, y), shown = found && pixel(1, found[1], seen);
      if (!found) continue;
      if (shown >= top - 1 && shown <= bottom + 1)
        make('circle', {cx: pixel(0, found[0], seen), cy: shown, r: 3, fill: '#fff', stroke: curve.colour, 'stroke-width': 1.5}, front);
      rows.push([curve, (curve.rising ? '' : text(0, found[0]) + ', ') + text(1, found[1])]);
    }
    tip.textContent = text(0, x);
    for (const [curve, number] of rows) {
      const row = document.createElement('div');
      row.style.setProperty('--c', curve.colour);
      row.textContent = (curve.name ? curve.name + ': ' : '') + number;
      tip.append(row);
    }
    const rect = svg.getBoundingClientRect(), scale = rect.width / svg.viewBox.baseVal.width;
    tip.style.top = `${(top + 4) * scale}px`;
    tip.style.left = px < (left + right) / 2 ? `${(px + 10) * scale}px` : '';
    tip.style.right = px < (left + right) / 2 ? '' : `${rect.width - (px - 10) * scale}px`;
  };
  svg.onpointerleave = () => { front.textContent = ''; tip.hidden = true; from = null; };

  // Ticks and lines of the grid as drawn, and others while zoomed.
  const drawn = [...svg.querySelectorAll('path')].filter(path => {
    const p = points(path);
    return p.length === 2 && !path.closest('[id*="_plot_"]') && (p[0][0] === p[1][0] || p[0][1] === p[1][1]);
  }).map(path => path.parentElement);
  const zoomed = make('g', {'font-family': 'sans-serif', 'font-size': 11, fill: '#333'}, svg);
  const clip = make('clipPath', {id: `clip-${groups[0].id}`}, svg);
  make('rect', {x: left, y: top, width: right - left, height: bottom - top}, clip);
  function zoom(to) {
    const whole = to.every((v, k) => v === full[k]);
    seen = to;
    zoomed.textContent = '';
    for (const group of drawn) group.style.display = whole ? '' : 'none';
    const map = axis => {
      const scale = (full[2 * axis + 1] - full[2 * axis]) / (to[2 * axis + 1] - to[2 * axis]);
      return [scale, pixel(axis, full[2 * axis], to) - scale * box[2 * axis]];
    };
    const [sx, tx] = map(0), [sy, ty] = map(1);
    for (const curve of curves) {
      curve.group.setAttribute('clip-path', whole ? '' : `url(#${clip.id})`);
      for (const part of curve.group.querySelectorAll('path, use')) {
        if (part.dataset.own === undefined) part.dataset.own = part.getAttribute('transform') || '';
        part.setAttribute('vector-effect', 'non-scaling-stroke');
        part.setAttribute('transform', whole ? part.dataset.own : `matrix(${sx} 0 0 ${sy} ${tx} ${ty}) ${part.dataset.own}`);
      }
    }
    for (let axis = 0; axis < 2 && !whole; ++axis) {
      const span = to[2 * axis + 1] - to[2 * axis], power = 10 ** Math.floor(Math.log10(span / 5));
      const step = power * [1, 2, 5, 10].find(digit => digit * power >= span / 6);
      for (let k = Math.ceil(to[2 * axis] / step); k * step <= to[2 * axis + 1]; ++k) {
        const p = pixel(axis, k * step, to), label = make('text', axis === 0 ? {x: p, y: bottom + 22, 'text-anchor': 'middle'} : {x: left - 11, y: p + 4, 'text-anchor': 'end'}, zoomed);
        label.textContent = String(Number((k * step).toPrecision(6)));
        make('line', {...(axis === 0 ? {x1: p, x2: p, y1: top, y2: bottom} : {y1: p, y2: p, x1: left, x2: right}), stroke: '#ddd', 'stroke-width': 0.6}, zoomed);
      }
    }
  }
  svg.onpointerdown = event => {
    const [px, py] = place(event);
    if (event.button === 0 && event.pointerType !== 'touch' && px > left && px < right && py > top && py < bottom && !logs[0] && !logs[1]) {
      from = [px, py];
      event.preventDefault();
    }
  };
  svg.onpointerup = event => {
    const [px] = place(event), began = from;
    from = null;
    if (!began || Math.abs(px - began[0]) < 6) return;
    const x = [value(0, Math.min(px, began[0]), seen), value(0, Math.max(px, began[0]), seen)];
    let low = Infinity, high = -Infinity; // of the curves there
    for (const curve of curves) {
      const inside = [...curve.runs.filter(p => p[0] >= x[0] && p[0] <= x[1]), at(curve, x[0], 0), at(curve, x[1], 0)].filter(Boolean);
      for (const p of inside) { low = Math.min(low, p[1]); high = Math.max(high, p[1]); }
    }
    const margin = 0.05 * (high - low);
    zoom([...x, ...(high > low ? [low - margin, high + margin] : seen.slice(2))]);
  };
  svg.ondblclick = () => zoom([...full]);
}
