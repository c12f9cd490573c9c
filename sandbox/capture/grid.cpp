#include "capture/grid.h"

#include "capture/labels.h"
#include "capture/sidecar.h"
#include "capture/sidecar_json.h"
#include "capture/technique_json.h"
#include "image/cut_paste.h"
#include "image/error.h"
#include "image/picture_size.h"
#include "scene/scene_read.h"
#include "scene/scene_setting.h"
#include "words/row_words.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

constexpr std::string_view expected = "expected PATH=v1,v2,... such as objects[0].material.shininess=8,32,128";

/// The strip above the columns, then one for each row, all in the largest text in which every label is whole.
std::vector<Strips> strips_of(std::span<const std::string> rows, std::span<const std::string> columns, Size cell) {
    const int width = cell.width * static_cast<int>(columns.size());
    LabelTexts values{.labels = {columns.begin(), columns.end()}, .splits = {}};
    for (std::size_t i = 1; i < columns.size(); ++i) {
        values.splits.push_back(static_cast<int>(i) * cell.width);
    }
    std::vector<LabelTexts> texts{values};
    for (const std::string &row : rows) {
        texts.push_back({.labels = {row}, .splits = {}});
    }
    double text = 64;
    std::vector<Strips> strips;
    for (int pass = 0; pass < 2; ++pass) { // the second in the size that the first found
        strips.clear();
        for (const LabelTexts &of : texts) {
            strips.push_back(strips_for(width, of, text));
        }
        text = std::ranges::min(strips, {}, &Strips::text).text;
    }
    return strips;
}

std::filesystem::path folder_of(const Grid &grid) {
    return grid.folder.empty() ? std::filesystem::current_path() : grid.folder;
}

/// As a strip names a value: of a file without its folder, so that a moved grid has the same labels.
std::string label_of(const Grid &grid, const std::string &value) {
    return names_file(grid.sweep.path) ? std::filesystem::path(file_of_value(grid, value)).filename().string() : value;
}

} // namespace

std::string file_of_value(const Grid &grid, std::string_view value) {
    const bool quoted = value.size() > 1 && value.front() == '"' && value.back() == '"';
    return resolve_path(std::string(quoted ? value.substr(1, value.size() - 2) : value), folder_of(grid));
}

Sweep parse_sweep(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0) {
        throw InputError("{}, got '{}'", expected, text);
    }
    Sweep sweep{std::string(text.substr(0, equals)), {""}};
    int depth = 0;
    for (const char c : text.substr(equals + 1)) {
        depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        if (c == ',' && depth == 0) {
            sweep.values.emplace_back();
        } else {
            sweep.values.back() += c;
        }
    }
    if (depth != 0) {
        throw InputError("{}, got a bracket without its other half in '{}'", expected, text);
    }
    if (std::ranges::any_of(sweep.values, &std::string::empty)) {
        throw InputError("{}, got an empty value in '{}'", expected, text);
    }
    return sweep;
}

std::string grid_text(std::string_view cell, const Grid &grid, const std::filesystem::path &folder) {
    auto rows = nlohmann::ordered_json::array();
    for (const Technique &technique : grid.techniques) {
        rows.push_back(technique_json(technique, folder));
    }
    std::vector<std::string> values = grid.sweep.values;
    if (!folder.empty() && names_file(grid.sweep.path)) {
        std::ranges::transform(values, values.begin(),
                               [&](const std::string &value) { return path_from(file_of_value(grid, value), folder); });
    }
    const std::string sweep = fmt::format("{}={}", grid.sweep.path, fmt::join(values, ","));
    return with_keys(cell, nlohmann::ordered_json{{"rows", rows}, {"sweep", sweep}}.dump());
}

std::optional<Grid> grid_of(std::string_view text, std::string_view name, const std::filesystem::path &folder) {
    const auto json = sidecar_json(text, name);
    if (!json.contains("sweep")) {
        return std::nullopt;
    }
    try {
        Grid grid{{}, parse_sweep(json.at("sweep").get<std::string>()), folder};
        for (const auto &row : json.at("rows").get<std::vector<nlohmann::ordered_json>>()) {
            grid.techniques.push_back(technique_of(row, folder));
        }
        if (grid.techniques.empty()) {
            throw InputError("expected at least one technique");
        }
        return grid;
    } catch (const InputError &error) {
        throw InputError("{}: the grid's rows and sweep: {}", name, error.what());
    } catch (const nlohmann::json::exception &) {
        throw InputError("{}: expected both rows, a list of techniques, and sweep, a text", name);
    }
}

ByteImage grid_picture(std::span<const std::string> rows, std::span<const std::string> columns, Size cell,
                       const DrawCell &draw) {
    if (rows.empty() || columns.empty() || rows.size() * columns.size() > most_cells) {
        throw InputError("expected 1 to {} cells, got {} x {}", most_cells, rows.size(), columns.size());
    }
    const std::vector<Strips> strips = strips_of(rows, columns, cell);
    Size size{cell.width * static_cast<int>(columns.size()), 0};
    for (const Strips &strip : strips) {
        size.height += strip.above;
    }
    size.height += cell.height * static_cast<int>(rows.size());
    try {
        check_size(size);
    } catch (const InputError &) {
        throw InputError("the grid would have {}x{} pixels, too many: ask for smaller cells", size.width, size.height);
    }
    ByteImage picture = black_picture(size);
    const auto add_strip = [&](const Strips &strip, int top) {
        ByteImage part = black_picture({size.width, strip.above});
        draw_labels(part, strip);
        paste(picture, part, 0, top);
        return top + strip.above;
    };
    int top = add_strip(strips[0], 0);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        top = add_strip(strips[row + 1], top);
        for (std::size_t column = 0; column < columns.size(); ++column) {
            paste(picture, draw(row, column), static_cast<int>(column) * cell.width, top);
        }
        for (std::size_t column = 1; column < columns.size(); ++column) {
            draw_divider(picture, static_cast<int>(column) * cell.width, top, cell.height);
        }
        top += cell.height;
    }
    return picture;
}

Sweep sweep_of(const Motion &motion, const Scene &scene, int values) {
    const std::vector<SceneNumber> numbers = numbers_of(scene);
    const auto number = std::ranges::find(numbers, motion.path, &SceneNumber::path);
    if (motion.mover != Mover::number || number == numbers.end()) {
        throw InputError("a sweep is of a number of the scene, got '{}'", motion_words(motion));
    }
    Sweep sweep{motion.path, {}};
    for (int i = 0; i < values; ++i) {
        const double value = motion.from + (motion.to - motion.from) * i / std::max(values - 1, 1);
        std::string text = number->whole ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
        if (const double read = std::stod(text); nearest_accepted(read, number->range) != read) {
            text = fmt::format("{}", nearest_accepted(value, number->range)); // rounded out of its range
        }
        if (sweep.values.empty() || sweep.values.back() != text) {
            sweep.values.push_back(text);
        }
    }
    if (sweep.values.size() < 2) {
        throw InputError("a sweep needs two values that differ, got {} alone", sweep.values.front());
    }
    return sweep;
}

PictureOptions cell_options(PictureOptions options, const Technique &technique) {
    options.layout = Layout::single;
    options.flip = FlipSide::none;
    options.textbook_left = false;
    options.left = options.right = technique;
    options.labels = false;
    return options;
}

ByteImage draw_grid(const Scene &scene, const Grid &grid, const PictureOptions &options, const Painters &painters,
                    std::string_view name, const Progress &progress) {
    const Words words = words_of_labels(options.language);
    std::vector<Scene> scenes;
    std::vector<std::string> rows, columns;
    for (const std::string &value : grid.sweep.values) {
        const std::string setting = grid.sweep.path + "=" + value;
        scenes.push_back(with_settings(scene, {&setting, 1}, name, folder_of(grid)));
        columns.push_back(
            fmt::format("{} = {}", grid.sweep.path.substr(grid.sweep.path.rfind('.') + 1), label_of(grid, value)));
    }
    const auto factor = [&](std::size_t row) { return options.mesh_factors[row > 0 ? 1 : 0]; };
    for (std::size_t row = 0; row < grid.techniques.size(); ++row) {
        rows.push_back(title_of(words, grid.techniques[row]) + mesh_factor_note(words, factor(row)));
    }
    const double cells = static_cast<double>(rows.size() * columns.size());
    return grid_picture(rows, columns, options.size, [&](std::size_t row, std::size_t column) {
        PictureOptions cell = cell_options(options, grid.techniques[row]);
        cell.mesh_factors[0] = factor(row);
        ByteImage drawn = show_picture(scenes[column], cell, painters);
        if (progress && !progress(static_cast<double>(row * columns.size() + column + 1) / cells)) {
            throw Cancelled();
        }
        return drawn;
    });
}

} // namespace sandbox
