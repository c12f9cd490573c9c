#include "tools/hostile_answers.h"

#include "image/write_files.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <utility>

namespace sandbox {
namespace {

std::string repeated(const std::string &text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) {
        all += text;
    }
    return all;
}

std::string body(const std::string &lines) { return "vec3 lighting(vec3 P, vec3 N, vec3 eye)\n{\n" + lines + "\n}\n"; }
std::string value(const std::string &expression) { return body("    return " + expression + ";"); }

std::vector<std::pair<std::string, std::string>> texts() {
    std::vector<std::pair<std::string, std::string>> all{
        {"endless-while", body("float a = 0.0; while (true) { a += 1.0; } return vec3(a);")},
        {"endless-for", body("float a = 0.0; for (;;) { a += sin(a); } return vec3(a);")},
        {"endless-do", body("float a = 0.0; do { a += 1.0; } while (a >= 0.0); return vec3(a);")},
        {"nested-loops",
         body("float a = 0.0;" + repeated("for (int i = 0; i < 1000000; ++i) {", 1) +
              "for (int j = 0; j < 1000000; ++j) { for (int k = 0; k < 1000000; ++k) { a += pow(a, 0.5); } }}"
              " return vec3(a);")},
        {"deep-loops", body("float a = 0.0;" + repeated("while (a < 1e30) {", 60) + "a += 1.0;" + repeated("}", 60) +
                            " return vec3(a);")},
        {"continue", body("float a = 0.0; while (a < 1.0) { continue; } return vec3(a);")},
        {"recursion", "float f(float x) { return f(x + 1.0); }\n" + value("vec3(f(P.x))")},
        {"mutual-recursion", "float g(float x); float f(float x) { return g(x); } float g(float x) { return f(x); }\n" +
                                 value("vec3(f(P.x))")},
        {"call-tree",
         [] {
             std::string text = "float f0(float x) { return sin(x); }\n";
             for (int i = 1; i < 30; ++i) {
                 text += fmt::format("float f{0}(float x) {{ return f{1}(x) + f{1}(x + 1.0); }}\n", i, i - 1);
             }
             return text + value("vec3(f29(P.x))");
         }()},
        {"macro-bomb",
         [] {
             std::string text = "#define A0 sin(1.0)\n";
             for (int i = 1; i < 30; ++i) {
                 text += fmt::format("#define A{0} A{1} + A{1}\n", i, i - 1);
             }
             return text + value("vec3(A29)");
         }()},
        {"macro-of-itself", "#define A A\n" + value("vec3(A)")},
        {"macro-circle", "#define A B\n#define B A\n" + value("vec3(A)")},
        {"macro-function", "#define F(x) F(x)\n" + value("vec3(F(1.0))")},
        {"huge-array", body("float a[100000000]; return vec3(a[int(P.x)]);")},
        {"large-arrays", body(repeated("{ float a[256]; a[int(P.x)] = 1.0; }", 100) + " return vec3(1.0);")},
        {"negative-array", body("float a[-1]; return vec3(a[0]);")},
        {"out-of-bounds", body("return lights[1000000].color + lights[-5].color;")},
        {"array-of-arrays", body("float a[100][100][100]; return vec3(a[0][0][0]);")},
        {"struct-of-arrays", "struct S { float a[1000000]; };\n" + body("S s; return vec3(s.a[0]);")},
        {"include", "#include \"/etc/passwd\"\n" + value("vec3(1.0)")},
        {"extension", "#extension GL_ARB_gpu_shader5 : enable\n" + value("vec3(1.0)")},
        {"version", "#version 460\n" + value("vec3(1.0)")},
        {"pragma", "#pragma optimize(off)\n" + value("vec3(1.0)")},
        {"line", "#line 1 \"../../x\"\n" + value("vec3(1.0)")},
        {"discard", body("discard; return vec3(1.0);")},
        {"frag-depth", body("gl_FragDepth = 0.0; return vec3(1.0);")},
        {"position-of-stage", body("gl_Position = vec4(0.0); return vec3(1.0);")},
        {"layout", "layout(location = 5) out vec4 more;\n" + value("vec3(1.0)")},
        {"main", "void main() { }\n" + value("vec3(1.0)")},
        {"two-lightings", value("vec3(1.0)") + value("vec3(0.0)")},
        {"closes-early", "vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(1.0); } } void main() {"},
        {"comment-to-the-end", "/* " + value("vec3(1.0)")},
        {"backslashes", "\\\n\\\n\\\n" + value("vec3(1.0) \\\n + P")},
        {"nul-bytes", std::string("vec3 lighting(vec3 P, vec3 N, vec3 eye) { return vec3(1.0\0); }", 62)},
        {"binary",
         [] {
             std::string bytes;
             for (int i = 0; i < 4096; ++i) {
                 bytes += static_cast<char>(i * 7919 % 256);
             }
             return bytes;
         }()},
        {"empty", ""},
        {"elf", std::string("\x7F"
                            "ELF\x02\x01\x01\0\0\0",
                            10)},
        {"parentheses", value("vec3(" + repeated("(", 5000) + "1.0" + repeated(")", 5000) + ")")},
        {"braces", body(repeated("{", 5000) + repeated("}", 5000) + " return vec3(1.0);")},
        {"long-sum", value("vec3(1.0" + repeated(" + sin(P.x)", 5000) + ")")},
        {"long-else", body(repeated("if (P.x > 1.0) { return vec3(1.0); } else ", 700) + "return vec3(0.0);")},
        {"long-name", value("vec3(" + std::string(60000, 'a') + ")")},
        {"many-functions",
         [] {
             std::string text;
             for (int i = 0; i < 900; ++i) {
                 text += fmt::format("float f{}(float x){{return x;}}\n", i);
             }
             return text + value("vec3(1.0)");
         }()},
        {"nan", value("vec3(sqrt(-1.0 - dot(N, N)))")},
        {"infinity", value("vec3(1.0 / 0.0)")},
        {"nan-in-places", value("vec3(pow(dot(N, eye - P), 0.5))")},
        {"huge-light", value("vec3(3e38) * P")},
        {"terminal", "\x1B[2J\x1B]0;x\x07" + value("vec3(1.0)")},
        {"html-in-error", value("vec3(\"<script>alert(1)</script>\")")},
        {"wrong-types", value("mat4(1.0)")},
    };
    return all;
}

} // namespace

std::vector<std::string> write_hostile_answers(const std::filesystem::path &folder,
                                               const std::filesystem::path &outside) {
    namespace fs = std::filesystem;
    fs::create_directories(folder);
    std::vector<std::string> names;
    const auto add = [&](const std::string &name, const std::string &bytes) {
        write_file(folder / name, bytes);
        names.push_back(name);
    };
    for (const auto &[name, text] : texts()) {
        add(name + ".glsl", text);
    }
    const std::string black = value("vec3(0.0)");
    for (const char *name :
         {"=1+1.glsl", "+cmd.glsl", "-rf.glsl", "@sum.glsl", "\tTab.glsl", "<b>bold.glsl", "a&b\".glsl",
          "new\nline.glsl", "\x1B[31mred.glsl", "\xFF\xFE.glsl", "CON.glsl", "index.glsl", "marks.glsl", "..glsl.glsl",
          "...glsl", "%2e%2e%2fup.glsl", "UPPER.glsl", "upper.glsl", "\u202Egnp.glsl"}) {
        add(name, black);
    }
    add(std::string(230, 'n') + ".glsl", black);
    write_file(folder / "hundred-megabytes.glsl", black);
    fs::resize_file(folder / "hundred-megabytes.glsl", 100 << 20);
    names.emplace_back("hundred-megabytes.glsl");
    ::mkfifo((folder / "pipe.glsl").c_str(), 0600);
    fs::create_symlink(outside, folder / "link.glsl");
    fs::create_symlink("/dev/zero", folder / "zero.png");
    fs::create_directory(folder / "folder.glsl");
    names.insert(names.end(), {"pipe.glsl", "link.glsl", "zero.png", "folder.glsl"});
    add("no-picture.png", "\x89PNG\r\n\x1a\n");
    add("vast.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x1F\xFF\0\0\x1F\xFF\x08\x02\0\0\0", 29));
    add("vast.pfm", "PF\n1e9 1e9\n-1\n");
    add("cut.pfm", "PF\n160 120\n-1\n");
    return names;
}

} // namespace sandbox
