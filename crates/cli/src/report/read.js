"use strict";
// Reads values off the pictures: with a pointer, or with the arrow keys on a slider under each.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const NS = "http://www.w3.org/2000/svg";
  const STEPS = 600;

  const text = value => {
    const size = Math.abs(value);
    if (size === 0) return "0";
    const shown = size < 1e-3 || size >= 1e5 ? value.toExponential(3) : String(Number(value.toPrecision(4)));
    return shown.replace("-", "−");
  };
  const unit = (value, name) => text(value) + (name === "°" ? "°" : name ? " " + name : "");
  const element = (name, parent, words) => {
    const made = document.createElement(name);
    if (words !== undefined) made.textContent = words;
    parent.append(made);
    return made;
  };
  const shape = (name, parent, attributes) => {
    const made = document.createElementNS(NS, name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    parent.append(made);
    return made;
  };
  // The value of a curve at x, between its neighbours; none where it has no point.
  const at = (series, x) => {
    for (const run of series.runs) {
      const last = run.x.length - 1;
      if (last < 0 || x < run.x[0] || x > run.x[last]) continue;
      let low = 0, high = last;
      while (high - low > 1) {
        const middle = (low + high) >> 1;
        if (run.x[middle] <= x) low = middle; else high = middle;
      }
      const width = run.x[high] - run.x[low];
      const share = width > 0 ? (x - run.x[low]) / width : 0;
      return { y: run.y[low] + share * (run.y[high] - run.y[low]), regime: run.regime };
    }
    return null;
  };
  const within = (value, [low, high]) => Math.min(high, Math.max(low, value));
  const place = (panel, y) => {
    const [low, high] = panel.y_ends;
    const share = panel.log
      ? (Math.log(y) - Math.log(low)) / (Math.log(high) - Math.log(low))
      : (y - low) / (high - low);
    return share >= -1e-9 && share <= 1 + 1e-9 ? panel.top + panel.height * (1 - share) : null;
  };
  const nearest = (values, value) => {
    let best = 0;
    values.forEach((other, index) => {
      if (Math.abs(other - value) < Math.abs(values[best] - value)) best = index;
    });
    return best;
  };

  for (const plot of data.plots) {
    const figure = [...document.querySelectorAll("figure.plot")].find(one => one.dataset.plot === plot.id);
    const svg = figure && figure.querySelector("svg");
    if (!svg || !plot.panels.length) continue;
    // A browser would show the title as a hint over the values.
    const title = svg.querySelector("title");
    if (title) title.remove();
    svg.setAttribute("aria-label", plot.title);

    const main = plot.panels[0];
    const grid = plot.more && plot.more.cells ? plot.more : null;
    const names = plot.more && plot.more.steps;
    const [from, to] = names ? [1, names.length] : main.x_ends;
    const steps = names ? Math.max(1, names.length - 1) : STEPS;
    const marks = shape("g", svg, { "pointer-events": "none" });
    const reader = element("div", figure);
    reader.className = "reader";
    const slider = (label, count) => {
      const row = element("label", reader, label);
      const input = element("input", row);
      input.type = "range";
      input.min = 0;
      input.max = count;
      return input;
    };
    const across = slider(plot.x, steps);
    const up = grid ? slider(main.quantity, 300) : null;
    const output = element("output", reader);

    const show = () => {
      const x = from + (to - from) * across.value / steps;
      const [x0, x1] = main.x_ends;
      const where = main.left + main.width * (x - x0) / (x1 - x0);
      marks.replaceChildren();
      output.replaceChildren();
      const head = names ? names[Math.round(x) - 1] : plot.x_unit ? unit(x, plot.x_unit) : "r = " + text(x);
      const said = [head];
      element("strong", output, head);
      for (const panel of plot.panels)
        shape("line", marks, { x1: where, x2: where, y1: panel.top, y2: panel.top + panel.height, stroke: "#222", "stroke-width": 0.8 });
      if (grid) {
        const [y0, y1] = main.y_ends;
        const y = y0 + (y1 - y0) * up.value / 300;
        const level = place(main, y);
        shape("line", marks, { x1: main.left, x2: main.left + main.width, y1: level, y2: level, stroke: "#222", "stroke-width": 0.8 });
        const cell = grid.cells[nearest(grid.y, y) * grid.x.length + nearest(grid.x, x)];
        const line = ", " + unit(y, main.unit) + ": " + grid.names[cell];
        element("span", output, line);
        said.push(line);
      }
      const list = element("ul", output);
      main.series.forEach((series, index) => {
        const values = plot.panels.map(panel => {
          const found = at(panel.series[index], x);
          const level = found && place(panel, found.y);
          if (found && level !== null)
            shape("circle", marks, { cx: where, cy: level, r: 3.4, fill: series.colour, stroke: "#fff", "stroke-width": 1 });
          return found && unit(found.y, panel.unit);
        });
        const first = at(main.series[index], x);
        const row = element("li", list);
        element("i", row).style.background = series.colour;
        const name = element("span", row, series.name);
        if (first && first.regime) {
          element("span", name, " " + first.regime).className = "soft";
        }
        const words = first ? values.filter(Boolean).join(", ") : "no value";
        element("span", row, words);
        said.push(series.name + ": " + words + (first && first.regime ? ", " + first.regime : ""));
      });
      across.setAttribute("aria-valuetext", said.join("; "));
      if (up) up.setAttribute("aria-valuetext", said.join("; "));
    };
    const follow = event => {
      const box = svg.getBoundingClientRect();
      const view = svg.viewBox.baseVal;
      const px = (event.clientX - box.left) * view.width / box.width;
      const py = (event.clientY - box.top) * view.height / box.height;
      const [x0, x1] = main.x_ends;
      const x = within(x0 + (x1 - x0) * (px - main.left) / main.width, [from, to]);
      across.value = Math.round((x - from) / (to - from || 1) * steps);
      if (up) up.value = Math.round(300 * within((main.top + main.height - py) / main.height, [0, 1]));
      show();
    };
    svg.addEventListener("pointermove", follow);
    svg.addEventListener("pointerdown", follow);
    across.addEventListener("input", show);
    if (up) up.addEventListener("input", show);
    across.value = Math.round(0.35 * steps);
    if (up) up.value = 100;
    show();
  }
})();
