// The page's data: figures in one JSON, pictures as base64 texts that are
// decoded when they are looked at.

const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);

function blob(id) {
  return byId(id).textContent;
}

function pictureUrl(id) {
  return `data:${blob(id)}`;
}

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(
    new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Undoes the differences to the cell on the left, plane by plane.
function undoDifferences(planes, columns, rows) {
  const cells = columns * rows;
  for (let plane = 2; plane < 8; ++plane) {
    for (let row = 0; row < rows; ++row) {
      const start = plane * cells + row * columns;
      for (let i = start + 1; i < start + columns; ++i) {
        planes[i] = (planes[i] + planes[i - 1]) & 255;
      }
    }
  }
}

const hexByte = Array.from({ length: 256 },
  (_, i) => i.toString(16).padStart(2, "0"));

// {columns, rows, glyphs: [number], foregrounds, backgrounds: ["#rrggbb"]}
async function readGrid(id, columns, rows) {
  const planes = await inflate(bytesOf(blob(id)));
  undoDifferences(planes, columns, rows);
  const cells = columns * rows;
  const color = (plane, i) => "#" + hexByte[planes[plane * cells + i]]
    + hexByte[planes[(plane + 1) * cells + i]]
    + hexByte[planes[(plane + 2) * cells + i]];
  const grid = { columns, rows, glyphs: [], foregrounds: [], backgrounds: [] };
  for (let i = 0; i < cells; ++i) {
    grid.glyphs.push(planes[i] + 256 * planes[cells + i]);
    grid.foregrounds.push(color(2, i));
    grid.backgrounds.push(color(5, i));
  }
  return grid;
}

const shown = (value, digits) => value === null || value === undefined
  ? "–" : value.toFixed(digits).replace("-", "−");

// Three significant digits, never an exponent.
function significant(value) {
  if (value === null || value === undefined) return "–";
  if (value === 0) return "0";
  const digits = 2 - Math.floor(Math.log10(Math.abs(value)));
  return shown(value, Math.min(12, Math.max(0, digits)));
}

function format(column, value) {
  if (column.text) return value;
  return column.digits === null ? significant(value)
    : shown(value, column.digits);
}
