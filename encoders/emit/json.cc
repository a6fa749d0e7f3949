#include <nlohmann/json.hpp>

#include "encoders/emit/emit.h"
#include "encoders/emit/hex_color.h"

namespace rtb {

std::string EmitJson(const CellGrid& grid) {
  using Json = nlohmann::ordered_json;
  Json cells = Json::array();
  for (const Cell& cell : grid.cells) {
    cells.push_back({Utf8(cell.glyph), HexColor(cell.fg), HexColor(cell.bg)});
  }
  const Json json = {{"columns", grid.size.columns},
                     {"rows", grid.size.rows},
                     {"cells", std::move(cells)}};
  return json.dump() + "\n";
}

}  // namespace rtb
