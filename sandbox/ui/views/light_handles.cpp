#include "ui/views/light_handles.h"

#include "capture/marks.h"
#include "ui/views/view_captions.h"
#include "ui/views/view_overlays.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <string>
#include <utility>
#include <vector>

namespace sandbox {

namespace {

constexpr ImU32 dark = IM_COL32(0, 0, 0, 200);
constexpr double handle_radius = 0.6; // text heights

double aspect_of(const Rect &picture) {
    return static_cast<double>(picture.width()) / static_cast<double>(picture.height());
}

Scene shown_scene(const Session &session, const Rect &picture) {
    return scene_in_view(shown_document(session),
                         {static_cast<int>(picture.width()), static_cast<int>(picture.height())});
}

std::vector<LightMark> marks_of(const Session &session, const Rect &picture) {
    return session.view.drawn_over.lights ? light_marks(shown_scene(session, picture), aspect_of(picture))
                                          : std::vector<LightMark>{};
}

void draw_cone(const LightGizmo &gizmo, const Rect &picture, ImU32 color) {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize();
    for (const std::vector<glm::dvec2> &line : gizmo.lines) {
        std::vector<ImVec2> points;
        for (const glm::dvec2 &place : line) {
            points.push_back(place_of(picture, place));
        }
        list.AddPolyline(points.data(), static_cast<int>(points.size()), dark, ImDrawFlags_None, em * 0.2F);
        list.AddPolyline(points.data(), static_cast<int>(points.size()), color, ImDrawFlags_None, em * 0.09F);
    }
}

void describe_handle(Session &session, const std::string &name, ImVec2 at) {
    const auto reach = static_cast<float>(handle_radius) * ImGui::GetFontSize();
    describe_text(session, name, {at.x - reach, at.y - reach}, {at.x + reach, at.y + reach}, name);
}

void draw_light(Session &session, const LightMark &light, const Rect &picture) {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const LightGizmo &gizmo = light.gizmo;
    const float em = ImGui::GetFontSize();
    const ImU32 color = IM_COL32(light.color[0], light.color[1], light.color[2], 255);
    const std::string name = fmt::format("light {}", gizmo.light + 1);
    draw_cone(gizmo, picture, color);
    if (gizmo.from && gizmo.to) {
        draw_arrow(place_of(picture, *gizmo.from), place_of(picture, *gizmo.to), color, "");
    }
    const ImVec2 lamp = place_of(picture, gizmo.lamp);
    constexpr auto radius = static_cast<float>(lamp_radius);
    list.AddCircleFilled(lamp, (radius + 0.12F) * em, dark);
    list.AddCircleFilled(lamp, radius * em, color);
    if (light.named) {
        const std::string shown_name = session.text("light.numbered", gizmo.light + 1);
        const ImVec2 beside{lamp.x + (radius + 0.6F) * em, lamp.y - 0.5F * em};
        const float right = beside.x + ImGui::CalcTextSize(shown_name.c_str()).x;
        list.AddRectFilled({beside.x - 0.4F * em, beside.y - 0.1F * em}, {right + 0.4F * em, beside.y + 1.1F * em},
                           IM_COL32(0, 0, 0, 153), 0.6F * em);
        list.AddText(beside, IM_COL32(255, 255, 255, 255), shown_name.c_str());
    }
    describe_handle(session, name, lamp);
    if (gizmo.turns && gizmo.to) {
        describe_handle(session, name + " tip", place_of(picture, *gizmo.to));
    }
}

/// The mouse's distance from a place, in text heights.
double distance_to_mouse(const Rect &picture, const glm::dvec2 &place) {
    const ImVec2 at = place_of(picture, place), mouse = ImGui::GetIO().MousePos;
    return static_cast<double>(std::hypot(at.x - mouse.x, at.y - mouse.y) / ImGui::GetFontSize());
}

} // namespace

void draw_lights(Session &session, const Rect &picture) {
    ImGui::GetWindowDrawList()->PushClipRect(picture.low, picture.high, true);
    const std::vector<LightMark> lights = marks_of(session, picture);
    for (const LightMark &light : lights) {
        draw_light(session, light, picture);
    }
    if (session.view.drawn_over.lights && lights.empty()) {
        ImGui::GetWindowDrawList()->AddRectFilled(picture.low,
                                                  {picture.high.x, picture.low.y + ImGui::GetFrameHeight()},
                                                  ImGui::GetColorU32(ImGuiCol_PopupBg));
        draw_text_line(session, "lights", picture, picture.low.y, ImGui::GetStyleColorVec4(ImGuiCol_Text),
                       shortened(session.text("view.no_lamp"), picture.width() - ImGui::GetFontSize()), false);
    }
    ImGui::GetWindowDrawList()->PopClipRect();
}

std::optional<LightDrag> light_under_mouse(const Session &session, const Rect &picture) {
    std::optional<LightDrag> found;
    double nearest = handle_radius;
    for (const LightMark &mark : marks_of(session, picture)) {
        const LightGizmo &gizmo = mark.gizmo;
        for (const auto &[handle, place] : {std::pair(LightHandle::lamp, std::optional(gizmo.lamp)),
                                            std::pair(LightHandle::tip, gizmo.turns ? gizmo.to : std::nullopt)}) {
            const double distance = place ? distance_to_mouse(picture, *place) : nearest;
            if (distance < nearest) {
                nearest = distance;
                found = LightDrag{gizmo.light, handle, shown_scene(session, picture)};
            }
        }
    }
    return found;
}

void drag_light(Session &session, const Rect &picture) {
    const auto &drag = session.view.light_drag;
    std::vector<Light> &lights = session.document.scene.lights;
    if (!drag || drag->light >= lights.size()) {
        return;
    }
    const ImGuiIO &io = ImGui::GetIO();
    if (io.MouseDragMaxDistanceSqr[0] == 0) {
        return; // a click leaves a light that a motion moves as the scene has it
    }
    const glm::dvec2 by(static_cast<double>((io.MousePos.x - io.MouseClickedPos[0].x) / picture.width()),
                        static_cast<double>((io.MousePos.y - io.MouseClickedPos[0].y) / picture.height()));
    const Light moved = dragged_light(drag->scene, drag->light, drag->handle, aspect_of(picture), by);
    lights[drag->light].position = moved.position;
    lights[drag->light].direction = moved.direction;
}

} // namespace sandbox
