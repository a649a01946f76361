// SPDX-License-Identifier: MIT
// The kernels' text: inside the binary, or read from disk for work on them.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "device/methods.h"

namespace stagelight {

// By path in the checkout: "kernels/ray.cl", "stages/01_primitives/kernel.cl", …
extern const std::map<std::string, std::string, std::less<>> embedded_sources;

// The folder to read kernels from: `checkout`, or where there is none STAGELIGHT_KERNELS; none
// where nobody names one.
std::optional<std::filesystem::path>
named_kernels(const std::optional<std::filesystem::path> &checkout);

// The text of `path` ("stages/NN_name/kernel.cl") with every #include "module" replaced by
// kernels/module, each once, and #line directives, so that a compiler's message names the
// module and its line. A .inc is a part of a declaration, and replaced wherever it stands. A module
// in a folder of a kind of `methods`, as sphere/haines.cl, gives way to the one that was chosen.
// With a folder named, which holds kernels/ and stages/ as the repository does, all of it is read
// from there. Throws UserError for a file that is missing.
std::string kernel_source(const std::string &path,
                          const std::optional<std::filesystem::path> &checkout = {},
                          const Methods &methods = {});

}  // namespace stagelight
