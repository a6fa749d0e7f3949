// The divider: the grid on its left, the other picture on its right. Moved by
// dragging anywhere in the stage, or by the keys of a slider.

const stage = byId("stage");
const divider = byId("divider");
let split = 50;

function moveDivider(percent) {
  split = Math.min(100, Math.max(0, percent));
  stage.style.setProperty("--split", `${split}%`);
  divider.setAttribute("aria-valuenow", Math.round(split));
  divider.setAttribute("aria-valuetext",
    `${Math.round(split)} % grid, the rest ${byId("tag-right").textContent}`);
  byId("tag-left").hidden = split < 12;
  byId("tag-right").hidden = split > 88;
}

function followPointer(event) {
  const box = stage.getBoundingClientRect();
  moveDivider(100 * (event.clientX - box.left) / box.width);
}

stage.addEventListener("pointerdown", (event) => {
  if (event.button !== 0) return;
  stage.setPointerCapture(event.pointerId);
  followPointer(event);
  divider.focus({ preventScroll: true, focusVisible: false });
  event.preventDefault();
});
stage.addEventListener("pointermove", (event) => {
  if (stage.hasPointerCapture(event.pointerId)) followPointer(event);
});

divider.addEventListener("keydown", (event) => {
  const step = event.shiftKey ? 10 : 2;
  const to = {
    ArrowLeft: split - step, ArrowDown: split - step,
    ArrowRight: split + step, ArrowUp: split + step,
    PageDown: split - 10, PageUp: split + 10, Home: 0, End: 100,
  }[event.key];
  if (to === undefined) return;
  moveDivider(to);
  event.preventDefault();
});
