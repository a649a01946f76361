// SPDX-License-Identifier: MIT
#include "bench/collected_runs.h"

#include "scene/errors.h"

namespace stagelight::bench {

int run_benchmarks(int argc, char **argv, benchmark::BenchmarkReporter &table) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return exit_user_error;
    }
    const std::size_t run = benchmark::RunSpecifiedBenchmarks(&table);
    benchmark::Shutdown();
    return run > 0 ? exit_done : exit_user_error;  // a filter that lets nothing through
}

}  // namespace stagelight::bench
