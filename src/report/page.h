#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace knitmech::report {

/// The bytes of a PNG file as an image inside the page. \param description for those who do not see it
[[nodiscard]] std::string inline_png(std::string_view bytes, const std::string& description);

/// A drawing [HTML] with a line below it [text].
[[nodiscard]] std::string figure(const std::string& drawing, const std::string& caption);

/// Figures side by side, as many as fit.
[[nodiscard]] std::string side_by_side(const std::vector<std::string>& figures);

/// A table of cells [HTML], the first row its head. Cells that begin like a number are set to the right.
[[nodiscard]] std::string table(const std::vector<std::vector<std::string>>& rows);

/// A page that needs no other file and no network: sections with a list of them at the top.
class Page {
 public:
  /// \param title, subtitle text
  Page(std::string title, std::string subtitle) : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

  /// What stands before the first section [HTML].
  void add_to_head(const std::string& html) { head_ += html; }
  void add_section(const std::string& title, const std::string& html) { sections_.push_back({title, html}); }

  /// \param footer [HTML]
  [[nodiscard]] std::string html(const std::string& footer) const;

 private:
  struct Section {
    std::string title, html;
  };
  std::string title_, subtitle_, head_;
  std::vector<Section> sections_;
};

}  // namespace knitmech::report
