// SPDX-License-Identifier: MIT
// The direction of a vector is what OpenCL's own normalize gives.
