#include "measure/report.h"
namespace sandbox { std::string report_html(const std::vector<ReportRun> &) { return {}; } }
