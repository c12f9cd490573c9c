#include "ui/tabs/plot_drawing.h"

#include "ui/widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

namespace {

ImU32 faded(ImVec4 color, float alpha) {
    color.w *= alpha;
    return ImGui::GetColorU32(color);
}
ImU32 grid_color(bool labelled) { return faded(ImGui::GetStyleColorVec4(ImGuiCol_Border), labelled ? 0.45F : 0.18F); }

class Canvas {
  public:
    Canvas(const PlotLayout &layout, ImVec2 corner) : layout_(layout), corner_(corner) {}

    [[nodiscard]] ImVec2 at(double x, double y) const {
        return {corner_.x + static_cast<float>(x), corner_.y + static_cast<float>(y)};
    }
    void line(double x1, double y1, double x2, double y2, ImU32 color, float width = 1) const {
        list_.AddLine(at(x1, y1), at(x2, y2), color, width);
    }
    /// `anchor`: the share of the text that lies left of x.
    void text(double x, double y, float anchor, ImVec4 color, const std::string &words) const {
        const float width = ImGui::CalcTextSize(words.c_str()).x;
        const ImVec2 position = at(x, y);
        list_.AddText({std::floor(position.x - width * anchor), std::floor(position.y)}, ImGui::GetColorU32(color),
                      words.c_str());
    }
    [[nodiscard]] const PlotLayout &layout() const { return layout_; }
    [[nodiscard]] ImDrawList &list() const { return list_; }

  private:
    const PlotLayout &layout_;
    ImVec2 corner_;
    ImDrawList &list_ = *ImGui::GetWindowDrawList();
};

/// The spans of an axis that have a label.
class LabelledSpans {
  public:
    /// `gap`: the least distance between two labels.
    explicit LabelledSpans(double gap) : gap_(gap) {}
    /// False if the span is not free.
    bool claim(double low, double high) {
        const bool free = std::ranges::none_of(
            spans_, [&](const auto &span) { return low < span.second + gap_ && high > span.first - gap_; });
        if (free) {
            spans_.emplace_back(low, high);
        }
        return free;
    }

  private:
    double gap_;
    std::vector<std::pair<double, double>> spans_;
};

bool is_decade(const std::string &label) {
    const auto digit = label.find_first_of("123456789");
    return digit != std::string::npos && label[digit] == '1';
}

/// The ticks with labels, whole decades first: those are kept where there is no room for all.
std::vector<PlotTick> labelled(const std::vector<PlotTick> &ticks) {
    std::vector<PlotTick> kept;
    std::ranges::copy_if(ticks, std::back_inserter(kept), [](const PlotTick &tick) { return !tick.label.empty(); });
    // not std::ranges::stable_partition: Clang 14 cannot compile the subrange it returns
    std::stable_partition(kept.begin(), kept.end(), [](const PlotTick &tick) { return is_decade(tick.label); });
    return kept;
}

void draw_axes(const Canvas &canvas, const PlotRequest &request) {
    const PlotLayout &l = canvas.layout();
    const double half = ImGui::GetFontSize() / 2.0;
    for (const PlotTick &tick : l.x_ticks) {
        canvas.line(tick.at, l.top, tick.at, l.bottom, grid_color(!tick.label.empty()));
    }
    for (const PlotTick &tick : l.y_ticks) {
        canvas.line(l.left, tick.at, l.right, tick.at, grid_color(!tick.label.empty()));
    }
    LabelledSpans columns(half), lines(0);
    for (const PlotTick &tick : labelled(l.x_ticks)) {
        const double width = static_cast<double>(ImGui::CalcTextSize(tick.label.c_str()).x);
        if (columns.claim(tick.at - width / 2, tick.at + width / 2)) {
            canvas.text(tick.at, l.bottom + 2, 0.5F, quiet_text(), tick.label);
        }
    }
    for (const PlotTick &tick : labelled(l.y_ticks)) {
        if (lines.claim(tick.at - half, tick.at + half)) {
            canvas.text(l.left - half / 2, tick.at - half, 1, quiet_text(), tick.label);
        }
    }
    const ImVec4 ink = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    canvas.text(0, 0, 0, ink, request.y_label);
    canvas.text(l.right, l.bottom + 2 * half + 2, 1, ink, request.x_label);
}

void draw_guides(const Canvas &canvas) {
    const PlotLayout &l = canvas.layout();
    for (const PlotGuide &guide : l.guides) {
        const double step = 6;
        for (double x = l.left; x < l.right; x += step) {
            canvas.line(x, guide.y, std::min(x + step / 2, l.right), guide.y, ImGui::GetColorU32(quiet_text()));
        }
    }
}

/// On the left, where few points are; two that are too close stand beside each other.
void draw_guide_labels(const Canvas &canvas) {
    const PlotLayout &l = canvas.layout();
    std::vector<PlotGuide> guides = l.guides;
    std::ranges::sort(guides, {}, &PlotGuide::y);
    const double height = ImGui::GetFontSize();
    double below = 0, right = 0; // of the label before
    for (const PlotGuide &guide : guides) {
        const ImVec2 size = ImGui::CalcTextSize(guide.label.c_str());
        const double top = guide.y - height / 2;
        const double x = (top < below ? right : l.left) + height * 0.4;
        const ImVec2 low = canvas.at(x, top);
        canvas.list().AddRectFilled({low.x - 2, low.y}, {low.x + size.x + 2, low.y + size.y},
                                    faded(ImGui::GetStyleColorVec4(ImGuiCol_WindowBg), 0.85F));
        canvas.text(x, top, 0, quiet_text(), guide.label);
        below = top + height;
        right = x + static_cast<double>(size.x);
    }
}

void draw_path(const Canvas &canvas, const std::vector<PlotPoint> &points, ImU32 color, float width) {
    std::vector<ImVec2> path;
    path.reserve(points.size());
    for (const PlotPoint &point : points) {
        path.push_back(canvas.at(point.x, point.y));
    }
    canvas.list().AddPolyline(path.data(), static_cast<int>(path.size()), color, ImDrawFlags_None, width);
}

void draw_series(const Canvas &canvas, const PlotSeries &series, std::optional<std::size_t> hovered) {
    const float em = ImGui::GetFontSize();
    const ImVec4 color = series_color(series.style);
    draw_path(canvas, series.points, ImGui::GetColorU32(color), em * 0.12F);
    for (const PlotPoint &point : series.points) {
        if (point.x_high - point.x_low > 1) {
            canvas.line(point.x_low, point.y, point.x_high, point.y, faded(color, 0.6F), em * 0.08F);
        }
        const float radius = em * (hovered == point.tag ? 0.42F : 0.27F);
        draw_marker(canvas.list(), canvas.at(point.x, point.y), radius * 1.35F, series.style,
                    ImGui::GetColorU32(ImGuiCol_WindowBg));
        draw_marker(canvas.list(), canvas.at(point.x, point.y), radius, series.style, ImGui::GetColorU32(color));
    }
}

} // namespace

void set_margins(PlotRequest &request) {
    const double em = ImGui::GetFontSize();
    request.left = 3.4 * em;
    request.right = 0.5 * em;
    request.top = 1.5 * em;
    request.bottom = 2.3 * em;
}

void draw_marker(ImDrawList &list, ImVec2 at, float radius, int style, ImU32 color) {
    const auto corners = marker_corners(style);
    if (corners.empty()) {
        list.AddCircleFilled(at, radius, color);
        return;
    }
    for (const auto &[x, y] : corners) {
        list.PathLineTo({at.x + radius * static_cast<float>(x), at.y + radius * static_cast<float>(y)});
    }
    list.PathFillConvex(color);
}

void draw_plot(const PlotRequest &request, const PlotLayout &layout, ImVec2 corner,
               std::optional<std::size_t> hovered) {
    const Canvas canvas(layout, corner);
    draw_axes(canvas, request);
    draw_guides(canvas);
    draw_guide_labels(canvas);
    draw_path(canvas, layout.front, ImGui::GetColorU32(front_color()), ImGui::GetFontSize() * 0.4F);
    for (const PlotSeries &series : layout.series) {
        draw_series(canvas, series, hovered);
    }
}

void draw_ring(const PlotLayout &layout, ImVec2 corner, std::size_t tag, bool right, const std::string &name) {
    const Canvas canvas(layout, corner);
    const float em = ImGui::GetFontSize();
    for (const PlotSeries &series : layout.series) {
        const auto point = std::ranges::find(series.points, tag, &PlotPoint::tag);
        if (point != series.points.end()) {
            const ImVec2 at = canvas.at(point->x, point->y);
            canvas.list().AddCircle(at, em * 0.62F, ImGui::GetColorU32(side_color(right)), 0, em * 0.14F);
            const double side = right ? 1 : -1; // both may be at one point
            const double width = static_cast<double>(ImGui::CalcTextSize(name.c_str()).x);
            const double beside = point->x + side * static_cast<double>(em) * 0.75 - (right ? 0 : width);
            canvas.text(std::clamp(beside, 0.0, std::max(layout.right - width, 0.0)),
                        point->y - static_cast<double>(em) * 1.1, 0, side_color(right), name);
        }
    }
}

} // namespace sandbox
