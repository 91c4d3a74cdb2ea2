// Names on a picture, where they cover neither each other nor what is to be avoided: LabelPlacer of the drawings, for a canvas.
class ModelLabels {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.buckets = new Map(); // boxes that are taken, by the fields of 64 x 32 pixels that they touch
  }
  bucketsOf(box) {
    const keys = [];
    for (let i = Math.floor(box[0] / 64); i <= Math.floor(box[2] / 64); ++i)
      for (let j = Math.floor(box[1] / 32); j <= Math.floor(box[3] / 32); ++j) keys.push(1e5 * i + j);
    return keys;
  }
  take(box) {
    for (const key of this.bucketsOf(box)) {
      const bucket = this.buckets.get(key);
      if (bucket) bucket.push(box);
      else this.buckets.set(key, [box]);
    }
  }
  avoid(x, y, radius) { this.take([x - radius, y - radius, x + radius, y + radius]); }
  isFree(box) {
    return box[0] >= 2 && box[1] >= 2 && box[2] <= this.width - 2 && box[3] <= this.height - 2 &&
      !this.bucketsOf(box).some(key => (this.buckets.get(key) || []).some(other =>
        box[0] < other[2] && other[0] < box[2] && box[1] < other[3] && other[1] < box[3]));
  }
  /** Left and baseline of a text of some width near a place; null if there is no room. */
  place(wide, x, y) {
    const high = 15, around = [[1, -0.8], [-1, -0.8], [1, 0.8], [-1, 0.8], [1, 0], [-1, 0], [0, -1], [0, 1]];
    for (const far of [7, 14, 24])
      for (const [dx, dy] of around) {
        const left = dx > 0 ? x + far : dx < 0 ? x - far - wide - 4 : x - wide / 2 - 2, middle = y + dy * (far + (dx === 0 ? 6 : 3));
        const box = [left, middle - high / 2, left + wide + 4, middle + high / 2];
        if (!this.isFree(box)) continue;
        this.take(box);
        return box;
      }
    return null;
  }
}

// What is drawn over the model: names, rings around what was picked and where most is, the axes.
const makeModelOverlay = (canvas, camera) => {
  const pen = canvas.getContext('2d'), way = new THREE.Vector3();
  const most = 300; // labels
  const ring = (at, colour) => { pen.beginPath(); pen.arc(at.x, at.y, 9, 0, 7); pen.lineWidth = 2; pen.strokeStyle = colour; pen.stroke(); };
  /** @param named lists of [item, where it is on the screen, colour]; @param rings of [where, colour] */
  return (width, height, named, rings) => {
    const ratio = window.devicePixelRatio || 1;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.font = '12px system-ui, sans-serif';
    if (named.length) {
      const labels = new ModelLabels(width, height);
      for (const [, at] of named) if (at.seen) labels.avoid(at.x, at.y, 3);
      let written = 0;
      for (const [item, at, colour] of named) {
        const box = at.seen && written < most && labels.place(pen.measureText(item.name).width, at.x, at.y);
        if (!box) continue;
        ++written;
        pen.fillStyle = 'rgba(255,255,255,.8)';
        pen.fillRect(box[0], box[1], box[2] - box[0], box[3] - box[1]);
        pen.fillStyle = colour;
        pen.fillText(item.name, box[0] + 2, box[3] - 3.5);
      }
    }
    for (const [at, colour] of rings) ring(at, colour);
    const origin = {x: 38, y: height - 38};
    ['x', 'y', 'z'].forEach((name, d) => {
      way.set(0, 0, 0).setComponent(d, 1).transformDirection(camera.matrixWorldInverse);
      pen.beginPath(); pen.moveTo(origin.x, origin.y); pen.lineTo(origin.x + 24 * way.x, origin.y - 24 * way.y);
      pen.lineWidth = 1.5; pen.strokeStyle = '#444'; pen.stroke();
      pen.fillStyle = '#222'; pen.fillText(name, origin.x + 31 * way.x - 3, origin.y - 31 * way.y + 4);
    });
  };
};
