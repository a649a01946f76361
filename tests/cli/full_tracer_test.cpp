// SPDX-License-Identifier: MIT
// Stage 10 as a user meets it: what it warns of.
#include "cli/program.h"

namespace stagelight::cli {
namespace {

class Stage10Warning : public Cli {
protected:
    // A pyramid of glass with these faces.
    Outcome draw(const std::string &faces) const {
        folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + faces);
        folder.write("scene.toml", "[camera]\nposition = [3, 2, 4]\nlook_at = [0, 0, 0]\n"
                                   "[materials.glass]\ntype = \"dielectric\"\n"
                                   "[[meshes]]\nfile = \"a.obj\"\nmaterial = \"glass\"\n");
        return run("10_full_tracer", {"scene.toml", "--size", small, "--out", "a.png"});
    }
};

TEST_F(Stage10Warning, NamesGlassThatIsNotClosed) {
    const Outcome outcome = draw("f 1 3 2\nf 1 2 4\nf 2 3 4\n");
    EXPECT_EQ(outcome.code, 0) << outcome;
    EXPECT_TRUE(outcome.err.starts_with("warning: scene.toml:7:8: ")
                && outcome.err.find('\n') + 1 == outcome.err.size())
        << outcome;
    expect_part(outcome.err, "not closed: 3 of its edges");
    expect_part(outcome.out, "wrote a.png");
}

TEST_F(Stage10Warning, IsNotForClosedGlass) {
    expect_done(draw("f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"));
}

}  // namespace
}  // namespace stagelight::cli
