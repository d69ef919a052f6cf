#include "report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/text.h"
#include "report/style.h"
#include "results/base64.h"

namespace knitmech::report {
namespace {

bool begins_like_a_number(std::string_view cell) {
  if (cell.starts_with("-") || cell.starts_with("+")) cell.remove_prefix(1);
  return !cell.empty() && cell.front() >= '0' && cell.front() <= '9';
}

std::string table_row(const std::vector<std::string>& cells, const char* tag,
                      const std::vector<bool>& is_number_column) {
  std::string row = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    row += fmt::format("<{}{}>{}</{}>", tag, is_number_column[i] ? " class=\"number\"" : "", cells[i], tag);
  }
  return row + "</tr>\n";
}

/// A column is one of numbers if each of its cells below the head is one, or empty, and one is not.
std::vector<bool> number_columns(const std::vector<std::vector<std::string>>& rows) {
  std::vector<bool> is_number_column(rows.front().size(), false);
  for (std::size_t column = 0; column < is_number_column.size(); ++column) {
    int n_numbers = 0, n_others = 0;
    for (std::size_t row = 1; row < rows.size(); ++row) {
      const std::string& cell = rows[row][column];
      if (begins_like_a_number(cell)) {
        ++n_numbers;
      } else if (!cell.empty()) {
        ++n_others;
      }
    }
    is_number_column[column] = n_numbers > 0 && n_others == 0;
  }
  return is_number_column;
}

}  // namespace

std::string inline_png(std::string_view bytes, const std::string& description) {
  const auto data = std::as_bytes(std::span(bytes.data(), bytes.size()));
  return fmt::format(R"(<img alt="{}" src="data:image/png;base64,{}">)", base::in_markup(description),
                     results::to_base64(data));
}

std::string figure(const std::string& drawing, const std::string& caption) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", drawing, base::in_markup(caption));
}

std::string side_by_side(const std::vector<std::string>& figures) {
  return fmt::format("<div class=\"grid\">\n{}</div>\n", fmt::join(figures, ""));
}

std::string table(const std::vector<std::vector<std::string>>& rows) {
  if (rows.empty()) return {};
  const std::vector<bool> is_number_column = number_columns(rows);
  std::string html = "<div class=\"scroll\"><table>\n" + table_row(rows.front(), "th", is_number_column);
  for (std::size_t row = 1; row < rows.size(); ++row) html += table_row(rows[row], "td", is_number_column);
  return html + "</table></div>\n";
}

std::string Page::html(const std::string& footer) const {
  std::string links, body;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    links += fmt::format("<a href=\"#s{}\">{}</a> ", i + 1, base::in_markup(sections_[i].title));
    body += fmt::format("<h2 id=\"s{}\">{}</h2>\n{}", i + 1, base::in_markup(sections_[i].title), sections_[i].html);
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>\n{1}</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n<p class=\"soft\">{2}</p>\n"
      "{3}<nav>{4}</nav>\n{5}<footer>{6}</footer>\n</main>\n</body>\n</html>\n",
      base::in_markup(title_), kStyle, base::in_markup(subtitle_), head_, links, body, footer);
}

}  // namespace knitmech::report
