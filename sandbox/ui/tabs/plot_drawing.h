#pragma once

#include "measure/report/plot_layout.h"

#include <imgui.h>
#include <optional>
#include <string>

/// Draws plots that lay_out() has laid out, with ImGui's draw list. A layout's positions are relative to `corner`.
namespace sandbox {

/// Leaves room for labels and numbers at the present text size.
void set_margins(PlotRequest &request);

/// Axes, guides, front and series; the point of the tag `hovered` is larger.
void draw_plot(const PlotRequest &request, const PlotLayout &layout, ImVec2 corner, std::optional<std::size_t> hovered);

/// A ring with `name` in a side's colour around the point with this tag, if the plot has one.
void draw_ring(const PlotLayout &layout, ImVec2 corner, std::size_t tag, bool right, const std::string &name);

/// Each series has its own marker, so that colour is not all that tells them apart.
void draw_marker(ImDrawList &list, ImVec2 at, float radius, int style, ImU32 color);

} // namespace sandbox
