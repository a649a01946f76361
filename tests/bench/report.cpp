// SPDX-License-Identifier: MIT
#include "bench/report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "image/whole_file.h"

namespace stagelight::bench {

std::filesystem::path report_file(const std::string &name) {
    const std::filesystem::path file = std::filesystem::path("out") / name;
    std::error_code ignored;  // what is wrong with the folder is told by require_writable_place
    std::filesystem::create_directories(file.parent_path(), ignored);
    require_writable_place(file);
    return file;
}

void write_report(const ordered_json &report, const std::filesystem::path &file) {
    const std::string json = report.dump(2, ' ', false, ordered_json::error_handler_t::replace);
    write_whole(std::vector<unsigned char>(json.begin(), json.end()), file);
    fmt::print("wrote {}\n", file.string());
}

std::string table(const std::vector<std::vector<std::string>> &rows) {
    std::vector<std::size_t> widths;
    for (const auto &row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], row[i].size());
        }
    }
    std::string text;
    for (const auto &row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            text += i == 0 ? fmt::format("{:<{}}", row[i], widths[i])
                           : fmt::format("  {:>{}}", row[i], widths[i]);
        }
        text += '\n';
    }
    return text;
}

void say(const std::string &what) {
    fmt::print(stderr, "bench: {}\n", what);
}

double fitted_exponent(const std::vector<double> &x, const std::vector<double> &y) {
    const auto count = static_cast<double>(x.size());
    double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double log_x = std::log(x[i]), log_y = std::log(y[i]);
        sum_x += log_x;
        sum_y += log_y;
        sum_xx += log_x * log_x;
        sum_xy += log_x * log_y;
    }
    return (count * sum_xy - sum_x * sum_y) / (count * sum_xx - sum_x * sum_x);
}

}  // namespace stagelight::bench
