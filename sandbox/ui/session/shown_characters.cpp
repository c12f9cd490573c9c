#include "ui/session/shown_characters.h"

#include "image/system_font.h"
#include "ui/session/session.h"

namespace sandbox {

void use_shown_characters(Session &session, const std::vector<std::string> &recent, const std::string &typed) {
    if (!chinese_font()) {
        return;
    }
    const Document &document = session.document;
    for (const std::string &text :
         {document.opened->name, document.scene.name, document.scene.description, session.message.text, typed}) {
        use_characters(session, text);
    }
    for (const Object &object : document.scene.objects) {
        use_characters(session, object.name);
        use_characters(session, object.material.texture);
    }
    for (const View &view : document.scene.views) {
        use_characters(session, view.name);
    }
    for (const std::string &file : recent) {
        use_characters(session, file);
    }
}

} // namespace sandbox
