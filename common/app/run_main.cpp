// SPDX-License-Identifier: MIT
#include "app/run_main.h"

#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "device/opencl.h"
#include "scene/errors.h"

namespace stagelight {

int run_main(const std::function<int()> &body) {
    try {
        return body();
    } catch (const UserError &error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return exit_user_error;
    } catch (const KernelError &error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return exit_user_error;
    } catch (const MachineError &error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return exit_machine_error;
    } catch (const cl::Error &error) {
        fmt::print(
            stderr,
            "error: OpenCL: {} failed with error {}; try another --device (--list-devices)\n",
            error.what(), error.err());
        return exit_machine_error;
    } catch (const std::bad_alloc &) {
        fmt::print(stderr, "error: out of memory; try a smaller --size or scene\n");
        return exit_machine_error;
    }
}

}  // namespace stagelight
