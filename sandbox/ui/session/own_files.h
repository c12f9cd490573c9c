#pragma once

#include "shading/technique.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

/// Own shading in the window: a file is opened, watched, and read again when it is saved.
namespace sandbox {

struct Session;

/// Does a file's name say that it is own shading?
bool is_own_name(const std::filesystem::path &path);

/// A shows it, per pixel unless it has shown own shading at another frequency: one edit for undo. Throws InputError,
/// and then nothing changes.
void open_own(Session &session, const std::filesystem::path &file);

/// The text that the row "own shading" stands for on a side: its own, else the other side's, else the last one opened.
/// May be none.
OwnShader own_of(const Session &session, bool right);

/// Why the file that a side shows is not what is shown: "FILE:LINE: ..."; empty: it is.
std::string own_failure(const Session &session, bool right);

/// Files of own shading that the two sides show.
class OwnFiles {
  public:
    /// Reads those that have been saved since: what they draw is one more edit for undo; of one that is not accepted
    /// the last good text stays, and session.own_failures says why. True if anything has changed.
    bool read_saved(Session &session);

  private:
    struct State {
        std::filesystem::file_time_type saved;
        std::uintmax_t size = 0;
        bool operator==(const State &) const = default;
    };
    std::map<std::string, State> seen_; ///< by path
};

} // namespace sandbox
