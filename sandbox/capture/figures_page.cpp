#include "capture/figures_page.h"

#include "words/row_words.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace sandbox {
namespace {

/// Names of scenes and objects may hold what Markdown reads as its own.
std::string plain(std::string_view text) {
    std::string out;
    for (const char c : text) {
        out += std::string_view("\\`*_[]<>#|").find(c) != std::string_view::npos ? fmt::format("\\{}", c)
                                                                                 : std::string(1, c);
    }
    return out;
}

std::string code(std::string_view lines) { return fmt::format("```sh\n{}\n```\n", lines); }

bool has(const Figure &figure, const std::string &name) {
    return std::ranges::find(figure.files, name, &FigureFile::name) != figure.files.end();
}

/// An SVG stands for its PNG, too.
bool is_shown(const Figure &figure, const std::filesystem::path &file) {
    const std::string svg = file.stem().string() + ".svg";
    return file.extension() == ".svg" || (file.extension() == ".png" && !has(figure, svg));
}

std::string section_of(const Words &words, std::size_t number, const Figure &figure) {
    const std::string name = words.format("figures.number", number);
    std::string text, files;
    for (const FigureFile &file : figure.files) {
        text += is_shown(figure, file.name) ? fmt::format("![{}]({})\n\n", name, file.name) : "";
        files += fmt::format("{}[{}]({})", files.empty() ? "" : words.text("list.comma"), file.name, file.name);
    }
    const std::string caption = figure.caption.substr(0, figure.caption.find_last_not_of(' ') + 1);
    text += fmt::format("**{}** {}{}\n\n", name, figure.title, caption);
    text += figure.table + (figure.table.empty() ? "" : "\n");
    text += words.format("figures.files", files) + "\n\n";
    return text + (figure.commands.empty() ? "" : code(fmt::format("{}", fmt::join(figure.commands, "\n"))) + "\n");
}

} // namespace

std::string figures_page(const FigureRequest &request, const FigureDraw &draw, const std::vector<Figure> &figures) {
    const Words &words = request.words;
    const std::string title = request.scene.name.empty() ? request.name : file_text(words, request.scene.name);
    const std::string about = file_text(words, request.scene.description);
    std::string page = fmt::format("# {}\n\n", words.format("figures.page", plain(title)));
    page += about.empty() ? "" : plain(about) + "\n\n";
    page += words.format("figures.about", SANDBOX_VERSION, draw.by.renderer) + words.text("figures.errors") + "\n\n" +
            words.text("figures.again") + "\n\n";
    page += code(fmt::format("shading-sandbox figures {}{} --out {}", request.scene_arguments, request.common_arguments,
                             request.folder)) +
            "\n";
    for (std::size_t i = 0; i < figures.size(); ++i) {
        page += section_of(words, i + 1, figures[i]);
    }
    page.pop_back();
    return page;
}

} // namespace sandbox
