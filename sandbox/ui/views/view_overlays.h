#pragma once

#include "ui/session/session.h"
#include "ui/views/view_mouse.h"

#include <glm/vec2.hpp>
#include <imgui.h>
#include <string>

/// What is drawn over a picture while a tab or a switch asks for it.
namespace sandbox {

/// A place given as shares of a picture.
ImVec2 place_of(const Rect &picture, const glm::dvec2 &share);
void draw_arrow(ImVec2 from, ImVec2 to, ImU32 color, const std::string &name);

/// A cross at the probed pixel, and from its point N, V and every light's L, R or H as arrows.
void draw_probe(const Session &session, const Rect &picture);
/// The line of the profile.
void draw_profile_line(const Session &session, const Rect &picture);
/// The ring where a lesson says to look.
void draw_ring(const Session &session, const Rect &picture);
/// The probed pixel and its neighbours, magnified, in a corner of the picture, or nothing.
void draw_loupe(const Session &session, const Rect &picture, unsigned texture);

} // namespace sandbox
