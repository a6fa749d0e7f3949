#include "harness/results/table.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

#include "core/base/check.h"
#include "core/base/error.h"
#include "harness/results/display_width.h"

namespace rtb {
namespace {

std::vector<int> ColumnWidths(const Table& table) {
  std::vector<int> widths;
  for (const TableColumn& column : table.columns) {
    widths.push_back(DisplayWidth(Printable(column.heading)));
  }
  for (const std::vector<std::string>& row : table.rows) {
    RTB_CHECK_EQ(row.size(), widths.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], DisplayWidth(Printable(row[i])));
    }
  }
  return widths;
}

std::string Padded(const std::string& text, int width, bool right_aligned) {
  const std::string shown = Printable(text);
  const std::string blanks(
      static_cast<std::size_t>(width - DisplayWidth(shown)), ' ');
  return right_aligned ? blanks + shown : shown + blanks;
}

std::string FormatLine(const Table& table, const std::vector<int>& widths,
                       const std::vector<std::string>& row) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) line += "  ";
    line += Padded(row[i], widths[i], table.columns[i].right_aligned);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string FormatTable(const Table& table) {
  const std::vector<int> widths = ColumnWidths(table);
  std::vector<std::string> headings;
  std::vector<std::string> rules;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    headings.push_back(table.columns[i].heading);
    rules.emplace_back(static_cast<std::size_t>(widths[i]), '-');
  }
  std::string text = FormatLine(table, widths, headings);
  text += FormatLine(table, widths, rules);
  for (const std::vector<std::string>& row : table.rows) {
    text += FormatLine(table, widths, row);
  }
  return text;
}

std::string FormatFixed(double value, int digits) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

}  // namespace rtb
