#pragma once

#include "capture/picture.h"
#include "capture/sidecar.h"
#include "measure/report/report.h"
#include "measure/work_precision/run.h"
#include "reference/parallel.h"
#include "words/words.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// The figures of a hand-in: pictures, plots and numbers of one scene under two techniques, with their captions.
namespace sandbox {

struct FigureRequest {
    std::string name; ///< SCENE as it was typed
    Scene scene;
    PictureOptions pair; ///< both techniques, meshes, display, exposure, language
    Size view{640, 480}; ///< of each picture of a pair; see check_figure_size()
    /// As commands take them, quoted: SCENE with what changes it (--set, --view), and what every command needs
    /// (--assets, --shaders).
    std::string scene_arguments, common_arguments;
    std::string folder;        ///< where the files will be, for commands
    std::filesystem::path out; ///< the same, as a path
    Words words;
};

/// Who draws and measures what.
struct FigureDraw {
    Load load;
    std::function<Frame(const Scene &, const Technique &, Size)> picture; ///< with object ids
    Painters painters;                                                    ///< without overlays
    DrawRows timed;                                                       ///< for pictures of quick_plan().size
    DrawnBy by;
    Machine machine;
};

struct FigureFile {
    std::string name, bytes;
};
struct Figure {
    std::string title, caption, table; ///< Markdown
    std::vector<std::string> commands; ///< that make its pictures, or print its numbers, again
    std::vector<FigureFile> files;
};

/// Throws InputError for a size that leaves no room in some figure, or is too large for one.
void check_figure_size(Size view);

/// The pair, the exponent series, the subdivision series, the difference, the profile, error against run time. Throws
/// InputError where a technique is refused for the scene, Cancelled.
std::vector<Figure> draw_figures(const FigureRequest &request, const FigureDraw &draw, const Progress &progress = {});

} // namespace sandbox
