#pragma once

#include "image/image.h"
#include "teach/claims.h"
#include "teach/lesson.h"
#include "words/words.h"

#include <span>
#include <string>
#include <vector>

/// What was measured of a lesson: as a terminal's table, as JSON, and the lesson as a page.
namespace sandbox {

struct MeasuredLesson {
    Lesson lesson;
    LessonResult result;
};

/// A line a claim.
std::string lesson_table(const MeasuredLesson &measured);

/// Keys: format, version, renderer, passed, lessons (name, title, passed, steps (title, claims (what, value, measured,
/// bound, unit, checked, passed))). A value that is not finite is null.
std::string lessons_json(std::span<const MeasuredLesson> measured, const std::string &renderer);

/// A self-contained page; `pictures` has one for each step.
std::string lesson_html(const Words &words, const MeasuredLesson &measured, std::span<const ByteImage> pictures,
                        const std::string &renderer);

/// A page that links to the pages NAME.html of all.
std::string lessons_index(const Words &words, std::span<const MeasuredLesson> measured);

/// Famous bugs on one sheet: of each the picture NAME-01.png, what people saw, the cure and the source.
std::string gallery_sheet(const Words &words, std::span<const MeasuredLesson> measured);

} // namespace sandbox
