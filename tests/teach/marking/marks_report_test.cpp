#include "teach/marking/marking_fakes.h"
#include "teach/marking/marks_page.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace sandbox {
namespace {

MarkedAnswer answer_of(const Exercise &exercise, const std::string &name, bool right) {
    MarkedAnswer answer{name, "p.html", {}, {right ? "Fine." : "=HYPERLINK(\"x\")"}};
    for (const TermPoints &row : exercise.terms) {
        answer.mark.judgement.terms.push_back({row.term, 3, right ? 3U : 1U, {}, false});
    }
    return answer;
}

TEST(MarksReport, CsvHoldsNoFormulaAndRoundsPointsToTheSum) {
    const Exercise exercise = small_exercise(R"([{"term": "diffuse"}, {"term": "ambient", "points": 2}])");
    const std::vector<MarkedAnswer> answers{answer_of(exercise, "=cmd,|\".glsl", false),
                                            answer_of(exercise, "b", true)};
    EXPECT_EQ(marks_csv(exercise, answers), "answer,points,of,diffuse,ambient,said\r\n"
                                            "\"'=cmd,|\"\".glsl\",1,3,0.33,0.67,\"'=HYPERLINK(\"\"x\"\")\"\r\n"
                                            "b,3,3,1,2,Fine.\r\n");
}

TEST(MarksReport, JsonHoldsWhatIsSaid) {
    const Exercise exercise = small_exercise(R"([{"term": "diffuse"}])");
    std::vector<MarkedAnswer> answers{answer_of(exercise, "\xFF.glsl", false)};
    answers[0].mark.faults = {{MarkTerm::diffuse, ErrorKind::negative, "mark.fault.no-max"}};
    const auto json = nlohmann::json::parse(marks_json(exercise, answers));
    EXPECT_EQ(json["of"], 1);
    EXPECT_EQ(json["answers"][0]["name"], "\\xFF.glsl");
    EXPECT_EQ(json["answers"][0]["points"], 0.33);
    EXPECT_EQ(json["answers"][0]["terms"][0]["pictures"], 3);
    EXPECT_EQ(json["answers"][0]["faults"][0], "no-max");
    EXPECT_EQ(marks_json(exercise, answers), marks_json(exercise, answers));
    answers[0].mark.unknown = true;
    EXPECT_TRUE(nlohmann::json::parse(marks_json(exercise, answers))["answers"][0]["points"].is_null());
}

TEST(MarksReport, PagesEscapeWhatOthersWrote) {
    const Exercise exercise = small_exercise(R"([{"term": "diffuse"}])");
    const std::vector<MarkedAnswer> answers{answer_of(exercise, "<script>alert(1)</script>", false)};
    for (const std::string &page :
         {mark_html(english, exercise, answers[0]), marks_index(english, exercise, answers)}) {
        EXPECT_EQ(page.find("<script>alert"), std::string::npos);
        EXPECT_NE(page.find("&lt;script&gt;alert"), std::string::npos);
    }
}

} // namespace
} // namespace sandbox
