#pragma once

#include "measure/diagnosis/diagnosis.h"
#include "teach/marking/exercise.h"
#include "teach/marking/kinds.h"
#include "teach/marking/wrong_lines.h"

#include <string>
#include <vector>

/// What a diagnosis names, and which term it costs.
namespace sandbox {

/// What an answer was found to have.
struct Fault {
    MarkTerm term = MarkTerm::diffuse; ///< that pays
    ErrorKind kind = ErrorKind::shape;
    std::string key;     ///< of its sentence in assets/words; empty: a setting's
    std::string other{}; ///< of another one that cannot be told from it here; empty: none
    std::string value{}; ///< that the sentence takes: a factor
    int setting = -1;    ///< in technique_settings; -1: none
    int setting_value = 0;
};

/// Those of an explanation, each charged to a term that the exercise asks for.
std::vector<Fault> faults_of(const Technique &technique, const std::vector<Convention> &conventions,
                             const Exercise &exercise);

} // namespace sandbox
