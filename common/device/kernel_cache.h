// SPDX-License-Identifier: MIT
// The folder where PoCL keeps the kernels that it has compiled. PoCL shows no device at all where
// it can't make that folder, and ends the process where the disk is full or a file is damaged.
#pragma once

namespace stagelight {

// Before the first call into OpenCL. Where PoCL's folder can't be made, or has no room, kernels go
// to a temporary one, which is removed at the end; a warning says so, and why.
void prepare_kernel_cache();

}  // namespace stagelight
