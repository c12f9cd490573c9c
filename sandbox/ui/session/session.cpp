#include "ui/session/session.h"

#include "capture/samples.h"
#include "image/system_font.h"

#include <algorithm>
#include <exception>

namespace sandbox {

namespace {

void keep_object_valid(Session &session) {
    const std::size_t count = session.document.scene.objects.size();
    session.object = std::min(session.object, count == 0 ? 0 : count - 1);
}

} // namespace

const Object &Session::opened_object() const {
    const auto &objects = document.opened->scene.objects;
    return object < objects.size() ? objects[object] : document.scene.objects[object];
}

const Light &Session::opened_light(std::size_t light) const {
    static const Light fresh;
    const auto &lights = document.opened->scene.lights;
    return light < lights.size() ? lights[light] : fresh;
}

int samples_shown(const Session &session) {
    const ViewSettings &view = session.view;
    const bool single = view.layout == Layout::difference || view.layout == Layout::three_up || view.loupe ||
                        view.masks || session.document.left_is_textbook();
    return single ? 1 : samples_at_rest;
}

void attempt(Session &session, const std::string &failure, const std::function<void()> &action) {
    try {
        action();
    } catch (const std::exception &error) {
        session.message = {failure + error.what(), true};
    }
}

void show_document(Session &session, const Document &document) {
    session.history.record(session.document);
    session.document = document;
    session.history.record(document);
    keep_object_valid(session);
}

void use_characters(Session &session, std::string_view text) {
    while (!text.empty()) {
        const char32_t character = take_character(text);
        if (character >= 0x80 && !in_text_font(character)) {
            session.rare_characters.insert(character);
        }
    }
}

void toggle_tab(Session &session, std::size_t tab) {
    Appearance &look = session.appearance;
    const bool shown = look.panels && look.tab == tab;
    look.tab = shown ? std::nullopt : std::optional(tab);
    look.panels = true;
}

void undo(Session &session) {
    session.history.record(session.document);
    const auto step = session.document.step;
    session.document = session.history.undo();
    follow_step(session, step, true);
    keep_object_valid(session);
}

void redo(Session &session) {
    session.history.record(session.document);
    const auto step = session.document.step;
    session.document = session.history.redo();
    follow_step(session, step, false);
    keep_object_valid(session);
}

} // namespace sandbox
