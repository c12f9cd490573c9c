#include "ui/jobs/drawing_job.h"

#include "ui/widgets/widgets.h"

#ifndef __EMSCRIPTEN__
#include <GLFW/glfw3.h>
#endif
#include <fmt/format.h>
#include <imgui.h>
#include <string>

#ifdef __EMSCRIPTEN__
extern "C" void page_wake(); // sandbox/page/browser.js
#endif

namespace sandbox {

void wake_window() {
#ifdef __EMSCRIPTEN__
    page_wake();
#else
    glfwPostEmptyEvent();
#endif
}

void job_progress_row(Session &session, BackgroundJob &job) {
    const bool cancelled = job.cancelled();
    ImGui::BeginDisabled(cancelled);
    if (button(session, session.label("cancel"), session.text("job.cancel.help"))) {
        job.cancel();
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    const JobProgress progress = job.progress();
    const std::string text =
        cancelled ? session.text("job.stopping") : session.text("job.progress", progress.share * 100, progress.doing);
    ImGui::ProgressBar(static_cast<float>(progress.share), {-1, 0}, text.c_str());
}

} // namespace sandbox
