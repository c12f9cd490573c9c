#include "ui/jobs/job_progress.h"

#include "ui/widgets/widgets.h"

#include <cstdio>
#include <imgui.h>

namespace sandbox {

void job_progress_row(Session &session, BackgroundJob &job) {
    const bool cancelled = job.cancelled();
    ImGui::BeginDisabled(cancelled);
    if (ImGui::Button("Cancel")) {
        job.cancel();
    }
    ImGui::EndDisabled();
    hint_for_item(session, "Stops; what was measured until then stays.");
    ImGui::SameLine();
    const JobProgress progress = job.progress();
    char share[16];
    std::snprintf(share, sizeof share, "%.0f %%   ", progress.share * 100);
    const std::string text = cancelled ? "stopping" : share + progress.doing;
    ImGui::ProgressBar(static_cast<float>(progress.share), {-1, 0}, text.c_str());
}

} // namespace sandbox
