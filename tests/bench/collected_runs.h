// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "app/stats.h"

namespace stagelight::bench {

// Keeps what Google Benchmark reports, all repetitions of a benchmark together, for a table at the
// end.
class CollectedRuns : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context &) override { return true; }

    void ReportRuns(const std::vector<Run> &runs) override {
        for (const Run &run : runs) {
            if (run.run_type == Run::RT_Iteration) {
                runs_[run.run_name.function_name].push_back(run);
            }
        }
    }

protected:
    static double counter(const std::vector<Run> &runs, const char *key) {
        return median_of(runs, [key](const Run &run) { return run.counters.at(key).value; });
    }

    const std::map<std::string, std::vector<Run>> &runs() const { return runs_; }

private:
    std::map<std::string, std::vector<Run>> runs_;
};

// Runs what is registered, reported to `table`. Returns the program's exit code.
int run_benchmarks(int argc, char **argv, benchmark::BenchmarkReporter &table);

}  // namespace stagelight::bench
