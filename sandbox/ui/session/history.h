#pragma once

#include "ui/session/document.h"

#include <vector>

namespace sandbox {

/// Undo and redo over whole documents, which are small.
class History {
  public:
    explicit History(Document first) : steps_{std::move(first)} {}

    /// Adds a step and forgets undone ones; does nothing if `now` is the current step. Successive camera moves are one
    /// step, so that undo after looking around reverts the last edit, not the last nudge.
    void record(const Document &now);

    [[nodiscard]] const Document &current() const { return steps_[at_]; }
    [[nodiscard]] bool can_undo() const { return at_ > 0; }
    [[nodiscard]] bool can_redo() const { return at_ + 1 < steps_.size(); }
    /// The new current document; unchanged if there is nothing to undo or redo.
    const Document &undo();
    const Document &redo();

  private:
    static constexpr std::size_t most_steps = 500;
    std::vector<Document> steps_; ///< never empty
    std::size_t at_ = 0;
};

} // namespace sandbox
