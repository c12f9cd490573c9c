#include "ui/views/view_mouse.h"

#include "scene/light_kind.h"
#include "scene/orbit.h"
#include "ui/session/edits.h"
#include "ui/views/light_handles.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

namespace sandbox {

namespace {

bool near_divider(const Session &session, const Rect &rect) {
    return session.view.layout == Layout::wipe &&
           std::abs(ImGui::GetIO().MousePos.x - divider_x(session, rect)) < ImGui::GetFontSize() * 0.6F;
}

bool near_profile(const Session &session, const Rect &rect) {
    const float y = rect.low.y + static_cast<float>(session.view.profile_row) * rect.height();
    return session.view.overlay == Overlay::profile &&
           std::abs(ImGui::GetIO().MousePos.y - y) < ImGui::GetFontSize() * 0.6F;
}

/// What a drag does depends on where it began.
enum class Drag { none, orbit, pan, divider, profile, light };

Drag begun_drag(Session &session, const Rect &rect) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        session.view.light_drag = light_under_mouse(session, rect);
        if (session.view.light_drag) {
            return Drag::light;
        }
        return near_divider(session, rect) ? Drag::divider : near_profile(session, rect) ? Drag::profile : Drag::orbit;
    }
    return Drag::pan;
}

void drag_camera(Camera &camera, const Rect &rect, Drag drag) {
    constexpr double degrees_per_height = 180; // from the top of a picture to its bottom: half a turn
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    const double x = static_cast<double>(moved.x) / rect.height();
    const double y = static_cast<double>(moved.y) / rect.height();
    if (x == 0 && y == 0) {
        return;
    }
    camera =
        drag == Drag::orbit ? orbited(camera, -x * degrees_per_height, y * degrees_per_height) : panned(camera, -x, y);
}

void use_wheel(Camera &camera) {
    constexpr double closer_per_notch = 0.9;
    if (const float wheel = ImGui::GetIO().MouseWheel; wheel != 0) {
        camera = dollied(camera, std::pow(closer_per_notch, static_cast<double>(wheel)));
    }
}

void drag_divider(Session &session, const Rect &rect) {
    const float share = (ImGui::GetIO().MousePos.x - rect.low.x) / rect.width();
    session.view.divider = std::clamp(share, 0.0F, 1.0F);
}

/// The mouse's place as shares of the picture.
glm::dvec2 mouse_share(const Rect &rect) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return {std::clamp(static_cast<double>((mouse.x - rect.low.x) / rect.width()), 0.0, 1.0),
            std::clamp(static_cast<double>((mouse.y - rect.low.y) / rect.height()), 0.0, 1.0)};
}

std::string light_hint(const Session &session, const LightDrag &drag) {
    const std::vector<Light> &lights = session.document.scene.lights;
    const bool moves =
        drag.handle == LightHandle::lamp && drag.light < lights.size() && has_position(lights[drag.light]);
    return session.text(moves ? "light.move.help" : "light.turn.help", drag.light + 1);
}

/// A click pins the pixel; one on the pinned pixel lets it go.
void click_pixel(Session &session, const Rect &rect) {
    const glm::dvec2 at = mouse_share(rect);
    std::optional<glm::dvec2> &pinned = session.view.pinned_pixel;
    const double reach = static_cast<double>(ImGui::GetFontSize());
    const bool again = pinned && std::hypot((pinned->x - at.x) * static_cast<double>(rect.width()),
                                            (pinned->y - at.y) * static_cast<double>(rect.height())) < reach;
    pinned = again ? std::nullopt : std::optional(at);
}

} // namespace

float divider_x(const Session &session, const Rect &picture) {
    return std::round(picture.low.x + picture.width() * session.view.divider);
}

void mouse_over_picture(Session &session, const Rect &picture, const std::string &name) {
    ImGui::SetCursorScreenPos(picture.low);
    const ScopedName scope(session, name);
    ImGui::InvisibleButton("picture", {picture.width(), picture.height()},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    describe_item(session, "picture", "");
    ImGuiStorage &state = *ImGui::GetStateStorage();
    const ImGuiID drag_id = ImGui::GetID("drag");
    if (ImGui::IsItemActivated()) {
        state.SetInt(drag_id, static_cast<int>(begun_drag(session, picture)));
    }
    const Drag drag = ImGui::IsItemActive() ? static_cast<Drag>(state.GetInt(drag_id)) : Drag::none;
    if (drag == Drag::divider) {
        drag_divider(session, picture);
    } else if (drag == Drag::profile) {
        session.view.profile_row = mouse_share(picture).y;
    } else if (drag == Drag::light) {
        drag_light(session, picture);
    } else if (drag != Drag::none) {
        drag_camera(session.document.scene.camera, picture, drag);
    }
    const bool hovered = ImGui::IsItemHovered();
    const auto light = hovered ? light_under_mouse(session, picture) : std::nullopt;
    const bool on_divider = near_divider(session, picture);
    if (drag == Drag::divider || (hovered && on_divider)) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
    if (drag == Drag::profile || (hovered && near_profile(session, picture))) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    }
    if (drag == Drag::light || (light && drag == Drag::none)) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
        session.hint = light_hint(session, drag == Drag::light ? *session.view.light_drag : *light);
    }
    const bool probes = session.view.overlay == Overlay::pixel || session.view.loupe;
    constexpr float click_reach = 9; // pixels, squared
    if (probes && ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
        ImGui::GetIO().MouseDragMaxDistanceSqr[0] < click_reach && !on_divider && !light) {
        click_pixel(session, picture);
    }
    if (hovered) {
        session.view.hovered_pixel = mouse_share(picture);
        use_wheel(session.document.scene.camera);
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !on_divider && !light) {
            reset_camera(session.document);
        }
    }
}

} // namespace sandbox
