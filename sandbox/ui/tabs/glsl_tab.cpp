#include "ui/tabs/bottom_tabs.h"

#include "shading/prepared_object.h"
#include "shading/program_source.h"
#include "ui/tabs/line_diff.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "words/row_words.h"

#include <algorithm>
#include <array>
#include <exception>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <vector>

namespace sandbox {

namespace {

struct Listing {
    std::array<std::string, 2> text; ///< vertex, fragment
    std::array<std::vector<std::string>, 2> lines;
    std::array<std::vector<std::string>, 2> origins; ///< "light_point.glsl:12"
};

std::vector<std::string> origin_names(const StageSource &stage) {
    std::vector<std::string> names;
    for (const LineOrigin &origin : stage.origins) {
        names.push_back(fmt::format("{}:{}", origin.part, origin.line));
    }
    return names;
}

Listing list_program(const Session &session, ViewPainter &painter, bool right) {
    const Scene scene = with_mesh_factor(session.document.scene, session.document.mesh_factors[right ? 1 : 0]);
    const auto resources = painter.renderer().resources().load(scene);
    const auto objects = prepare_objects(scene, session.technique(right), resources);
    const ProgramSource source = assemble(objects[session.object].program, painter.renderer().parts());
    return {{source.vertex.text, source.fragment.text},
            {split_lines(source.vertex.text), split_lines(source.fragment.text)},
            {origin_names(source.vertex), origin_names(source.fragment)}};
}

void draw_line(Session &session, const Listing &own, const Listing &other, std::size_t stage, std::size_t line,
               bool missing, bool right) {
    const std::string &text = own.lines[stage][line];
    const bool moved = missing && holds_line(other.lines[1 - stage], text);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (missing && text.find_first_not_of(' ') != std::string::npos) {
        ImVec4 tint = side_color(right);
        tint.w = 0.18F;
        const ImVec2 end{at.x + ImGui::GetWindowWidth() + ImGui::GetScrollMaxX(), at.y + ImGui::GetTextLineHeight()};
        ImGui::GetWindowDrawList()->AddRectFilled(at, end, ImGui::GetColorU32(tint));
    }
    ImGui::TextColored(quiet_text(), "%3zu %s", line + 1, moved ? "\xE2\x86\x95" : missing ? "*" : " ");
    ImGui::SameLine();
    ImGui::TextUnformatted(text.c_str());
    if (line < own.origins[stage].size()) {
        const std::string where = own.origins[stage][line];
        describe_item(session, fmt::format("line {}", line + 1), moved ? session.text("glsl.moved.help", where) : where,
                      text);
    }
}

void draw_listing(Session &session, const Listing &own, const Listing &other, std::size_t stage, bool right) {
    const std::vector<bool> missing = lines_missing(own.lines[stage], other.lines[stage]);
    const float below = ImGui::GetStyle().CellPadding.y + 1;
    const ScopedName side(session, right ? "B" : "A");
    ImGui::BeginChild("listing", {0, -below}, true, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::PushFont(code_font());
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {4, 0});
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(own.lines[stage].size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto line = static_cast<std::size_t>(i);
            draw_line(session, own, other, stage, line, missing[line], right);
        }
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::EndChild();
}

std::size_t stage_choice(Session &session) {
    ImGuiStorage &state = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("stage");
    int stage = state.GetInt(id, 1);
    if (toggle_button(session, session.label("glsl.vertex"), stage == 0, session.text("glsl.vertex.help"))) {
        stage = 0;
    }
    ImGui::SameLine();
    if (toggle_button(session, session.label("glsl.fragment"), stage == 1, session.text("glsl.fragment.help"))) {
        stage = 1;
    }
    state.SetInt(id, stage);
    return static_cast<std::size_t>(stage);
}

void column_title(Session &session, const Listing &listing, std::size_t stage, bool right) {
    ImGui::TextColored(side_color(right), "%s",
                       session.text("glsl.lines", right ? "B" : "A", listing.lines[stage].size()).c_str());
    if (!right && session.document.left_is_textbook()) {
        describe_item(session, "textbook", session.text("glsl.textbook.help"));
        ImGui::SameLine();
        ImGui::TextColored(error_text(), "%s", session.text("glsl.textbook").c_str());
    }
    ImGui::SameLine();
    const ScopedName side(session, right ? "B" : "A");
    if (small_button(session, session.label("copy"), session.text("glsl.copy.help"))) {
        ImGui::SetClipboardText(listing.text[stage].c_str());
        session.message = {session.text("message.copied"), false};
    }
}

/// The programs of A and B for the shown object, beside each other. A line that the other side lacks has the side's
/// colour; a line that the other side has in its other stage ("moved") has an arrow.
class GlslTab final : public TabContent {
  public:
    void draw(Session &session, ViewPainter &painter) override;
};

} // namespace

std::unique_ptr<TabContent> glsl_tab(const DrawingSupplies &) { return std::make_unique<GlslTab>(); }

void GlslTab::draw(Session &session, ViewPainter &painter) {
    const auto &objects = session.document.scene.objects;
    if (objects.empty()) {
        ImGui::TextUnformatted(session.text("object.none").c_str());
        return;
    }
    try {
        const std::array<Listing, 2> listings{list_program(session, painter, false),
                                              list_program(session, painter, true)};
        const std::size_t stage = stage_choice(session);
        if (objects.size() > 1) {
            const std::string of =
                session.text("glsl.object", session.object + 1, file_text(session.words, objects[session.object].name));
            same_line_if_fits(ImGui::CalcTextSize(of.c_str()).x);
            ImGui::TextColored(quiet_text(), "%s", of.c_str());
        }
        if (ImGui::BeginTable("columns", 2, ImGuiTableFlags_SizingStretchSame)) {
            for (const bool right : {false, true}) {
                ImGui::TableNextColumn();
                column_title(session, listings[right ? 1 : 0], stage, right);
                draw_listing(session, listings[right ? 1 : 0], listings[right ? 0 : 1], stage, right);
            }
            ImGui::EndTable();
        }
    } catch (const std::exception &error) {
        ImGui::TextColored(error_text(), "%s", error.what());
    }
}

} // namespace sandbox
