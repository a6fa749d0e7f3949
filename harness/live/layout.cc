#include "harness/live/layout.h"

#include <algorithm>

namespace rtb {

Layout MakeLayout(GridSize terminal, bool panel) {
  constexpr int kPanelColumns = 34;
  Layout layout;
  layout.picture = {0, 0, terminal.columns, terminal.rows};
  if (!panel) return layout;
  if (terminal.columns >= 2 * kPanelColumns && terminal.rows >= 8) {
    layout.picture.columns -= kPanelColumns;
    layout.panel = {layout.picture.columns, 0, kPanelColumns, terminal.rows};
  } else if (terminal.columns >= 20 && terminal.rows >= 4) {
    --layout.picture.rows;
    layout.status = {0, layout.picture.rows, terminal.columns, 1};
  }
  return layout;
}

}  // namespace rtb
