// SPDX-License-Identifier: MIT
// The bar of a program that is started at a terminal.
#include <cstdlib>

#include <unistd.h>

#include "cli/program.h"
#include "scene/pty.h"

namespace stagelight::cli {
namespace {

class Stage01Progress : public Cli {};

TEST_F(Stage01Progress, TellsHowManyFramesAreRendered) {
    const std::string program = std::string(STAGELIGHT_BINARY_DIR) + "/stages/01_primitives";
    const std::string cache = std::string(STAGELIGHT_BINARY_DIR) + "/tests/pocl_cache";
    AtTerminal terminal([&] {
        setenv("POCL_CACHE_DIR", cache.c_str(), 0);
        if (chdir(folder.path().c_str()) == 0) {
            execl(program.c_str(), program.c_str(), "--size", small, "--frames", "1000000",
                  nullptr);
        }
    });
    terminal.wait_for("rendering frames [");
    terminal.wait_for(" of 1000000, ");
    expect_part(terminal.output(), " of 1000000, ");
}

}  // namespace
}  // namespace stagelight::cli
