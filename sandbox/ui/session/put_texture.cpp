#include "ui/session/put_texture.h"

#include "image/error.h"
#include "ui/session/session.h"
#include "words/row_words.h"

namespace sandbox {

void put_texture(Session &session, const std::filesystem::path &image, Resources &resources) {
    const std::string file = image.filename().string();
    Document document = session.document;
    if (session.object >= document.scene.objects.size()) {
        throw InputError("the scene has no object to put {} on", file);
    }
    Object &object = document.scene.objects[session.object];
    object.material.texture = std::filesystem::absolute(image).lexically_normal().string();
    object.material.checker.reset();
    resources.load(document.scene); // throws for what cannot be read
    show_document(session, document);
    session.message = {session.text("message.texture", file, file_text(session.words, object.name)), false};
}

} // namespace sandbox
