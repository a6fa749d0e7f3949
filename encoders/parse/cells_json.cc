#include <nlohmann/json.hpp>

#include "encoders/emit/hex_color.h"
#include "encoders/parse/glyph_text.h"
#include "encoders/parse/parse.h"

namespace rtb {
namespace {

using Json = nlohmann::json;

constexpr char kForm[] =
    "{\"columns\": C, \"rows\": R, \"cells\": [[glyph, \"#rrggbb\", "
    "\"#rrggbb\"], ...]}";
/// More columns or rows than any terminal has.
constexpr std::int64_t kMaxSide = 1 << 14;

Result<int> ReadSide(const Json& json, const char* key,
                     const std::string& name) {
  const std::string place = name + ": " + key;
  const auto found = json.find(key);
  if (found == json.end()) {
    return Fail(BadInput(place, "is missing", std::string("form: ") + kForm));
  }
  const bool fits = found->is_number_integer() &&
                    found->get<std::int64_t>() >= 1 &&
                    found->get<std::int64_t>() <= kMaxSide;
  if (!fits) {
    return Fail(BadInput(place, "expected an integer from 1 to " +
                                    std::to_string(kMaxSide) + ", found " +
                                    found->dump()));
  }
  return found->get<int>();
}

Result<Rgb8> ReadColor(const Json& json, const std::string& place) {
  if (json.is_string()) {
    if (const auto color = ParseHexColor(json.get_ref<const std::string&>())) {
      return *color;
    }
  }
  return Fail(
      BadInput(place, "expected a color \"#rrggbb\", found " + json.dump()));
}

Result<char32_t> ReadGlyph(const Json& json, const std::string& place) {
  if (json.is_string()) {
    if (const auto glyph = ParseGlyph(json.get_ref<const std::string&>())) {
      return *glyph;
    }
  }
  return Fail(BadInput(
      place,
      "expected a string of one visible character, found " + json.dump()));
}

Result<Cell> ReadCell(const Json& json, const std::string& place) {
  if (!json.is_array() || json.size() != 3) {
    return Fail(BadInput(place, "expected [glyph, \"#rrggbb\", \"#rrggbb\"]"));
  }
  Cell cell;
  RTB_ASSIGN_OR_RETURN(cell.glyph, ReadGlyph(json[0], place));
  RTB_ASSIGN_OR_RETURN(cell.fg, ReadColor(json[1], place));
  RTB_ASSIGN_OR_RETURN(cell.bg, ReadColor(json[2], place));
  return cell;
}

Result<CellGrid> ReadGrid(const Json& json, const std::string& name) {
  if (!json.is_object()) {
    return Fail(BadInput(name, std::string("expected ") + kForm));
  }
  GridSize size;
  RTB_ASSIGN_OR_RETURN(size.columns, ReadSide(json, "columns", name));
  RTB_ASSIGN_OR_RETURN(size.rows, ReadSide(json, "rows", name));
  const auto cells = json.find("cells");
  const auto expected = static_cast<std::size_t>(size.cells());
  if (cells == json.end() || !cells->is_array() || cells->size() != expected) {
    return Fail(BadInput(
        name + ": cells",
        "expected an array of columns x rows = " + std::to_string(expected) +
            " cells" +
            (cells == json.end() || !cells->is_array()
                 ? std::string()
                 : ", found " + std::to_string(cells->size()))));
  }
  CellGrid grid(size);
  for (std::size_t i = 0; i < expected; ++i) {
    const std::string place = name + ": cells[" + std::to_string(i) + "]";
    RTB_ASSIGN_OR_RETURN(grid.cells[i], ReadCell((*cells)[i], place));
  }
  return grid;
}

}  // namespace

Result<CellGrid> ParseCellsJson(const std::string& text,
                                const std::string& name) {
  try {
    return ReadGrid(Json::parse(text), name);
  } catch (const Json::exception& error) {
    return Fail(BadInput(name, std::string("not valid JSON: ") + error.what(),
                         std::string("form: ") + kForm));
  }
}

}  // namespace rtb
