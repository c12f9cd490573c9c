#pragma once

#include "capture/layout.h"
#include "scene/light_gizmos.h"
#include "scene/overlays.h"
#include "ui/session/document.h"
#include "ui/session/history.h"
#include "ui/session/label.h"
#include "ui/session/pixel_findings.h"
#include "ui/session/playback.h"
#include "ui/session/shown_exercise.h"
#include "ui/session/shown_lesson.h"
#include "ui/session/widget_map.h"
#include "words/words.h"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace sandbox {

/// What the open tab draws over the pictures.
enum class Overlay { none, pixel, profile };

/// A light that the mouse drags.
struct LightDrag {
    std::size_t light;
    LightHandle handle;
    Scene scene; ///< as seen when the drag began
};

/// How the two pictures are shown. Not part of the document: undo leaves it alone.
struct ViewSettings {
    Layout layout = Layout::side_by_side; ///< single: A, or B while Space is held ("flip")
    float divider = 0.5F;                 ///< wipe: A's share of the width
    bool show_right = false;              ///< single: B
    double gain = 4;                      ///< difference
    DifferenceOf difference_of = DifferenceOf::a_b;
    Overlays drawn_over;
    bool masks = false; ///< shows which pixels error figures leave out
    bool loupe = false; ///< magnifies the probed pixel and its neighbours in every picture
    /// Shares of a picture's width and height, from its upper left corner: the pixel under the mouse, and the one that
    /// a click has pinned.
    std::optional<glm::dvec2> hovered_pixel, pinned_pixel;
    std::optional<LightDrag> light_drag;
    Overlay overlay = Overlay::none;
    double profile_row = 0.5; ///< the line of the profile, as a share of the height
    [[nodiscard]] std::optional<glm::dvec2> probed() const { return pinned_pixel ? pinned_pixel : hovered_pixel; }
};

/// As edges were dragged; 0: not chosen yet.
struct PanelSizes {
    float side_ems = 0;     ///< the side panel's width, in text heights
    float bottom_share = 0; ///< of the height of pictures and bottom panel, while it is open
    bool operator==(const PanelSizes &) const = default;
};
constexpr float least_side_ems = 14, most_side_ems = 60, least_bottom_share = 0.2F, most_bottom_share = 0.85F;

struct Appearance {
    bool dark = true;
    float scale = 1; ///< of text and controls
    bool panels = true;
    bool full_screen = false;
    bool key_list = false;
    bool run_times = true;          ///< hidden, so that scripted pictures repeat
    std::optional<std::size_t> tab; ///< which of bottom_tabs is open; none: the panel is folded
    PanelSizes sizes;
};

/// The status line shows it until the next one, or for some seconds.
struct Message {
    std::string text;
    bool error = false;
};

/// A new message hides the hint that was shown when it came, until the mouse moves on to another hint.
struct StatusLine {
    std::string message; ///< the last one
    std::string hidden_hint;
};

/// What the panels ask of the window, which answers after the frame.
struct Requests {
    bool quit = false;
    bool capture = false;                          ///< the views
    bool capture_window = false;                   ///< all that the window shows
    bool open_folder = false;                      ///< of captures
    std::optional<std::string> open;               ///< a built-in name or a path
    std::optional<std::string> open_lesson;        ///< likewise
    std::size_t open_step = 0;                     ///< of that lesson
    std::optional<std::string> open_exercise;      ///< likewise
    bool begin_exercise = false;                   ///< writes the student's file, and opens it in an editor
    std::optional<std::string> save;               ///< a path for the scene
    std::optional<std::string> language;           ///< of languages
    bool ask_open = false, ask_save = false;       ///< for a path
    bool copy_scene = false, paste_scene = false;  ///< as JSON, by the clipboard
    bool copy_link = false, show_licences = false; ///< of a page
    bool operator==(const Requests &) const = default;
};

/// All that the window shows. Panels edit it; the pictures are derived from it.
struct Session {
    Document document;
    History history;
    ViewSettings view;
    Playback playback;
    Appearance appearance;
    Requests requests;
    Message message;
    StatusLine status;
    std::string hint;                           ///< about what the mouse is over; empty: nothing
    std::size_t object = 0;                     ///< whose material and mesh the panels show
    std::shared_ptr<const PixelFindings> pixel; ///< of the probed pixel, while something shows it
    /// Of A and of B: of each object, as last drawn.
    std::array<std::vector<std::size_t>, 2> triangles;
    OwnShader last_own;                              ///< the last text of own shading that was opened
    std::map<std::string, std::string> own_failures; ///< by file: why its last saved text is not shown
    bool same_picture = false;                       ///< A and B draw the same picture of the scene, as last drawn
    std::vector<std::string> scenes;                 ///< built-in ones, in the order they are taught
    std::vector<std::string> textures;               ///< built-in ones
    std::vector<ListedLesson> lessons;               ///< built-in ones, famous bugs behind the others
    LessonProgress progress;
    std::vector<ListedExercise> exercises; ///< built-in ones
    SolvedExercises solved;
    bool answer_shown = false; ///< of the step's question
    WidgetMap widgets;         ///< for scripts
    Words words = words_in(languages.front());
    std::set<char32_t> rare_characters; ///< in use, beside in_text_font(): see use_characters()

    explicit Session(Document first) : document(first), history(std::move(first)) {}

    /// A text in the window's language, with {0}, {1}, ... filled in.
    template <class... T> [[nodiscard]] std::string text(std::string_view key, const T &...values) const {
        return words.format(key, values...);
    }
    /// Likewise, for a widget that scripts know by the English text.
    template <class... T> [[nodiscard]] Label label(std::string_view key, const T &...values) const {
        return {words.format(key, values...), words.english().format(key, values...)};
    }
    /// The object of the Material and Mesh panels; the scene must have one.
    [[nodiscard]] Object &shown_object() { return document.scene.objects[object]; }
    /// That object as opened; as it is now if it was not there.
    [[nodiscard]] const Object &opened_object() const;
    /// A light as opened; a default one if it was not there.
    [[nodiscard]] const Light &opened_light(std::size_t light) const;
    [[nodiscard]] const Technique &technique(bool right) const { return right ? document.right : document.left; }
    [[nodiscard]] Technique &technique(bool right) { return right ? document.right : document.left; }
};

/// Samples a pixel of the pictures once nothing moves: 1 where they stand beside what has one (a truth, a textbook's
/// picture), are measured (a difference, masks) or magnified.
int samples_shown(const Session &session);
/// Runs `action`; what it throws becomes the status line's message, after `failure`.
void attempt(Session &session, const std::string &failure, const std::function<void()> &action);
/// Replaces the document, as one step that can be undone.
void show_document(Session &session, const Document &document);
/// The fonts have the Chinese characters of `text`, which comes from a file or a person, from the next frame on.
void use_characters(Session &session, std::string_view text);
/// Opens the bottom panel at `tab`; folds it if that tab is open.
void toggle_tab(Session &session, std::size_t tab);
void undo(Session &session);
void redo(Session &session);

} // namespace sandbox
