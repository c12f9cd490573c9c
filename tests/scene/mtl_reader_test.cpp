#include "scene/mtl_reader.h"
#include "tools/error_of.h"

#include <gtest/gtest.h>

namespace sandbox {
namespace {

using Materials = std::map<std::string, Material, std::less<>>;

Materials read(std::string_view text, const Material &base = {}) {
    std::vector<std::string> notes;
    return read_mtl(source_of(text), "a.mtl", base, notes);
}

std::vector<std::string> notes_of(std::string_view text) {
    std::vector<std::string> notes;
    read_mtl(source_of(text), "a.mtl", {}, notes);
    return notes;
}

std::string error(std::string_view text) {
    return error_of([&] { read(text); });
}

TEST(Mtl, ReadsColoursShininessAndTheTexture) {
    const Materials all = read("newmtl my red\nKa 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7\nKe 1e2 0 0\nNs 96.078431\n"
                               "newmtl b\nmap_Kd my wood.png\n");
    ASSERT_EQ(all.size(), 2U);
    const Material &red = all.at("my red");
    EXPECT_EQ(red.ambient, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_EQ(red.diffuse, glm::dvec3(0.4, 0.5, 0.6));
    EXPECT_EQ(red.specular, glm::dvec3(0.7)) << "one number is for all three";
    EXPECT_EQ(red.emission, glm::dvec3(100, 0, 0));
    EXPECT_EQ(red.shininess, 96.078431);
    EXPECT_EQ(red.texture, "");
    EXPECT_TRUE(red.texture_modulates_specular);
    EXPECT_EQ(all.at("b").texture, "my wood.png");
    EXPECT_FALSE(all.at("b").texture_modulates_specular) << "it is the diffuse colour's map";
}

TEST(Mtl, LeavesWhatItDoesNotSayAsTheSceneHasIt) {
    Material base;
    base.diffuse = {0.5, 0.5, 0.5};
    base.shininess = 7;
    const Materials all = read("newmtl a\nKs 0 0 0\n", base);
    Material expected = base;
    expected.specular = glm::dvec3(0);
    EXPECT_EQ(all.at("a"), expected);
}

TEST(Mtl, TakesTheFirstOfTwoMaterialsOfOneName) {
    EXPECT_EQ(read("newmtl a\nKd 1 0 0\nnewmtl a\nKd 0 1 0\n").at("a").diffuse, glm::dvec3(1, 0, 0));
}

TEST(Mtl, SaysOnceWhatItLeavesOut) {
    EXPECT_TRUE(notes_of("newmtl a\nKd 1 1 1\n").empty());
    EXPECT_EQ(notes_of("newmtl a\nd 0.5\nillum 2\nTr 0\nnewmtl b\nd 1\nKd spectral a.rfl\nmap_Bump b.png\n"),
              std::vector<std::string>{"only Ka, Kd, Ks, Ke, Ns and map_Kd are taken; left out: d, illum, Tr, "
                                       "Kd spectral, map_Bump"});
}

TEST(Mtl, PassesOverTheOptionsOfAMap) {
    const auto texture = [](const std::string &map) { return read("newmtl a\nmap_Kd " + map + "\n").at("a").texture; };
    EXPECT_EQ(texture("-s 2 2 1 -o 0.5 wood.png"), "wood.png");
    EXPECT_EQ(texture("-clamp on -blendu off my wood.png"), "my wood.png");
    EXPECT_EQ(texture("-mm 0 1 -bm 2 -imfchan r wood.png"), "wood.png");
    EXPECT_EQ(texture("-s 1 2 3 4.png"), "4.png");
    EXPECT_EQ(texture("-own.png"), "-own.png");
    EXPECT_EQ(notes_of("newmtl a\nmap_Kd -s 2 wood.png\n"),
              std::vector<std::string>{"only Ka, Kd, Ks, Ke, Ns and map_Kd are taken; left out: map_Kd -s"});
}

TEST(Mtl, RefusesNumbersThatAScenesMaterialsCannotHave) {
    EXPECT_EQ(error("newmtl a\nKd 0 -1 0\n"), "a.mtl:2: Kd: expected a number from 0 to 1e+06, got \"-1\"");
    EXPECT_EQ(error("newmtl a\nKs 2e6\n"), "a.mtl:2: Ks: expected a number from 0 to 1e+06, got \"2e6\"");
    EXPECT_EQ(error("newmtl a\n\nNs 2e7\n"), "a.mtl:3: Ns: expected a number from 0 to 1e+07, got \"2e7\"");
    EXPECT_EQ(error("newmtl a\nKe nan 0 0\n"), "a.mtl:2: Ke: expected a number from 0 to 1e+06, got \"nan\"");
    EXPECT_EQ(error("newmtl a\nKa 1 1\n"), "a.mtl:2: Ka: expected a number, got the end of the line");
    EXPECT_EQ(error("newmtl a\nNs\n"), "a.mtl:2: Ns: expected a number, got the end of the line");
    EXPECT_EQ(error("newmtl a\nmap_Kd -s 1\n"), "a.mtl:2: map_Kd: expected a file name");
    EXPECT_EQ(error("Kd 1 1 1\n"), "a.mtl:1: expected newmtl before what a material is made of");
    EXPECT_EQ(error("newmtl\n"), "a.mtl:1: newmtl: expected a name");
}

} // namespace
} // namespace sandbox
