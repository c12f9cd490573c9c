#pragma once

#include "scene/assets.h"
#include "ui/session/document.h"
#include "ui/session/history.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace sandbox {

enum class ViewMode { side_by_side, wipe, flip, difference };

/// How the two pictures are shown. Not part of the document: looking is no edit.
struct ViewSettings {
    ViewMode mode = ViewMode::side_by_side;
    float divider = 0.5F;    ///< wipe: A's share of the width
    bool show_right = false; ///< flip: B while Space is held
    double gain = 4;         ///< difference
    bool wireframe = false;
};

enum class BottomTab { error_time, glsl, stability };

struct Appearance {
    bool dark = true;
    float scale = 1; ///< of text and controls
    bool panels = true;
    bool full_screen = false;
    bool key_list = false;
    std::optional<BottomTab> tab; ///< of the bottom panel; none: it is folded
    float bottom_share = 0;       ///< of the height of pictures and bottom panel, while it is open; 0: not chosen yet
};

/// What the status line says until the next one.
struct Message {
    std::string text;
    bool error = false;
};

/// What the status line remembers: its last message, and the hint that it came over. Until the mouse moves on to
/// something else the message goes first.
struct StatusLine {
    std::string message, over;
};

/// What the panels ask of the window; answered once the frame is done.
struct Requests {
    bool quit = false;
    bool capture = false;
    std::optional<std::string> open; ///< a built-in name or a path
};

/// All that the window shows. Panels edit it; the pictures are derived from it.
struct Session {
    Document document;
    History history;
    ViewSettings view;
    Appearance appearance;
    Requests requests;
    Message message;
    StatusLine status;
    std::string hint;                   ///< about what the mouse is over; empty: nothing
    bool view_dragged = false;          ///< the camera or the divider is being dragged
    std::size_t object = 0;             ///< the one that Material and Mesh show
    std::vector<std::size_t> triangles; ///< of each object, as last drawn
    std::vector<std::string> scenes;    ///< built-in ones, in the order they are taught
    std::vector<std::string> textures;  ///< built-in ones

    explicit Session(Document first) : document(first), history(std::move(first)) {}

    /// The object of the Material and Mesh panels; only where the scene has any.
    [[nodiscard]] Object &shown_object() { return document.scene.objects[object]; }
    /// The same object as opened; the shown one where it was not there.
    [[nodiscard]] const Object &opened_object() const;
    /// The light as opened; a default one where it was not there.
    [[nodiscard]] const Light &opened_light(std::size_t light) const;
    [[nodiscard]] const Technique &technique(bool right) const { return right ? document.right : document.left; }
    [[nodiscard]] Technique &technique(bool right) { return right ? document.right : document.left; }
};

/// Goes on with another document, as one step that can be undone.
void show_document(Session &session, const Document &document);
/// Opens the bottom panel at `tab`; folds it where that is what it shows.
void toggle_tab(Session &session, BottomTab tab);
void undo(Session &session);
void redo(Session &session);

} // namespace sandbox
