#pragma once

#include "measure/diagnosis/diagnosis.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace sandbox {

/// A picture with faults that show, and what it is.
struct FaultyPicture {
    std::string scene_name;
    Scene scene;
    Technique base, truth;
    std::vector<std::string> conventions; ///< their names
    Observed observed;                    ///< 8 bits
};

/// What a program writes to a PNG.
Observed drawn_as_bytes(const DiagnosisDraw &draw, const Scene &scene, const Technique &technique, Size size);

/// Every technique of `base` with so many faults that can be seen in the scene: by more than two levels from the base
/// and, of two faults, from every technique with one. Of those that may show, only each `every`-th is drawn.
std::vector<FaultyPicture> faulty_pictures(const std::string &scene_name, const Scene &scene, const Technique &base,
                                           std::size_t faults, const DiagnosisDraw &draw, Size size,
                                           std::size_t every = 1);

/// Every technique of `base` with one fault, written to its file otherwise or under other light, where both the fault
/// and the convention can be seen.
std::vector<FaultyPicture> unconventional_pictures(const std::string &scene_name, const Scene &scene,
                                                   const Technique &base, const DiagnosisDraw &draw, Size size,
                                                   std::size_t every = 1);

enum class Naming { named, tied, unknown, misnamed };
Naming naming_of(const Diagnosis &diagnosis, const FaultyPicture &picture);
/// Technique and conventions: "per-pixel/phong:gate=none display=srgb".
std::string truth_of(const FaultyPicture &picture);
std::string name_of(const Diagnosis &diagnosis);

/// How often faults were named so.
class ConfusionTable {
  public:
    void add(const FaultyPicture &picture, const Diagnosis &diagnosis);
    /// A line a fault: how often it was named, tied (and of these, how often the proposed scene leaves it alone),
    /// unknown, misnamed, and as what; then the sums.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::size_t count(Naming naming) const;

  private:
    struct Row {
        std::map<Naming, std::size_t> counts;
        std::size_t told = 0;                        ///< of those that are tied
        std::map<std::string, std::size_t> named_as; ///< other than the truth
    };
    std::map<std::string, Row> rows_; ///< by the settings of the truth
};

} // namespace sandbox
