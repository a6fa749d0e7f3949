// The table of runs: sorted by a heading, filtered by the selects.

// The viewer shows the other columns too.
const listed = data.columns.filter((column) => column.listed);
const body = document.querySelector("#table tbody");
let order = { key: "flip", down: false };
let visible = [];

function cellOf(row, column) {
  const cell = document.createElement("td");
  const value = row.values[column.key];
  if (column.text) cell.className = "l";
  if (column.key === "encoder") {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "open";
    button.textContent = row.label;
    button.title = value;
    cell.append(button);
  } else {
    cell.textContent = format(column, value);
  }
  return cell;
}

function makeRow(row) {
  row.element = document.createElement("tr");
  row.element.append(...listed.map((column) => cellOf(row, column)));
  row.element.addEventListener("click", () => select(row));
  row.button = row.element.querySelector("button");
  row.button.addEventListener("keydown", (event) => step(event, row));
}

// Arrow keys go from run to run.
function step(event, row) {
  const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  const next = by && visible[visible.indexOf(row) + by];
  if (!next) return;
  event.preventDefault();
  next.button.focus();
  select(next);
}

// Rows without a value come last, whichever way the others go.
function compareRows(a, b) {
  const [x, y] = [a.values[order.key], b.values[order.key]];
  if (x === null || y === null) return (x === null) - (y === null);
  const up = typeof x === "string" ? x.localeCompare(y) : x - y;
  return (order.down ? -up : up) || a.index - b.index;
}

function matches(row) {
  const wanted = (id) => byId(id).value;
  return (!wanted("scene") || row.values.scene === wanted("scene"))
    && (!wanted("encoder") || row.values.encoder === wanted("encoder"))
    && ofSetting(row);
}

function ofSetting(row) {
  return row.setting === Number(byId("setting").value);
}

function showRows() {
  visible = data.rows.filter(matches).sort(compareRows);
  for (const row of visible) if (!row.element) makeRow(row);
  body.replaceChildren(...visible.map((row) => row.element));
  byId("count").textContent = `${visible.length} of `
    + `${data.rows.filter(ofSetting).length} runs`;
  for (const head of document.querySelectorAll("#table th")) {
    head.setAttribute("aria-sort", head.dataset.key !== order.key ? "none"
      : order.down ? "descending" : "ascending");
  }
}

function sortBy(key) {
  order = { key, down: order.key === key && !order.down };
  showRows();
}

function makeHeads() {
  for (const column of listed) {
    const head = document.createElement("th");
    const button = document.createElement("button");
    head.scope = "col";
    head.dataset.key = column.key;
    if (column.text) head.className = "l";
    button.type = "button";
    button.textContent = column.listed;
    button.title = column.title;
    button.addEventListener("click", () => sortBy(column.key));
    head.append(button);
    document.querySelector("#table thead tr").append(head);
  }
}

function fill(id, pairs) {
  for (const [value, text] of pairs) byId(id).append(new Option(text, value));
}

function makeFilters() {
  const names = (key) => [...new Set(data.rows.map((r) => r.values[key]))];
  const labels = new Map(data.rows.map((r) => [r.values.encoder, r.label]));
  fill("scene", names("scene").sort().map((name) => [name, name]));
  fill("encoder", names("encoder").map((spec) => [spec, labels.get(spec)]));
  fill("setting", data.settings.map((text, index) => [index, text.label]));
  byId("setting-label").hidden = data.settings.length < 2;
  byId("filters").addEventListener("change", showRows);
  byId("filters").addEventListener("submit", (e) => e.preventDefault());
}
