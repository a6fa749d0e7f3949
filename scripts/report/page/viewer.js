// The viewer: one run's grid over its reference or its FLIP map.

const canvas = byId("grid");
const under = byId("under");
let current = null;
let grid = null;

function view() {
  return document.querySelector('input[name="view"]:checked').value;
}

function showUnder() {
  const flip = document.querySelector('input[value="flip"]');
  flip.disabled = !current.flip;
  if (flip.disabled && flip.checked) {
    document.querySelector('input[value="reference"]').checked = true;
  }
  const id = view() === "flip" ? current.flip : current.reference;
  if (id) under.src = pictureUrl(id);
  else under.removeAttribute("src");
  const name = view() === "flip" ? "FLIP map"
    : `reference (${current.renderer})`;
  under.alt = `${name} of ${current.values.scene}`;
  byId("tag-right").textContent = name;
  byId("scale").hidden = view() !== "flip";
  moveDivider(split);
}

function showFigures() {
  const list = data.columns.filter((column) => !column.text)
    .map((column) => {
      const group = document.createElement("div");
      const [name, value] = ["dt", "dd"].map((tag) =>
        document.createElement(tag));
      if (column.key === "flip") group.className = "main";
      name.textContent = column.heading;
      name.title = column.title;
      value.textContent = format(column, current.values[column.key]);
      group.append(name, value);
      return group;
    });
  byId("figures").replaceChildren(...list);
  const setting = data.settings[current.setting];
  byId("measured").textContent = `FLIP ${setting.measured}; ${setting.label}; `
    + `${current.note}`;
}

function showName() {
  const code = document.createElement("code");
  const dot = document.createElement("span");
  code.textContent = current.values.encoder;
  dot.textContent = "·";
  byId("run-name").replaceChildren(current.values.scene, dot, code);
  byId("tag-left").textContent = current.label;
}

function showText() {
  if (!byId("text-box").open || !grid) return;
  // As large as the lines fit: a monospaced letter is 0.602 of its size wide.
  const size = (byId("text").clientWidth - 20) / (grid.columns * 0.603);
  byId("text").style.fontSize = `${Math.min(16, Math.max(5, size))}px`;
  byId("text").replaceChildren(byId("colored").checked ? coloredText(grid)
    : textOf(grid));
}

async function showGrid() {
  const run = current;
  const missing = byId("none");
  missing.hidden = Boolean(run.cells);
  missing.textContent = run.missing;
  byId("text-box").hidden = !run.cells;
  divider.hidden = !run.cells;
  grid = null;
  if (!run.cells) return;
  const read = await readGrid(run.cells, ...run.grid);
  // Another run may have been chosen meanwhile.
  if (run !== current) return;
  grid = read;
  stage.style.aspectRatio = `${run.grid[0]} / ${run.grid[1] * 2}`;
  drawGrid(canvas, grid);
  canvas.setAttribute("aria-label",
    `${run.values.scene} in cells by ${run.values.encoder}`);
  canvas.dataset.run = run.index;
  showText();
}

async function select(row) {
  if (current && current.element) {
    current.element.removeAttribute("aria-current");
  }
  current = row;
  row.element.setAttribute("aria-current", "true");
  showName();
  showFigures();
  showUnder();
  await showGrid();
}

for (const input of document.querySelectorAll('input[name="view"]')) {
  input.addEventListener("change", showUnder);
}
byId("text-box").addEventListener("toggle", showText);
byId("colored").addEventListener("change", showText);
byId("copy").addEventListener("click", async () => {
  if (!grid) return;
  try {
    await navigator.clipboard.writeText(textOf(grid));
    byId("copy").textContent = "Copied";
  } catch {
    // Not allowed here: the text is selected, ready to be copied by hand.
    byId("text-box").open = true;
    getSelection().selectAllChildren(byId("text"));
    byId("copy").textContent = "Selected";
  }
  setTimeout(() => { byId("copy").textContent = "Copy as text"; }, 1500);
});

let redraw = 0;
new ResizeObserver(() => {
  clearTimeout(redraw);
  redraw = setTimeout(() => { if (grid) drawGrid(canvas, grid); }, 150);
}).observe(stage);
