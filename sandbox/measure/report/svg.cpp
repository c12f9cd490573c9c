#include "measure/report/svg.h"

#include "measure/report/html.h"
#include "measure/report/paper.h"

#include <fmt/format.h>

namespace sandbox {
namespace {

std::string line(double x1, double y1, double x2, double y2, std::string_view style) {
    return fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" class="{}"/>)", x1, y1, x2, y2, style);
}

std::string svg_text(double x, double y, std::string_view style, std::string_view text, std::string_view more = {}) {
    return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" class="{}"{}>{}</text>)", x, y, style, more, html::escaped(text));
}

/// A series' marker around (x, y); the tip, if there is one, shows when the mouse rests on it.
std::string marker(double x, double y, int style, std::string_view tip = {}) {
    constexpr double r = 3.6;
    const std::string title = tip.empty() ? "" : fmt::format("<title>{}</title>", html::escaped(tip));
    std::string corners;
    for (const auto &[dx, dy] : marker_corners(style)) {
        corners += fmt::format("{:.1f},{:.1f} ", x + r * dx, y + r * dy);
    }
    return corners.empty()
               ? fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" class="dot">{}</circle>)", x, y, r, title)
               : fmt::format(R"(<polygon points="{}" class="dot">{}</polygon>)", corners, title);
}

std::string path_of(const std::vector<PlotPoint> &points) {
    std::string path;
    for (const PlotPoint &point : points) {
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", point.x, point.y);
    }
    return path;
}

std::string axes(const PlotRequest &request, const PlotLayout &layout) {
    std::string svg;
    for (const PlotTick &tick : layout.x_ticks) {
        svg += line(tick.at, layout.top, tick.at, layout.bottom, tick.label.empty() ? "minor" : "grid");
        svg += tick.label.empty() ? "" : svg_text(tick.at, layout.bottom + 16, "tick mid", tick.label);
    }
    for (const PlotTick &tick : layout.y_ticks) {
        svg += line(layout.left, tick.at, layout.right, tick.at, tick.label.empty() ? "minor" : "grid");
        svg += tick.label.empty() ? "" : svg_text(layout.left - 7, tick.at + 4, "tick end", tick.label);
    }
    const double middle = (layout.top + layout.bottom) / 2;
    svg += svg_text(layout.left, layout.top - 12, "title", request.title);
    svg += svg_text((layout.left + layout.right) / 2, layout.bottom + 36, "label mid", request.x_label);
    svg += svg_text(14, middle, "label mid", request.y_label,
                    fmt::format(R"~( transform="rotate(-90 14 {:.1f})")~", middle));
    return svg;
}

std::string guide_lines(const PlotLayout &layout) {
    std::string svg;
    for (const PlotGuide &guide : layout.guides) {
        svg += line(layout.left, guide.y, layout.right, guide.y, "guide");
    }
    return svg;
}

/// Drawn last, over everything else, to stay readable.
std::string guide_labels(const PlotLayout &layout) {
    std::string svg;
    for (const PlotGuide &guide : layout.guides) {
        svg += svg_text(layout.left + 5, guide.y - 4, "guide-label", guide.label);
    }
    return svg;
}

/// The style has the usual width.
std::string line_path(const std::string &path, double width) {
    const std::string own = width == PlotSeries{}.width ? "" : fmt::format(R"( style="stroke-width: {:g}")", width);
    return fmt::format(R"(<path class="line"{} d="{}"/>)", own, path);
}

std::string series_svg(const PlotSeries &series, const std::function<std::string(std::size_t)> &tip) {
    std::string svg =
        fmt::format(R"(<g class="s{}">{})", series.style, line_path(path_of(series.points), series.width));
    for (const PlotPoint &point : series.points) {
        if (point.x_high - point.x_low > 1) {
            svg += line(point.x_low, point.y, point.x_high, point.y, "spread");
        }
        svg += series.curve ? "" : marker(point.x, point.y, series.style, tip ? tip(point.tag) : "");
    }
    return svg + "</g>";
}

std::string open_svg(double width, double height, const std::string &name) {
    return fmt::format("<svg viewBox=\"0 0 {:.1f} {:.1f}\" role=\"img\" aria-label=\"{}\" "
                       "xmlns=\"http://www.w3.org/2000/svg\">",
                       width, height, html::escaped(name));
}

std::string plot_parts(const PlotRequest &request, const PlotLayout &layout,
                       const std::function<std::string(std::size_t)> &tip) {
    std::string svg = axes(request, layout) + guide_lines(layout);
    if (!layout.front.empty()) {
        svg += fmt::format(R"(<path class="front" d="{}"/>)", path_of(layout.front));
    }
    for (const PlotSeries &series : layout.series) {
        svg += series_svg(series, tip);
    }
    return svg + guide_labels(layout);
}

std::string hex(const PaperColor &color) { return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]); }

/// The page's rules for plots with the light theme's colours filled in: not every program knows CSS variables.
std::string paper_style(const PlotLayout &layout) {
    const auto color = [](std::string_view name) { return hex(paper_color(name)); };
    std::string style = fmt::format(
        "text {{ font: {:.0f}px sans-serif; fill: {}; }}\n.title {{ font-weight: 600; font-size: 13px; }}\n"
        ".label, .tick, .guide-label {{ fill: {}; }}\n.guide-label {{ font-size: 10.5px; }}\n"
        ".mid {{ text-anchor: middle; }}\n.end {{ text-anchor: end; }}\n"
        ".grid {{ stroke: {}; }}\n.minor {{ stroke: {}; }}\n.guide {{ stroke: {}; stroke-dasharray: 2 4; }}\n"
        ".front {{ fill: none; stroke: {}; stroke-width: 6; stroke-opacity: 0.55; stroke-linejoin: round; }}\n"
        ".line {{ fill: none; stroke-width: 1.8; stroke-linejoin: round; }}\n"
        ".spread {{ stroke-width: 1; stroke-opacity: 0.55; }}\n.dot {{ stroke: #ffffff; stroke-width: 0.8; }}\n",
        plot_text, color("ink"), color("muted"), color("rule"), color("faint"), color("muted"), color("front"));
    for (const PlotSeries &series : layout.series) {
        const std::string own = hex(series_paper_color(series.style));
        style += fmt::format(".s{0} .line, .s{0} .spread {{ stroke: {1}; }} .s{0} .dot {{ fill: {1}; }}\n",
                             series.style, own);
    }
    return style;
}

std::string legend_svg(const PlotRequest &request, const PlotLayout &layout) {
    std::string svg;
    for (const LegendEntry &entry : lay_out_legend(request, layout, legend_top(layout))) {
        const std::string sample =
            entry.style ? line_path(fmt::format("M{:.1f} {:.1f}h{:.0f}", entry.x, entry.y, legend_line), entry.width)
                        : fmt::format(R"(<path class="front" d="M{:.1f} {:.1f}h{:.0f}v6h{:.0f}"/>)", entry.x,
                                      entry.y - 3, legend_line / 2, legend_line / 2);
        svg += fmt::format("<g class=\"s{}\">{}{}</g>{}\n", entry.style.value_or(0), sample,
                           entry.curve ? "" : marker(entry.x + legend_line / 2, entry.y, *entry.style),
                           svg_text(entry.x + legend_line + 8, entry.y + 4, "name", entry.name));
    }
    return svg;
}

} // namespace

std::string plot_svg(const PlotRequest &request, const std::function<std::string(std::size_t)> &tip) {
    const PlotLayout layout = lay_out(request);
    return open_svg(request.width, request.height, request.title) + plot_parts(request, layout, tip) + "</svg>\n";
}

std::string plot_file(const PlotRequest &asked) {
    const PlotRequest request = with_legend(asked);
    const PlotLayout layout = lay_out(request);
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                       "viewBox=\"0 0 {0:.0f} {1:.0f}\">\n<title>{2}</title>\n<style>\n{3}</style>\n"
                       "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{4}\n{5}</svg>\n",
                       request.width, request.height, html::escaped(request.title), paper_style(layout),
                       plot_parts(request, layout, {}), legend_svg(request, layout));
}

std::string legend_html(const Words &words, const std::vector<std::string> &names, bool with_front) {
    std::string legend;
    for (std::size_t i = 0; i < names.size(); ++i) {
        legend += fmt::format(R"(<span><svg viewBox="0 0 30 12" class="s{}" aria-hidden="true">)"
                              R"(<path class="line" d="M0 6L30 6"/>{}</svg>{}</span>)",
                              i, marker(15, 6, static_cast<int>(i)), html::escaped(names[i]));
    }
    if (with_front) {
        legend +=
            std::string(
                "<span><svg viewBox=\"0 0 30 12\" aria-hidden=\"true\"><path class=\"front\" d=\"M0 3L15 3L15 10L30 "
                "10\"/></svg>") +
            words.text("report.front") + "</span>";
    }
    return fmt::format("<p class=\"legend\">{}</p>\n", legend);
}

std::string bars_svg(const std::vector<LabelledBar> &bars, double width, const std::string &title) {
    constexpr double left = 250, right = 190, step = 17, thickness = 12, gap = 9;
    std::string svg;
    double y = 4;
    for (const LabelledBar &bar : bars) {
        y += bar.gap_above ? gap : 0;
        svg += fmt::format("<g><title>{}</title>{}", html::escaped(bar.tip),
                           svg_text(left - 10, y + 10, "tick end", bar.label));
        for (const BarPiece &piece : lay_out_shares({bar.bar}, left, y, width - left - right, step, thickness)) {
            svg += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" class="p{}"/>)", piece.x,
                               piece.y, piece.width, piece.height, piece.part);
        }
        svg += svg_text(width - right + 10, y + 10, "tick", bar.value) + "</g>";
        y += step;
    }
    return open_svg(width, y + 2, title) + svg + "</svg>\n";
}

} // namespace sandbox
