#pragma once

#include "teach/marking/marker.h"
#include "words/words.h"

#include <span>
#include <string>
#include <vector>

/// Marks as a terminal's table, as JSON and as CSV. The same marks give the same bytes: there is no time and
/// no date in them.
namespace sandbox {

struct MarkedAnswer {
    std::string name; ///< as the file is called, whatever that is
    std::string page; ///< of page_names()
    Mark mark;        ///< without pictures, once its page is written
    std::vector<std::string> said;
};

/// A row an answer, and what is said of it.
std::string marks_table(const Words &words, const Exercise &exercise, std::span<const MarkedAnswer> answers);

/// Keys: format, version, exercise, title, of, answers (name, points (null: none can be given), terms (term, points,
/// of, right, pictures), faults (of a program: "no-max", "gate=none"), refused, said).
std::string marks_json(const Exercise &exercise, std::span<const MarkedAnswer> answers);

/// Columns: answer, points, of, a column a term, said.
std::string marks_csv(const Exercise &exercise, std::span<const MarkedAnswer> answers);

} // namespace sandbox
