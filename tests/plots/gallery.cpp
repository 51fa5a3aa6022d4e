// gallery: the page names nothing that is missing, tells what runs have reached, and is valid HTML.
#include "plots/gallery.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "lab/options.hpp"
#include "plots/findings.hpp"
#include "plots/notes.hpp"
#include "tests/programs/process.hpp"

namespace mpm::test {
namespace {

const std::string columns = "program,case,scheme,shape,transfer,options,cells,error_name,error,order,wall_s,verdict\n";

const std::string errors = "name,cells,error,seconds,verdict\n";

struct Drawn {
    Folder folder;
    Drawn() {
        write("plots/gallery.txt", "# Bars & beams\nwave\n\n# Programs\nmesh | a-mesh | Cells <1.\n");
        write("plots/wave.gp", "# A wave,\n# in two lines.\nplot 'data/wave-'.name.'/history.csv', 'data/still/history.csv'\n");
        write("figures/wave.gp", "");
        write("figures/wave.png", "");
        write("figures/mesh.png", "");
        write("figures/data/wave-1/command", "bar --cells 8,16\n");
        write("figures/data/wave-1/summary.csv",
              columns + "bar,b,usl,hat,flip,cells=8,8,e1,1e-2,nan,.1,ok\nbar,b,usl,hat,flip,cells=16,16,e1,2.5e-3,2,.2,ok\n" +
                  "bar,b,usl,hat,flip,cells=16,16,e2,7,2,.2,ok\n");
        write("figures/data/wave-2/command", "compare -- bar -- bar --mode 2\n");
        write("figures/data/wave-2/compare.csv",
              columns + "bar,b,usl,hat,flip,,8,e1,1e-2,nan,.1,ok\nbar,b,usl,hat,flip,mode=2;cells=8,8,e1,nan,nan,.1,unstable:energy\n");
        write("figures/data/still/command", "bar --dt 0\n");
        write("figures/data/still/history.csv", "t\n0\n");
        write("figures/data/atlas-bar/title", "The bar\ne2\nVibration\n");
        write("figures/data/atlas-bar/compare.csv", columns);
        write("figures/data/atlas-bar/work_precision.png", "");
        write("figures/data/atlas-bar/errors.csv", errors + "usl,8,9e-3,.1,ok\nusf,8,nan,.1,unstable:energy-growth\n");
        write("chapters/bars/notes.md",
              "# Bars & beams\n\nText with `a < b`\nand **bold**.\n\n- one\n  and more\n- two\n\n| a | b |\n|---|---|\n| 1 | |\n");
        write("figures/data/a-mesh/command", "fill\n");
        write("figures/data/a-mesh/mesh.gp", "");
    }
    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories(std::filesystem::path(folder.path(name)).parent_path());
        std::ofstream(folder.path(name)) << text;
    }
    std::string page() const {
        write_gallery(folder.path("plots"), folder.path("figures"));
        return folder.read("figures/index.html");
    }
};

std::vector<std::string> found(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> all;
    for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) all.push_back((*it)[1]);
    return all;
}

void expect_all_there(const std::string& page, const std::string& folder) {
    for (const std::string& link : found(page, "(?:href|src)=\"([^\"]*)\"")) {
        const bool there = link[0] == '#' ? holds(page, "id=\"" + link.substr(1) + "\"") : std::filesystem::exists(folder + "/" + link);
        EXPECT_TRUE(there) << link;
    }
}

void expect_valid(const std::string& file) {
    if (std::system("command -v tidy >/dev/null") != 0) GTEST_SKIP() << "tidy is not installed";
    EXPECT_EQ(std::system(("tidy -quiet -errors '" + file + "'").c_str()), 0);
}

TEST(Gallery, NamesOnlyWhatIsThere) {
    const Drawn drawn;
    const std::string page = drawn.page();
    EXPECT_GE(found(page, "(href)").size(), 8u);
    expect_all_there(page, drawn.folder.path("figures"));
}

TEST(Gallery, IsValidHtml) {
    const Drawn drawn;
    drawn.page();
    expect_valid(drawn.folder.path("figures/index.html"));
}

TEST(Gallery, TellsTheFinestOfEachRun) {
    const Drawn drawn;
    const std::vector<GalleryRun> runs = runs_of(drawn.folder.path("figures"), {"wave", {"wave-*", "still"}, ""});
    ASSERT_EQ(runs.size(), 4u);
    EXPECT_EQ(runs[0].command, "bar --cells 8,16");
    EXPECT_EQ(runs[0].cells, "16");
    EXPECT_EQ(runs[0].error, "0.0025");
    EXPECT_EQ(runs[2].command, "bar --mode 2");
    EXPECT_EQ(runs[2].verdict, "unstable:energy");
    EXPECT_EQ(runs[3].csv, "data/still/history.csv");
}

TEST(Findings, TellWhoIsBeatenByNobodyAndWhenALevelIsReached) {
    const std::string rows =
        "fast,8,9e-3,.1,ok\nfast,16,2e-3,.2,ok\ngood,8,5e-5,1,ok\nslow,8,6e-5,2,ok\nslow,16,1e-9,.01,unstable:energy\nsame,8,9.01e-3,.05,"
        "ok\n";
    const std::vector<Finding> found = findings(parse_csv(errors + rows, "test"));
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(found[0].name, "good");
    EXPECT_EQ(found[1].name, "fast");
    EXPECT_TRUE(found[0].best && found[1].best && found[2].best && !found[3].best);
    EXPECT_EQ(found[1].levels[0].seconds, 0.1);
    EXPECT_TRUE(std::isnan(found[1].levels[1].seconds));
    EXPECT_EQ(found[0].levels[2].seconds, 1);
    EXPECT_EQ(found[3].trouble, "1 of 2 runs unstable:energy");
    EXPECT_EQ(found[3].finest.error, 6e-5);
    EXPECT_EQ(found[3].finest.cells, 8);
}
TEST(Findings, TakeTheLessCostlyOfTwoThatAreEqual) {
    // One row is as good to less than a per cent and twice as fast: it is the one to use.
    const std::vector<Finding> found = findings(parse_csv(errors + "slow,8,1e-3,.2,ok\nfast,8,1.005e-3,.1,ok\n", "test"));
    EXPECT_EQ(found[0].name, "fast");
    EXPECT_FALSE(found[1].best);
}
TEST(Findings, AreAPageOfCasesAndNotes) {
    const Drawn drawn;
    drawn.page();
    const std::string page = drawn.folder.read("figures/findings.html");
    expect_all_there(page, drawn.folder.path("figures"));
    expect_valid(drawn.folder.path("figures/findings.html"));
    EXPECT_TRUE(holds(page, "<b>usl</b><br>0.1 s, 8 cells")) << page;
    EXPECT_TRUE(holds(page, "usf: 1 of 1 runs unstable:energy-growth")) << page;
    EXPECT_TRUE(holds(page, "id=\"notes-bars\"")) << page;
}

TEST(Notes, AreHeadingsParagraphsListsAndTables) {
    EXPECT_EQ(notes_html("# A & B\n\nIn `a < b`\nand **`c`**.\n## C\n"),
              "<h3>A &amp; B</h3>\n<p>In <code>a &lt; b</code> and <b><code>c</code></b>.</p>\n<h4>C</h4>\n");
    EXPECT_EQ(notes_html("- one\n  more\n- two\n\ntext"), "<ul><li>one more</li>\n<li>two</li></ul>\n<p>text</p>\n");
    EXPECT_EQ(notes_html("Text:\n| a | b |\n|---|---|\n| 1 | |\n"),
              "<p>Text:</p>\n<table><tr><th>a</th><th>b</th></tr>\n<tr><td>1</td><td></td></tr>\n</table>\n");
}

TEST(Gallery, ReadsCaptionAndRunsOfARecipe) {
    EXPECT_EQ(recipe_caption("# A wave,\n# in two.\nplot x\n# not this"), "A wave, in two.");
    EXPECT_EQ(recipe_runs("'data/a-'.x 'data/b/c.csv' 'data/%s/c' 'data/b/d'"), (std::vector<std::string>{"a-*", "b"}));
}

TEST(Gallery, MissesAPicture) {
    const Drawn drawn;
    std::filesystem::remove(drawn.folder.path("figures/mesh.png"));
    EXPECT_THROW(drawn.page(), FileTrouble);
}

TEST(Gallery, MissesARun) {
    const Drawn drawn;
    std::filesystem::remove_all(drawn.folder.path("figures/data/still"));
    EXPECT_THROW(drawn.page(), FileTrouble);
}

TEST(Gallery, MissesARecipeInTheList) {
    const Drawn drawn;
    drawn.write("plots/other.gp", "# Another.\n");
    EXPECT_THROW(drawn.page(), FileTrouble);
}

// The pages that `make figures` has drawn, if it has.
TEST(Gallery, OfTheProjectIsWhole) {
    const std::string folder = std::string(MPM_BUILD_DIR) + "/../figures";
    if (!std::filesystem::exists(folder + "/index.html")) GTEST_SKIP() << "make figures has not been run";
    std::ifstream file(folder + "/index.html");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    expect_all_there(page, folder);
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".png" || entry.path().extension() == ".gif") {
            EXPECT_TRUE(holds(page, "src=\"" + entry.path().filename().string() + "\"")) << entry.path();
        }
    expect_valid(folder + "/index.html");
    std::ifstream other(folder + "/findings.html");
    expect_all_there({std::istreambuf_iterator<char>(other), {}}, folder);
    expect_valid(folder + "/findings.html");
}

}  // namespace
}  // namespace mpm::test
