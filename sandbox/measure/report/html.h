#pragma once

#include "image/image.h"
#include "measure/work_precision/findings.h"
#include "words/words.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Pieces of the pages report.html and stability.html.
namespace sandbox::html {

/// & < > " become entities.
std::string escaped(std::string_view text);
std::string base64(std::string_view bytes);

/// A table whose columns sort when their heads are clicked, where scripts run. All texts are HTML; a `style` is a class
/// of assets/page/style.css.
class Table {
  public:
    explicit Table(std::vector<std::string> heads, std::string caption = {})
        : heads_(std::move(heads)), caption_(std::move(caption)) {}
    void begin_row() { rows_.emplace_back(); }
    void text(std::string_view html, std::string_view style = {});
    /// What is shown, at the right, and the number that the column sorts by.
    void number(double value, std::string_view html, std::string_view style = {});
    /// A text over all columns that have no cell in this row yet.
    void rest(std::string_view html, std::string_view style = {});
    /// The whole table; empty if it has no rows.
    [[nodiscard]] std::string html() const;

  private:
    struct Cell {
        std::string html;
        bool number;
    };
    std::vector<std::string> heads_;
    std::string caption_;
    std::vector<std::vector<Cell>> rows_;
};

/// A whole self-contained page; `title` is plain text.
/// The heads of columns report.column.NAME.
std::vector<std::string> heads_of(const Words &words, std::initializer_list<std::string_view> names);
std::string page(const Words &words, std::string_view title, std::string_view body);
/// A heading, a lead and a body; empty if the body is.
std::string section(std::string_view style, std::string_view title, std::string_view lead, std::string_view body);
std::string card(std::string_view top, std::string_view big, std::string_view below, bool words = false);
/// A picture with its title, its caption and a number that is kept on one line; plain texts.
std::string figure(std::string_view title, std::string_view caption, std::string_view number, const ByteImage &image);
std::string technique_code(const Technique &technique);
/// "1.23 [1.20, 1.31]"
std::string ratio_text(const TimeRatio &ratio);

} // namespace sandbox::html
