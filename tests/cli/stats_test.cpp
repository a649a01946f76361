// SPDX-License-Identifier: MIT
// --stats and --frames: what a run has cost, as JSON.
#include <algorithm>
#include <chrono>
#include <fstream>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace stagelight::cli {
namespace {

using nlohmann::json;

class StatsFile : public Cli {
protected:
    json stats(const std::string &stage, std::vector<std::string> arguments = {}) const {
        arguments.insert(arguments.end(),
                         {"--size", small, "--out", "a.png", "--stats", "stats.json", "--verbose"});
        const Outcome outcome = run(stage, arguments);
        expect_done(outcome);
        said_ = outcome.out;
        return json::parse(std::ifstream(folder.path() / "stats.json"));
    }
    const std::string &said() const { return said_; }
    static std::vector<std::string> keys_of(const json &object) {
        std::vector<std::string> keys;
        for (const auto &[key, value] : object.items()) {
            keys.push_back(key);
        }
        return keys;
    }

private:
    mutable std::string said_;
};

class Stage01Stats : public StatsFile {};
class Stage04Stats : public StatsFile {};
class Stage08Stats : public StatsFile {};
class Stage09Stats : public StatsFile {};

TEST_F(Stage01Stats, HaveATimeForEachFrame) {
    const json stats = this->stats("01_primitives", {"--frames", "4"});
    std::vector<double> times = stats.at("frames").at("milliseconds");
    ASSERT_EQ(times.size(), 4u);
    EXPECT_TRUE(std::ranges::all_of(times, [](double time) { return time > 0; })) << stats;
    std::ranges::sort(times);
    EXPECT_DOUBLE_EQ(stats.at("frames").at("median"), (times[1] + times[2]) / 2);
    EXPECT_EQ(this->stats("01_primitives").at("frames").at("milliseconds").size(), 1u);
    EXPECT_EQ(files(), (std::vector<std::string>{"a.png", "stats.json"}));
}

TEST_F(Stage01Stats, NameTheDeviceAndTheBuild) {
    const json stats = this->stats("01_primitives");
    const json &device = stats.at("device");
    EXPECT_TRUE(said().starts_with(device.at("name").get<std::string>() + '\n'));
    for (const char *field : {"platform", "version", "driver"}) {
        EXPECT_NE(device.at(field), "") << field;
    }
    EXPECT_GE(device.at("compute_units"), 1);
    expect_part(stats.at("build").at("options"), "-D HAS_SPHERES=1 -D HAS_PLANES=1");
    EXPECT_GT(stats.at("build").at("milliseconds"), 0);
}

// The scene has one plane and seven spheres, and stage 01 neither materials nor lights. A
// sphere and a plane take 32 bytes, a pixel 16.
TEST_F(Stage01Stats, HaveWhatTheSceneNeededAndNoMore) {
    const json stats = this->stats("01_primitives");
    EXPECT_EQ(stats.at("stage"), "01_primitives");
    EXPECT_EQ(stats.at("size"), json({32, 20}));
    EXPECT_EQ(stats.at("samples"), 1);
    EXPECT_EQ(stats.at("needs"), json({{"HAS_SPHERES", 1}, {"HAS_PLANES", 1}}));
    EXPECT_EQ(stats.at("bytes_on_device"), json({{"spheres", 7 * 32},
                                                 {"planes", 32},
                                                 {"image", 32 * 20 * 16},
                                                 {"total", 7 * 32 + 32 + 32 * 20 * 16}}));
    EXPECT_EQ(stats.at("methods"),
              json({{"math", "strict"}, {"normalise", "exact"}, {"sphere", "geometric"}}));
    EXPECT_EQ(stats.at("rays"),
              json({{"primary", 32 * 20}, {"shadow", 0}, {"reflection", 0}, {"refraction", 0}}));
    EXPECT_EQ(stats.at("dropped_rays"), 0);
}

// The parts follow each other, so that their sum is the whole way. A tick of the clock that says
// when a process started is 10 ms.
TEST_F(Stage09Stats, NameThePartsFromStartToPicture) {
    const auto began = std::chrono::steady_clock::now();
    const json startup = this->stats("09_tree", {"--frames", "3"}).at("startup");
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
    EXPECT_EQ(keys_of(startup),
              (std::vector<std::string>{"device", "first_frame", "kernel", "scene", "start",
                                        "total", "tree", "upload", "write"}));
    double sum = 0;
    for (const auto &[part, milliseconds] : startup.items()) {
        EXPECT_GE(milliseconds, 0) << part;
        sum += part == "total" ? 0 : milliseconds.get<double>();
    }
    EXPECT_NEAR(startup.at("total"), sum, 1e-6);
    EXPECT_LT(sum, took.count() + 20) << "more than the program was there";
    for (const char *part : {"start", "scene", "tree", "kernel", "first_frame", "write"}) {
        EXPECT_GT(startup.at(part), 0) << part;
    }
    expect_part(said(), "from start to picture: ");
}

// OpenImageIO brings 240 libraries, which take 0.3 s of every start. The loader says what it loads.
TEST_F(Stage09Stats, NeedNoOpenImageIo) {
    const Outcome outcome = run("09_tree", Start{{}, {"LD_TRACE_LOADED_OBJECTS=1"}});
    expect_part(outcome.out, "libassimp");
    EXPECT_EQ(outcome.out.find("libOpenImageIO"), std::string::npos) << outcome;
}

TEST_F(Stage04Stats, CountRaysSamplesAndDroppedRays) {
    const json stats = this->stats("04_refraction_beer",
                                   {"--samples", "2", "--depth", "3", "--method", "interior=full"});
    EXPECT_EQ(stats.at("samples"), 2);
    for (const char *picture : {"image", "sample", "sample_sum"}) {
        EXPECT_EQ(stats.at("bytes_on_device").at(picture), 32 * 20 * 16) << picture;
    }
    EXPECT_EQ(stats.at("max_depth"), 3);
    EXPECT_EQ(stats.at("methods").at("interior"), "full");
    EXPECT_EQ(stats.at("needs").at("MAX_DEPTH"), 3);
    EXPECT_EQ(stats.at("needs").at("STACK_SIZE"), 4);
    EXPECT_EQ(stats.at("rays").at("primary"), 2 * 32 * 20);
    for (const char *kind : {"shadow", "reflection", "refraction"}) {
        EXPECT_GT(stats.at("rays").at(kind), 0) << kind;
    }
    EXPECT_GT(stats.at("dropped_rays"), 0);
    expect_part(said(),
                to_string(stats.at("dropped_rays")) + " rays dropped: deeper than 3 bounces");
}

TEST_F(Stage04Stats, NameTheMethod) {
    const json stats = this->stats("04_refraction_beer", {"--method", "interior=paper"});
    EXPECT_EQ(stats.at("methods").at("interior"), "paper");
    expect_part(stats.at("build").at("options"), "-D METHOD_INTERIOR_PAPER=1");
}

TEST_F(Stage08Stats, NameTheCurves) {
    const json stats = this->stats("08_gamma", {"--method", "encode=2.2"});
    EXPECT_EQ(stats.at("methods").at("decode"), "srgb");
    EXPECT_EQ(stats.at("methods").at("encode"), "2.2");
}

}  // namespace
}  // namespace stagelight::cli
