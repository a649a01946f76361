// SPDX-License-Identifier: MIT
// The two OpenCL implementations that packages.txt brings. They share no compiler.
#pragma once

#include <cstdlib>

namespace stagelight {

// Rusticl must be asked for before the first call into OpenCL.
inline const bool rusticl_enabled = setenv("RUSTICL_ENABLE", "llvmpipe", 1) == 0;

// By parts of their devices' names: PoCL's, and rusticl's on Mesa's llvmpipe.
inline constexpr const char *implementations[] = {"pthread", "llvmpipe"};

}  // namespace stagelight
