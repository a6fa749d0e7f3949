/// @file
/// Plain-text tables for people.
#pragma once

#include <string>
#include <vector>

namespace rtb {

/// A column's heading, and on which side its values line up.
struct TableColumn {
  std::string heading;
  bool right_aligned = true;
};

/// Rows of text, each as long as `columns`.
struct Table {
  std::vector<TableColumn> columns;
  std::vector<std::vector<std::string>> rows;
};

/// The table with its columns aligned, two spaces between them, a rule under
/// the headings, no blanks at line ends. Widths are terminal columns of UTF-8
/// text; control characters are made visible.
std::string FormatTable(const Table& table);

/// `value` with `digits` decimals, whatever the locale.
std::string FormatFixed(double value, int digits);

}  // namespace rtb
