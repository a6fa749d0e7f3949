// Puts the page together; the first run with pictures is shown.

data.rows.forEach((row, index) => { row.index = index; });
makeHeads();
makeFilters();
showRows();
const first = data.rows.find((row) => row.index === data.first)
  || visible[0];
if (first) {
  select(first);
  byId("runs").scrollTop = first.element.offsetTop
    - byId("runs").clientHeight / 2;
}
document.documentElement.dataset.ready = "true";
