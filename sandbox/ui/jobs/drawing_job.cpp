#include "ui/jobs/drawing_job.h"

#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui.h>
#include <string>

namespace sandbox {

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
