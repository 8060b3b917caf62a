// Draws the chain in motion. A contact glows while it sticks.
class ChainView {
  constructor(canvas) {
    this.canvas = canvas;
    this.plays = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.phase = 0;
    this.last = 0;
    this.frames = 0;
    requestAnimationFrame((now) => this.tick(now));
  }

  show(scene, orbit, hertz) {
    Object.assign(this, { scene, orbit, hertz });
  }

  // Returns the factor by which the picture moves more slowly than the chain.
  slowness() {
    return Math.max(1, this.hertz / 0.7);
  }

  tick(now) {
    const step = Math.min(0.1, (now - this.last) / 1000);
    this.last = now;
    this.frames += 1;
    if (this.plays && this.hertz) this.phase += step * this.hertz / this.slowness();
    this.draw();
    requestAnimationFrame((next) => this.tick(next));
  }

  // Returns the value of a list of samples at the present phase.
  sample(values, cycles) {
    const place = (this.phase / cycles % 1) * (values.length - 1);
    const index = Math.min(Math.floor(place), values.length - 2);
    return values[index] + (values[index + 1] - values[index]) * (place - index);
  }

  draw() {
    const { canvas, scene } = this;
    const ratio = devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    const pen = canvas.getContext("2d");
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    if (!scene) return;
    const style = getComputedStyle(document.documentElement);
    const [ink, soft, accent, glow] = ["--ink", "--soft", "--accent", "--glow"].map((name) => style.getPropertyValue(name));
    const motion = this.orbit?.motion;
    const count = scene.masses.length;
    const gap = width / (count + 1.6);
    const middle = height * 0.45;
    const half = Math.min(26, gap * 0.28);
    const base = scene.excitation === "base" ? Math.cos(2 * Math.PI * this.phase) : 0;
    const all = motion ? motion.masses.flat().map(Math.abs) : [1];
    const largest = Math.max(scene.excitation === "base" ? 1 : 0, ...all) || 1;
    const scale = 0.42 * (gap - 2 * half) / largest + 0.12 * gap / largest;
    const place = { base: 0.3 * gap + base * scale, wall: width - 0.3 * gap };
    scene.masses.forEach((mass, index) => {
      const moved = motion ? this.sample(motion.masses[index], motion.cycles) * scale : 0;
      place[mass.name] = gap * (index + 1.3) + moved;
    });
    const order = { base: -1, wall: count };
    scene.masses.forEach((mass, index) => { order[mass.name] = index; });
    const edge = (node, side) => place[node] + (node === "base" || node === "wall" ? 0 : side * half);
    const ends = ([a, b]) => order[a] <= order[b] ? [edge(a, 1), edge(b, -1), order[b] - order[a]] : [edge(b, 1), edge(a, -1), order[a] - order[b]];

    pen.strokeStyle = soft;
    pen.fillStyle = soft;
    pen.lineWidth = 1.5;
    const floor = height * 0.8;
    wall(pen, place.wall, 12, floor, 1);
    wall(pen, place.base, 12, floor, -1);
    pen.beginPath(); pen.moveTo(place.base, floor); pen.lineTo(place.wall, floor); pen.globalAlpha = 0.25; pen.stroke(); pen.globalAlpha = 1;
    scene.springs.forEach((spring) => {
      const [from, to, far] = ends(spring);
      const up = middle - (far > 1 ? half + 4 + 5 * Math.min(far, 3) : 0);
      pen.strokeStyle = ink;
      zigzag(pen, from, to, up, far > 1 ? 3 : 6);
    });
    scene.dampers.forEach((damper) => {
      const [from, to] = ends(damper);
      pen.strokeStyle = soft;
      dashpot(pen, from, to, middle - half * 0.75);
    });
    scene.masses.forEach((mass) => {
      pen.fillStyle = accent;
      pen.globalAlpha = 0.85;
      pen.fillRect(place[mass.name] - half, middle - half * 0.62, 2 * half, half * 1.24);
      pen.globalAlpha = 1;
      pen.fillStyle = ink;
      pen.font = "12px system-ui, sans-serif";
      pen.textAlign = "center";
      pen.fillText(mass.name.slice(0, 14), place[mass.name], height - 6);
      if (scene.excitation === mass.name) arrow(pen, place[mass.name], middle - half * 0.62 - 8, 16 * Math.cos(2 * Math.PI * this.phase), glow);
    });
    scene.contacts.forEach((contact, index) => {
      const sticks = motion ? this.sample(motion.sticks[index] ?? motion.sticks[0], motion.cycles) > 0.5 : false;
      rub(pen, contact.between, place, order, [half, middle, floor], sticks ? glow : soft, sticks);
    });
  }
}

function wall(pen, x, top, bottom, side) {
  pen.beginPath();
  pen.moveTo(x, top);
  pen.lineTo(x, bottom);
  for (let y = top; y < bottom; y += 9) {
    pen.moveTo(x, y + 9);
    pen.lineTo(x + side * 7, y);
  }
  pen.stroke();
}

function zigzag(pen, from, to, y, size) {
  const turns = 10;
  pen.beginPath();
  pen.moveTo(from, y);
  for (let turn = 1; turn < turns; turn += 1) pen.lineTo(from + (to - from) * (0.1 + 0.8 * turn / turns), y + (turn % 2 ? size : -size));
  pen.lineTo(to, y);
  pen.stroke();
}

function dashpot(pen, from, to, y) {
  const middle = (from + to) / 2;
  pen.beginPath();
  pen.moveTo(from, y);
  pen.lineTo(middle, y);
  pen.moveTo(middle, y - 4);
  pen.lineTo(middle, y + 4);
  pen.moveTo(middle - 5, y - 5);
  pen.lineTo(middle + 5, y - 5);
  pen.lineTo(middle + 5, y + 5);
  pen.lineTo(middle - 5, y + 5);
  pen.moveTo(middle + 5, y);
  pen.lineTo(to, y);
  pen.stroke();
}

function arrow(pen, x, y, reach, colour) {
  const side = Math.sign(reach) || 1;
  pen.strokeStyle = colour;
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(x + reach, y);
  pen.moveTo(x + reach - side * 5, y - 4);
  pen.lineTo(x + reach, y);
  pen.lineTo(x + reach - side * 5, y + 4);
  pen.stroke();
}

// Draws two plates that rub: below a mass on the floor, or between the arms of two masses or of a mass and the base.
function rub(pen, [a, b], place, order, [half, middle, floor], colour, sticks) {
  const [left, right] = order[a] <= order[b] ? [a, b] : [b, a];
  const below = middle + half * 0.62;
  pen.strokeStyle = colour;
  pen.lineWidth = sticks ? 4 : 2.5;
  pen.shadowColor = colour;
  pen.shadowBlur = sticks ? 14 : 0;
  pen.beginPath();
  if (right === "wall") {
    pen.moveTo(place[left], below);
    pen.lineTo(place[left], floor - 4);
    pen.moveTo(place[left] - half * 0.6, floor - 4);
    pen.lineTo(place[left] + half * 0.6, floor - 4);
    pen.moveTo(place[left] - half * 1.2, floor);
    pen.lineTo(place[left] + half * 1.2, floor);
  } else {
    const y = (below + floor) / 2;
    const centre = (place[left] + place[right]) / 2;
    const reach = Math.max(8, (place[right] - place[left]) * 0.14);
    pen.moveTo(place[left], left === "base" ? y - 2 : below);
    pen.lineTo(place[left], y - 2);
    pen.lineTo(centre + reach, y - 2);
    pen.moveTo(place[right], below);
    pen.lineTo(place[right], y + 3);
    pen.lineTo(centre - reach, y + 3);
  }
  pen.stroke();
  pen.lineWidth = 1.5;
  pen.shadowBlur = 0;
}
