#pragma once

#include "ui/session/session.h"
#include "ui/views/view_mouse.h"
#include "ui/views/view_painter.h"

namespace sandbox {

/// Heights of what stands above and below the pictures, the same in every layout: a picture keeps its place.
float captions_above();
float captions_below();

/// Above all pictures: in what A and B differ, and what the scene is for.
void draw_header(Session &session, const ViewPainter &painter, ImVec2 corner, float width);
/// A side's technique above `picture`; under it how far it is from the truth and, in a second line, its run time.
void draw_captions(Session &session, const ViewPainter &painter, const Rect &picture, bool right, bool align_right,
                   bool run_time = true);
/// The same for a picture of the reference of a side's model.
void draw_truth_captions(Session &session, const Rect &picture, bool right);

/// With dots in place of the last words where it is wider than `width`.
std::string shortened(std::string text, float width);
/// A line of text at the left or right of `rect`, clipped to it. Scripts call it `name`.
void draw_text_line(Session &session, const std::string &name, const Rect &rect, float y, ImVec4 color,
                    const std::string &text, bool align_right);

/// In the lower corner of a picture of masks: what each colour means, how many pixels, the largest error under them.
void draw_mask_legend(const Session &session, const ViewPainter &painter, const Rect &picture, bool right,
                      bool align_right);

} // namespace sandbox
