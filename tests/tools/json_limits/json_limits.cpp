// Hands every reader of JSON 16 MiB of several shapes, each in a process of its own, and prints the processor time and
// the memory that the worst shapes took. Run by hand; fails beyond 2 s or 400 MB.
#include "image/error.h"
#include "scene/read_json.h"
#include "tools/json_readers.h"
#include "ui/session/settings.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <functional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <type_traits>
#include <unistd.h>
#include <utility>

namespace sandbox {
namespace {

struct Shape {
    std::string name;
    std::function<std::string()> text;
};

/// `before`, then as many pieces as bytes and values allow, then `after`; `piece` is handed its number. `values`: of a
/// piece.
template <class Piece>
std::string filled(std::string_view before, std::string_view after, std::size_t values, Piece piece) {
    std::string text(before);
    text.reserve(largest_json);
    for (std::size_t i = 0; i < most_json_values / values - 10; ++i) {
        const std::string next = (i > 0 ? "," : "") + piece(i);
        if (text.size() + next.size() + after.size() > largest_json) {
            break;
        }
        text += next;
    }
    return text += after;
}
std::string repeated(std::string_view before, std::string_view piece, std::string_view after) {
    std::string text(before);
    text.reserve(largest_json);
    while (text.size() + piece.size() + after.size() <= largest_json) {
        text += piece;
    }
    return text += after;
}

std::vector<Shape> shapes() {
    const auto key = [](std::size_t i) { return fmt::format("\"k{}\":0", i); };
    const std::string sidecar = R"({"scene":{},"techniques":["per-pixel/phong"],)";
    const std::string box = R"({"mesh":{"shape":"box"}})";
    const std::string light = R"({"type":"point","position":[1,2,3]})";
    const std::string run =
        R"({"version":"1","date":"","quick":true,"size":[1,1],"truth_reason":"","finished":true,)"
        R"("clock":"","warm_ups":0,"repeats":0,"first_rings":1,"last_rings":1,"machine":)"
        R"({"renderer":"","opengl":"","processor":"","threads":1,"llvmpipe_threads":"","build":""},)"
        R"("scene":{"objects":[)" +
        box + R"(]},"seconds":{},"rows":[],"omitted":[],"meshes":[)";
    const auto fill = [](std::string before, std::string after, std::size_t values, auto piece) {
        return [=] {
            return filled(before, after, values, [&](std::size_t i) {
                if constexpr (std::is_invocable_v<decltype(piece), std::size_t>) {
                    return piece(i);
                } else {
                    return std::string(piece);
                }
            });
        };
    };
    const auto repeat = [](std::string before, std::string piece, std::string after) {
        return [=] { return repeated(before, piece, after); };
    };
    return {
        {"nested arrays", repeat("", "[", "")},
        {"nested objects", repeat("", R"({"a":)", "")},
        {"empty objects", repeat("[", "{},", "{}]")},
        {"numbers", fill("[", "]", 1, "1.23456789012")},
        {"numbers of a scene", fill(R"({"background":[)", "]}", 1, "1.23456789012")},
        {"keys", fill("{", "}", 1, key)},
        {"keys of a sidecar", fill(sidecar, "}", 1, key)},
        {"views", fill(R"({"views":[)", "]}", 2, [](std::size_t i) { return fmt::format(R"({{"name":"{}"}})", i); })},
        {"views of one name", fill(R"({"views":[)", "]}", 2, R"({"name":"a"})")},
        {"objects", fill(R"({"objects":[)", "]}", 3, box)},
        {"objects of a sidecar", fill(sidecar + R"("scene":{"objects":[)", "]}}", 3, box)},
        {"lights", fill(R"({"lights":[)", "]}", 6, light)},
        {"techniques", fill(R"({"scene":{},"techniques":[)", "]}", 1, "\"per-pixel/phong\"")},
        {"a sweep", repeat(sidecar + R"("rows":1,"sweep":"background=)", "[1,2,3],", "[1,2,3]\"}")},
        {"a long string", repeat(R"({"name":")", "k", "\"}")},
        {"a long string in a lesson", repeat(R"({"title":")", "k", R"(","steps":[]})")},
        {"escapes", repeat(R"({"name":")", R"(\u00e9)", "\"}")},
        {"surrogates", repeat(R"({"name":")", R"(\ud83d\ude00)", "\"}")},
        {"controls", repeat(R"({"name":")", R"(\u001b)", "\"}")},
        {"a long key", repeat("{\"", "k", "\":0}")},
        {"a long number", repeat("[0.", "0", "1]")},
        {"a huge number", repeat("[", "9", "]")},
        {"white space", repeat("[", " ", "]")},
        {"lines", repeat("[", "\n", "x]")},
        {"no UTF-8", repeat("[\"", "\xff", "\"]")},
        {"zeros", repeat("[", std::string(1, '\0'), "]")},
        {"runs", fill(R"({"format":"shading-sandbox report 1","runs":[)", "]}", 40, run + "]}")},
        {"meshes of a run", fill(R"({"format":"shading-sandbox report 1","runs":[)" + run, "]}]}", 5,
                                 R"({"rings":1,"own":true,"ladder":true,"triangles":1})")},
        {"steps", fill(R"({"title":"a","about":"b","steps":[)", "]}", 2, R"({"text":"a"})")},
        {"claims", fill(R"({"title":"a","about":"b","steps":[{"text":"a","claims":[)", "]}]}", 3,
                        R"({"metric":"rmse","below":1})")},
        {"scenes of an exercise", fill(R"({"title":"a","task":"b","target":"per-pixel/phong","terms":[],"scenes":[)",
                                       "]}", 2, R"({"name":"a"})")},
        {"settings of a case", fill(R"({"group":"a","symptom":"b","cause":"c","source":"d","scene":"studio","set":[)",
                                    "]}", 1, "\"background=[0,0,0]\"")},
        {"recent files", fill(R"({"recent":[)", "]}", 1, "\"/a/b/c/d.json\"")},
        {"lessons seen",
         fill(R"({"lessons":{"seen":{"a":[)", "]}}}", 1, [](std::size_t i) { return fmt::format("{}", i); })},
    };
}

struct Cost {
    double seconds = 0, megabytes = 0;
    bool ended = true; ///< not by a signal
};

Cost cost_of(const JsonReader &reader, const std::string &text) {
    const pid_t child = ::fork();
    if (child == 0) {
        try {
            reader.read(text);
        } catch (const std::exception &) { // refused
        }
        ::_exit(0);
    }
    int status = 0;
    rusage used{};
    ::wait4(child, &status, 0, &used);
    const auto seconds = [](const timeval &time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
    };
    return {seconds(used.ru_utime) + seconds(used.ru_stime), static_cast<double>(used.ru_maxrss) * 1024e-6,
            WIFEXITED(status) && WEXITSTATUS(status) == 0};
}

int measure() {
    std::vector<JsonReader> readers = json_readers();
    readers.push_back({"settings", [](const std::string &text) { parse_settings(text, "a.json"); }});
    bool good = true;
    fmt::print("{:<20} {:>7}  {:<26} {:>7}  {}\n", "reader", "seconds", "of", "MB", "of");
    std::vector<std::vector<std::pair<Cost, std::string>>> costs(readers.size());
    for (const Shape &shape : shapes()) {
        const std::string text = shape.text();
        for (std::size_t i = 0; i < readers.size(); ++i) {
            costs[i].emplace_back(cost_of(readers[i], text), shape.name);
        }
    }
    for (std::size_t i = 0; i < readers.size(); ++i) {
        const auto slowest = std::ranges::max_element(costs[i], {}, [](const auto &c) { return c.first.seconds; });
        const auto largest = std::ranges::max_element(costs[i], {}, [](const auto &c) { return c.first.megabytes; });
        fmt::print("{:<20} {:>7.2f}  {:<26} {:>7.0f}  {}\n", readers[i].name, slowest->first.seconds, slowest->second,
                   largest->first.megabytes, largest->second);
        for (const auto &[cost, shape] : costs[i]) {
            if (cost.seconds > 2 || cost.megabytes > 400 || !cost.ended) {
                good = false;
                fmt::print("  over: {}: {:.2f} s, {:.0f} MB{}\n", shape, cost.seconds, cost.megabytes,
                           cost.ended ? "" : ", ended by a signal");
            }
        }
    }
    return good ? 0 : 1;
}

} // namespace
} // namespace sandbox

int main() { return sandbox::measure(); }
