#include "measure/report/svg.h"

#include "measure/report/text.h"

#include <cstdio>

namespace sandbox {
namespace {

/// One decimal of a pixel is enough.
std::string at(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

std::string attribute(const char *name, const std::string &value) {
    return " " + std::string(name) + "=\"" + value + "\"";
}

std::string line(double x1, double y1, double x2, double y2, const std::string &style) {
    return "<line" + attribute("x1", at(x1)) + attribute("y1", at(y1)) + attribute("x2", at(x2)) +
           attribute("y2", at(y2)) + attribute("class", style) + "/>";
}

std::string words(double x, double y, const std::string &style, const std::string &text, const std::string &more = {}) {
    return "<text" + attribute("x", at(x)) + attribute("y", at(y)) + attribute("class", style) + more + ">" +
           escaped(text) + "</text>";
}

std::string polygon(double x, double y, const std::vector<std::pair<double, double>> &corners) {
    std::string points;
    for (const auto &[dx, dy] : corners) {
        points += at(x + dx) + "," + at(y + dy) + " ";
    }
    return "<polygon points=\"" + points + "\"";
}

/// Told apart by form as well as by colour; the caller closes the element.
std::string marker(double x, double y, int style) {
    constexpr double r = 3.6;
    switch (style % 5) {
    case 0:
        return "<circle" + attribute("cx", at(x)) + attribute("cy", at(y)) + attribute("r", at(r));
    case 1:
        return polygon(x, y, {{-r, -r}, {r, -r}, {r, r}, {-r, r}});
    case 2:
        return polygon(x, y, {{0, -1.4 * r}, {1.4 * r, 0}, {0, 1.4 * r}, {-1.4 * r, 0}});
    case 3:
        return polygon(x, y, {{0, -1.3 * r}, {1.25 * r, r}, {-1.25 * r, r}});
    default:
        return polygon(x, y, {{0, 1.3 * r}, {1.25 * r, -r}, {-1.25 * r, -r}});
    }
}

std::string path_of(const std::vector<PlacedPoint> &points) {
    std::string path;
    for (const PlacedPoint &point : points) {
        path += (path.empty() ? "M" : "L") + at(point.x) + " " + at(point.y);
    }
    return path;
}

std::string axes(const PlotRequest &request, const PlotLayout &layout) {
    std::string svg;
    for (const PlotTick &tick : layout.x_ticks) {
        svg += line(tick.at, layout.top, tick.at, layout.bottom, tick.label.empty() ? "minor" : "grid");
        svg += tick.label.empty() ? "" : words(tick.at, layout.bottom + 16, "tick mid", tick.label);
    }
    for (const PlotTick &tick : layout.y_ticks) {
        svg += line(layout.left, tick.at, layout.right, tick.at, tick.label.empty() ? "minor" : "grid");
        svg += tick.label.empty() ? "" : words(layout.left - 7, tick.at + 4, "tick end", tick.label);
    }
    const double middle = (layout.top + layout.bottom) / 2;
    svg += words(layout.left, layout.top - 12, "title", request.title);
    svg += words((layout.left + layout.right) / 2, layout.bottom + 36, "label mid", request.x_label);
    svg += words(14, middle, "label mid", request.y_label, " transform=\"rotate(-90 14 " + at(middle) + ")\"");
    return svg;
}

std::string guide_lines(const PlotLayout &layout) {
    std::string svg;
    for (const PlacedGuide &guide : layout.guides) {
        svg += line(layout.left, guide.at, layout.right, guide.at, "guide");
    }
    return svg;
}

/// Over everything else, to be readable.
std::string guide_labels(const PlotLayout &layout) {
    std::string svg;
    for (const PlacedGuide &guide : layout.guides) {
        svg += words(layout.left + 5, guide.at - 4, "guide-label", guide.label);
    }
    return svg;
}

std::string series_svg(const PlacedSeries &series, const std::function<std::string(std::size_t)> &tip) {
    std::string svg = "<g" + attribute("class", "s" + std::to_string(series.style)) + "><path class=\"line\" d=\"" +
                      path_of(series.points) + "\"/>";
    for (const PlacedPoint &point : series.points) {
        if (point.x_high - point.x_low > 1) {
            svg += line(point.x_low, point.y, point.x_high, point.y, "spread");
        }
        svg += marker(point.x, point.y, series.style) + " class=\"dot\"><title>" + escaped(tip(point.tag)) +
               "</title></" + (series.style % 5 == 0 ? "circle>" : "polygon>");
    }
    return svg + "</g>";
}

std::string open_svg(double width, double height, const std::string &name) {
    return "<svg viewBox=\"0 0 " + at(width) + " " + at(height) + "\" role=\"img\" aria-label=\"" + escaped(name) +
           "\" xmlns=\"http://www.w3.org/2000/svg\">";
}

} // namespace

std::string plot_svg(const PlotRequest &request, const std::function<std::string(std::size_t)> &tip) {
    const PlotLayout layout = lay_out(request);
    std::string svg =
        open_svg(request.width, request.height, request.title) + axes(request, layout) + guide_lines(layout);
    if (!layout.front.empty()) {
        svg += "<path class=\"front\" d=\"" + path_of(layout.front) + "\"/>";
    }
    for (const PlacedSeries &series : layout.series) {
        svg += series_svg(series, tip);
    }
    return svg + guide_labels(layout) + "</svg>\n";
}

std::string legend_html(const std::vector<std::string> &names, bool with_front) {
    std::string html = "<p class=\"legend\">";
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int style = static_cast<int>(i);
        html += "<span><svg viewBox=\"0 0 30 12\" class=\"s" + std::to_string(i) +
                "\" aria-hidden=\"true\"><path class=\"line\" d=\"M0 6L30 6\"/>" + marker(15, 6, style) +
                " class=\"dot\"/></svg>" + escaped(names[i]) + "</span>";
    }
    if (with_front) {
        html += "<span><svg viewBox=\"0 0 30 12\" aria-hidden=\"true\"><path class=\"front\" d=\"M0 3L15 3L15 10L30 "
                "10\"/></svg>no other is both faster and closer</span>";
    }
    return html + "</p>\n";
}

std::string bars_svg(const std::vector<LabelledBar> &bars, double width, const std::string &title) {
    constexpr double left = 250, right = 190, step = 17, thickness = 12, gap = 9;
    std::string svg;
    double y = 4;
    for (const LabelledBar &bar : bars) {
        y += bar.gap_above ? gap : 0;
        svg += "<g><title>" + escaped(bar.tip) + "</title>" + words(left - 10, y + 10, "tick end", bar.label);
        for (const BarPiece &piece : lay_out_shares({bar.bar}, left, y, width - left - right, step, thickness)) {
            svg += "<rect" + attribute("x", at(piece.x)) + attribute("y", at(piece.y)) +
                   attribute("width", at(piece.width)) + attribute("height", at(piece.height)) +
                   attribute("class", "p" + std::to_string(piece.part)) + "/>";
        }
        svg += words(width - right + 10, y + 10, "tick", bar.value) + "</g>";
        y += step;
    }
    return open_svg(width, y + 2, title) + svg + "</svg>\n";
}

} // namespace sandbox
