// SPDX-License-Identifier: MIT
#include "scene/ply_header.h"

#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/temporary_folder.h"

namespace stagelight {
namespace {

using namespace std::string_literals;

std::string fault_of(std::string_view bytes) {
    const TemporaryFolder folder;
    return ply_fault(folder.write("a.ply", bytes));
}

std::string header(std::string_view format, std::string_view vertices, std::string_view faces) {
    return fmt::format("ply\nformat {} 1.0\ncomment a\nelement vertex {}\nproperty float x\n"
                       "property float y\nproperty float z\nelement face {}\n"
                       "property list uchar int vertex_indices\nend_header\n",
                       format, vertices, faces);
}

const std::string rows = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string triangle = "\3\0\0\0\0\1\0\0\0\2\0\0\0"s;
const std::string binary_rows = std::string(36, '\0') + triangle;

TEST(PlyHeader, IsRightWhereTheFileHoldsWhatItSays) {
    EXPECT_EQ(fault_of(header("ascii", "3", "1") + rows), "");
    EXPECT_EQ(fault_of(header("ascii", "3", "1") + rows.substr(0, rows.size() - 1)), "");
    EXPECT_EQ(fault_of(header("binary_little_endian", "3", "1") + binary_rows), "");
    EXPECT_EQ(fault_of(header("binary_big_endian", "3", "1") + binary_rows), "");
    EXPECT_EQ(fault_of(header("binary_big_endian", "3", "0") + binary_rows), "")
        << "more than it says is for Assimp to tell";
    std::string lines = header("ascii", "3", "1") + rows;
    for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 2) {
        lines.replace(at, 1, "\r\n");
    }
    EXPECT_EQ(fault_of(lines), "");
    EXPECT_EQ(fault_of("no ply\n"), "");
    EXPECT_EQ(fault_of("OFF\n"), "");
}

TEST(PlyHeader, NeedsAnEnd) {
    const std::string whole = header("binary_big_endian", "3", "1");
    for (std::size_t size = 4; size < whole.size() - 1; ++size) {
        EXPECT_EQ(fault_of(whole.substr(0, size)) == "",
                  whole.substr(0, size).ends_with("end_header"))
            << whole.substr(0, size);
    }
    EXPECT_EQ(fault_of("ply\nelement face 2 more\n"),
              "its header has no end, expected a line 'end_header'");
}

TEST(PlyHeader, PromisesNoMoreThanTheFileHolds) {
    for (const char *count : {"4", "400000000", "18446744073709551615"}) {
        const std::string at_vertices =
            fault_of(header("binary_little_endian", count, "0") + std::string(47, '\0'));
        EXPECT_EQ(at_vertices.rfind("its header promises "s + count + " of 'vertex', expected", 0),
                  0U)
            << at_vertices;
        const std::string at_faces =
            fault_of(header("binary_little_endian", "3", count) + binary_rows);
        EXPECT_EQ(at_faces.rfind("its header promises "s + count + " of 'face', expected", 0), 0U)
            << at_faces;
    }
    EXPECT_NE(fault_of(header("ascii", "400000000", "1") + rows), "");
    EXPECT_NE(fault_of(header("ascii", "3", "400000000") + rows), "");
}

TEST(PlyHeader, CountsTheValuesOfLists) {
    const std::string start = header("binary_little_endian", "3", "1") + std::string(36, '\0');
    EXPECT_EQ(fault_of(start + "\3" + std::string(12, '\0')), "");
    EXPECT_NE(fault_of(start + "\4" + std::string(12, '\0')), "");
    EXPECT_NE(fault_of(start), "");
}

TEST(PlyHeader, LeavesTypesThatItDoesNotKnowToAssimp) {
    EXPECT_EQ(
        fault_of("ply\nformat ascii 1.0\nelement vertex 2\nproperty half x\nend_header\n1\n2\n"),
        "");
    EXPECT_NE(
        fault_of("ply\nformat ascii 1.0\nelement vertex 20\nproperty half x\nend_header\n1\n"), "");
    EXPECT_NE(fault_of("ply\nformat ascii 1.0\nelement nothing 400000000\nend_header\n"), "");
}

}  // namespace
}  // namespace stagelight
