#pragma once

#include "ui/session/session.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace sandbox {

class BackgroundJob;

/// A field for a path, with the recent files below it, and the desktop's own dialog where there is one (zenity,
/// kdialog).
class FileDialog {
  public:
    FileDialog();
    ~FileDialog();
    FileDialog(const FileDialog &) = delete;
    FileDialog &operator=(const FileDialog &) = delete;

    /// As typed so far.
    [[nodiscard]] const std::string &path() const { return path_; }
    enum class Purpose { open, save };
    void show(Purpose purpose, std::string path);
    /// Once a frame. What the user settles for becomes a request of the session.
    void draw(Session &session, const std::vector<std::string> &recent);

  private:
    void draw_fields(Session &session, const std::vector<std::string> &recent);
    void settle(Session &session, const std::string &path);
    void browse();
    void take_browsed(Session &session);

    Purpose purpose_ = Purpose::open;
    bool asked_ = false; ///< to open, in the next frame
    std::string path_;
    std::string command_; ///< of the desktop's dialog; empty: there is none
    std::shared_ptr<std::string> browsed_;
    std::unique_ptr<BackgroundJob> job_; ///< while the desktop's dialog is open
};

} // namespace sandbox
