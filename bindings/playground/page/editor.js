// Shows the description: its text, the messages under its lines, and the sliders of its numbers.
class Editor {
  constructor(changed) {
    this.area = document.getElementById("text");
    this.marks = document.getElementById("marks");
    this.list = document.getElementById("faults");
    this.box = document.getElementById("numbers");
    this.changed = changed;
    this.faults = [];
    this.ranges = new Map();
    this.area.addEventListener("input", () => { this.ranges.clear(); changed(); });
    for (const event of ["scroll", "keyup", "click"]) this.area.addEventListener(event, () => this.place());
    addEventListener("resize", () => this.place());
  }

  set(text) {
    this.area.value = text;
    this.ranges.clear();
  }

  get text() {
    return this.area.value;
  }

  // Shows all messages below the text, and the message of the line with the cursor under this line.
  tell(faults) {
    this.faults = faults;
    this.list.replaceChildren(...faults.slice(0, 8).map((fault) => {
      const line = document.createElement("li");
      line.textContent = fault.line ? `Line ${fault.line}, column ${fault.column}: ${fault.message}` : fault.message;
      return line;
    }));
    this.area.setAttribute("aria-invalid", String(faults.length > 0));
    this.place();
  }

  place() {
    const style = getComputedStyle(this.area);
    const [line, left, top] = [parseFloat(style.lineHeight), parseFloat(style.paddingLeft), parseFloat(style.paddingTop)];
    const cursor = this.text.slice(0, this.area.selectionStart).split("\n").length;
    const placed = this.faults.filter((fault) => fault.line);
    const shown = placed.find((fault) => fault.line === cursor) ?? placed[0];
    const marks = placed.map((fault) => {
      const mark = document.createElement("u");
      mark.style.top = `${top + (fault.line - 1) * line - this.area.scrollTop}px`;
      mark.style.left = `calc(${left - this.area.scrollLeft}px + ${fault.column - 1}ch)`;
      return mark;
    });
    if (shown) {
      const text = document.createElement("p");
      text.textContent = shown.message;
      text.style.top = `${top + shown.line * line + 3 - this.area.scrollTop}px`;
      marks.push(text);
    }
    this.marks.replaceChildren(...marks);
  }

  // Makes a slider for each number. A slider keeps its range while the scene has the same numbers.
  sliders(numbers) {
    const key = numbers.map((number) => number.kind + number.name).join();
    this.numbers = numbers;
    if (key === this.key && this.ranges.size) {
      numbers.forEach((number, index) => this.write(index, number.value));
      return;
    }
    this.key = key;
    const units = { mass: "kg", spring: "N/m", damper: "N·s/m", stiffness: "N/m" };
    const names = { mass: "Mass", spring: "Spring", damper: "Damper", damping: "Damping", stiffness: "Contact stiffness", stiction: "Stiction μ", share: "Share" };
    this.rows = numbers.map((number, index) => {
      const label = document.createElement("label");
      const [value, slider] = [document.createElement("span"), document.createElement("input")];
      // An element `output` would take the label for itself.
      value.className = "number";
      const range = this.range(number);
      this.ranges.set(index, range);
      Object.assign(slider, { type: "range", min: 0, max: 1, step: "any" });
      slider.addEventListener("input", () => this.rewrite(index, range.at(Number(slider.value))));
      label.append(`${names[number.kind]} ${number.name} `, value, ` ${units[number.kind] ?? ""}`, slider);
      return { label, value, slider, range };
    });
    this.box.replaceChildren(this.box.firstElementChild, ...this.rows.map((row) => row.label));
    numbers.forEach((number, index) => this.write(index, number.value));
  }

  // A slider covers a factor of 16 about its first value. A slider of a ratio covers the range of the ratio.
  range({ kind, value }) {
    const plain = (low, high) => ({ at: (part) => low + (high - low) * part, part: (number) => (number - low) / (high - low) });
    if (kind === "damping") return plain(0, Math.max(0.1, 4 * value));
    if (kind === "stiction") return plain(1, Math.max(2.5, value));
    if (kind === "share") return plain(0, Math.max(2, 2 * value));
    return { at: (part) => value * 4 ** (2 * part - 1), part: (number) => (Math.log(number / value) / Math.log(4) + 1) / 2 };
  }

  write(index, value) {
    const row = this.rows[index];
    row.value.textContent = short(value);
    if (document.activeElement !== row.slider) row.slider.value = row.range.part(value);
    row.slider.setAttribute("aria-valuetext", short(value));
  }

  // Writes the number of a slider into the text.
  rewrite(index, value) {
    const number = this.numbers[index];
    if (!number) return;
    const written = short(value);
    this.area.value = this.text.slice(0, number.start) + written + this.text.slice(number.end);
    // The positions of later numbers shift with the text, until the next answer gives the new positions.
    const moved = written.length - (number.end - number.start);
    for (const other of this.numbers) if (other.start > number.start) { other.start += moved; other.end += moved; }
    number.end += moved;
    this.write(index, value);
    this.changed();
  }
}

// Formats a number with four digits.
function short(value) {
  if (value === null || value === undefined) return "∞";
  const text = String(Number(value.toPrecision(4)));
  return text;
}
