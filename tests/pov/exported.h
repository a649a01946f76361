// SPDX-License-Identifier: MIT
// What a scene becomes for POV-Ray.
#pragma once

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "pov/pov_export.h"
#include "reference/scenes.h"
#include "scene/temporary_folder.h"

namespace stagelight::pov {

using namespace reference;  // its small scenes

class Export : public testing::Test {
protected:
    std::filesystem::path file() const { return folder.path() / "scene.pov"; }

    std::string exported(const Scene &scene, const PovSettings &settings = {}) const {
        export_pov(scene, settings, file());
        std::ifstream stream(file());
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    TemporaryFolder folder;
};

inline void expect_part(const std::string &text, const std::string &part) {
    EXPECT_NE(text.find(part), std::string::npos) << "expected: " << part << "\nin:\n" << text;
}

inline void expect_no_part(const std::string &text, const std::string &part) {
    EXPECT_EQ(text.find(part), std::string::npos) << "did not expect: " << part << "\nin:\n"
                                                  << text;
}

// The number, or the vector, that follows the first `word`; NaN where there is none.
inline double number_after(const std::string &text, const std::string &word) {
    double number = std::numeric_limits<double>::quiet_NaN();
    const auto place = text.find(word);
    std::istringstream(place == std::string::npos ? "" : text.substr(place + word.size()))
        >> number;
    return number;
}

inline dvec3 vector_after(const std::string &text, const std::string &word) {
    const auto open = text.find('<', text.find(word));
    const auto first = text.find(',', open);
    const auto second = text.find(',', first + 1);
    const auto at = [&](std::size_t place) {
        return number_after(text.substr(std::min(place, text.size())), text.substr(place, 1));
    };
    return second == std::string::npos ? dvec3(std::numeric_limits<double>::quiet_NaN())
                                       : dvec3(at(open), at(first), at(second));
}

}  // namespace stagelight::pov
