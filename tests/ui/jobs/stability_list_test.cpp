#include "ui/jobs/stability_list.h"

#include "image/image_file.h"
#include "tools/english.h"
#include "tools/temporary_folder.h"
#include "ui/session/session.h"
#include "ui/session/written_files.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace sandbox {
namespace {

StabilityCase plain_case(const char *group, const char *name) {
    StabilityCase one;
    one.group = group;
    one.name = std::string(group) + "-" + name;
    one.scene.objects = {{"ball", SphereShape{}, {}, {}, false}};
    one.techniques = {parse_technique("per-pixel/blinn-phong"), parse_technique("per-pixel/phong")};
    one.bound = 1.0 / 255;
    return one;
}

StabilityRow row(double error, bool passed, std::size_t nonfinite = 0) {
    StabilityRow row;
    row.error = nonfinite > 0 ? std::numeric_limits<double>::infinity() : error;
    row.metrics.nonfinite_pixels = nonfinite;
    row.passed = passed;
    return row;
}

/// Judged: the textbook's form, then both techniques of the robust one.
ListedCase judged(const StabilityCase &definition, StabilityRow textbook, StabilityRow first, StabilityRow second) {
    StabilityResult result;
    result.definition = definition;
    result.textbook = textbook;
    result.rows = {first, second};
    const ByteImage pixel{{1, 1}, {0, 0, 0}};
    result.textbook_image = result.robust_image = result.reference_image = pixel;
    return {definition, result};
}

TEST(StabilityList, SaysWhatIsKnown) {
    const ListedCase unknown{plain_case("spot", "cutoff-0"), std::nullopt};
    EXPECT_EQ(textbook_text(english, unknown), "not run");
    EXPECT_EQ(robust_verdict(unknown), Verdict::not_run);

    const ListedCase good = judged(unknown.definition, row(0.31, false), row(1.2e-6, true), row(2e-5, true));
    EXPECT_EQ(textbook_text(english, good), "breaks, 0.310");
    EXPECT_EQ(robust_text(english, good), "holds, 2.00e-05"); // the worst of its techniques
    EXPECT_EQ(cost_text(good), "");

    const ListedCase bad = judged(unknown.definition, row(1e-6, true), row(1e-6, true), row(0, false, 3));
    EXPECT_EQ(textbook_text(english, bad), "holds, 1.00e-06");
    EXPECT_EQ(robust_text(english, bad), "breaks, 3 not finite");
}

TEST(StabilityList, CostsAreRatios) {
    ListedCase one = judged(plain_case("exponent", "1e5"), row(1, false), row(0, true), row(0, true));
    one.result->cost = 1.0449;
    EXPECT_EQ(cost_text(one), "1.04x");
}

TEST(StabilityList, SumsUp) {
    const StabilityCase of = plain_case("spot", "cutoff-0");
    std::vector<ListedCase> cases = list_cases({of, of, of});
    EXPECT_EQ(summary(english, cases), "3 cases, none run yet");
    cases[0] = judged(of, row(1, false), row(0, true), row(0, true));
    cases[1] = cases[0];
    cases[0] = judged(of, row(0, true), row(0, true), row(0, true));
    cases[2] = cases[0];
    EXPECT_EQ(summary(english, {cases[0], cases[2]}), "2 of 2 run: robust holds in all, the textbook breaks in none");
    cases[2].result.reset();
    EXPECT_EQ(summary(english, cases), "2 of 3 run: robust holds in all, the textbook breaks in 1");
    cases[2] = judged(of, row(0, true), row(0, true), row(1, false));
    EXPECT_EQ(summary(english, cases), "3 of 3 run: robust breaks in 1, the textbook breaks in 1");
    EXPECT_EQ(results_of(cases).size(), 3U);
}

TEST(StabilityList, Filters) {
    const ListedCase unknown{plain_case("spot", "a"), std::nullopt};
    const ListedCase broken = judged(plain_case("spot", "b"), row(1, false), row(0, true), row(0, true));
    const ListedCase sound = judged(plain_case("display", "c"), row(0, true), row(0, true), row(0, true));
    const std::vector<ListedCase> cases{unknown, broken, sound};
    EXPECT_EQ(groups_of(cases), (std::vector<std::string>{"spot", "display"}));
    const auto shown = [&](const CaseFilter &filter) {
        std::string names;
        for (const ListedCase &listed : cases) {
            names += is_shown(listed, filter) ? short_name(listed.definition) : "";
        }
        return names;
    };
    EXPECT_EQ(shown({}), "abc");
    EXPECT_EQ(shown({"spot", false}), "ab");
    EXPECT_EQ(shown({"", true}), "b");
    EXPECT_EQ(shown({"display", true}), "");
}

TEST(StabilityList, ListsByWhetherTheTextbookBreaks) {
    const ListedCase unknown{plain_case("spot", "a"), std::nullopt};
    const ListedCase broken = judged(plain_case("spot", "b"), row(1, false), row(0, true), row(0, true));
    const ListedCase sound = judged(plain_case("display", "c"), row(0, true), row(0, true), row(0, true));
    const auto titles = [](const std::vector<ListedCase> &cases, const CaseFilter &filter) {
        std::string all;
        for (const CaseList &list : lists_of(english, cases, filter)) {
            all += list.title + "; ";
        }
        return all;
    };
    EXPECT_EQ(titles({sound, unknown, broken, sound}, {}), "The textbook's form breaks on this renderer: 1; "
                                                           "Not run yet: 1; Nothing breaks on this renderer: 2; ");
    EXPECT_EQ(titles({sound, broken}, {"display", false}), "Nothing breaks on this renderer: 1; ");
    EXPECT_EQ(titles({unknown, unknown}, {}), "; ") << "one list, and nothing to call it";
    const std::vector<CaseList> lists = lists_of(english, {sound, unknown, broken, sound}, {});
    EXPECT_EQ(lists[0].cases, std::vector<std::size_t>{2});
    EXPECT_EQ(lists[2].cases, (std::vector<std::size_t>{0, 3}));
}

TEST(StabilityList, EveryCaseHasAStoryAndANameOfItsOwn) {
    std::set<std::string> names;
    for (const ListedCase &listed : list_cases(stability_cases())) {
        EXPECT_TRUE(names.insert(listed.definition.name).second) << listed.definition.name;
        EXPECT_LT(short_name(listed.definition).size(), listed.definition.name.size()) << listed.definition.name;
        EXPECT_FALSE(listed.definition.symptom.empty() || listed.definition.cause.empty() ||
                     listed.definition.source.empty())
            << listed.definition.name;
    }
    EXPECT_GT(names.size(), 50U);
}

TEST(StabilityList, ACaseIsOpenedBesideItsTextbooksForm) {
    StabilityCase one = plain_case("display", "dim");
    const Document on_processor = case_document(one, 1e9);
    EXPECT_EQ(on_processor.opened->name, "display-dim");
    EXPECT_EQ(on_processor.scene, one.scene);
    EXPECT_EQ(on_processor.right, one.techniques[0]);
    EXPECT_TRUE(on_processor.left_is_textbook());
    EXPECT_EQ(on_processor.exposure, 1e9);

    one.textbook = parse_technique("per-pixel/blinn-phong:power=textbook");
    const Document in_glsl = case_document(one, 1);
    EXPECT_EQ(in_glsl.left, *one.textbook);
    EXPECT_EQ(in_glsl.right, one.techniques[0]);
    EXPECT_FALSE(in_glsl.left_is_textbook());
}

TEST(StabilityList, UndoBringsBackWhatWasOpen) {
    const Document before = document_of("ball", Scene{}, parse_technique("flat/phong"), Technique{});
    Session session(before);
    show_document(session, case_document(plain_case("spot", "a"), 1));
    show_document(session, case_document(plain_case("spot", "b"), 1));
    undo(session);
    EXPECT_EQ(session.document.opened->name, "spot-a");
    undo(session);
    EXPECT_EQ(session.document, before);
}

TEST(ExportedFiles, AreThoseOfTheCommand) {
    const TemporaryFolder folder;
    const auto old = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    const StabilityCase of = plain_case("spot", "a");
    const StabilityRun run{{*judged(of, row(1, false), row(0, true), row(0, true)).result}, "soft", "1.2"};
    const auto first = export_stability(run);
    const auto second = export_stability(run);
    std::filesystem::current_path(old);
    EXPECT_EQ(first.filename(), "stability-001");
    EXPECT_EQ(second.filename(), "stability-002");
    EXPECT_TRUE(first.is_absolute());
    EXPECT_EQ(read_file(first / "stability.csv"), stability_csv(run));
    EXPECT_EQ(read_file(first / "stability.json"), stability_json(run));
    EXPECT_EQ(read_file(first / "stability.html"), stability_html(run));
}

} // namespace
} // namespace sandbox
