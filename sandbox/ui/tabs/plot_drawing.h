#pragma once

#include "measure/report/plot_layout.h"

#include <imgui.h>
#include <optional>

/// Plots of lay_out() with ImGui's draw list. Positions in a layout count from `corner`.
namespace sandbox {

/// The room that labels and numbers need, at the present text size.
void set_margins(PlotRequest &request);

/// Axes, guides, front and series; the point of the tag `hovered` is larger.
void draw_plot(const PlotRequest &request, const PlotLayout &layout, ImVec2 corner, std::optional<std::size_t> hovered);

/// A ring with A's or B's letter around the point of a tag, if the plot has it.
void draw_ring(const PlotLayout &layout, ImVec2 corner, std::size_t tag, bool right);

/// Series differ by the marker's form as well as by its colour.
void draw_marker(ImDrawList &list, ImVec2 at, float radius, int style, ImU32 color);

} // namespace sandbox
