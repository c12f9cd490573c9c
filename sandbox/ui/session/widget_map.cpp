#include "ui/session/widget_map.h"

#include <utility>

namespace sandbox {

void WidgetMap::begin_frame() { shown_ = std::exchange(drawn_, {}); }

void WidgetMap::add(std::string_view name, Widget widget) {
    if (listening_) {
        drawn_.try_emplace(full_name(name), std::move(widget));
    }
}

const Widget *WidgetMap::find(const std::string &name) const {
    const auto found = shown_.find(name);
    return found == shown_.end() ? nullptr : &found->second;
}

std::string WidgetMap::full_name(std::string_view name) const {
    std::string full;
    for (const std::string &scope : scopes_) {
        full += scope + "/";
    }
    return full.append(name);
}

} // namespace sandbox
