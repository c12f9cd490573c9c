#include "capture/plot_picture.h"

#include "capture/strokes.h"
#include "image/cut_paste.h"
#include "image/text.h"
#include "measure/report/paper.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace sandbox {
namespace {

constexpr double title_text = 13, guide_text = 10.5;
constexpr double baseline = 0.8; ///< of a line of text, from its top, as a share of its height
constexpr PaperColor white{255, 255, 255};

ByteImage white_picture(Size size) {
    ByteImage picture = black_picture(size);
    std::ranges::fill(picture.rgb, std::uint8_t{255});
    return picture;
}

/// A quarter turn to the left.
ByteImage turned_left(const ByteImage &picture) {
    const auto width = static_cast<std::size_t>(picture.size.width),
               height = static_cast<std::size_t>(picture.size.height);
    ByteImage turned = black_picture({picture.size.height, picture.size.width});
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            std::copy_n(&picture.rgb[3 * (y * width + x)], 3, &turned.rgb[3 * ((width - 1 - x) * height + y)]);
        }
    }
    return turned;
}

/// Draws in the units of a request.
class Sheet {
  public:
    Sheet(double width, double height, double scale)
        : picture(white_picture({static_cast<int>(width * scale), static_cast<int>(height * scale)})), scale_(scale) {}

    void line(double x1, double y1, double x2, double y2, double width, PaperColor color, double opacity = 1) {
        draw_line(picture, at(x1, y1), at(x2, y2), width * scale_, color, opacity);
    }
    /// `anchor`: the share of the text that lies left of x.
    void text(double x, double y, double anchor, double height, PaperColor color, const std::string &words) {
        const double size = height * scale_;
        draw_text(picture, x * scale_ - anchor * text_width(words, size), y * scale_ - baseline * size, size, words,
                  color);
    }
    /// Upwards, around (x, y).
    void upright_text(double x, double y, double height, PaperColor color, const std::string &words) {
        const double size = height * scale_;
        const Size box{std::min(static_cast<int>(std::ceil(text_width(words, size))) + 2, picture.size.height),
                       static_cast<int>(std::ceil(1.2 * size))};
        ByteImage line = white_picture(box);
        draw_text(line, 1, 0, size, words, color);
        const int top = static_cast<int>(y * scale_) - box.width / 2;
        paste(picture, turned_left(line), std::max(0, static_cast<int>(x * scale_ - baseline * size)),
              std::clamp(top, 0, picture.size.height - box.width));
    }
    void marker(double x, double y, double radius, int style, PaperColor color) {
        std::vector<glm::dvec2> corners;
        for (const auto &[dx, dy] : marker_corners(style)) {
            corners.push_back(at(x + radius * dx, y + radius * dy));
        }
        if (corners.empty()) {
            draw_disc(picture, at(x, y), radius * scale_, color);
        } else {
            draw_polygon(picture, corners, color);
        }
    }
    void path(const std::vector<PlotPoint> &points, double width, PaperColor color) {
        for (std::size_t i = 1; i < points.size(); ++i) {
            line(points[i - 1].x, points[i - 1].y, points[i].x, points[i].y, width, color);
        }
    }

    ByteImage picture;

  private:
    [[nodiscard]] glm::dvec2 at(double x, double y) const { return {x * scale_, y * scale_}; }
    double scale_;
};

void draw_axes(Sheet &sheet, const PlotRequest &request, const PlotLayout &l) {
    const PaperColor rule = paper_color("rule"), faint = paper_color("faint"), muted = paper_color("muted");
    for (const PlotTick &tick : l.x_ticks) {
        sheet.line(tick.at, l.top, tick.at, l.bottom, 1, tick.label.empty() ? faint : rule);
        sheet.text(tick.at, l.bottom + 16, 0.5, plot_text, muted, tick.label);
    }
    for (const PlotTick &tick : l.y_ticks) {
        sheet.line(l.left, tick.at, l.right, tick.at, 1, tick.label.empty() ? faint : rule);
        sheet.text(l.left - 7, tick.at + 4, 1, plot_text, muted, tick.label);
    }
    sheet.text(l.left, l.top - 12, 0, title_text, paper_color("ink"), request.title);
    sheet.text((l.left + l.right) / 2, l.bottom + 36, 0.5, plot_text, muted, request.x_label);
    sheet.upright_text(14, (l.top + l.bottom) / 2, plot_text, muted, request.y_label);
}

void draw_guides(Sheet &sheet, const PlotLayout &l) {
    for (const PlotGuide &guide : l.guides) {
        for (double x = l.left; x < l.right; x += 6) {
            sheet.line(x, guide.y, std::min(x + 2, l.right), guide.y, 1, paper_color("muted"));
        }
    }
}

/// Blended with white, so that the corners of the staircase do not add up.
PaperColor pale(PaperColor color) {
    std::ranges::transform(color, color.begin(), [](std::uint8_t c) {
        return static_cast<std::uint8_t>(std::lround(255 - 0.55 * (255 - c)));
    });
    return color;
}

void draw_series(Sheet &sheet, const PlotSeries &series) {
    const PaperColor color = series_paper_color(series.style);
    sheet.path(series.points, series.width, color);
    for (const PlotPoint &point : series.points) {
        if (point.x_high - point.x_low > 1) {
            sheet.line(point.x_low, point.y, point.x_high, point.y, 1, color, 0.55);
        }
        if (!series.curve) {
            sheet.marker(point.x, point.y, 4.3, series.style, white);
            sheet.marker(point.x, point.y, 3.6, series.style, color);
        }
    }
}

void draw_legend(Sheet &sheet, const PlotRequest &request, const PlotLayout &layout) {
    for (const LegendEntry &entry : lay_out_legend(request, layout, legend_top(layout))) {
        const double middle = entry.x + legend_line / 2, end = entry.x + legend_line;
        if (entry.style) {
            draw_series(sheet, {{}, *entry.style, {{entry.x, entry.y}, {end, entry.y}}, true, entry.width});
            if (!entry.curve) {
                draw_series(sheet, {{}, *entry.style, {{middle, entry.y}}});
            }
        } else {
            sheet.path({{entry.x, entry.y - 3}, {middle, entry.y - 3}, {middle, entry.y + 3}, {end, entry.y + 3}}, 6,
                       pale(series_paper_color({})));
        }
        sheet.text(end + 8, entry.y + 4, 0, plot_text, paper_color("ink"), entry.name);
    }
}

} // namespace

ByteImage plot_picture(const PlotRequest &asked, int scale) {
    const PlotRequest request = with_legend(asked);
    const PlotLayout layout = lay_out(request);
    Sheet sheet(request.width, request.height, scale);
    draw_axes(sheet, request, layout);
    draw_guides(sheet, layout);
    sheet.path(layout.front, 6, pale(series_paper_color({})));
    for (const PlotSeries &series : layout.series) {
        draw_series(sheet, series);
    }
    for (const PlotGuide &guide : layout.guides) {
        sheet.text(layout.left + 5, guide.y - 4, 0, guide_text, paper_color("muted"), guide.label);
    }
    draw_legend(sheet, request, layout);
    return sheet.picture;
}

} // namespace sandbox
