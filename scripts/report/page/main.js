// Puts the page together; the first run with pictures is shown.

data.rows.forEach((row, index) => { row.index = index; });
makeHeads();
makeFilters();
showRows();
const first = data.rows.find((row) => row.index === data.first)
  || visible[0];
if (first) {
  select(first);
  first.element.scrollIntoView({ block: "nearest" });
}
document.documentElement.dataset.ready = "true";
