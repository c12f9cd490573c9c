#pragma once

#include "capture/figures.h"

#include <string>
#include <vector>

namespace sandbox {

/// Every figure with its number, caption, table, files and commands, in Markdown.
std::string figures_page(const FigureRequest &request, const FigureDraw &draw, const std::vector<Figure> &figures);

} // namespace sandbox
