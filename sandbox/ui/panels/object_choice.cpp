#include "ui/panels/object_choice.h"

#include "ui/widgets/widgets.h"

#include <imgui.h>
#include <string>
#include <vector>

namespace sandbox {

bool object_choice(Session &session) {
    const auto &objects = session.document.scene.objects;
    if (objects.empty()) {
        ImGui::TextUnformatted("This scene has no object.");
        return false;
    }
    if (objects.size() == 1) {
        return true;
    }
    std::vector<std::string> names;
    for (const Object &object : objects) {
        const std::string number = std::to_string(names.size() + 1);
        names.push_back(object.name.empty() ? "object " + number : number + "  " + object.name);
    }
    choice_row(session, "object", names, session.object, "Which object the rows below belong to");
    return true;
}

} // namespace sandbox
