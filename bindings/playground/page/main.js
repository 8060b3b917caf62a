// Connects the parts of the page. The page has one state, and every picture shows an answer about this state.
const at = (id) => document.getElementById(id);
const examples = JSON.parse(at("examples").textContent);
const state = { r: null, beta: null, of: null, sweep: false, from: null, to: null };
const timing = { start: performance.now(), first: null, answers: 0 };
let [scene, orbit, top_, best, fast, slow] = [null, null, 1, null, null, null];
let [busy, again, pictures] = [false, false, { map: "", curve: "" }];

const chain = new ChainView(at("chain"));
const sound = new Sound();
const editor = new Editor(() => changed("text"));

function question(ask, more = {}) {
  const { r, beta, of, from, to } = state;
  return { ask, text: editor.text, r, beta, of, from, to, ...more };
}

// Asks the questions whose answers a change affects. Changes that occur before the answer are answered together after
// it.
async function changed(what) {
  if (what === "text") state.fresh = true;
  again = true;
  if (busy) return;
  busy = true;
  while (again) {
    again = false;
    try { await refresh(); } catch (error) { says(String(error)); }
  }
  busy = false;
  later();
}

async function refresh() {
  if (state.fresh) {
    state.fresh = false;
    const told = await fast.ask({ ask: "scene", text: editor.text });
    if (told.error) return fail(told.error);
    editor.tell(told.faults ?? []);
    document.body.classList.toggle("faulty", Boolean(told.faults));
    for (const id of ["curve", "map", "loop"]) at(id).classList.toggle("old", Boolean(told.faults));
    if (told.faults) return;
    describe(told);
  }
  if (!scene) return;
  const told = await fast.ask(question("orbit"));
  show(told);
  timing.answers += 1;
  if (scene.joined) return mark();
  await quickCurve();
  if (pictures.map !== mapKey()) {
    const map = await fast.ask(question("map", { top: null }));
    draw("map", map);
    pictures.map = map.error ? "" : mapKey();
  }
  mark();
  timing.first ??= performance.now() - timing.start;
}

// Draws as many points of the curve as there is time for in a frame. Later `refine` replaces this curve by a finer
// curve.
async function quickCurve() {
  const [end, points] = [performance.now() + 10, []];
  const places = halves(97).map((part) => state.from + (state.to - state.from) * part);
  for (let start = 0; start < places.length && (start < 17 || performance.now() < end); start += 8) {
    const told = await fast.ask(question("points", { rs: places.slice(start, start + 8) }));
    if (told.error) return;
    points.push(...told.points);
  }
  if (orbit) points.push([state.r, state.of === undefined ? orbit.contact : orbit.masses[state.of].amplitude, regimes.indexOf(orbit.regime)]);
  points.sort((a, b) => a[0] - b[0]);
  draw("curve", await fast.ask(question("line", { points })));
}

const regimes = ["continuous", "stick-slip", "stuck"];
const starts = () => state.sweep ? ["up", "down"] : ["rest"];
const mapKey = () => JSON.stringify([editor.text, state.from, state.to]);

// Shows a new scene.
function describe(told) {
  const same = scene && told.name === scene.name && told.masses.length === scene.masses.length && told.joined === scene.joined;
  const typed = scene && !same;
  scene = told;
  if (!same) {
    // A scene from a link keeps the range of the link. Another scene gets a range of its own.
    Object.assign(state, { from: (typed ? null : state.from) ?? told.from, to: (typed ? null : state.to) ?? told.to });
    // If friction can hold a mass still, its amplitude is smallest with the most friction, which is not informative.
    const held = told.contacts.flatMap((contact) => contact.between);
    const free = told.masses.findIndex((mass) => !held.includes(mass.name));
    if (state.of === null || state.of >= told.masses.length) state.of = free < 0 ? told.masses.length - 1 : free;
    pictures = { map: "", curve: "" };
  }
  // The best friction of an earlier description is not that of this description.
  forget();
  at("lines").hidden = told.joined;
  state.r ??= Math.min(Math.max(0.9 * (told.resonances.find((r) => r > 0) ?? 1), state.from), state.to);
  state.beta ??= 0.4;
  at("of").replaceChildren(...told.masses.map((mass, index) => new Option(mass.name, index, false, index === state.of)), new Option("the contact", "", false, state.of === undefined));
  at("sketch").innerHTML = told.sketch && told.contacts.length === 1 ? told.sketch : "";
  editor.sliders(told.numbers);
  [at("from").value, at("to").value] = [short(state.from), short(state.to)];
}

function forget() {
  best = null;
  at("best-is").textContent = "";
}

// Returns the friction force in newtons that the friction ratio means. A description has its masses in kg and its
// springs in N/m.
function force() {
  const stiffness = scene.masses[0].value * (2 * Math.PI * scene.hertz) ** 2;
  const shared = scene.contacts.length > 1 ? " Each contact has this force times its share." : "";
  if (scene.excitation !== "base") return `The friction force F is ${short(state.beta)} times the load amplitude P.${shared}`;
  return `The friction force F is ${short(state.beta * stiffness / 1000)} N per millimetre of the base amplitude Y.${shared}`;
}

function fail(message) {
  editor.tell([{ line: 0, message }]);
}

function says(text) {
  at("says").textContent = text;
}

const words = {
  "continuous": "The contact <strong>slides all the time</strong> (continuous sliding).",
  "stick-slip": "The contact <strong>sticks and slips</strong>.",
  "stuck": "The contact is <strong>stuck</strong>: friction is too strong, or the load too weak, to move it.",
};

const verbs = { "continuous": "slides all the time", "stick-slip": "sticks and slips", "stuck": "is stuck" };

function show(told) {
  orbit = told.error ? null : told;
  const hertz = state.r * scene.hertz;
  [at("beta-is").textContent, at("r-is").textContent] = [`β = ${short(state.beta)}`, `r = ${short(state.r)} (${short(hertz)} Hz)`];
  at("means").textContent = `${force()} The frequency ratio r = 1 is ${short(scene.hertz)} Hz.`;
  chain.show(scene, orbit, hertz);
  at("slowed").textContent = chain.slowness() > 1.05 ? `shown ${short(chain.slowness())} times slower` : "shown at its own speed";
  sound.show(orbit, state.of, hertz);
  if (told.error) {
    says(`No steady state here: ${told.error}.`);
    at("loop").innerHTML = "";
    return;
  }
  const unit = scene.excitation === "base" ? "Y" : "P/k₁";
  const masses = told.masses.map((mass, index) => `${scene.masses[index].name} ${short(mass.amplitude)}`).join(", ");
  const stops = told.stops ? ` It stops ${told.stops} times in ${told.period > 1 ? `${told.period} cycles` : "a cycle"}${told.stuck_fraction === undefined ? "" : ` and sticks for ${short(100 * told.stuck_fraction)} % of the time`}.` : "";
  const settled = told.settled ? "" : " The motion never repeats.";
  at("says").innerHTML = told.contacts?.length > 1 ? "" : words[told.regime] + stops + settled;
  if (told.contacts?.length > 1) at("says").append(`${told.contacts.map((contact) => `${contact.name} ${verbs[contact.regime]}`).join(", ")}.`);
  at("says").append(` Largest displacements over ${unit}: ${masses}.`);
  at("work").textContent = told.work ? `friction dissipates ${short(told.work)} ${scene.excitation === "base" ? "k₁Y²" : "P²/k₁"} in a cycle` : "";
  if (told.loop) at("loop").innerHTML = told.loop.svg;
}

function draw(id, told) {
  if (told.stopped) return;
  const place = at(id);
  if (told.error) {
    place.textContent = told.error;
    place.frame = null;
    return;
  }
  place.innerHTML = `${told.svg}<div class="over"></div>`;
  place.frame = told.frame;
  if (id === "map") top_ = told.top;
}

// Draws the markers on the map and on the curve, and moves both sliders.
function mark() {
  Object.assign(at("r"), { min: state.from, max: state.to, value: state.r });
  // Small frictions have more space on the slider than large ones.
  if (document.activeElement !== at("beta")) at("beta").value = Math.sqrt(state.beta / top_);
  at("beta").setAttribute("aria-valuetext", at("beta-is").textContent);
  at("r").setAttribute("aria-valuetext", at("r-is").textContent);
  over("map", state.beta, best);
  over("curve", state.of === undefined ? orbit?.contact : orbit?.masses[state.of]?.amplitude, null);
}

function over(id, height, line) {
  const { frame } = at(id);
  const layer = at(id).querySelector(".over");
  const box = at(id).querySelector("svg")?.getAttribute("viewBox");
  if (!frame || !layer || !box) return;
  const x = frame.left + frame.width * (state.r - frame.x[0]) / (frame.x[1] - frame.x[0]);
  const y = (value) => frame.top + frame.height * (1 - (value - frame.y[0]) / (frame.y[1] - frame.y[0]));
  const inside = height !== null && height !== undefined && height <= frame.y[1];
  const place = Math.max(y(height ?? 0), frame.top);
  const rule = line && line.beta <= frame.y[1]
    ? `<line x1="${frame.left}" x2="${frame.left + frame.width}" y1="${y(line.beta)}" y2="${y(line.beta)}" stroke="#b3261e" stroke-width="2"/><text x="${frame.left + frame.width - 4}" y="${y(line.beta) - 5}" text-anchor="end" font-size="13" font-family="sans-serif" fill="#b3261e">best</text>` : "";
  layer.innerHTML = `<svg viewBox="${box}"><line x1="${x}" x2="${x}" y1="${frame.top}" y2="${frame.top + frame.height}" stroke="#1c2126" stroke-dasharray="2 4"/>${rule}<circle cx="${x}" cy="${place}" r="6" fill="${inside ? "#b3261e" : "none"}" stroke="${inside ? "#fff" : "#b3261e"}" stroke-width="2"/></svg>`;
}

// Computes answers that take longer: finer curves, and scenes with several contacts. A newer change ends the
// computation.
let turn = 0;
let timer = 0;
function later() {
  clearTimeout(timer);
  const own = ++turn;
  timer = setTimeout(() => refine(() => own === turn && !busy), 180);
}

async function refine(valid) {
  link();
  // A screen reader tells the state when the user pauses, and not in every frame.
  at("spoken").textContent = at("says").textContent;
  emitted();
  at("scenes").value = examples.findIndex((example) => example.text === editor.text);
  if (!scene || document.body.classList.contains("faulty")) return;
  if (scene.joined) return joined(valid);
  const curve = await slow.ask(question("curve", { starts: starts(), work: 25000 }));
  if (valid()) { draw("curve", curve); mark(); }
}

// Shows the emitted code of the description while its tab is open.
async function emitted() {
  if (!at("emitted").open || document.body.classList.contains("faulty") || at("code").of === editor.text) return;
  at("code").of = editor.text;
  const told = await slow.ask({ ask: "code", text: editor.text });
  if (told.stopped) at("code").of = null;
  else at("code").textContent = told.error ? `// ${told.error.replaceAll("\n", "\n// ")}` : told.code;
}

// Returns numbers from 0 to 1. Each number is halfway between two earlier numbers, so that a curve is coarse first and
// fine later.
function halves(count) {
  const places = [0, 1];
  for (let step = 1; places.length < count; step *= 2) for (let i = 1; i < 2 * step; i += 2) places.push(i / (2 * step));
  return places;
}

async function joined(valid) {
  const { from, to } = state;
  const points = [];
  const blank = await slow.ask(question("raster", { top: null }));
  if (!valid()) return;
  if (pictures.map !== mapKey()) { draw("map", blank); mark(); }
  const places = halves(65).map((part) => from + (to - from) * part);
  for (let start = 0; start < places.length; start += 4) {
    const told = await slow.ask(question("points", { rs: places.slice(start, start + 4) }));
    if (!valid()) return;
    if (told.error) { says(told.error); break; }
    points.push(...told.points);
    if (points.length < 8 && start + 4 < places.length) continue;
    const ordered = [...points].sort((a, b) => a[0] - b[0]);
    const line = await slow.ask(question("line", { points: ordered }));
    if (!valid()) return;
    draw("curve", line);
    mark();
    timing.first ??= performance.now() - timing.start;
  }
  if (pictures.map === mapKey() || blank.error) return;
  const [columns, rows] = [28, 16];
  const betas = Array.from({ length: rows }, (_, i) => blank.top * (i + 0.5) / rows);
  const cells = Array.from({ length: rows }, () => Array(columns).fill(null));
  const rs = Array.from({ length: columns }, (_, i) => from + (to - from) * (i + 0.5) / columns);
  for (const [column, r] of rs.entries()) {
    const told = await slow.ask(question("cells", { r, betas }));
    if (!valid()) return;
    told.cells?.forEach((cell, row) => { cells[row][column] = cell; });
    if (column % 4 !== 3 && column < columns - 1) continue;
    const map = await slow.ask(question("raster", { top: blank.top, rs, cells: cells.flat() }));
    if (!valid()) return;
    draw("map", map);
    mark();
  }
  pictures.map = mapKey();
}

// Writes the description and the point into the link. A page within a report has no address of its own.
const framed = self !== parent;
function link() {
  if (framed) return;
  const { r, beta, of, from, to, sweep } = state;
  const held = JSON.stringify({ text: editor.text, r, beta, of, from, to, sweep });
  const bytes = new TextEncoder().encode(held);
  const hash = btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  history.replaceState(null, "", `#${hash}`);
}

function linked() {
  try {
    const text = location.hash.slice(1).replaceAll("-", "+").replaceAll("_", "/");
    if (!text) return null;
    return JSON.parse(new TextDecoder().decode(Uint8Array.from(atob(text), (char) => char.charCodeAt(0))));
  } catch {
    return null;
  }
}

function load(held) {
  const number = (value) => Number.isFinite(value) ? value : null;
  editor.set(String(held.text ?? examples[0].text).slice(0, 30000));
  scene = null;
  Object.assign(state, { r: number(held.r), beta: number(held.beta), from: number(held.from), to: number(held.to), sweep: Boolean(held.sweep), of: number(held.of) });
  at("sweep").checked = state.sweep;
  changed("text");
}

function listen() {
  at("beta").addEventListener("input", (event) => { state.beta = top_ * Number(event.target.value) ** 2; changed(); });
  at("r").addEventListener("input", (event) => { state.r = Number(event.target.value); changed(); });
  at("of").addEventListener("change", (event) => { state.of = event.target.value === "" ? undefined : Number(event.target.value); forget(); changed(); });
  at("sweep").addEventListener("change", (event) => { state.sweep = event.target.checked; changed(); });
  at("scenes").addEventListener("change", (event) => { if (examples[event.target.value]) load({ text: examples[event.target.value].text }); });
  at("play").addEventListener("click", () => { chain.plays = !chain.plays; playing(); });
  at("sound").addEventListener("change", (event) => { sound.on = event.target.checked; resound(); });
  at("pitch").addEventListener("change", (event) => { sound.heard = event.target.value === "heard"; resound(); });
  for (const id of ["from", "to"]) at(id).addEventListener("change", () => range());
  at("map").addEventListener("click", (event) => point(event));
  at("curve").addEventListener("click", (event) => point(event));
  at("map").addEventListener("keydown", (event) => arrowKey(event));
  at("emitted").addEventListener("toggle", () => emitted());
  at("best").addEventListener("click", () => findBest());
  at("link").addEventListener("click", async () => {
    link();
    try { await navigator.clipboard.writeText(location.href); at("copied").textContent = "Copied."; } catch { at("copied").textContent = "The address of this page is the link."; }
  });
}

function playing() {
  at("play").textContent = chain.plays ? "Pause" : "Play";
  at("play").setAttribute("aria-pressed", String(chain.plays));
}

function resound() {
  if (sound.asked) sound.show(sound.asked.orbit, sound.asked.mass, sound.asked.hertz);
}

function range() {
  const [from, to] = [Number(at("from").value), Number(at("to").value)];
  if (!(from > 0 && from < to && to < 1e6)) return says("The range of frequencies must begin above 0 and end above its start.");
  Object.assign(state, { from, to, r: Math.min(Math.max(state.r, from), to) });
  forget();
  changed();
}

// Moves the state to the point of a picture that was clicked.
function point(event) {
  const id = event.currentTarget.id;
  const { frame } = at(id);
  const picture = at(id).querySelector("svg");
  if (!frame || !picture) return;
  const box = picture.getBoundingClientRect();
  const size = picture.viewBox.baseVal.width / box.width;
  const part = ((event.clientX - box.left) * size - frame.left) / frame.width;
  const rise = 1 - ((event.clientY - box.top) * size - frame.top) / frame.height;
  if (part < 0 || part > 1 || rise < 0 || rise > 1) return;
  state.r = frame.x[0] + part * (frame.x[1] - frame.x[0]);
  if (id === "map") state.beta = Math.max(0, frame.y[0] + rise * (frame.y[1] - frame.y[0]));
  changed();
}

function arrowKey(event) {
  const step = event.shiftKey ? 0.1 : 0.01;
  const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
  if (!move) return;
  event.preventDefault();
  state.r = Math.min(Math.max(state.r + move[0] * step * (state.to - state.from), state.from), state.to);
  state.beta = Math.max(0, state.beta + move[1] * step * top_);
  changed();
}

async function findBest() {
  slow.stop();
  at("best-is").textContent = "Searching…";
  const asked = [editor.text, state.of, state.from, state.to].join();
  const told = scene.joined ? await searched() : await slow.ask(question("best", { work: 60000 }));
  if (asked !== [editor.text, state.of, state.from, state.to].join()) {
    at("best-is").textContent = "The scene changed during the search.";
    return;
  }
  if (told.error) {
    at("best-is").textContent = `None found: ${told.error}.`;
    return;
  }
  best = told;
  const whole = told.finished ? "" : " The search stopped at its limit; the command goes on.";
  const unit = scene.excitation === "base" ? "Y" : "P/k₁";
  const motion = state.of === undefined ? "the contact" : scene.masses[state.of].name;
  const extremes = scene.joined ? "" : ` Without friction the maximum is ${most(told.without_friction)}, with the contact stuck ${most(told.stuck)}.`;
  at("best-is").textContent = `With β = ${short(told.beta)} the largest displacement of ${motion} ${scene.joined ? "at the frequencies compared" : "over the range"} is smallest: ${short(told.amplitude)} ${unit} (${told.why}).${extremes}${whole}`;
  if (told.beta <= top_) {
    state.beta = told.beta;
    if (told.r) state.r = told.r;
  }
  changed();
}

// Writes a maximum of a search. A resonance without damping has none.
function most(amplitude) {
  return amplitude === null || amplitude === undefined ? "unbounded" : short(amplitude);
}

// Compares frictions on a grid, for a scene without closed form, and then between the neighbours of the best friction.
async function searched() {
  const asked = question("points");
  const even = Array.from({ length: 29 }, (_, i) => asked.from + (asked.to - asked.from) * i / 28);
  const peaks = scene.resonances.filter((r) => asked.from < r && r < asked.to);
  asked.rs = [...even, ...peaks];
  const known = new Map();
  let [low, high, done] = [0.02 * top_, top_, 0];
  for (const count of [7, 5]) {
    for (let i = 0; i < count; i += 1) {
      const beta = low * (high / low) ** (i / (count - 1));
      const points = [];
      for (let start = 0; start < asked.rs.length; start += 3) {
        const told = await slow.ask({ ...asked, beta, rs: asked.rs.slice(start, start + 3) });
        if (told.error) return told;
        points.push(...told.points);
      }
      const sizes = points.filter((point) => point[1] !== null).sort((a, b) => b[1] - a[1]);
      if (sizes.length) known.set(beta, sizes[0]);
      at("best-is").textContent = `Searching… ${Math.round(100 * ++done / 12)} %`;
    }
    const betas = [...known.keys()].sort((a, b) => a - b);
    const place = betas.reduce((least, beta, index) => known.get(beta)[1] < known.get(betas[least])[1] ? index : least, 0);
    [low, high] = [betas[Math.max(place - 1, 0)], betas[Math.min(place + 1, betas.length - 1)]];
    if (count === 5) return { beta: betas[place], amplitude: known.get(betas[place])[1], r: known.get(betas[place])[0], finished: true, why: `the best of 12 frictions at ${asked.rs.length} frequencies` };
  }
  return { error: "no motion settles" };
}

async function begin() {
  at("scenes").replaceChildren(new Option("Your own", -1, false, false), ...examples.map((example, index) => new Option(example.title, index)));
  listen();
  at("link").hidden = framed;
  // On a narrow window the answers come first, also for the keyboard. Otherwise the sliders are below the first screen.
  const narrow = matchMedia("(max-width:820px)");
  const order = () => narrow.matches ? at("describe").before(at("answers")) : at("answers").before(at("describe"));
  narrow.addEventListener("change", order);
  order();
  playing();
  const packed = Uint8Array.from(atob(at("wasm").textContent), (char) => char.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const module = await WebAssembly.compile(await new Response(stream).arrayBuffer());
  fast = new Engine(module, 1000);
  slow = new Engine(module, 8000);
  const given = JSON.parse(at("given").textContent);
  load(linked() ?? given ?? { text: examples[0].text });
}

begin();
