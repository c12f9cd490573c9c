#include "measure/report/plot_layout.h"

#include "image/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sandbox {
namespace {

/// Maps a span of numbers to a span of positions.
class Axis {
  public:
    Axis(Scale scale, double first, double last) : scale_(scale), first_(first), last_(last) {}

    [[nodiscard]] bool takes(double value) const {
        return std::isfinite(value) && (scale_ == Scale::linear || value > 0);
    }
    void include(double value) {
        if (takes(value)) {
            low_ = std::min(low_, inner(value));
            high_ = std::max(high_, inner(value));
        }
    }
    /// Adds room around the outermost values; a single value gets a span, too.
    void pad(double share) {
        if (low_ > high_) {
            low_ = 0;
            high_ = 1;
        }
        const double room = std::max(share * (high_ - low_), scale_ == Scale::logarithmic ? 0.05 : 1e-9);
        low_ -= room;
        high_ += room;
    }
    [[nodiscard]] bool holds(double value) const {
        return takes(value) && inner(value) >= low_ && inner(value) <= high_;
    }
    [[nodiscard]] double position(double value) const {
        return first_ + (last_ - first_) * (inner(value) - low_) / (high_ - low_);
    }
    [[nodiscard]] std::vector<PlotTick> ticks() const {
        return scale_ == Scale::logarithmic ? decade_ticks() : even_ticks();
    }

    [[nodiscard]] std::vector<PlotTick> ticks_at(const std::vector<double> &values) const {
        std::vector<PlotTick> out;
        for (const double value : values) {
            if (holds(value)) {
                out.push_back({position(value), label(value)});
            }
        }
        return out;
    }

  private:
    [[nodiscard]] double inner(double value) const { return scale_ == Scale::logarithmic ? std::log10(value) : value; }
    static std::string label(double value) {
        if (value == 0) {
            return "0"; // 0 has no power of ten, and must not read -0
        }
        const int power = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
        return power < -3 ? fmt::format("{:g}e{}", std::round(value / std::pow(10.0, power)), power)
                          : fmt::format("{:g}", value);
    }
    /// Labels 1, 10, 100; over short spans also 2 and 5, over very short ones every digit.
    [[nodiscard]] std::vector<PlotTick> decade_ticks() const {
        const double span = high_ - low_;
        std::vector<PlotTick> out;
        for (int decade = static_cast<int>(std::floor(low_)); decade <= static_cast<int>(std::ceil(high_)); ++decade) {
            for (int digit = 1; digit < 10; ++digit) {
                const double value = digit * std::pow(10.0, decade);
                if (holds(value)) {
                    const bool labelled = digit == 1 || span < 0.6 || (span < 2 && (digit == 2 || digit == 5));
                    out.push_back({position(value), labelled ? label(value) : std::string()});
                }
            }
        }
        return out;
    }
    /// Steps of 1, 2 or 5 times a power of ten, about five of them.
    [[nodiscard]] std::vector<PlotTick> even_ticks() const {
        const double rough = (high_ - low_) / 5;
        const double power = std::pow(10.0, std::floor(std::log10(rough)));
        const double digit = rough / power;
        const double step = power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
        std::vector<PlotTick> out;
        for (double i = std::ceil(low_ / step); i * step <= high_; ++i) {
            out.push_back({position(i * step), label(i * step)});
        }
        return out;
    }

    Scale scale_;
    double first_, last_;
    double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

/// The points go down and to the right; between two of them nothing is faster and closer.
std::vector<PlotPoint> staircase(const std::vector<PlotSeries> &series, const std::vector<std::size_t> &tags) {
    std::vector<PlotPoint> corners;
    for (const std::size_t tag : tags) {
        for (const PlotSeries &drawn : series) {
            const auto point = std::ranges::find(drawn.points, tag, &PlotPoint::tag);
            if (point == drawn.points.end()) {
                continue;
            }
            if (!corners.empty()) {
                corners.push_back({point->x, corners.back().y, 0, 0, tag});
            }
            corners.push_back(*point);
            break;
        }
    }
    return corners;
}

constexpr double legend_gap = 8;
/// Of a plot's text, in whatever font a viewer has: a little more than this program's own needs.
double legend_name_width(const std::string &name) { return 1.1 * text_width(name, plot_text); }

} // namespace

PlotLayout lay_out(const PlotRequest &request) {
    PlotLayout layout{
        request.left, request.top, request.width - request.right, request.height - request.bottom, {}, {}, {}, {}, {}};
    Axis x(request.x_scale, layout.left, layout.right);
    Axis y(request.y_scale, layout.bottom, layout.top);
    for (const PlotSeries &series : request.series) {
        for (const PlotPoint &point : series.points) {
            x.include(point.x);
            y.include(point.y);
        }
    }
    for (const double value : request.y_shown) {
        y.include(value);
    }
    x.pad(request.x_room);
    y.pad(request.y_room);
    for (const PlotSeries &series : request.series) {
        PlotSeries placed{series.name, series.style, {}, series.curve, series.width};
        for (const PlotPoint &p : series.points) {
            if (x.takes(p.x) && y.takes(p.y)) {
                const bool spread = p.x_low < p.x_high && x.takes(p.x_low);
                const auto within = [&](double value) {
                    return std::clamp(x.position(value), layout.left, layout.right);
                };
                placed.points.push_back({x.position(p.x), y.position(p.y), within(spread ? p.x_low : p.x),
                                         within(spread ? p.x_high : p.x), p.tag});
            }
        }
        layout.series.push_back(std::move(placed));
    }
    for (const PlotGuide &guide : request.guides) {
        if (y.holds(guide.y)) {
            layout.guides.push_back({y.position(guide.y), guide.label});
        }
    }
    layout.x_ticks = request.x_marks.empty() ? x.ticks() : x.ticks_at(request.x_marks);
    layout.y_ticks = y.ticks();
    layout.front = staircase(layout.series, request.front);
    return layout;
}

std::vector<LegendEntry> lay_out_legend(const PlotRequest &request, const PlotLayout &layout, double top) {
    std::vector<LegendEntry> entries;
    double x = layout.left, y = top;
    const auto add = [&](const PlotSeries *of, const std::string &name) {
        const double width = legend_line + legend_gap + legend_name_width(name);
        if (x > layout.left && x + width > layout.right) {
            x = layout.left;
            y += legend_row;
        }
        entries.push_back(of != nullptr ? LegendEntry{of->style, of->curve, of->width, name, x, y}
                                        : LegendEntry{std::nullopt, true, 0, name, x, y});
        x += width + 2 * legend_gap;
    };
    for (const PlotSeries &series : layout.series) {
        if (!series.points.empty()) {
            add(&series, series.name);
        }
    }
    if (!layout.front.empty() && !request.front_name.empty()) {
        add(nullptr, request.front_name);
    }
    return entries;
}

double legend_top(const PlotLayout &layout) { return layout.bottom + 58; }

PlotRequest with_legend(PlotRequest request) {
    const PlotLayout layout = lay_out(request);
    const std::vector<LegendEntry> entries = lay_out_legend(request, layout, legend_top(layout));
    const double below = entries.empty() ? 0 : entries.back().y + legend_row - request.height;
    request.height += below;
    request.bottom += below;
    return request;
}

std::optional<std::size_t> nearest_point(const PlotLayout &layout, double x, double y, double reach) {
    std::optional<std::size_t> best;
    for (const PlotSeries &series : layout.series) {
        for (const PlotPoint &point : series.points) {
            const double distance = std::hypot(point.x - x, point.y - y);
            if (distance <= reach) {
                reach = distance;
                best = point.tag;
            }
        }
    }
    return best;
}

std::span<const std::pair<double, double>> marker_corners(int style) {
    using Corners = std::vector<std::pair<double, double>>;
    static const std::array<Corners, 6> markers{Corners{},
                                                {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
                                                {{0, -1.4}, {1.4, 0}, {0, 1.4}, {-1.4, 0}},
                                                {{0, -1.3}, {1.25, 1}, {-1.25, 1}},
                                                {{0, 1.3}, {-1.25, -1}, {1.25, -1}},
                                                {{-1.5, -0.6}, {1.5, -0.6}, {1.5, 0.6}, {-1.5, 0.6}}};
    return markers[static_cast<std::size_t>(style) % markers.size()];
}

std::vector<BarPiece> lay_out_shares(const std::vector<Bar> &bars, double left, double top, double width, double step,
                                     double thickness) {
    std::vector<BarPiece> pieces;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        double sum = 0;
        for (const double part : bars[i].parts) {
            sum += part;
        }
        double x = left;
        for (std::size_t part = 0; part < bars[i].parts.size() && sum > 0 && std::isfinite(sum); ++part) {
            const double share = bars[i].parts[part] / sum * width;
            if (share > 0) {
                pieces.push_back({i, part, x, top + static_cast<double>(i) * step, share, thickness});
                x += share;
            }
        }
    }
    return pieces;
}

} // namespace sandbox
