#pragma once

#include "measure/work_precision/findings.h"
#include "ui/session/document.h"
#include "words/words.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// What a measurement has to do with what the window shows now.
namespace sandbox {

/// The scene is one of those that were measured, on whichever of its meshes: its numbers hold for what is shown.
bool is_current(const WorkPrecision &measured, const Scene &shown);

/// The row that a side shows now, if it was measured; with `model`, the row of the same technique under that model.
std::optional<std::size_t> shown_row(const WorkPrecision &measured, const Document &document, bool right,
                                     std::optional<Model> model = {});

/// Puts a row's technique into A or B and, where the measurement is current, its mesh into the scene, which A and B
/// share. An edited scene keeps its edits, so then its mesh stays.
void take_row(Document &document, const WorkPrecision &measured, std::size_t row, bool right);

/// What is said of a row, a line each: technique, mesh, time, error, and where the error comes from.
std::vector<std::string> row_lines(const Words &words, const WorkPrecision &measured, std::size_t row);

/// Rows that have both an error and a run time.
std::size_t complete_rows(const WorkPrecision &measured);
/// Timed rounds that every row has: options.repeats unless it was stopped.
std::size_t complete_rounds(const WorkPrecision &measured);

} // namespace sandbox
