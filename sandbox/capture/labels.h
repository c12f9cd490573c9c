#pragma once

#include "image/image.h"
#include "words/words.h"

#include <span>
#include <string>
#include <vector>

/// What stands around the views of a picture: a strip above with their labels, below a difference one with its scale.
/// Never around a PFM, which is data.
namespace sandbox {

/// The texts in `language`; in English where no installed font has its characters.
Words words_of_labels(const std::string &language);

/// What is to be written.
struct LabelTexts {
    std::vector<std::string> labels; ///< one over each view, from left to right; none: no strip above
    std::vector<int> splits;         ///< the columns where the second and third label's views begin
    bool splits_move = false;        ///< one view lies behind both labels, so that they may share its width freely
    bool scale = false;              ///< a strip below
};

/// Where it is written: all in one size, wrapped or smaller until it is whole.
struct Strips {
    double text = 0; ///< pixels, of a line from above its capitals to the foot of its descenders
    int above = 0;   ///< rows
    int below = 0;
    std::vector<int> lefts;                      ///< the columns where labels begin
    std::vector<std::vector<std::string>> lines; ///< of each label
};

/// For a picture `width` pixels wide, in text of at most `most_text` pixels. Rows are 0 where that leaves no room for
/// text that can be read.
Strips strips_for(int width, const LabelTexts &texts, double most_text = 64);

/// Writes the labels into the strip above, whose rows are filled.
void draw_labels(ByteImage &picture, const Strips &strips);

/// What a difference's scale says.
struct ScaleTexts {
    std::string what, result; ///< "A - B", "largest 0.31"
    std::string low, high;    ///< what its ends mean: "truth brighter", "A brighter"
    double gain = 1;
};
/// Draws the scale into the strip below: the colours with five numbers, which end means what.
void draw_scale(ByteImage &picture, const Strips &strips, const ScaleTexts &texts);

/// A thin upright line in `rows` rows from `top` at column `split`, where one view ends and the next begins.
void draw_divider(ByteImage &picture, int split, int top, int rows);

} // namespace sandbox
