#pragma once

#include <string>
#include <vector>

namespace sandbox {

struct Session;

/// The fonts have what names and texts from files and people need: those of the session, the recent files, and what is
/// being typed. Does nothing where no font has Chinese characters.
void use_shown_characters(Session &session, const std::vector<std::string> &recent, const std::string &typed);

} // namespace sandbox
