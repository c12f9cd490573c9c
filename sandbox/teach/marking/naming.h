#pragma once

#include "teach/marking/faults.h"
#include "teach/marking/judge.h"
#include "teach/marking/marker.h"
#include "teach/marking/truth.h"

#include <map>
#include <optional>
#include <vector>

namespace sandbox {

/// Which of the wrong lines an answer has: those whose pictures are the answer's, wherever a term is judged. Each line
/// is drawn at most once an exercise.
class WrongLines {
  public:
    /// All must outlive this.
    WrongLines(const Exercise &exercise, const MarkDraw &draw, Truth &truth);

    /// The lines that explain a term as well as each other: those that explain most of the wrong terms, among them
    /// those that touch fewest. Empty where none does.
    std::vector<const WrongLine *> explaining(MarkTerm term, const MarkTerms &wrong, PictureStore &answer);
    bool explains(const WrongLine &line, MarkTerm term, PictureStore &answer);
    /// Is the answer's picture of every judged scene that of the line?
    bool explains_all(const WrongLine &line, PictureStore &answer);

  private:
    PictureStore *pictures(const WrongLine &line);
    bool agree_in_the_dark(const WrongLine &line, MarkTerm term, PictureStore &answer);
    bool agree(const Scene &scene, PictureStore &answer, PictureStore &line);

    const Exercise &exercise_;
    const MarkDraw &draw_;
    Truth &truth_;
    std::map<const WrongLine *, std::optional<PictureStore>> drawn_; ///< empty: the model has no such line
};

} // namespace sandbox
