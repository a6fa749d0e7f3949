// Draws a grid on a canvas, every glyph by its outline in a cell of 8 x 16.

const paths = new Map();

function pathOf(number) {
  if (!paths.has(number)) {
    const shape = data.shapes[number];
    paths.set(number, shape && { path: new Path2D(shape[0]), alpha: shape[1] });
  }
  return paths.get(number);
}

// A glyph that has no outline here, in whatever font the reader has.
function drawText(context, number) {
  context.font = `13.3px ${getComputedStyle(document.documentElement)
    .getPropertyValue("--mono")}`;
  context.fillText(data.alphabet[number], 0, 12.6, 8);
}

function drawCell(context, grid, i, scale) {
  const x = i % grid.columns * 8 * scale;
  const y = Math.floor(i / grid.columns) * 16 * scale;
  context.setTransform(scale, 0, 0, scale, x, y);
  context.globalAlpha = 1;
  context.fillStyle = grid.backgrounds[i];
  context.fillRect(0, 0, 8, 16);
  if (grid.foregrounds[i] === grid.backgrounds[i]) return;
  const shape = pathOf(grid.glyphs[i]);
  context.fillStyle = grid.foregrounds[i];
  if (!shape) {
    drawText(context, grid.glyphs[i]);
    return;
  }
  context.globalAlpha = shape.alpha;
  context.fill(shape.path);
}

// Sharp at the size at which the canvas is seen.
function drawGrid(canvas, grid) {
  const seen = canvas.clientWidth * (window.devicePixelRatio || 1);
  const scale = Math.min(4, Math.max(1, Math.ceil(seen / (grid.columns * 8))));
  canvas.width = grid.columns * 8 * scale;
  canvas.height = grid.rows * 16 * scale;
  const context = canvas.getContext("2d", { alpha: false });
  for (let i = 0; i < grid.columns * grid.rows; ++i) {
    // What sticks out of its cell is cut off by the next ones' backgrounds on
    // the right and below; a clip for each cell would cost far more.
    drawCell(context, grid, i, scale);
  }
}

function lineOf(grid, row) {
  const start = row * grid.columns;
  return grid.glyphs.slice(start, start + grid.columns)
    .map((number) => data.alphabet[number]).join("");
}

function textOf(grid) {
  const lines = [];
  for (let row = 0; row < grid.rows; ++row) lines.push(lineOf(grid, row));
  return lines.join("\n") + "\n";
}

// The text in color: a span for each stretch of equal colors.
function coloredText(grid) {
  const whole = document.createDocumentFragment();
  for (let row = 0; row < grid.rows; ++row) {
    let span = null;
    for (let i = row * grid.columns; i < (row + 1) * grid.columns; ++i) {
      const [color, ground] = [grid.foregrounds[i], grid.backgrounds[i]];
      if (!span || span.color !== color || span.ground !== ground) {
        const element = document.createElement("span");
        element.style.cssText = `color:${color};background:${ground}`;
        whole.append(element);
        span = { element, color, ground };
      }
      span.element.textContent += data.alphabet[grid.glyphs[i]];
    }
    whole.append("\n");
  }
  return whole;
}
