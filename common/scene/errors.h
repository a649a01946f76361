// SPDX-License-Identifier: MIT
// The ways a program ends without a picture, and their exit codes.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace stagelight {

enum ExitCode : int {
    exit_done = 0,
    exit_check_failed = 1,
    exit_user_error = 2,
    exit_machine_error = 3,
};

// Text that went into a one-line message: anything below space becomes a space.
std::string one_line(std::string text);

// The user's input is wrong. The message is one line: where (file:line:column),
// what is wrong, what was expected.
class UserError : public std::runtime_error {
public:
    explicit UserError(const std::string &message) : std::runtime_error(one_line(message)) {}
};

// The user's own kernel (--kernels) does not build. The message is the compiler's log.
class KernelError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The machine lacks something. The message names the remedy.
class MachineError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// One device can't draw this, and another may. The message names the remedy; `reason` is the first
// line of what is wrong.
class DeviceError : public MachineError {
public:
    DeviceError(const std::string &message, std::string reason)
        : MachineError(message), reason_(std::move(reason)) {}
    explicit DeviceError(const std::string &message) : DeviceError(message, message) {}
    const std::string &reason() const { return reason_; }

private:
    std::string reason_;
};

}  // namespace stagelight
